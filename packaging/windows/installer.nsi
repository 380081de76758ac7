; Installer and uninstaller for Windows.
;
;   makensis -DVERSION=0.1.0 -DSOURCE=FOLDER -DICON=FILE.ico -DOUTPUT=FILE.exe installer.nsi
;
; SOURCE is the frozen folder. TARGET=amd64-unicode builds a 64-bit installer, if NSIS supports it.

Unicode true
!ifdef TARGET
  Target ${TARGET}
!endif
!include LogicLib.nsh
!include MUI2.nsh

!define NAME "TReX Studio"
!define UNINSTALL_KEY "Software\Microsoft\Windows\CurrentVersion\Uninstall\${NAME}"

Name "${NAME} ${VERSION}"
OutFile "${OUTPUT}"
InstallDir "$PROGRAMFILES64\${NAME}"
RequestExecutionLevel admin
SetCompressor /SOLID lzma
ManifestDPIAware true

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!define MUI_ABORTWARNING
!define MUI_FINISHPAGE_RUN "$INSTDIR\trex-gui.exe"
!define MUI_FINISHPAGE_RUN_NOTCHECKED
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "German"
!insertmacro MUI_LANGUAGE "French"

LangString RUNNING ${LANG_ENGLISH} \
  "${NAME} is running and may be driving motors. Stop them and close it, then click Retry."
LangString RUNNING ${LANG_GERMAN} \
  "${NAME} läuft und treibt vielleicht Motoren an. Halten Sie sie an, schließen Sie das Programm und klicken Sie dann auf „Wiederholen“."
LangString RUNNING ${LANG_FRENCH} \
  "${NAME} est ouvert et commande peut-être des moteurs. Arrêtez-les, fermez le programme, puis cliquez sur « Réessayer »."

; The file of a running program cannot be opened for writing. In silent mode the status is 2.
!macro RequireClosed PROGRAM
  ${Do}
    ${IfNot} ${FileExists} "$INSTDIR\${PROGRAM}"
      ${Break}
    ${EndIf}
    ClearErrors
    FileOpen $0 "$INSTDIR\${PROGRAM}" a
    ${IfNot} ${Errors}
      FileClose $0
      ${Break}
    ${EndIf}
    ${If} ${Cmd} `MessageBox MB_RETRYCANCEL|MB_ICONEXCLAMATION $(RUNNING) /SD IDCANCEL IDCANCEL`
      Abort
    ${EndIf}
  ${Loop}
!macroend

; Remove the installed files from the folder, and no files of the user.
!macro RemoveFiles
  !insertmacro RequireClosed trex-gui.exe
  !insertmacro RequireClosed trexcmd.exe
  !insertmacro RequireClosed trex-sim.exe
  Delete "$INSTDIR\trex-gui.exe"
  Delete "$INSTDIR\trexcmd.exe"
  Delete "$INSTDIR\trex-sim.exe"
  Delete "$INSTDIR\trex-studio.ico"
  RMDir /r "$INSTDIR\_internal"
  RMDir /r "$INSTDIR\licences"
!macroend

Function .onInit
  ${If} $INSTDIR == "$PROGRAMFILES64\${NAME}" ; not set by /D
    SetRegView 64
    ReadRegStr $0 HKLM "${UNINSTALL_KEY}" "InstallLocation"
    ${If} $0 != ""
      StrCpy $INSTDIR $0
    ${EndIf}
  ${EndIf}
FunctionEnd

Section "" PROGRAMS
  SetShellVarContext all
  SetRegView 64
  !insertmacro RemoveFiles ; of an earlier version
  SetOutPath "$INSTDIR"
  File /r "${SOURCE}/*"
  File "/oname=trex-studio.ico" "${ICON}"
  CreateShortcut "$SMPROGRAMS\${NAME}.lnk" "$INSTDIR\trex-gui.exe" "" "$INSTDIR\trex-studio.ico"
  WriteUninstaller "$INSTDIR\uninstall.exe"
  WriteRegStr HKLM "${UNINSTALL_KEY}" "DisplayName" "${NAME}"
  WriteRegStr HKLM "${UNINSTALL_KEY}" "DisplayVersion" "${VERSION}"
  WriteRegStr HKLM "${UNINSTALL_KEY}" "Publisher" "The TReX Studio developers"
  SectionGetSize ${PROGRAMS} $0
  WriteRegDWORD HKLM "${UNINSTALL_KEY}" "EstimatedSize" $0
  WriteRegStr HKLM "${UNINSTALL_KEY}" "DisplayIcon" "$INSTDIR\trex-studio.ico"
  WriteRegStr HKLM "${UNINSTALL_KEY}" "InstallLocation" "$INSTDIR"
  WriteRegStr HKLM "${UNINSTALL_KEY}" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKLM "${UNINSTALL_KEY}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKLM "${UNINSTALL_KEY}" "NoModify" 1
  WriteRegDWORD HKLM "${UNINSTALL_KEY}" "NoRepair" 1
SectionEnd

; Does not remove settings, snapshots and recordings of users.
Section "Uninstall"
  SetShellVarContext all
  SetRegView 64
  !insertmacro RemoveFiles
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR" ; only if it is empty
  Delete "$SMPROGRAMS\${NAME}.lnk"
  DeleteRegKey HKLM "${UNINSTALL_KEY}"
SectionEnd
