<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>trex_gui</name>
    <message><source>{0} is ambiguous: write {1} or {2}</source>
        <translation>{0} kann {1} oder {2} bedeuten: Schreiben Sie, was Sie meinen</translation></message>
    <message><source>{0} is not a number</source>
        <translation>{0} ist keine Zahl</translation></message>
    <message><source>an empty text</source>
        <translation>leer</translation></message>
    <message><source>Internal error while searching {0} ({1}).</source>
        <translation>Interner Fehler bei der Suche an {0} ({1}).</translation></message>
    <message><source>Permission denied for {0}. {1}</source>
        <translation>Zugriff auf {0} verweigert. {1}</translation></message>
    <message><source>The port {0} cannot be reached: {1}.</source>
        <translation>Der Port {0} ist nicht erreichbar: {1}.</translation></message>
    <message><source>There is no port {0}. Ports of this computer: {1}.</source>
        <translation>Es gibt keinen Port {0}. Ports dieses Computers: {1}.</translation></message>
    <message><source>{0} is in use by another program or locked by its driver. After a crash, the guardian process also uses it for up to 5 seconds to stop the motors. Close the other program or wait, then connect again.</source>
        <translation>{0} wird von einem anderen Programm verwendet oder ist durch seinen Treiber gesperrt; nach einem Absturz bis zu 5 Sekunden lang auch durch den Wächterprozess, der die Motoren stoppt.</translation></message>
    <message><source>Motors may still be turning: no stop has been confirmed for the {0} at {1}, driven since {2}. Stop the motors, or cut their power.</source>
        <translation>Motoren drehen sich vielleicht noch: Für das Board ({0}) an {1}, angesteuert seit {2}, ist kein Stopp bestätigt. Stoppen Sie sie oder trennen Sie die Motorversorgung.</translation></message>
    <message><source>Motors may still be turning: the file {0} shows that a board was left running, but the file is damaged and does not identify the board. If a motor is turning, cut its power. Then delete the file.</source>
        <translation>Motoren drehen sich vielleicht noch: {0} besagt, dass ein Board weiterlief, ist aber beschädigt und sagt nicht, welches. Falls sich ein Motor dreht, trennen Sie die Motorversorgung; löschen Sie dann die Datei.</translation></message>
    <message><source>The guardian process is still stopping the motors on {0}. Wait up to 5 seconds, then connect again.</source>
        <translation>Der Wächterprozess stoppt noch die Motoren an {0}; das dauert bis zu 5 Sekunden. Verbinden Sie danach erneut.</translation></message>
    <message><source>{0} is in use by {1}. Close the port there, then connect again.</source>
        <translation>{0} wird von {1} verwendet. Schließen Sie den Port dort und verbinden Sie erneut.</translation></message>
    <message><source>The port {0} cannot be set to {1} ({2}).</source>
        <translation>Der Port {0} lässt sich nicht auf {1} einstellen ({2}).</translation></message>
    <message><source>The port {0} cannot be opened: {1}.</source>
        <translation>Der Port {0} kann nicht geöffnet werden: {1}.</translation></message>
    <message><source>Another program is also reading from {0} and has taken some of the bytes. Close that program, then connect again.</source>
        <translation>Ein anderes Programm liest {0} ebenfalls und hat Bytes davon abgefangen. Schließen Sie den Port dort und verbinden Sie erneut.</translation></message>
    <message><source>The connection to {0} is gone. Plug the adapter in, then connect again.</source>
        <translation>Die Leitung zu {0} ist weg. Stecken Sie den Adapter ein und verbinden Sie erneut.</translation></message>
    <message><source>it is not an ordinary file</source>
        <translation>es ist keine gewöhnliche Datei</translation></message>
    <message><source>this is a binary file; settings are text</source>
        <translation>dies ist eine Binärdatei; Einstellungen sind Text</translation></message>
    <message><source>this is UTF-16 text, as PowerShell writes with &gt;; save the file as UTF-8</source>
        <translation>dies ist UTF-16-Text, wie ihn PowerShell mit &gt; schreibt; speichern Sie ihn als UTF-8</translation></message>
    <message><source>it is a folder, not a file</source>
        <translation>es ist ein Ordner, keine Datei</translation></message>
    <message><source>it cannot be read</source>
        <translation>sie kann nicht gelesen werden</translation></message>
    <message><source>it cannot be written</source>
        <translation>sie kann nicht geschrieben werden</translation></message>
    <message><source>warning</source>
        <translation>Warnung</translation></message>
    <message><source>it cannot be written: permission denied</source>
        <translation>sie kann nicht geschrieben werden: Zugriff verweigert</translation></message>
    <message><source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation></message>
    <message><source>is larger than {0} KiB; {1} are never that large</source>
        <translation>ist größer als {0} KiB; so lang sind {1} nicht</translation></message>
    <message><source>line {0}</source>
        <translation>Zeile {0}</translation></message>
    <message><source>this is not UTF-8 text</source>
        <translation>dies ist kein UTF-8-Text</translation></message>
    <message><source>there is no folder {0}</source>
        <translation>es gibt keinen Ordner {0}</translation></message>
    <message><source>permission denied</source>
        <translation>Zugriff verweigert</translation></message>
    <message><source>The folder cannot be used: {0}.</source>
        <translation>Nicht verwendbar: {0}.</translation></message>
    <message><source>Samples lost here because the disk was too slow: {0}.</source>
        <translation>Hier fehlen Messwerte, weil der Datenträger zu langsam war: {0}.</translation></message>
    <message><source>This is not a TReX Studio recording.</source>
        <translation>Das ist keine Aufzeichnung von TReX Studio.</translation></message>
    <message><source>The file cannot be written: {0}.</source>
        <translation>Sie kann nicht geschrieben werden: {0}.</translation></message>
    <message><source>The file cannot be opened: {0}.</source>
        <translation>Lässt sich nicht öffnen: {0}.</translation></message>
    <message><source>The file cannot be read: {0}.</source>
        <translation>Sie kann nicht gelesen werden: {0}.</translation></message>
    <message><source>The file is damaged: {0}.</source>
        <translation>Beschädigt: {0}.</translation></message>
    <message><source>its time is not a number</source>
        <translation>die Zeit ist keine Zahl</translation></message>
    <message><source>The end of the file is missing.</source>
        <translation>Das Ende der Datei fehlt.</translation></message>
    <message><source>The log of the recording cannot be read, so the last samples are missing.</source>
        <translation>Ihr Protokoll ist nicht lesbar: Die letzten Messwerte fehlen.</translation></message>
    <message><source>The recording was not closed properly. Samples from the last seconds may be missing.</source>
        <translation>Sie wurde nicht beendet; Messwerte der letzten Sekunden können fehlen.</translation></message>
    <message><source>the clock in the header is not in seconds</source>
        <translation>die Uhrzeit im Kopf ist nicht in Sekunden angegeben</translation></message>
    <message><source>The column {0} is not the key of its table.</source>
        <translation>Die Spalte {0} ist nicht der Schlüssel ihrer Tabelle.</translation></message>
    <message><source>its time is outside the recording</source>
        <translation>die Zeit liegt nicht in der Aufzeichnung</translation></message>
    <message><source>Record {0} cannot be read: {1}.</source>
        <translation>Datensatz {0} ist nicht lesbar: {1}.</translation></message>
    <message><source>{0} is not of type {1}</source>
        <translation>{0} ist nicht vom Typ {1}</translation></message>
    <message><source>A CSV file is an export and cannot be opened as a recording. Open the original recording ({0}).</source>
        <translation>Eine CSV-Datei ist ein Export und lässt sich nicht als Aufzeichnung öffnen. Öffnen Sie die Aufzeichnung ({0}), aus der sie exportiert wurde.</translation></message>
    <message><source>The recording is still running. End the recording, then open the file again.</source>
        <translation>Sie wird noch aufgezeichnet. Beenden Sie die Aufzeichnung und öffnen Sie sie dann erneut.</translation></message>
    <message><source>The format of the file ({0}) is unknown. A later version of TReX Studio may be able to open the file.</source>
        <translation>Das Format {0} ist unbekannt. Eine neuere Version von TReX Studio kann sie vielleicht öffnen.</translation></message>
    <message><source>This is a recording of another device: {0}. Select the port or the demo of that device in the list of ports, then open the file again.</source>
        <translation>Das ist eine Aufzeichnung eines anderen Geräts: {0}. Sie lässt sich öffnen, wenn das Fenster die Seiten dieses Geräts zeigt: Wählen Sie seinen Port oder seine Demo in der Liste der Ports und öffnen Sie die Datei dann erneut.</translation></message>
    <message><source>The table {0} is missing.</source>
        <translation>Die Tabelle {0} fehlt.</translation></message>
    <message><source>The column {0} is missing.</source>
        <translation>Die Spalte {0} fehlt.</translation></message>
    <message><source>Samples of the kind {0} between records {1} and {2} are lost: {3}.</source>
        <translation>Messwerte von {0} in den Datensätzen {1} bis {2} sind verloren: {3}.</translation></message>
    <message><source>The column {0} is computed, but it must be stored.</source>
        <translation>Die Spalte {0} ist berechnet.</translation></message>
    <message><source>The motors of the {0} at {1}, driven since {2}, were left running. The board now connected there has confirmed a stop. If a motor is still turning, cut its power.</source>
        <translation>Die Motoren des Boards ({0}) an {1}, angesteuert seit {2}, liefen noch. Das Board, das jetzt dort ist, hat einen Stopp bestätigt. Falls sich noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>Stop the motors first.</source>
        <translation>Die Motoren müssen zuerst gestoppt werden.</translation></message>
    <message><source>another connection of this program</source>
        <translation>einer anderen Leitung dieses Programms</translation></message>
    <message><source>{0} (process {1})</source>
        <translation>{0} (Prozess {1})</translation></message>
    <message><source>Join the group of the port with this command, then log out and log in again: {0} (or grant access until the port is unplugged: {1}).</source>
        <translation>Treten Sie seiner Gruppe bei, dann melden Sie sich ab und wieder an: {0} (oder, bis zum Ausstecken: {1}).</translation></message>
    <message><source>the server rejects the line settings</source>
        <translation>der Server lehnt die Leitungseinstellungen ab</translation></message>
    <message><source>The port belongs to root. This command grants access until the port is unplugged: {0}</source>
        <translation>Er gehört root; dieser Befehl öffnet ihn bis zum Ausstecken: {0}</translation></message>
    <message><source>none</source>
        <translation>keine</translation></message>
    <message><source>another program</source>
        <translation>einem anderen Programm</translation></message>
    <message><source>the server does not use RFC 2217</source>
        <translation>was der Server sendet, ist nicht RFC 2217</translation></message>
    <message><source>the port accepts no data</source>
        <translation>der Port nimmt nichts an</translation></message>
    <message><source>the port cannot be set to {0}</source>
        <translation>der Port lässt sich nicht auf {0} einstellen</translation></message>
    <message><source>The device sends data without being queried ({0} …).</source>
        <translation>Das Gerät sendet ohne Anfrage ({0} …).</translation></message>
    <message><source>even parity</source>
        <translation>gerade Parität</translation></message>
    <message><source>odd parity</source>
        <translation>ungerade Parität</translation></message>
    <message><source>2 stop bits</source>
        <translation>2 Stoppbits</translation></message>
    <message><source>no error detection</source>
        <translation>keine Fehlererkennung</translation></message>
    <message><source>1 stop bit</source>
        <translation>1 Stoppbit</translation></message>
    <message><source>{0} baud, {1}, {2}</source>
        <translation>{0} Baud, {1}, {2}</translation></message>
    <message><source>{0} at {1}</source>
        <translation>{0} bei {1}</translation></message>
    <message><source>{0} baud</source>
        <translation>{0} Baud</translation></message>
    <message><source>Opened {0}.</source>
        <translation>{0} geöffnet.</translation></message>
    <message><source>this is not a traffic log from the Traffic page or from trexcmd --traffic</source>
        <translation>dies ist kein Datenverkehrsprotokoll: Solche schreiben die Seite „Datenverkehr“ und trexcmd --traffic</translation></message>
    <message><source>this is not a row of a traffic log</source>
        <translation>dies ist keine Zeile eines Datenverkehrsprotokolls</translation></message>
    <message><source>{0} cannot be written: {1}.</source>
        <translation>{0} kann nicht geschrieben werden: {1}.</translation></message>
    <message><source>Other users of this computer can read your secrets. Prevent this with the command: chmod 600 “{0}”</source>
        <translation>Andere Benutzer dieses Rechners können die Geheimnisse lesen: chmod 600 „{0}“.</translation></message>
    <message><source>{0} does not have the form trex://host/name, such as trex://robot.local/arm.</source>
        <translation>{0} ist nicht trex://Rechner/Name, etwa trex://robot.local/arm.</translation></message>
    <message><source>{0}: {1!r} is not a kind of port; try socket:// or rfc2217://.</source>
        <translation>{0}: Eine Portart {1!r} gibt es nicht; versuchen Sie socket:// oder rfc2217://.</translation></message>
    <message><source>{0} does not have the form {1}://host:port, such as {1}://192.168.1.20:2217.</source>
        <translation>{0} hat nicht die Form {1}://host:port, zum Beispiel {1}://192.168.1.20:2217.</translation></message>
    <message><source>{0} is not the name of a host, such as robot.local.</source>
        <translation>{0} ist kein Rechner, etwa robot.local.</translation></message>
    <message><source>Opening this port reset the board. The board responds again after about a second.</source>
        <translation>Das Öffnen dieses Ports hat das Board zurückgesetzt: Es antwortet etwa eine Sekunde später.</translation></message>
    <message><source>Aracna {0}</source>
        <translation>Aracna {0}</translation></message>
    <message><source>No probe for an Aracna was sent on {0}: the baud rate is set at the other end of the network, and a TReX at another rate could mistake the probe for a command. If you know that the device is an Aracna, connect once with: trex-gui --device aracna --port {1}</source>
        <translation>An {0} wurde keine Anfrage an einen Aracna gesendet: Die Baudrate ist am anderen Ende des Netzwerks eingestellt, und ein TReX mit einer anderen Baudrate könnte die Anfrage für einen Befehl halten. Wenn Sie wissen, dass es ein Aracna ist, verbinden Sie einmal mit: trex-gui --device aracna --port {1}</translation></message>
    <message><source>No probe for an Aracna was sent: {0} cannot be set to {1}.</source>
        <translation>Es wurde keine Anfrage an einen Aracna gesendet: {0} lässt sich nicht auf {1} einstellen.</translation></message>
    <message><source>Rename {0}</source>
        <translation>{0} umbenennen</translation></message>
    <message><source>Duplicate {0}</source>
        <translation>{0} duplizieren</translation></message>
    <message><source>Delete {0}</source>
        <translation>{0} löschen</translation></message>
    <message><source>Move {0}</source>
        <translation>{0} verschieben</translation></message>
    <message><source>pose</source>
        <translation>Pose</translation></message>
    <message><source>Add pose {0}</source>
        <translation>Pose {0} hinzufügen</translation></message>
    <message><source>Change pose {0}</source>
        <translation>Pose {0} ändern</translation></message>
    <message><source>sequence</source>
        <translation>Sequenz</translation></message>
    <message><source>Change sequence {0}</source>
        <translation>Sequenz {0} ändern</translation></message>
    <message><source>Add sequence {0}</source>
        <translation>Sequenz {0} hinzufügen</translation></message>
    <message><source>Motor {0}</source>
        <translation>Motor {0}</translation></message>
    <message><source>The recording ends here.</source>
        <translation>Die Aufzeichnung endet hier.</translation></message>
    <message><source>Recording {0} ended because the connection was closed.</source>
        <translation>Aufzeichnung {0} endete mit der Verbindung.</translation></message>
    <message><source>Recording {0} ended: the number of motors has changed.</source>
        <translation>Aufzeichnung {0} beendet: Die Anzahl der Motoren hat sich geändert.</translation></message>
    <message numerus="yes"><source>%n time(s)</source>
        <translation><numerusform>%n-mal</numerusform><numerusform>%n-mal</numerusform></translation></message>
    <message><source>repeating</source>
        <translation>endlos</translation></message>
    <message><source>slowly to the start</source>
        <translation>langsam zum Start</translation></message>
    <message><source>A running motion continues to its goal.</source>
        <translation>Eine laufende Bewegung geht bis zu ihrem Ziel weiter.</translation></message>
    <message><source>No robot is connected.</source>
        <translation>Es ist kein Roboter verbunden.</translation></message>
    <message numerus="yes"><source>Connected to Aracna: firmware {0}, %n motor(s).</source>
        <translation><numerusform>Mit Aracna verbunden: Firmware {0}, %n Motor.</numerusform><numerusform>Mit Aracna verbunden: Firmware {0}, %n Motoren.</numerusform></translation></message>
    <message><source>The board has restarted; it is ready again in a second …</source>
        <translation>Das Board wurde neu gestartet; es ist in einer Sekunde wieder bereit …</translation></message>
    <message><source>The robot is not responding. Is its power on? Waiting for it …</source>
        <translation>Der Roboter antwortet nicht. Ist er eingeschaltet? Es wird auf ihn gewartet …</translation></message>
    <message numerus="yes"><source>Clamped to the limits of the joints: %n step(s).</source>
        <translation><numerusform>Auf die Gelenkgrenzen begrenzt: %n Schritt.</numerusform><numerusform>Auf die Gelenkgrenzen begrenzt: %n Schritte.</numerusform></translation></message>
    <message><source>Speeds not set: {0}</source>
        <translation>Geschwindigkeiten nicht gesetzt: {0}</translation></message>
    <message><source>LED not switched: {0}</source>
        <translation>LED nicht geschaltet: {0}</translation></message>
    <message><source>Not moved: {0}</source>
        <translation>Nicht bewegt: {0}</translation></message>
    <message><source>Aborted: {0}</source>
        <translation>Abgebrochen: {0}</translation></message>
    <message><source>Move to {0}.</source>
        <translation>Bewegung nach {0}.</translation></message>
    <message numerus="yes"><source>Playing %n step(s), {0}.</source>
        <translation><numerusform>%n Schritt wird abgespielt, {0}.</numerusform><numerusform>%n Schritte werden abgespielt, {0}.</numerusform></translation></message>
    <message><source>Nothing more is sent.</source>
        <translation>Es wird nichts mehr gesendet.</translation></message>
    <message><source>Solid lines: last reported positions. Dashed lines: goals. In this sketch, all angles are drawn flat.</source>
        <translation>Durchgezogene Linien: zuletzt gemeldet; gestrichelt: Ziel. Eine Skizze: Winkel sind flach gezeichnet.</translation></message>
    <message><source>The order of the legs is assumed. Even motors are inner joints, odd motors are outer joints.</source>
        <translation>Welches Bein welches ist, ist angenommen; Motoren mit gerader Nummer sind innere Gelenke, solche mit ungerader äußere.</translation></message>
    <message><source>The motion ends by itself in about {0:.1f} s.</source>
        <translation>Die Bewegung endet in etwa {0:.1f} s von selbst.</translation></message>
    <message><source>Playing step {0} of {1} “{2}”, round {3} of {4}.</source>
        <translation>Schritt {0} von {1} „{2}“ läuft, Durchlauf {3} von {4}.</translation></message>
    <message><source>Check its power and the cable.</source>
        <translation>Prüfen Sie seine Stromversorgung und das Kabel.</translation></message>
    <message><source>unlimited</source>
        <translation>unbegrenzt</translation></message>
    <message><source>The reply was lost, or no motor responds. The positions are unknown.</source>
        <translation>Die Antwort ging verloren (oder kein Motor reagiert): Die Positionen sind nicht bekannt.</translation></message>
    <message><source>Unknown: a motion may continue for about {0:.0f} s.</source>
        <translation>Unbekannt: Eine Bewegung kann noch etwa {0:.0f} s weiterlaufen.</translation></message>
    <message><source>Nothing is sent. The robot may be moving: its state is unknown until its first move.</source>
        <translation>Es wird nichts gesendet. Ob er sich bewegt, ist bis zu seiner ersten Bewegung unbekannt.</translation></message>
    <message><source>The robot does not respond.</source>
        <translation>Der Roboter antwortet nicht.</translation></message>
    <message><source>Check the servo power, the cable, and whether the servo is blocked. Resetting the board ends the wait, but does not stop the servos.</source>
        <translation>Prüfen Sie Servoversorgung, Kabel und ob er blockiert ist. Ein Reset des Boards beendet das Warten; die Servos stoppt er nicht.</translation></message>
    <message><source>Motor {0}, {1} leg</source>
        <translation>Motor {0}, Bein {1}</translation></message>
    <message><source>stuck here</source>
        <translation>hängt hier</translation></message>
    <message><source>no reply (−1)</source>
        <translation>keine Antwort (−1)</translation></message>
    <message><source>At rest: nothing is sent.</source>
        <translation>In Ruhe: Es wird nichts gesendet.</translation></message>
    <message><source>Unknown: the last motion may still be running.</source>
        <translation>Unbekannt: Die letzte Bewegung läuft vielleicht noch.</translation></message>
    <message><source>The sequence starts.</source>
        <translation>Die Sequenz beginnt.</translation></message>
    <message><source>Playing blend-in.</source>
        <translation>Einblendung läuft.</translation></message>
    <message><source>Playing blend-out.</source>
        <translation>Ausblendung läuft.</translation></message>
    <message><source>Clamped to the limits of the joints: {0}.</source>
        <translation>Auf die Gelenkgrenzen begrenzt: {0}.</translation></message>
    <message><source>The board has restarted. Its servos continue to their goals.</source>
        <translation>Das Board wurde neu gestartet. Seine Servos bewegen sich weiter zu ihren Zielen.</translation></message>
    <message><source>outer</source>
        <translation>außen</translation></message>
    <message><source>inner</source>
        <translation>innen</translation></message>
    <message><source>moving …</source>
        <translation>bewegt sich …</translation></message>
    <message><source>Playing step {0}, round {1}.</source>
        <translation>Schritt {0} läuft, Durchlauf {1}.</translation></message>
    <message><source>motor {0} to {1} instead of {2}</source>
        <translation>Motor {0} auf {1} statt {2}</translation></message>
    <message><source>missed by {0}</source>
        <translation>{0} verfehlt</translation></message>
    <message><source>Waiting for motor {0} to arrive …</source>
        <translation>Warten, bis Motor {0} ankommt …</translation></message>
    <message><source>Lies down flat in 3 s and stands up in 3 s, from any position.</source>
        <translation>Legt sich in 3 s flach hin und steht in 3 s auf, aus jeder Stellung.</translation></message>
    <message><source>Lifts two opposite legs, swings the other two, changes over and swings them back.</source>
        <translation>Hebt zwei gegenüberliegende Beine, schwenkt die anderen beiden, wechselt und schwenkt sie zurück.</translation></message>
    <message><source>Moves all motors together, up to 100 units to either side of the centre.</source>
        <translation>Alle Motoren gemeinsam, 100 Einheiten um die Mitte.</translation></message>
    <message><source>Moves back and forth between two poses; a motor that ends more than 50 units from its goal is suspect.</source>
        <translation>Zwischen zwei Posen hin und her; Motoren, die mehr als 50 Einheiten abweichen, sind verdächtig.</translation></message>
    <message><source>Moves down to half-stand and up again.</source>
        <translation>Hinunter in „half-stand“ und wieder hinauf.</translation></message>
    <message><source>Moves through half-stand to flat, from any position.</source>
        <translation>Über „half-stand“ nach „flat“, aus jeder Stellung.</translation></message>
    <message><source>The poses are for {0} motors, but the robot has {1}: the last positions are ignored.</source>
        <translation>Die Posen sind für {0} Motoren, der Roboter hat {1}: Die letzten Positionen werden weggelassen.</translation></message>
    <message><source>The poses are for {0} motors, but the robot has {1}: the remaining motors go to {2}.</source>
        <translation>Die Posen sind für {0} Motoren, der Roboter hat {1}: Seine letzten Motoren gehen auf {2}.</translation></message>
    <message><source>{0} uses poses that are not defined: {1}</source>
        <translation>{0} verwendet nicht definierte Posen: {1}</translation></message>
    <message><source>{0} has no steps</source>
        <translation>{0} hat keine Schritte</translation></message>
    <message><source>the first line should contain the name of the robot and the number of servos; assuming 8 servos</source>
        <translation>die erste Zeile sollte den Roboter und seine Servos nennen; angenommen werden 8 Servos</translation></message>
    <message><source>poses</source>
        <translation>Posen</translation></message>
    <message><source>this is neither a pose nor a sequence: there is no colon</source>
        <translation>weder Pose noch Sequenz: Der Doppelpunkt fehlt</translation></message>
    <message><source>a sequence needs a colon after its name</source>
        <translation>eine Sequenz hat einen Doppelpunkt nach ihrem Namen</translation></message>
    <message><source>this text is not in UTF-8; it was read as Western European, and will be saved as UTF-8</source>
        <translation>dies ist kein UTF-8-Text; er wird als westeuropäisch gelesen, und „Speichern“ schreibt UTF-8</translation></message>
    <message><source>this is a binary file, but pose files contain text</source>
        <translation>dies ist eine Binärdatei; Posen sind Text</translation></message>
    <message><source>{0} resolutions are expected; assuming {1} for every servo</source>
        <translation>{0} Auflösungen werden erwartet; angenommen wird {1} für jedes Servo</translation></message>
    <message><source>pose {0} has only {1} of {2} positions; the missing positions become {3}</source>
        <translation>Pose {0} hat {1} von {2} Positionen; fehlende werden zu {3}</translation></message>
    <message><source>pose {0}: positions must be numbers from 0 to {1}, not {2!r} (motor {3})</source>
        <translation>Pose {0}: Positionen sind Zahlen von 0 bis {1}, nicht {2!r} (Motor {3})</translation></message>
    <message><source>sequence {0}: a step must be a pose, a bar and {1} to {2} ms, not {3!r}</source>
        <translation>Sequenz {0}: Ein Schritt ist eine Pose, ein senkrechter Strich und {1} bis {2} ms, nicht {3!r}</translation></message>
    <message><source>pose {0} has {1} positions for {2} servos; the last positions are kept, but not used</source>
        <translation>Pose {0} hat {1} Positionen für {2} Servos; die letzten bleiben erhalten, werden aber nicht verwendet</translation></message>
    <message><source>line {0} defines this {1} again and takes precedence; the name in this line becomes {2}</source>
        <translation>Zeile {0} enthält diese {1} noch einmal und gilt; diese hier heißt jetzt {2}</translation></message>
    <message><source>sequence {0} uses the pose {1}, which is not in the file</source>
        <translation>Sequenz {0} verwendet die Pose {1}, die nicht in der Datei steht</translation></message>
    <message><source>a {0} needs a name before the colon</source>
        <translation>vor dem Doppelpunkt fehlt der Name ({0})</translation></message>
    <message><source>{0}; the line is kept, but not used</source>
        <translation>{0}; die Zeile bleibt erhalten, wird aber nicht verwendet</translation></message>
    <message><source>a name must have 1 to {0} printable characters, without colon, comma or bar</source>
        <translation>ein Name hat 1 bis {0} druckbare Zeichen und weder Doppelpunkt noch Komma noch senkrechten Strich</translation></message>
    <message><source>the name {0} is taken</source>
        <translation>der Name {0} ist schon vergeben</translation></message>
    <message><source>the speed of motor {0} must be 0 to {1}, not {2}</source>
        <translation>die Geschwindigkeit von Motor {0} ist 0 bis {1}, nicht {2}</translation></message>
    <message><source>the position of motor {0} must be 0 to {1}, not {2}</source>
        <translation>die Position von Motor {0} ist 0 bis {1}, nicht {2}</translation></message>
    <message><source>{0} motors need {0} values, not {1}</source>
        <translation>{0} Motoren brauchen {0} Werte, nicht {1}</translation></message>
    <message><source>Front left</source>
        <translation>Vorn links</translation></message>
    <message><source>Front right</source>
        <translation>Vorn rechts</translation></message>
    <message><source>Back right</source>
        <translation>Hinten rechts</translation></message>
    <message><source>Back left</source>
        <translation>Hinten links</translation></message>
    <message><source>limits must be 0 to {0}, the lower one first, not {1} to {2}</source>
        <translation>Grenzen sind 0 bis {0} in aufsteigender Reihenfolge, nicht {1} bis {2}</translation></message>
    <message><source>No Aracna responds on {0}. If the robot is moving, wait until it stops: it does not listen while it moves. Check that the robot's board has power, that the adapter's TX is connected to the board's RX and the adapter's RX to the board's TX (or that both radios are on the same channel), and that ground is connected.</source>
        <translation>An {0} antwortet kein Aracna. Während einer Bewegung hört er nicht zu: Falls er sich bewegt, warten Sie, bis er stillsteht. Prüfen Sie, ob das Board des Roboters Strom hat, ob TX des Adapters mit dessen RX und RX mit dessen TX verbunden ist (oder ob beide Funkmodule auf demselben Kanal sind) und ob Masse verbunden ist.</translation></message>
    <message><source>No Aracna responds on {0}: everything sent comes back, and nothing else arrives. The adapter's TX and RX are joined; an Aracna never echoes.</source>
        <translation>An {0} antwortet kein Aracna: Alles Gesendete kommt zurück, und sonst nichts. TX und RX des Adapters sind verbunden; ein Aracna sendet nie ein Echo.</translation></message>
    <message><source>An Aracna on {0} reports that it has started, but does not respond afterwards. It may be restarting repeatedly. Check its power supply.</source>
        <translation>Ein Aracna an {0} meldet, dass er startet, antwortet danach aber nicht. Vielleicht startet er immer wieder neu: Prüfen Sie seine Stromversorgung.</translation></message>
    <message><source>A reply arrived on {0}, but not from an Aracna: {1}. The cause may be another device, perhaps a TReX at another baud rate, or interference on the line.</source>
        <translation>An {0} antwortet etwas, aber nicht wie ein Aracna: {1}. Ein anderes Gerät, vielleicht ein TReX mit anderer Baudrate, oder Störungen auf der Leitung.</translation></message>
    <message><source>The robot has not replied yet. Wait until it responds, then try again.</source>
        <translation>Der Roboter hat noch nicht geantwortet; er wird noch abgefragt.</translation></message>
    <message><source>The robot has not yet replied to the last command.</source>
        <translation>Nur ein Befehl auf einmal: Der Roboter hat auf den letzten noch nicht geantwortet.</translation></message>
    <message><source>The robot did not reply in time.</source>
        <translation>Der Roboter hat nicht rechtzeitig geantwortet.</translation></message>
    <message><source>The reply does not match the command: {0}.</source>
        <translation>Die Antwort passt nicht zum Befehl: {0}.</translation></message>
    <message><source>The robot is waiting for motor {0} and reads no commands until this motor responds.</source>
        <translation>Der Roboter wartet auf Motor {0} und liest nichts, bis dieser reagiert.</translation></message>
    <message><source>The robot is stuck: nothing was sent.</source>
        <translation>Der Roboter hängt: Es wurde nichts gesendet.</translation></message>
    <message><source>Motor {0} did not accept speed {1}; it still has speed {2}.</source>
        <translation>Motor {0} hat Geschwindigkeit {1} nicht angenommen; er hat noch Geschwindigkeit {2}.</translation></message>
    <message><source>Motor {0} did not accept speed {1}: it does not respond.</source>
        <translation>Motor {0} hat Geschwindigkeit {1} nicht angenommen: Er reagiert nicht.</translation></message>
    <message><source>No motor accepted its speed. Check the servo power.</source>
        <translation>Kein Motor hat seine Geschwindigkeit angenommen. Prüfen Sie die Servoversorgung.</translation></message>
    <message><source>The robot did not confirm its speeds, so no motor was moved. {0}</source>
        <translation>Der Roboter hat seine Geschwindigkeiten nicht bestätigt, daher wurde kein Motor bewegt. {0}</translation></message>
    <message><source>{0} The motor is blocked, or servo power was off. Remove the cause, then play the sequence again.</source>
        <translation>{0} Er ist blockiert, oder die Servoversorgung war aus. Die Sequenz wird nicht von selbst fortgesetzt.</translation></message>
    <message><source>Motor {0} is at {1}, {2} from its goal {3}.</source>
        <translation>Motor {0} steht auf {1}, {2} von seinem Ziel {3} entfernt.</translation></message>
    <message><source>Motor {0} did not report its position (−1).</source>
        <translation>Motor {0} hat seine Position nicht gemeldet (−1).</translation></message>
    <message><source>A sequence is playing: stop it first.</source>
        <translation>Eine Sequenz läuft: Stoppen Sie sie zuerst.</translation></message>
    <message><source>A newer request replaced this one.</source>
        <translation>Ein neuerer Auftrag hat diesen ersetzt.</translation></message>
    <message><source>Stopped before the command was sent.</source>
        <translation>Vor dem Senden gestoppt.</translation></message>
    <message><source>The robot's board has restarted.</source>
        <translation>Das Board des Roboters wurde neu gestartet.</translation></message>
    <message><source>Another robot now responds on this port.</source>
        <translation>An diesem Port antwortet jetzt ein anderer Roboter.</translation></message>
    <message><source>The robot stopped responding.</source>
        <translation>Der Roboter antwortet nicht mehr.</translation></message>
    <message><source>The connection was closed before the request was complete.</source>
        <translation>Die Verbindung wurde geschlossen, bevor dies erledigt war.</translation></message>
    <message><source>Internal error in the connection: {0}</source>
        <translation>Interner Fehler in der Verbindung: {0}</translation></message>
    <message><source>Played to the end.</source>
        <translation>Bis zum Ende abgespielt.</translation></message>
    <message><source>The sequence ended after the current step.</source>
        <translation>Die Sequenz wurde nach ihrem Schritt beendet.</translation></message>
    <message><source>The sequence was stopped.</source>
        <translation>Die Sequenz wurde gestoppt.</translation></message>
    <message><source>The sequence was aborted: the board has restarted.</source>
        <translation>Die Sequenz wurde abgebrochen: Das Board wurde neu gestartet.</translation></message>
    <message><source>The sequence was aborted: the robot is waiting for a motor.</source>
        <translation>Die Sequenz wurde abgebrochen: Der Roboter wartet auf einen Motor.</translation></message>
    <message><source>The sequence was aborted: a motor did not accept its speed.</source>
        <translation>Die Sequenz wurde abgebrochen: Ein Motor hat seine Geschwindigkeit nicht angenommen.</translation></message>
    <message><source>The sequence was aborted: a motor was far from its goal.</source>
        <translation>Die Sequenz wurde abgebrochen: Ein Motor war weit von seinem Ziel entfernt.</translation></message>
    <message><source>The sequence was aborted: the robot does not respond.</source>
        <translation>Die Sequenz wurde abgebrochen: Der Roboter antwortet nicht.</translation></message>
    <message><source>A robot with {0} motors cannot play this sequence.</source>
        <translation>Ein Roboter mit {0} Motoren kann das nicht abspielen.</translation></message>
    <message><source>query version and motors</source>
        <translation>Version und Motoren abfragen</translation></message>
    <message><source>switch the debug LED on</source>
        <translation>die Debug-LED einschalten</translation></message>
    <message><source>switch the debug LED off</source>
        <translation>die Debug-LED ausschalten</translation></message>
    <message><source>end an unfinished line in the robot's buffer</source>
        <translation>eine unvollständige Zeile im Puffer des Roboters abschließen</translation></message>
    <message><source>not an Aracna command</source>
        <translation>kein Befehl eines Aracna</translation></message>
    <message><source>the robot has started and is busy for a second</source>
        <translation>der Roboter ist gestartet, eine Sekunde lang beschäftigt</translation></message>
    <message><source>{0}, then query whether the robot is free</source>
        <translation>{0}, dann Abfrage, ob er frei ist</translation></message>
    <message><source>no reply</source>
        <translation>keine Antwort</translation></message>
    <message><source>incomplete reply</source>
        <translation>unvollständige Antwort</translation></message>
    <message><source>no reply to the command itself</source>
        <translation>keine Antwort auf den Befehl selbst</translation></message>
    <message><source>1 motor</source>
        <translation>1 Motor</translation></message>
    <message><source>the LED is on</source>
        <translation>die LED ist an</translation></message>
    <message><source>the LED is off</source>
        <translation>die LED ist aus</translation></message>
    <message><source>go to {0}</source>
        <translation>bewegen nach {0}</translation></message>
    <message><source>set speeds {0}</source>
        <translation>Geschwindigkeiten setzen: {0}</translation></message>
    <message><source>unsolicited: {0}</source>
        <translation>unaufgefordert: {0}</translation></message>
    <message><source>firmware {0}, {1}</source>
        <translation>Firmware {0}, {1}</translation></message>
    <message><source>firmware {0}</source>
        <translation>Firmware {0}</translation></message>
    <message><source>speeds {0}</source>
        <translation>Geschwindigkeiten {0}</translation></message>
    <message><source>at {0}</source>
        <translation>steht auf {0}</translation></message>
    <message><source>not a reply from an Aracna: {0}</source>
        <translation>keine Antwort eines Aracna: {0}</translation></message>
    <message><source>incomplete line: {0}</source>
        <translation>unvollständige Zeile: {0}</translation></message>
    <message><source>{0} motors</source>
        <translation>{0} Motoren</translation></message>
    <message><source>followed by {0}</source>
        <translation>gefolgt von {0}</translation></message>
    <message><source>Percentage of bytes that are corrupted, in both directions. The protocol does not detect corrupted bytes, and a corrupted command may restart the firmware.</source>
        <translation>Dieser Anteil der Bytes wird in beiden Richtungen verfälscht; dieses Protokoll erkennt das nicht, und ein verfälschter Befehl kann die Firmware neu starten</translation></message>
    <message><source>A command that loses a byte may have too few values, which restarts the firmware</source>
        <translation>Ein verlorenes Byte eines Befehls kann zu wenige Werte darin lassen; das startet die Firmware neu</translation></message>
    <message><source>To stop a motion, switch off the servo power: the protocol has no stop command.</source>
        <translation>Die einzige Möglichkeit, eine Bewegung zu stoppen: Das Protokoll hat keinen Stoppbefehl.</translation></message>
    <message><source>The debug LED; it blinks while the firmware boots</source>
        <translation>Die Debug-LED; sie blinkt, während die Firmware startet</translation></message>
    <message><source>Power</source>
        <translation>Versorgung</translation></message>
    <message><source>Robot on</source>
        <translation>Roboter ein</translation></message>
    <message><source>The robot's power switch, for board and servos</source>
        <translation>Der Schalter des Roboters selbst: Board und Servos</translation></message>
    <message><source>Restart board</source>
        <translation>Board neu starten</translation></message>
    <message><source>Servo power</source>
        <translation>Servoversorgung</translation></message>
    <message><source>Power of the servos only. Without power, the servos stop, go limp and lose their speeds, and the firmware waits for them.</source>
        <translation>Nur die Versorgung der Servos: Ohne sie stoppen sie, halten nichts und verlieren ihre Geschwindigkeiten; die Firmware wartet auf sie</translation></message>
    <message><source>Dead</source>
        <translation>Tot</translation></message>
    <message><source>Blocked</source>
        <translation>Blockiert</translation></message>
    <message><source>Servos</source>
        <translation>Servos</translation></message>
    <message><source>Real position</source>
        <translation>Wirkliche Position</translation></message>
    <message><source>Cable</source>
        <translation>Kabel</translation></message>
    <message><source>Plugged in</source>
        <translation>Eingesteckt</translation></message>
    <message><source>When the cable is unplugged, the port disappears, but a running motion continues to its goal</source>
        <translation>Ausgesteckt: Der Port verschwindet; eine laufende Bewegung geht bis zu ihrem Ziel weiter</translation></message>
    <message><source>Moving indefinitely: waiting for a servo that is blocked or dead.</source>
        <translation>Bewegt sich endlos: Wartet auf ein Servo, das blockiert oder tot ist.</translation></message>
    <message><source>no power</source>
        <translation>keine Versorgung</translation></message>
    <message><source>Clear all faults</source>
        <translation>Alle Störungen beheben</translation></message>
    <message><source>Noise</source>
        <translation>Störungen</translation></message>
    <message><source>LED: on</source>
        <translation>LED: an</translation></message>
    <message><source>LED: off</source>
        <translation>LED: aus</translation></message>
    <message><source>LED: blinks</source>
        <translation>LED: blinkt</translation></message>
    <message><source>Robot switched on</source>
        <translation>Roboter eingeschaltet</translation></message>
    <message><source>Reset the board: the firmware restarts, but the servos continue to their goals</source>
        <translation>Die Reset-Leitung: Die Firmware startet neu, die Servos bewegen sich weiter zu ihren Zielen</translation></message>
    <message><source>{0}: real position</source>
        <translation>{0}: wirkliche Position</translation></message>
    <message><source>Cable plugged in</source>
        <translation>Kabel eingesteckt</translation></message>
    <message><source>The return wire is broken: the robot executes commands, but no reply arrives</source>
        <translation>Die Rückleitung ist unterbrochen: Der Roboter führt Befehle aus, es kommt keine Antwort an</translation></message>
    <message><source>Moving indefinitely: waiting for servos that have no power.</source>
        <translation>Bewegt sich endlos: Wartet auf Servos, die keine Versorgung haben.</translation></message>
    <message><source>The power is off: the robot does not reply, and no servo holds its position.</source>
        <translation>Die Versorgung ist aus: keine Antwort, und kein Servo hält.</translation></message>
    <message><source>Booting: blinks for a second and reads nothing.</source>
        <translation>Startet: Blinkt eine Sekunde lang und liest nichts.</translation></message>
    <message><source>Idle: waiting for commands.</source>
        <translation>Untätig: Wartet auf Befehle.</translation></message>
    <message><source>Setting speeds and reading them back from the servos.</source>
        <translation>Setzt Geschwindigkeiten: Liest sie aus den Servos zurück.</translation></message>
    <message><source>Moving: reads nothing until every servo has arrived.</source>
        <translation>Bewegt sich: Liest nichts, bis jedes Servo angekommen ist.</translation></message>
    <message><source>The robot's switch is off: board and servos have no power.</source>
        <translation>Der Schalter des Roboters ist aus: Board und Servos haben keine Versorgung.</translation></message>
    <message><source>Servo power is off: no servo moves, holds its position or replies.</source>
        <translation>Aus: Kein Servo bewegt sich, hält oder antwortet.</translation></message>
    <message><source>dead</source>
        <translation>tot</translation></message>
    <message><source>Number of times that the firmware has started</source>
        <translation>Wie oft die Firmware gestartet ist</translation></message>
    <message><source>Repair and free every servo, clear all line faults, and switch everything on</source>
        <translation>Servos intakt, frei und unbelastet, Leitung ungestört, alles eingeschaltet</translation></message>
    <message><source>{0} does not respond, as if it were unplugged: its speed reads as −1, and a move waits indefinitely</source>
        <translation>{0} reagiert nicht, wie ausgesteckt: Geschwindigkeiten werden als −1 gelesen, und eine Bewegung wartet endlos darauf</translation></message>
    <message><source>{0} is blocked: it remains “moving”, and the firmware waits</source>
        <translation>Etwas blockiert {0}: Es bleibt „in Bewegung“, und die Firmware wartet</translation></message>
    <message><source>Simulated loss</source>
        <translation>Zu simulierender Verlust</translation></message>
    <message><source>Lose</source>
        <translation>Verlieren</translation></message>
    <message><source>Takes effect in the next transfer</source>
        <translation>Wirkt bei der nächsten Übertragung</translation></message>
    <message><source>limp until its first goal</source>
        <translation>kraftlos bis zum ersten Ziel</translation></message>
    <message><source>Starts: {0}</source>
        <translation>Starts: {0}</translation></message>
    <message><source>{0}: dead</source>
        <translation>{0}: tot</translation></message>
    <message><source>{0}: blocked</source>
        <translation>{0}: blockiert</translation></message>
    <message><source>Reply byte</source>
        <translation>Antwortbyte</translation></message>
    <message><source>Command byte</source>
        <translation>Befehlsbyte</translation></message>
    <message><source>End of reply</source>
        <translation>Antwort: Ende</translation></message>
    <message><source>holds</source>
        <translation>hält</translation></message>
    <message><source>cannot reach {0}</source>
        <translation>kann {0} nicht erreichen</translation></message>
    <message><source>moving to {0}</source>
        <translation>bewegt sich nach {0}</translation></message>
    <message><source>This link has no stop command: a running motion ends by itself or when the servo power is cut.</source>
        <translation>Diese Verbindung kennt keinen Stopp: Eine laufende Bewegung endet nur von selbst oder durch Trennen der Servoversorgung.</translation></message>
    <message><source>End the sequence and send nothing more. A running motion continues to its goal. (Esc, anywhere)</source>
        <translation>Die Sequenz beenden, nichts mehr senden, den Roboter dort lassen, wo er ist (Esc, überall)</translation></message>
    <message><source>End afte&amp;r this step</source>
        <translation>Nach diesem Schritt &amp;beenden</translation></message>
    <message><source>&amp;Stop sequence</source>
        <translation>&amp;Sequenz stoppen</translation></message>
    <message><source>Let the step finish, then blend out</source>
        <translation>Den Schritt zu Ende führen, dann ausblenden</translation></message>
    <message><source>Plot of the motors' positions against time</source>
        <translation>Diagramm der Motorpositionen über der Zeit</translation></message>
    <message numerus="yes"><source>Aracna, firmware {0}, %n motor(s)</source>
        <translation><numerusform>Aracna, Firmware {0}, %n Motor</numerusform><numerusform>Aracna, Firmware {0}, %n Motoren</numerusform></translation></message>
    <message><source>Curve</source>
        <translation>Kurve</translation></message>
    <message><source>Present</source>
        <translation>Ist</translation></message>
    <message><source>Goal</source>
        <translation>Ziel</translation></message>
    <message><source>Difference</source>
        <translation>Abweichung</translation></message>
    <message><source>Speed</source>
        <translation>Geschwindigkeit</translation></message>
    <message><source>Draw the position of this motor in the plot</source>
        <translation>Die Position dieses Motors im Diagramm zeichnen</translation></message>
    <message><source>&amp;Save pose file</source>
        <translation>Posendatei &amp;speichern</translation></message>
    <message><source>&amp;Open pose file…</source>
        <translation>&amp;Posendatei öffnen…</translation></message>
    <message><source>Not saved. {0}.</source>
        <translation>Nicht gespeichert. {0}.</translation></message>
    <message><source>Pose files (*{0});;All files (*)</source>
        <translation>Posendateien (*{0});;Alle Dateien (*)</translation></message>
    <message><source>Not opened. {0}.</source>
        <translation>Nicht geöffnet. {0}.</translation></message>
    <message><source>{0} was opened.</source>
        <translation>{0} wurde geöffnet.</translation></message>
    <message><source>Saved in {0}.</source>
        <translation>Gespeichert in {0}.</translation></message>
    <message><source>And {0} more.</source>
        <translation>Und {0} weitere.</translation></message>
    <message><source>Sequences and gaits</source>
        <translation>Sequenzen und Gangarten</translation></message>
    <message><source>New sequence</source>
        <translation>Neue Sequenz</translation></message>
    <message><source>Select a sequence; built-in gaits cannot be changed</source>
        <translation>Wählen Sie eine Sequenz; eingebaute Gangarten lassen sich nicht ändern</translation></message>
    <message><source>There are no poses</source>
        <translation>Es gibt keine Posen</translation></message>
    <message><source>A step cannot use “{0}”: remove commas and vertical bars from the pose's name</source>
        <translation>Ein Schritt kann „{0}“ nicht verwenden: Entfernen Sie Kommas und senkrechte Striche aus dem Namen der Pose</translation></message>
    <message><source>Steps</source>
        <translation>Schritte</translation></message>
    <message><source>Delete</source>
        <translation>Löschen</translation></message>
    <message><source>Move up</source>
        <translation>Nach oben</translation></message>
    <message><source>Move down</source>
        <translation>Nach unten</translation></message>
    <message><source>Select a sequence or a gait to see its steps.</source>
        <translation>Wählen Sie eine Sequenz oder eine Gangart, um ihre Schritte zu sehen.</translation></message>
    <message><source>{0} ms</source>
        <translation>{0} ms</translation></message>
    <message><source>&amp;New</source>
        <translation>&amp;Neu</translation></message>
    <message><source>Add s&amp;tep</source>
        <translation>Schritt hin&amp;zufügen</translation></message>
    <message><source>Add a step with the pose “{0}” after the current step</source>
        <translation>Einen Schritt zu „{0}“ nach dem aktuellen hinzufügen</translation></message>
    <message><source> ms</source>
        <translation> ms</translation></message>
    <message><source>Step</source>
        <translation>Schritt</translation></message>
    <message><source>Pose</source>
        <translation>Pose</translation></message>
    <message><source>Time</source>
        <translation>Zeit</translation></message>
    <message><source>Remarks</source>
        <translation>Bemerkungen</translation></message>
    <message><source>No steps yet. “Add step” adds a step with the current pose.</source>
        <translation>Noch keine Schritte. Fügen Sie einen hinzu: Er verwendet die aktuelle Pose.</translation></message>
    <message><source>Milliseconds of step {0}</source>
        <translation>Millisekunden von Schritt {0}</translation></message>
    <message><source>Pose of step {0}</source>
        <translation>Pose von Schritt {0}</translation></message>
    <message><source>Uses the authors' poses, but was not made by them.</source>
        <translation>Nutzt die Posen der Autoren, stammt aber nicht von ihnen.</translation></message>
    <message><source>Rename</source>
        <translation>Umbenennen</translation></message>
    <message><source>Duplicate</source>
        <translation>Duplizieren</translation></message>
    <message><source>&amp;Delete…</source>
        <translation>&amp;Löschen…</translation></message>
    <message><source>{0} (built in)</source>
        <translation>{0} (eingebaut)</translation></message>
    <message><source>Not renamed: {0}.</source>
        <translation>Nicht umbenannt: {0}.</translation></message>
    <message><source>Pos&amp;es</source>
        <translation>Pos&amp;en</translation></message>
    <message><source>{0}, changed</source>
        <translation>{0}, geändert</translation></message>
    <message><source>needs {0:.2f} s (motor {1})</source>
        <translation>braucht {0:.2f} s: Motor {1}</translation></message>
    <message numerus="yes"><source>%n step(s)</source>
        <translation><numerusform>%n Schritt</numerusform><numerusform>%n Schritte</numerusform></translation></message>
    <message><source>{0:.1f} s</source>
        <translation>{0:.1f} s</translation></message>
    <message><source>Rounds</source>
        <translation>Durchläufe</translation></message>
    <message><source>Speed in percent</source>
        <translation>Geschwindigkeit in Prozent</translation></message>
    <message><source>&amp;Blend in</source>
        <translation>E&amp;inblenden</translation></message>
    <message><source>B&amp;lend out to stand</source>
        <translation>Ausblenden zu „&amp;stand“</translation></message>
    <message><source>Pla&amp;y</source>
        <translation>Abs&amp;pielen</translation></message>
    <message><source>Play the current sequence or gait.</source>
        <translation>Die aktuelle Sequenz oder Gangart abspielen.</translation></message>
    <message><source>{0}, {1} per round, {2} in total.</source>
        <translation>{0}, {1} pro Durchlauf, {2} insgesamt.</translation></message>
    <message><source>0: repeat until stopped.</source>
        <translation>0: wiederholen, bis gestoppt wird.</translation></message>
    <message><source> %</source>
        <translation> %</translation></message>
    <message><source>Changes during playback take effect from the next step. At 50 %, each step takes twice as long.</source>
        <translation>Auch während des Abspielens, ab dem nächsten Schritt. 50 %: Jeder Schritt dauert doppelt so lange.</translation></message>
    <message><source>Move slowly to the start first, in 3 s.</source>
        <translation>Zuerst langsam, in 3 s, zum Start gehen.</translation></message>
    <message><source>At the end, move slowly to the pose “stand”, in 3 s.</source>
        <translation>Am Ende langsam, in 3 s, in die Pose „stand“ gehen.</translation></message>
    <message><source>Select a sequence or a gait to play it.</source>
        <translation>Wählen Sie eine Sequenz oder eine Gangart, um sie abzuspielen.</translation></message>
    <message><source>Positions outside the limits are clamped.</source>
        <translation>Positionen außerhalb der Grenzen werden begrenzt.</translation></message>
    <message><source>Some motors are too slow.</source>
        <translation>Einige Motoren sind zu langsam.</translation></message>
    <message><source>{0}, {1}.</source>
        <translation>{0}, {1}.</translation></message>
    <message><source>{0}, {1} per round, until stopped.</source>
        <translation>{0}, {1} pro Durchlauf, bis gestoppt wird.</translation></message>
    <message><source>R&amp;ounds</source>
        <translation>D&amp;urchläufe</translation></message>
    <message><source>&amp;Speed</source>
        <translation>Geschwindig&amp;keit</translation></message>
    <message><source>not defined</source>
        <translation>nicht definiert</translation></message>
    <message><source>Cannot play: {0}.</source>
        <translation>Abspielen nicht möglich: {0}.</translation></message>
    <message><source>The robot's position is unknown until its first move.</source>
        <translation>Die Position des Roboters ist nach seiner ersten Bewegung bekannt.</translation></message>
    <message><source>No poses. Capture the robot's position, or open a pose file.</source>
        <translation>Keine Posen. Nehmen Sie die Position des Roboters auf oder öffnen Sie eine Posendatei.</translation></message>
    <message><source>Set this pose to the robot's position</source>
        <translation>Diese Pose auf die Position des Roboters setzen</translation></message>
    <message><source>Capt&amp;ure</source>
        <translation>Aufneh&amp;men</translation></message>
    <message><source>&amp;Go to</source>
        <translation>Pose anfah&amp;ren</translation></message>
    <message><source>Motor {0}: {1:.0f}°, limits {2} to {3}</source>
        <translation>Motor {0}: {1:.0f}°, Grenzen {2} bis {3}</translation></message>
    <message><source>Save the robot's position as a new pose.</source>
        <translation>Die Position des Roboters als neue Pose speichern.</translation></message>
    <message><source>Move every motor to this pose, within its limits.</source>
        <translation>Jeden Motor in diese Pose bewegen, innerhalb seiner Grenzen.</translation></message>
    <message><source>Position of motor {0} in this pose</source>
        <translation>Position von Motor {0} in dieser Pose</translation></message>
    <message><source>Motor {0}: {1:.0f}°, limits {2} to {3}, sent as {4}</source>
        <translation>Motor {0}: {1:.0f}°, Grenzen {2} bis {3}, gesendet als {4}</translation></message>
    <message><source>Requests: {0}. Requests without a reply: {1}.</source>
        <translation>Anfragen: {0}, ohne Antwort: {1}.</translation></message>
    <message><source>Answered</source>
        <translation>Beantwortet</translation></message>
    <message><source>Slowest reply</source>
        <translation>Langsamste Antwort</translation></message>
    <message><source>Motions are not included</source>
        <translation>Ohne Bewegungen</translation></message>
    <message><source>Restarts detected</source>
        <translation>Neustarts</translation></message>
    <message><source>Corrupted replies</source>
        <translation>Verfälschte Antworten</translation></message>
    <message><source>Unrecognized lines</source>
        <translation>Nicht erkannte Zeilen</translation></message>
    <message><source>{0}, active now</source>
        <translation>{0}, jetzt aktiv</translation></message>
    <message><source>The robot from above</source>
        <translation>Der Roboter von oben</translation></message>
    <message><source>Legs at their reported positions, goals dashed; the table shows both as numbers.</source>
        <translation>Beine in den gemeldeten Positionen, Ziele gestrichelt; die Tabelle nennt beides in Zahlen.</translation></message>
    <message><source>front</source>
        <translation>vorn</translation></message>
    <message><source>Present position unknown</source>
        <translation>Istposition unbekannt</translation></message>
    <message><source>Speed setting 1–1023 in steps of 0.669 °/s; 0 means unlimited, not “stopped”. Above about 870 (AX-18A) or 530 (AX-12A) a servo gets no faster.</source>
        <translation>Einstellwert 1-1023 für die Geschwindigkeit, je 0,669 °/s; 0 ist unbegrenzt, nicht „gestoppt“. Über etwa 870 (AX-18A) oder 530 (AX-12A) wird ein Servo nicht schneller.</translation></message>
    <message><source>goal in units</source>
        <translation>Ziel in Einheiten</translation></message>
    <message><source>present position</source>
        <translation>Istposition</translation></message>
    <message><source>lowest position</source>
        <translation>kleinste Position</translation></message>
    <message><source>highest position</source>
        <translation>größte Position</translation></message>
    <message><source>Present position {0}</source>
        <translation>Istposition {0}</translation></message>
    <message><source>goal in degrees</source>
        <translation>Ziel in Grad</translation></message>
    <message><source>state</source>
        <translation>Zustand</translation></message>
    <message><source>speed</source>
        <translation>Geschwindigkeit</translation></message>
    <message><source>goal</source>
        <translation>Ziel</translation></message>
    <message><source>last speed reported by the servo: {0}</source>
        <translation>das Servo hat {0}</translation></message>
    <message><source>Leg*</source>
        <translation>Bein*</translation></message>
    <message><source>The order of the legs is assumed</source>
        <translation>Welches Bein welches ist, ist angenommen</translation></message>
    <message><source>Motor</source>
        <translation>Motor</translation></message>
    <message><source>Handle: the goal. Wedge below: the last reported position.</source>
        <translation>Griff: das Ziel. Keil darunter: die zuletzt gemeldete Position.</translation></message>
    <message><source>Last reported position</source>
        <translation>Zuletzt gemeldete Position</translation></message>
    <message><source>Present position minus goal</source>
        <translation>Istposition minus Ziel</translation></message>
    <message><source>Setting and degrees per second</source>
        <translation>Einstellwert und Grad pro Sekunde</translation></message>
    <message><source>From</source>
        <translation>Von</translation></message>
    <message><source>To</source>
        <translation>Bis</translation></message>
    <message><source>The positions of the motors are unknown.</source>
        <translation>Die Motorpositionen sind unbekannt.</translation></message>
    <message><source>This robot reports positions only in its reply to a move.</source>
        <translation>Dieser Roboter meldet sie nur in seiner Antwort auf eine Bewegung.</translation></message>
    <message><source>The first move runs at speed {0} ({1}) unless you set other speeds.</source>
        <translation>Die erste läuft mit Geschwindigkeit {0} ({1}), falls Sie keine anderen Geschwindigkeiten wählen.</translation></message>
    <message><source>Move every motor to its goal, within its limits (Ctrl+M)</source>
        <translation>Jeden Motor zu seinem Ziel bewegen, innerhalb seiner Grenzen (Strg+M)</translation></message>
    <message><source>The last motion may still be running; the next move will report the positions.</source>
        <translation>Die letzte Bewegung läuft vielleicht noch; die nächste wird sie melden.</translation></message>
    <message><source>Pre&amp;sent</source>
        <translation>&amp;Istposition</translation></message>
    <message><source>Present positions</source>
        <translation>Istpositionen</translation></message>
    <message><source>Ce&amp;ntre</source>
        <translation>&amp;Mitte</translation></message>
    <message><source>512 = 150°; nothing moves yet</source>
        <translation>512 = 150°; es bewegt sich noch nichts</translation></message>
    <message><source>S&amp;tand</source>
        <translation>&amp;Stand</translation></message>
    <message><source>Inner 512, outer 550; nothing moves yet</source>
        <translation>Innen 512, außen 550; es bewegt sich noch nichts</translation></message>
    <message><source>Speed of all motors</source>
        <translation>Geschwindigkeit aller Motoren</translation></message>
    <message><source>Mo&amp;ve</source>
        <translation>Be&amp;wegen</translation></message>
    <message><source>Send while dra&amp;gging</source>
        <translation>Beim &amp;Ziehen senden</translation></message>
    <message><source>Reset li&amp;mits</source>
        <translation>Grenzen z&amp;urücksetzen</translation></message>
    <message><source>Inner 50–600, outer 0–550: tuned on the robot by its authors</source>
        <translation>Innen 50–600, außen 0–550: von den Autoren am Roboter abgestimmt</translation></message>
    <message><source>&amp;Limits instead of speeds</source>
        <translation>Grenzen statt Geschwindig&amp;keiten</translation></message>
    <message><source>Speed &amp;of all:</source>
        <translation>Geschwi&amp;ndigkeit aller:</translation></message>
    <message><source>Goals and limits can already be set.</source>
        <translation>Ziele und Grenzen lassen sich schon einstellen.</translation></message>
    <message><source>Every motor has reached its goal within a few units.</source>
        <translation>Jeder Motor hat sein Ziel bis auf wenige Einheiten erreicht.</translation></message>
    <message><source>The newest goal is sent as soon as the robot has reached the previous goal</source>
        <translation>Das neueste Ziel wird gesendet, sobald der Roboter das letzte erreicht hat</translation></message>
    <message><source>Range of each joint. Goals outside this range are clamped before they are sent.</source>
        <translation>Wie weit sich jedes Gelenk drehen darf; Ziele werden vor dem Senden begrenzt</translation></message>
    <message><source>differ</source>
        <translation>verschieden</translation></message>
    <message><source>Set sliders to:</source>
        <translation>Schieberegler setzen auf:</translation></message>
    <message><source>Pages</source>
        <translation>Seiten</translation></message>
    <message><source>a robot</source>
        <translation>ein Roboter</translation></message>
    <message><source>Demo Aracna</source>
        <translation>Demo-Aracna</translation></message>
    <message><source>an Aracna pose file</source>
        <translation>eine Posendatei eines Aracna</translation></message>
    <message><source>&amp;Aracna</source>
        <translation>&amp;Aracna</translation></message>
    <message><source>Stop &amp;recording</source>
        <translation>&amp;Aufzeichnung beenden</translation></message>
    <message><source>&amp;Record…</source>
        <translation>&amp;Aufzeichnen…</translation></message>
    <message><source>Nothing can be recorded: no robot is connected.</source>
        <translation>Aufzeichnen nicht möglich: Es ist kein Roboter verbunden.</translation></message>
    <message><source>Aracna, Open recording</source>
        <translation>Aracna, Aufzeichnung öffnen</translation></message>
    <message><source>Keep clear of the legs: this robot has no stop command. Nothing moves until you press Move.</source>
        <translation>Geben Sie den Beinen Platz: Dieser Roboter hat keinen Stopp. Nichts bewegt sich, bis Sie Bewegen wählen.</translation></message>
    <message><source>No robot at hand?</source>
        <translation>Kein Roboter zur Hand?</translation></message>
    <message><source>Tr&amp;y the demo</source>
        <translation>Demo aus&amp;probieren</translation></message>
    <message><source>R&amp;obot</source>
        <translation>&amp;Roboter</translation></message>
    <message><source>&amp;Move to the sliders' goals</source>
        <translation>Zu den Zielen der Schieberegler &amp;bewegen</translation></message>
    <message><source>Pla&amp;y the current sequence or gait</source>
        <translation>Aktuelle Sequenz oder &amp;Gangart abspielen</translation></message>
    <message><source>&amp;End sequence after this step</source>
        <translation>Sequenz nach diesem Schritt b&amp;eenden</translation></message>
    <message><source>Ope&amp;n recording…</source>
        <translation>Aufzeich&amp;nung öffnen…</translation></message>
    <message><source>Set up &amp;goals and limits without a robot</source>
        <translation>&amp;Ziele und Grenzen ohne Roboter einstellen</translation></message>
    <message><source>&amp;Debug LED of the board</source>
        <translation>&amp;Debug-LED des Boards</translation></message>
    <message><source>&amp;New pose file</source>
        <translation>&amp;Neue Posendatei</translation></message>
    <message><source>Save pose file &amp;as…</source>
        <translation>Posendatei speichern &amp;unter…</translation></message>
    <message><source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation></message>
    <message><source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation></message>
    <message><source>&amp;Capture the present position as a pose</source>
        <translation>&amp;Istposition als Pose aufnehmen</translation></message>
    <message><source>&amp;Demo Aracna panel</source>
        <translation>Bedienfeld des &amp;Demo-Aracna</translation></message>
    <message><source>Connect my {0}</source>
        <translation>Meinen {0} verbinden</translation></message>
    <message><source>Connect an FTDI cable to the header or plug an XBee radio into the socket: both share one line. Switch on the servo power as well. Without servo power, the first move never ends.</source>
        <translation>Ein FTDI-Kabel an der Stiftleiste oder ein XBee-Funkmodul im Sockel: Beide teilen sich eine Leitung. Schalten Sie auch die Servoversorgung ein, ohne die die erste Bewegung nie endet.</translation></message>
    <message><source>Open pose fi&amp;le…</source>
        <translation>Po&amp;sendatei öffnen…</translation></message>
    <message><source>Set &amp;up goals and limits</source>
        <translation>&amp;Ziele und Grenzen einstellen</translation></message>
    <message><source>ArbotiX</source>
        <translation>ArbotiX</translation></message>
    <message><source>Adapter</source>
        <translation>Adapter</translation></message>
    <message><source>bench tests</source>
        <translation>Prüfläufe</translation></message>
    <message><source>line {0}: expected the columns {1}</source>
        <translation>Zeile {0}: erwartet werden die Spalten {1}</translation></message>
    <message><source>it is not a text file</source>
        <translation>es ist keine Textdatei</translation></message>
    <message><source>line {0}: invalid row “{1}”</source>
        <translation>Zeile {0}: ungültige Zeile „{1}“</translation></message>
    <message><source>line 1: a bench test begins with {0!r}</source>
        <translation>Zeile 1: Ein Prüflauf beginnt mit {0!r}</translation></message>
    <message><source>motor: expected 1 or 2, not {0}</source>
        <translation>motor: erwartet wird 1 oder 2, nicht {0}</translation></message>
    <message><source>the line “# {0}: …” is missing</source>
        <translation>die Zeile „# {0}: …“ fehlt</translation></message>
    <message><source>line {0}: expected a name and a value</source>
        <translation>Zeile {0}: erwartet werden ein Name und ein Wert</translation></message>
    <message><source>{0}: invalid value “{1}”</source>
        <translation>{0}: ungültiger Wert „{1}“</translation></message>
    <message><source>line {0} or below: {1}</source>
        <translation>Zeile {0} oder darunter: {1}</translation></message>
    <message><source>step {0}, {1} s</source>
        <translation>Sprung {0}, {1} s</translation></message>
    <message><source>ramp {0}, {1} s</source>
        <translation>Rampe {0}, {1} s</translation></message>
    <message><source>reverse {0}, {1} s</source>
        <translation>Umkehr {0}, {1} s</translation></message>
    <message><source>sine {0}, {1} s</source>
        <translation>Sinus {0}, {1} s</translation></message>
    <message><source>the speed of a bench test must be −{0} to −1 or 1 to {0}, not {1}</source>
        <translation>die Geschwindigkeit eines Prüflaufs ist −{0} bis {0} und nicht 0, nicht {1}</translation></message>
    <message><source>a bench test must last {0:g} to {1:g} s, not {2:g} s</source>
        <translation>ein Prüflauf dauert {0:g} bis {1:g} s, nicht {2:g} s</translation></message>
    <message><source>the period of a bench test must be {0:g} to {1:g} s, not {2:g} s</source>
        <translation>die Periode eines Prüflaufs ist {0:g} bis {1:g} s, nicht {2:g} s</translation></message>
    <message><source>{0} Doubtful: the line is noisy and has no CRC.</source>
        <translation>{0} Zweifelhaft: Die Leitung ist gestört und hat kein CRC.</translation></message>
    <message><source>The board does not respond; the stop is being repeated.</source>
        <translation>Das Board antwortet nicht; der Stopp wird wiederholt.</translation></message>
    <message><source>Check the cable and the ground connection, and make sure that no other program sends on this line.</source>
        <translation>Prüfen Sie Kabel und Masse und ob kein anderes Programm auf dieser Leitung sendet.</translation></message>
    <message><source>Check the cable and the ground connection, and make sure that every program on this line uses the same polynomial.</source>
        <translation>Prüfen Sie Kabel und Masse und ob jedes Programm an dieser Leitung dasselbe Polynom verwendet.</translation></message>
    <message><source>Check the cable, the ground connection and the baud rate, and keep motor leads away from the cable.</source>
        <translation>Prüfen Sie Kabel, Masse und Baudrate, und halten Sie die Motorleitungen von der Leitung fern.</translation></message>
    <message><source>Use a lower baud rate.</source>
        <translation>Verwenden Sie eine niedrigere Baudrate.</translation></message>
    <message><source>Check the cable and the ground connection, and make sure that every program on this line uses the same parity.</source>
        <translation>Prüfen Sie Kabel und Masse und ob jedes Programm an dieser Leitung dieselbe Parität verwendet.</translation></message>
    <message><source>Make sure that no other program sends on this line.</source>
        <translation>Lassen Sie kein anderes Programm auf dieser Leitung senden.</translation></message>
    <message><source>Make other programs request fewer channels at once.</source>
        <translation>Lassen Sie andere Programme weniger Kanäle auf einmal anfordern.</translation></message>
    <message><source>Latched before connecting, perhaps by a search for the board: {0}</source>
        <translation>Schon vor dem Verbinden gesetzt, vielleicht durch die Suche nach dem Board: {0}</translation></message>
    <message><source>Connected to {0} on {1}.</source>
        <translation>Verbunden mit {0} an {1}.</translation></message>
    <message><source>The board responds again</source>
        <translation>Das Board antwortet wieder</translation></message>
    <message><source>The board was switched off and on</source>
        <translation>Das Board wurde aus- und eingeschaltet</translation></message>
    <message><source>A setting changed: the board was restarted, or another program wrote to it</source>
        <translation>Eine Einstellung hat sich geändert: Das Board wurde neu gestartet, oder ein anderes Programm hat hineingeschrieben</translation></message>
    <message><source>Device {0} selected: {1}</source>
        <translation>Gerät {0} ausgewählt: {1}</translation></message>
    <message><source>{0} (doubtful)</source>
        <translation>{0} (zweifelhaft)</translation></message>
    <message><source>The notes, calibrations and applied settings saved for this {0} date from {1}, when it was connected through another USB adapter or socket. If this is another board, give it its own device number: boards with the same number share these files.</source>
        <translation>Was hier für diesen {0} aufbewahrt wird (Notizen, Kalibrierungen, angewendete Einstellungen), stammt vom {1}, als er an einem anderen USB-Adapter oder einer anderen Buchse war. Wenn dies ein anderes Board ist, geben Sie ihm eine eigene Gerätenummer: Boards mit derselben Nummer teilen sich das Aufbewahrte.</translation></message>
    <message><source>Disconnected</source>
        <translation>Getrennt</translation></message>
    <message><source>The board received nothing within its Serial Timeout, so the motors were stopped.</source>
        <translation>Das Board hat innerhalb seines seriellen Timeouts nichts empfangen, daher wurden die Motoren gestoppt.</translation></message>
    <message><source>The board stopped its motors because of an error on the line ({0}): UART-Error Shutdown is set.</source>
        <translation>Das Board hat seine Motoren wegen eines Fehlers auf der Leitung ({0}) gestoppt: „Abschaltung bei UART-Fehlern“ ist eingestellt.</translation></message>
    <message><source>The board stopped responding.</source>
        <translation>Das Board antwortet nicht mehr.</translation></message>
    <message><source>Bytes were corrupted: motor commands are repeated until the line is quiet</source>
        <translation>Bytes wurden verfälscht: Motorbefehle werden wiederholt, bis die Leitung ruhig ist</translation></message>
    <message><source>this program</source>
        <translation>dieses Programm</translation></message>
    <message><source>Motors may still be turning: disconnected before a stop was confirmed</source>
        <translation>Die Motoren können sich noch drehen: getrennt, bevor ein Stopp bestätigt war</translation></message>
    <message><source>The server of the robot does not respond.</source>
        <translation>Das Netz zum Roboter ist still.</translation></message>
    <message><source>Driver: {0}</source>
        <translation>Fahrer: {0}</translation></message>
    <message><source>The line is noisy: {0:.1f} % of the replies were lost or corrupted</source>
        <translation>Die Leitung ist gestört: {0:.1f} % verloren</translation></message>
    <message><source>The line is good again</source>
        <translation>Die Leitung ist wieder gut</translation></message>
    <message><source>The board reports: {0}.</source>
        <translation>Das Board meldet: {0}.</translation></message>
    <message><source>noisy: {0:.1f} % of the requests in the last {1:.0f} s were answered</source>
        <translation>gestört: {0:.1f} % der Anfragen der letzten {1:.0f} s beantwortet</translation></message>
    <message><source>being measured …</source>
        <translation>wird gemessen …</translation></message>
    <message><source>good: {0:.1f} % of the requests in the last {1:.0f} s were answered</source>
        <translation>gut: {0:.1f} % der Anfragen der letzten {1:.0f} s beantwortet</translation></message>
    <message><source>The proposed ends lie inside the measured ends by 1 % of the travel plus three times the noise, so that full output is reliably reached. The deadband covers the noise at rest, but is at least {0}, because a stick does not return to exactly the same position each time.</source>
        <translation>Die Enden liegen um 1 % des Wegs und das Dreifache des Rauschens innerhalb der gemessenen, damit die volle Ausgabe sicher erreicht wird. Der Totbereich deckt das Rauschen in Ruhe ab, beträgt aber mindestens {0}, da ein Knüppel nicht jedes Mal genau an dieselbe Stelle zurückkehrt.</translation></message>
    <message><source>At rest the noise is {0}, so the deadband is twice this value.</source>
        <translation>In Ruhe beträgt sein Rauschen {0}: Der Totbereich ist doppelt so groß.</translation></message>
    <message><source>{0}, so the channel should be reversed.</source>
        <translation>{0}; Vorschlag: umgekehrt.</translation></message>
    <message><source>{0}, so the channel should not be reversed.</source>
        <translation>{0}; Vorschlag: nicht umgekehrt.</translation></message>
    <message><source>The measured ends are up to {0} beyond the proposed ends.</source>
        <translation>Die gemessenen Endlagen liegen bis zu {0} weiter außen.</translation></message>
    <message><source>The signal never goes above its rest position, so maximum is set to the limit of the input.</source>
        <translation>Er geht nie über seine Ruhelage, daher wird das Maximum auf die Grenze des Eingangs gesetzt.</translation></message>
    <message><source>The signal never goes below its rest position, so minimum is set to the limit of the input.</source>
        <translation>Er geht nie unter seine Ruhelage, daher wird das Minimum auf die Grenze des Eingangs gesetzt.</translation></message>
    <message><source>The value fell when the stick first went forward or right</source>
        <translation>Der Wert fiel, als der Knüppel zuerst nach vorn oder rechts ging</translation></message>
    <message><source>The value rose when the stick first went forward or right</source>
        <translation>Der Wert stieg, als der Knüppel zuerst nach vorn oder rechts ging</translation></message>
    <message><source>The value is higher in the other position than at rest, where the switch should be off</source>
        <translation>Die andere Stellung liegt über der Ruhelage, die „aus“ sein soll</translation></message>
    <message><source>The value is lower in the other position than at rest, where the switch should be off</source>
        <translation>Die andere Stellung liegt unter der Ruhelage, die „aus“ sein soll</translation></message>
    <message><source>there is nothing to compare: only probes were sent</source>
        <translation>es gibt nichts zu vergleichen: Außer für die Suche wurde nichts gesendet</translation></message>
    <message><source>TReX 1.2, because no signature was read</source>
        <translation>TReX 1.2, da keine Signatur gelesen wurde</translation></message>
    <message><source>1 stored value</source>
        <translation>1 gespeicherter Wert</translation></message>
    <message><source>{0}, {1} from the file, all other values at their defaults</source>
        <translation>{0}, {1} aus der Datei, die übrigen wie ab Werk</translation></message>
    <message><source>traffic logs</source>
        <translation>Datenverkehrsprotokolle</translation></message>
    <message><source>{0} stored values</source>
        <translation>{0} gespeicherte Werte</translation></message>
    <message><source>{0}; the simulated board uses the default value instead.</source>
        <translation>{0}; das simulierte Board hat seinen Standardwert.</translation></message>
    <message><source>learned channels</source>
        <translation>eingelernte Kanäle</translation></message>
    <message><source>done</source>
        <translation>fertig</translation></message>
    <message><source>calibration of channel {0}</source>
        <translation>Kalibrierung von Kanal {0}</translation></message>
    <message><source>Calibration of channel {0}</source>
        <translation>Kalibrierung von Kanal {0}</translation></message>
    <message><source>stored settings</source>
        <translation>gespeicherte Einstellungen</translation></message>
    <message><source>device number {0}</source>
        <translation>Gerätenummer {0}</translation></message>
    <message><source>Only the full search finds a board with a custom CRC polynomial.</source>
        <translation>Ein Board mit eigenem CRC-Polynom findet nur die vollständige Suche.</translation></message>
    <message><source> It also echoes what is sent.</source>
        <translation> Es sendet außerdem ein Echo des Gesendeten.</translation></message>
    <message><source>After a power cycle, it will run at {0}.</source>
        <translation>Nach dem Aus- und Einschalten läuft es mit {0}.</translation></message>
    <message><source>No TReX responds on {0} at any baud rate, with any parity or with CRC. Check that the board has power (an LED is lit), that the adapter's TX goes to SI and its RX to SO (an RS-232 adapter: to the RS-232 pins), and that ground is connected.</source>
        <translation>An {0} antwortet kein TReX, bei keiner Baudrate, mit keiner Parität und nicht mit CRC. Prüfen Sie, ob das Board Strom hat (eine LED leuchtet), ob TX des Adapters mit SI und RX mit SO verbunden ist (oder beide mit den RS-232-Pins, nie gemischt) und ob die Masse verbunden ist.</translation></message>
    <message><source>Something is connected to {0}, but it does not respond like a TReX: it sent {1} at {2}{3}. Either it is another device, or the line is noisy.</source>
        <translation>An {0} ist etwas angeschlossen, das aber nicht wie ein TReX antwortet: Es hat {1} mit {2} gesendet{3}. Es ist ein anderes Gerät, oder die Leitung ist gestört.</translation></message>
    <message><source>It is set to {0} baud, but with this setting, firmware {1} runs at half the rate: connect at {2} baud.</source>
        <translation>Es ist auf {0} Baud eingestellt; Firmware {1} läuft dabei mit der Hälfte: Verbinden Sie mit {2}.</translation></message>
    <message><source>It is set to {0} stop bits; either number works on this line.</source>
        <translation>Es ist auf {0} Stoppbits eingestellt; an dieser Leitung funktioniert beides.</translation></message>
    <message><source> The port does not support {0} baud, so the scan skipped these settings.</source>
        <translation> Der Port unterstützt {0} Baud nicht, daher wurden diese Einstellungen ausgelassen.</translation></message>
    <message><source>, and data at {0} other settings</source>
        <translation>, und bei {0} weiteren ebenfalls etwas</translation></message>
    <message><source>Its UART settings have the unknown value {0:#04x}.</source>
        <translation>Seine UART-Einstellungen enthalten {0:#04x}; das ist keine bekannte Einstellung.</translation></message>
    <message><source>No TReX responds on {0}: at every rate, everything sent comes back and nothing else arrives. Either this is the RS-232 side of a board that is off, or the adapter's TX and RX are joined.</source>
        <translation>An {0} antwortet kein TReX: Alles Gesendete kommt zurück, und sonst nichts, bei jeder Baudrate. Entweder ist das die RS-232-Seite eines ausgeschalteten Boards, oder TX und RX des Adapters sind verbunden.</translation></message>
    <message><source>No TReX responds on {0}. The baud rate is set at the other end of the network, so only that rate could be tried, without parity and without CRC.</source>
        <translation>An {0} antwortet kein TReX. Die Baudrate ist am anderen Ende des Netzwerks eingestellt, daher konnte nur diese versucht werden, ohne Parität und ohne CRC.</translation></message>
    <message><source>The connection was lost: motors may still be turning.</source>
        <translation>Die Verbindung ist abgebrochen: Die Motoren drehen sich vielleicht noch.</translation></message>
    <message><source>Cut the power.</source>
        <translation>Trennen Sie die Motorversorgung.</translation></message>
    <message><source>The board does not respond.</source>
        <translation>Das Board antwortet nicht.</translation></message>
    <message><source>The server stops the motors half a second after the last heartbeat.</source>
        <translation>Sein Server stoppt die Motoren eine halbe Sekunde nach dem letzten Lebenszeichen.</translation></message>
    <message><source>Channel {0} is required but has no signal.</source>
        <translation>Kanal {0} ist erforderlich, hat aber kein Signal.</translation></message>
    <message><source>Safe-start keeps the motors off: switch the transmitter on and release its sticks.</source>
        <translation>Safe-Start hält die Motoren ausgeschaltet: Schalten Sie den Sender ein und lassen Sie seine Knüppel los.</translation></message>
    <message><source>Channel {0} is {1} above neutral.</source>
        <translation>Kanal {0} liegt {1} über der Neutralstellung.</translation></message>
    <message><source>Safe-start holds the motors until the channel is within about {2} of neutral (inferred): release the stick, or calibrate the channel (in serial mode).</source>
        <translation>Safe-Start hält die Motoren zurück, bis er höchstens etwa {2} abweicht (erschlossen): Lassen Sie den Knüppel los oder kalibrieren Sie den Kanal (im seriellen Modus).</translation></message>
    <message><source>Channel {0} is {1} below neutral.</source>
        <translation>Kanal {0} liegt {1} unter der Neutralstellung.</translation></message>
    <message><source>Channel 5 requests serial override.</source>
        <translation>Kanal 5 fordert den seriellen Vorrang an.</translation></message>
    <message><source>Safe-start holds the motors until you turn the switch of channel 5 off.</source>
        <translation>Safe-Start hält die Motoren zurück, bis dieser Schalter einmal aus ist.</translation></message>
    <message><source>Safe-start may be holding the motors (inferred).</source>
        <translation>Vielleicht hält Safe-Start die Motoren zurück (erschlossen).</translation></message>
    <message><source>Release all sticks.</source>
        <translation>Lassen Sie alle Knüppel los.</translation></message>
    <message><source>Motor {0} is off: its driver shut down because of overheating, a short circuit or low voltage.</source>
        <translation>Motor {0} wird nicht angetrieben: Sein Treiber hat abgeschaltet (zu heiß, Kurzschluss oder Unterspannung).</translation></message>
    <message><source>Reduce the load, check the wires and the battery, and let the driver cool.</source>
        <translation>Verringern Sie die Last, prüfen Sie Kabel und Batterie, lassen Sie den Treiber abkühlen.</translation></message>
    <message><source>Serial timeout: the board received nothing for {0}.</source>
        <translation>Serielles Timeout: Das Board hat {0} lang nichts empfangen.</translation></message>
    <message><source>Check the cable, or set a longer Serial Timeout in Parameters.</source>
        <translation>Prüfen Sie das Kabel oder stellen Sie unter „Parameter“ ein längeres „Serielles Timeout“ ein.</translation></message>
    <message><source>Serial errors ({0}): the board stops the motors when bytes arrive corrupted.</source>
        <translation>Serielle Fehler ({0}): Das Board stoppt die Motoren, wenn Bytes verfälscht ankommen.</translation></message>
    <message><source>Check the cable and the ground connection. Without UART-Error Shutdown, the Serial Timeout may not stop the motors either (twin).</source>
        <translation>Prüfen Sie Kabel und Masse. Ohne „Abschaltung bei UART-Fehlern“ stoppt vielleicht auch das serielle Timeout die Motoren nicht (Zwilling).</translation></message>
    <message><source>Stopping: the board has not confirmed the stop yet.</source>
        <translation>Stopp läuft: Das Board hat ihn noch nicht bestätigt.</translation></message>
    <message><source>The stop is being repeated. Motors may still be turning.</source>
        <translation>Der Stopp wird wiederholt; die Motoren können sich noch drehen.</translation></message>
    <message><source>Stopped. The motors are locked for {0} s.</source>
        <translation>Gestoppt. Die Motoren sind für {0} s gesperrt.</translation></message>
    <message><source>Then arm them again.</source>
        <translation>Geben Sie sie danach wieder frei.</translation></message>
    <message><source>{0} drives this robot. You can watch and stop it.</source>
        <translation>{0} fährt diesen Roboter. Sie können zusehen und ihn stoppen.</translation></message>
    <message><source>“Arm motors” asks {0} to hand over control.</source>
        <translation>„Motoren freigeben“ bittet {0}, ihn zu übergeben.</translation></message>
    <message><source>No board is connected.</source>
        <translation>Es ist kein Board verbunden.</translation></message>
    <message><source>Select a port above and press Connect.</source>
        <translation>Wählen Sie oben einen Port und klicken Sie auf „Verbinden“.</translation></message>
    <message><source>The program is connecting to the board.</source>
        <translation>Das Programm verbindet sich mit dem Board.</translation></message>
    <message><source>The connection is being closed.</source>
        <translation>Die Verbindung wird geschlossen.</translation></message>
    <message><source>The board has not yet reported what controls the motors.</source>
        <translation>Das Board hat noch nicht gemeldet, was die Motoren steuert.</translation></message>
    <message><source>The board reports that serial commands do not control the motors.</source>
        <translation>Das Board meldet, dass serielle Befehle die Motoren nicht steuern.</translation></message>
    <message><source>Switch the board off and on.</source>
        <translation>Das Board muss aus- und eingeschaltet werden.</translation></message>
    <message><source>The RC channels control the motors, not serial commands.</source>
        <translation>Die RC-Kanäle steuern die Motoren, nicht serielle Befehle.</translation></message>
    <message><source>To drive by serial commands, turn on the override switch (channel 5), or switch the board off, remove the mode jumper and switch the board on again.</source>
        <translation>Um mit seriellen Befehlen zu fahren, schalten Sie den Vorrangschalter (Kanal 5) ein oder schalten Sie das Board aus, ziehen Sie den Modus-Jumper ab und schalten Sie es ein.</translation></message>
    <message><source>The analog channels control the motors, not serial commands.</source>
        <translation>Die Analogkanäle steuern die Motoren, nicht serielle Befehle.</translation></message>
    <message><source>Commands without a device number would reach several boards.</source>
        <translation>Befehle ohne Gerätenummer würden mehrere Boards erreichen.</translation></message>
    <message><source>Select one of the boards on this line.</source>
        <translation>Wählen Sie eines der Boards an dieser Leitung aus.</translation></message>
    <message><source>Board {0}, which is driven together with this board, does not follow commands.</source>
        <translation>Board {0}, das mit diesem gefahren wird, folgt nicht.</translation></message>
    <message><source>Its diagram shows why. “Drive alone” drives the other board without it.</source>
        <translation>Seine Zeichnung sagt, warum. „Allein fahren“ verwendet das andere ohne dieses.</translation></message>
    <message><source>The motors cannot be armed at this moment.</source>
        <translation>Die Motoren können im Moment nicht freigegeben werden.</translation></message>
    <message><source>Stopped. {0}</source>
        <translation>Gestoppt. {0}</translation></message>
    <message><source>Arm the motors again to continue.</source>
        <translation>Geben Sie sie wieder frei, um fortzufahren.</translation></message>
    <message><source>Not armed: no motor is driven.</source>
        <translation>Nicht freigegeben: Kein Motor wird angesteuert.</translation></message>
    <message><source>Put the robot on blocks, then arm the motors.</source>
        <translation>Bocken Sie den Roboter auf und geben Sie dann die Motoren frei.</translation></message>
    <message><source>Motor {0} is slowed down: its current exceeds the limit.</source>
        <translation>Motor {0} wird verlangsamt: Strom über der Grenze.</translation></message>
    <message><source>Reduce the load, or raise the current limit in Parameters.</source>
        <translation>Verringern Sie die Last oder erhöhen Sie die Stromgrenze unter „Parameter“.</translation></message>
    <message><source>The motors are armed: the controls on the Motors page move them.</source>
        <translation>Die Motoren sind freigegeben: Die Bedienelemente der Seite „Motoren“ bewegen sie.</translation></message>
    <message><source>Esc stops everything.</source>
        <translation>Esc stoppt alles.</translation></message>
    <message><source>Channel 5 overrides the sticks for as long as its switch is on.</source>
        <translation>Kanal 5 hat Vorrang vor den Knüppeln, solange sein Schalter ein ist.</translation></message>
    <message><source>Joint mode: both drivers work as one motor.</source>
        <translation>Parallelbetrieb: Beide Treiber treiben gemeinsam einen Motor an.</translation></message>
    <message><source>If the green LED is steady instead, safe-start is over.</source>
        <translation>Leuchtet die grüne LED stattdessen dauernd, ist Safe-Start beendet.</translation></message>
    <message><source>on</source><comment>LED</comment>
        <translation>an</translation></message>
    <message><source>off</source><comment>LED</comment>
        <translation>aus</translation></message>
    <message><source>flickers with each packet</source><comment>LED</comment>
        <translation>flackert bei jedem Paket</translation></message>
    <message><source>flashes fast</source><comment>LED</comment>
        <translation>blinkt schnell</translation></message>
    <message><source>Motors may still be turning.</source>
        <translation>Die Motoren drehen sich vielleicht noch.</translation></message>
    <message><source>The board should stop its motors {0} after the last byte. If it does not, cut the power.</source>
        <translation>Das Board sollte die Motoren {0} nach dem letzten Byte stoppen; wenn nicht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>The auxiliary motor may still be turning.</source>
        <translation>Der Hilfsmotor dreht sich vielleicht noch.</translation></message>
    <message><source>Motor {0} may still be turning.</source>
        <translation>Motor {0} dreht sich vielleicht noch.</translation></message>
    <message><source>Not written: the settings stored in the board have changed since the review.</source>
        <translation>Nicht geschrieben: Das Board speichert andere Einstellungen als bei der Prüfung.</translation></message>
    <message><source>The same settings for several boards</source>
        <translation>Dieselben Einstellungen für mehrere Boards</translation></message>
    <message><source>The board does not respond. Check that it has power.</source>
        <translation>Es antwortet nicht. Prüfen Sie, ob es mit Strom versorgt ist.</translation></message>
    <message><source>Not verified: {0}. {1}</source>
        <translation>Konnte nicht bestätigt werden: {0}. {1}</translation></message>
    <message><source>The connection was closed.</source>
        <translation>Die Verbindung wurde geschlossen.</translation></message>
    <message><source>In joint mode the board measures no current, so excessive current could not abort a test.</source>
        <translation>Im Parallelbetrieb misst das Board keinen Strom; ein Prüflauf ließe sich nicht abbrechen.</translation></message>
    <message><source>No current has been read yet.</source>
        <translation>Es wurde noch kein Strom gelesen.</translation></message>
    <message><source>Serial commands no longer reach the motors.</source>
        <translation>Serielle Befehle erreichen die Motoren nicht mehr.</translation></message>
    <message><source>Stop was pressed.</source>
        <translation>„Motoren stoppen“ wurde gedrückt.</translation></message>
    <message><source>Bench test of motor {0}: {1}</source>
        <translation>Prüflauf von Motor {0}: {1}</translation></message>
    <message><source>Motor {0} drew {1:.2f} A, more than the abort current of {2:g} A.</source>
        <translation>Motor {0} nahm {1:.2f} A auf, mehr als den Abbruchstrom von {2:g} A.</translation></message>
    <message><source>The board received nothing within its Serial Timeout.</source>
        <translation>Das Board hat innerhalb seines seriellen Timeouts nichts empfangen.</translation></message>
    <message><source>The driver of motor {0} reported a fault.</source>
        <translation>Der Treiber von Motor {0} hat einen Fehler gemeldet.</translation></message>
    <message><source>No current was read for {0:g} s.</source>
        <translation>{0:g} s lang wurde kein Strom gelesen.</translation></message>
    <message><source>Motor {0} exceeded its current limit.</source>
        <translation>Motor {0} hat seine Stromgrenze überschritten.</translation></message>
    <message><source>No other board replies on this line. Every board needs power, the same serial settings as the connected board, and a unique device number.</source>
        <translation>An dieser Leitung antwortet kein anderes Board. Jedes braucht Strom, dieselben seriellen Einstellungen wie dieses und eine eigene Gerätenummer.</translation></message>
    <message numerus="yes"><source>%n board(s) on this line.</source>
        <translation><numerusform>%n Board an dieser Leitung.</numerusform><numerusform>%n Boards an dieser Leitung.</numerusform></translation></message>
    <message><source>Another board was selected.</source>
        <translation>Ein anderes Board wurde ausgewählt.</translation></message>
    <message><source>Minimum cannot pass neutral.</source>
        <translation>Das Minimum kann nicht über die Neutralstellung hinaus.</translation></message>
    <message><source>Maximum cannot pass neutral.</source>
        <translation>Das Maximum kann nicht über die Neutralstellung hinaus.</translation></message>
    <message><source>The deadband cannot be wider than the travel.</source>
        <translation>Der Totbereich kann nicht breiter als der Weg sein.</translation></message>
    <message><source>Minimum and maximum must differ.</source>
        <translation>Minimum und Maximum müssen verschieden sein.</translation></message>
    <message><source>Neutral cannot pass minimum.</source>
        <translation>Die Neutralstellung kann nicht über das Minimum hinaus.</translation></message>
    <message><source>Neutral cannot pass maximum.</source>
        <translation>Die Neutralstellung kann nicht über das Maximum hinaus.</translation></message>
    <message><source>The ends of the deadband cannot pass neutral.</source>
        <translation>Der Totbereich endet an der Neutralstellung.</translation></message>
    <message><source>Motor 1</source>
        <translation>Motor 1</translation></message>
    <message><source>Motor 2</source>
        <translation>Motor 2</translation></message>
    <message><source>Auxiliary</source>
        <translation>Hilfsmotor</translation></message>
    <message><source>Flip</source>
        <translation>Umdrehen</translation></message>
    <message><source>Override</source>
        <translation>Vorrang</translation></message>
    <message><source>RC pulses</source>
        <translation>RC-Impulse</translation></message>
    <message><source>analog voltages</source>
        <translation>Analogspannungen</translation></message>
    <message><source>drives motor 1, or steers when the mix jumper is on</source>
        <translation>steuert Motor 1; mit gestecktem Mix-Jumper lenkt er</translation></message>
    <message><source>drives motor 2, or drives forward and back when the mix jumper is on</source>
        <translation>steuert Motor 2; mit gestecktem Mix-Jumper steuert er vor und zurück</translation></message>
    <message><source>drives the auxiliary motor, which turns one way only</source>
        <translation>steuert den Hilfsmotor, der nur in eine Richtung dreht</translation></message>
    <message><source>is the flip switch: motors 1 and 2 are swapped and reversed</source>
        <translation>ist der Umdrehschalter: Motor 1 und 2 tauschen Platz und Drehrichtung</translation></message>
    <message><source>is the override switch: serial commands control the motors</source>
        <translation>ist der Vorrangschalter: Serielle Befehle steuern die Motoren</translation></message>
    <message><source>drives motor 1 (the mix jumper is off)</source>
        <translation>steuert Motor 1 (der Mix-Jumper ist nicht gesteckt)</translation></message>
    <message><source>steers with both motors (the mix jumper is on)</source>
        <translation>lenkt: er bewegt beide Motoren (der Mix-Jumper ist gesteckt)</translation></message>
    <message><source>drives motor 2 (the mix jumper is off)</source>
        <translation>steuert Motor 2 (der Mix-Jumper ist nicht gesteckt)</translation></message>
    <message><source>drives both motors forward and back (the mix jumper is on)</source>
        <translation>steuert beide Motoren vor und zurück (der Mix-Jumper ist gesteckt)</translation></message>
    <message><source>drives the single motor that both drivers power (joint mode, no mixing)</source>
        <translation>steuert den einen Motor, den beide Treiber speisen (Parallelbetrieb, kein Mischer)</translation></message>
    <message><source>has no motor: in joint mode both drivers power motor 1</source>
        <translation>hat keinen Motor: im Parallelbetrieb speisen beide Treiber Motor 1</translation></message>
    <message><source>{0} ({1}) is outside the input range. {2} The output never reaches its full value on that side.</source>
        <translation>{0} ({1}) liegt außerhalb des Eingangsbereichs. {2} Der volle Ausgang auf dieser Seite wird nie erreicht.</translation></message>
    <message><source>is ignored: it is held at neutral, whatever its input</source>
        <translation>wird ignoriert: er bleibt in Neutralstellung, was auch immer am Eingang anliegt</translation></message>
    <message><source>In RC and analog mode it {1}.</source>
        <translation>Im RC- und Analogmodus gilt: Er {1}.</translation></message>
    <message><source>The board now reads {0}, so it shows and accepts only the calibrations of this source. To see the calibrations for {1}, set Channel Input Source, apply, and switch the board off and on.</source>
        <translation>Das Board liest jetzt {0}, und nur dafür zeigt und akzeptiert es Kalibrierungen. Um diese hier zu sehen, lassen Sie es {1} lesen: Stellen Sie „Eingangsquelle der Kanäle“ um, wenden Sie die Änderung an und schalten Sie das Board aus und ein.</translation></message>
    <message><source>The board now reads {0}, so it shows and accepts only the calibrations of this source. To see these calibrations, switch the board off, set the mode jumper to {2}, and switch the board on.</source>
        <translation>Das Board liest jetzt {0}, und nur dafür zeigt und akzeptiert es Kalibrierungen. Um diese hier zu sehen: Schalten Sie es aus, stecken Sie den Modus-Jumper auf {2}, schalten Sie es ein.</translation></message>
    <message><source>applied {0}</source>
        <translation>angewendet {0}</translation></message>
    <message><source>read {0}</source>
        <translation>gelesen {0}</translation></message>
    <message><source>Pulses range from {0} to {1}.</source>
        <translation>Ein Impuls dauert {0} bis {1}.</translation></message>
    <message><source>Voltages range from {0} to {1}.</source>
        <translation>Eine Spannung beträgt {0} bis {1}.</translation></message>
    <message><source>Neutral ({0}) is outside the input range. {1} No stick position gives 0.</source>
        <translation>Die Neutralstellung ({0}) liegt außerhalb des Eingangsbereichs. {1} Keine Knüppelstellung ergibt 0.</translation></message>
    <message><source>Minimum</source>
        <translation>Minimum</translation></message>
    <message><source>Maximum</source>
        <translation>Maximum</translation></message>
    <message><source>no signal</source>
        <translation>kein Signal</translation></message>
    <message><source>{0}, output {1}</source>
        <translation>{0}, Ausgang {1}</translation></message>
    <message><source>is ignored: it stays off, whatever its input</source>
        <translation>wird ignoriert: er bleibt aus, was auch immer am Eingang anliegt</translation></message>
    <message><source>Has no effect now: serial commands override it. Otherwise it {1}.</source>
        <translation>Steuert jetzt nichts: Serielle Befehle haben Vorrang. Sonst gilt: Er {1}.</translation></message>
    <message><source>The deadband ({0} to each side of neutral) reaches {1}: no output between 0 and full is possible.</source>
        <translation>Der Totbereich ({0} auf jeder Seite der Neutralstellung) reicht bis zum {1}: Zwischen 0 und vollem Ausgang liegt nichts.</translation></message>
    <message><source>below about {0} (inferred)</source>
        <translation>unter etwa {0} (erschlossen)</translation></message>
    <message><source>above about {0} (inferred)</source>
        <translation>über etwa {0} (erschlossen)</translation></message>
    <message><source>On now. It {1}.</source>
        <translation>Jetzt ein. Er {1}.</translation></message>
    <message><source>Channel {0} {1}.</source>
        <translation>Kanal {0} {1}.</translation></message>
    <message><source>{0} The board accepts a calibration only if minimum is not above neutral, neutral is not above maximum, and minimum and maximum differ.</source>
        <translation>{0} Es akzeptiert eine Kalibrierung nur, wenn das Minimum nicht über der Neutralstellung und die Neutralstellung nicht über dem Maximum liegt und Minimum und Maximum verschieden sind.</translation></message>
    <message><source>{0} Your edits are kept.</source>
        <translation>{0} Die Änderungen bleiben so lange erhalten.</translation></message>
    <message><source>The board would reject this: {0}.</source>
        <translation>Das Board würde dies ablehnen: {0}.</translation></message>
    <message><source> and </source>
        <translation> und </translation></message>
    <message><source>{0} while the input is {1}</source>
        <translation>{0}, solange der Eingang {1} liegt</translation></message>
    <message><source>{0}; it is reversed</source>
        <translation>{0}; er ist umgekehrt</translation></message>
    <message><source>Not connected.</source>
        <translation>Nicht verbunden.</translation></message>
    <message><source>The board has stopped responding. Check its power. Waiting for a reply …</source>
        <translation>Das Board antwortet nicht mehr. Ist es eingeschaltet? Es wird darauf gewartet …</translation></message>
    <message><source>Selecting device {0} …</source>
        <translation>Gerät {0} wird ausgewählt …</translation></message>
    <message><source>Connected to {0}.</source>
        <translation>Verbunden mit {0}.</translation></message>
    <message><source>No reply yet. Trying other settings: {0} …</source>
        <translation>Noch keine Antwort. Andere Einstellungen werden probiert: {0} …</translation></message>
    <message><source>{0}: noisy; shorten cable, check ground</source>
        <translation>{0}: gestört; Kabel kürzen, Masse prüfen</translation></message>
    <message><source>Trying to reach the board to stop it …</source>
        <translation>Es wird versucht, das Board zu erreichen, um es zu stoppen …</translation></message>
    <message><source>Line: good</source>
        <translation>Leitung: gut</translation></message>
    <message><source>{0:.1f} % lost</source>
        <translation>{0:.1f} % verloren</translation></message>
    <message><source>{0}: noisy; shorten cable, check ground, use CRC</source>
        <translation>{0}: gestört; Kabel kürzen, Masse prüfen, CRC verwenden</translation></message>
    <message><source>{0} A stop was sent but is not confirmed yet.</source>
        <translation>{0} Ein Stopp wurde gesendet, ist aber noch nicht bestätigt.</translation></message>
    <message><source>{0}. The stop is not confirmed: {1} If a motor is still turning, cut its power.</source>
        <translation>{0}. Der Stopp ist nicht bestätigt: {1} Falls sich noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>{0}, so the motors were stopped.</source>
        <translation>{0}, daher wurden die Motoren gestoppt.</translation></message>
    <message><source>{0}. Motors may still be turning: cut their power. No board is connected, so no stop can be sent.</source>
        <translation>{0}. Es ist kein Board verbunden, das sich stoppen ließe, und die Motoren können sich noch drehen: Trennen Sie die Motorversorgung.</translation></message>
    <message><source>{0}. The board has confirmed the stop.</source>
        <translation>{0}. Das Board hat den Stopp bestätigt.</translation></message>
    <message><source>{0}. The connection is closed.</source>
        <translation>{0}. Die Leitung ist geschlossen.</translation></message>
    <message><source>Learning: remove the Mix jumper to begin.</source>
        <translation>Einlernen: Mix-Jumper abziehen, um zu beginnen.</translation></message>
    <message><source>Learning: waiting for a signal on any input.</source>
        <translation>Einlernen: Wartet auf ein Signal an einem Eingang.</translation></message>
    <message><source>Learning: leave the sticks centred for two seconds.</source>
        <translation>Einlernen: Knüppel zwei Sekunden in Mittelstellung lassen.</translation></message>
    <message><source>Learning: one flash per input; green means learned.</source>
        <translation>Einlernen: Ein Blinken je Eingang; Grün ist eingelernt.</translation></message>
    <message><source>Learning: hold each stick at both ends, ten seconds in all.</source>
        <translation>Einlernen: Jeden Knüppel in beiden Endlagen halten, insgesamt zehn Sekunden.</translation></message>
    <message><source>Learned; green means good. Remove SO–G, then power-cycle.</source>
        <translation>Eingelernt; Grün ist gut. SO–G abziehen, dann aus- und einschalten.</translation></message>
    <message><source>Boot loader: remove Mix, then SO–G.</source>
        <translation>Bootloader: Mix abziehen, dann SO–G.</translation></message>
    <message><source>Boot loader: waiting for firmware. Power-cycle to exit.</source>
        <translation>Bootloader: Wartet auf Firmware. Zum Verlassen aus- und einschalten.</translation></message>
    <message><source>Edits, notes or settings of another board with this device number were already saved. They were moved to {0}.</source>
        <translation>Für ein anderes Board mit dieser Gerätenummer waren hier Änderungen, Notizen oder Einstellungen hinterlegt. Sie sind jetzt in {0}.</translation></message>
    <message><source>The settings could not be read again. {0}</source>
        <translation>Erneutes Lesen fehlgeschlagen. {0}</translation></message>
    <message numerus="yes"><source>%n unapplied edit(s) of the previous {0} saved. They are offered when that board is connected again.</source>
        <translation><numerusform>%n Änderung wurde nicht auf {0}, das vorige Board, angewendet: Sie bleibt erhalten und wird angeboten, wenn es wieder verbunden ist.</numerusform><numerusform>%n Änderungen wurden nicht auf {0}, das vorige Board, angewendet: Sie bleiben erhalten und werden angeboten, wenn es wieder verbunden ist.</numerusform></translation></message>
    <message numerus="yes"><source>%n earlier change(s) still pending. Review them to write to this board.</source>
        <translation><numerusform>%n frühere Änderung ist noch ausstehend. Prüfen Sie sie, um sie auf dieses Board zu schreiben.</numerusform><numerusform>%n frühere Änderungen sind noch ausstehend. Prüfen Sie sie, um sie auf dieses Board zu schreiben.</numerusform></translation></message>
    <message><source>Nothing was written: another board was selected.</source>
        <translation>Es wurde nichts geschrieben: Ein anderes Board wurde ausgewählt.</translation></message>
    <message numerus="yes"><source>%n edit(s) of the previous board saved. They return when that board is selected again.</source>
        <translation><numerusform>%n Änderung des bisherigen Boards bleibt erhalten: Sie ist wieder da, wenn es erneut ausgewählt wird.</numerusform><numerusform>%n Änderungen des bisherigen Boards bleiben erhalten: Sie sind wieder da, wenn es erneut ausgewählt wird.</numerusform></translation></message>
    <message><source>Nothing was written: the board does not respond.</source>
        <translation>Es wurde nichts geschrieben: Das Board antwortet nicht.</translation></message>
    <message><source>Noise on the line can make a motor turn the wrong way for a moment.</source>
        <translation>Störungen auf der Leitung können einen Motor für einen Augenblick in die andere Richtung drehen.</translation></message>
    <message><source>Board {0}: {1}</source>
        <translation>Board {0}: {1}</translation></message>
    <message><source>Stop</source>
        <translation>Stopp</translation></message>
    <message><source>Nothing was written: the settings read from the board have changed.</source>
        <translation>Es wurde nichts geschrieben: Vom Board wurden andere Einstellungen gelesen.</translation></message>
    <message><source>The network is not responding; the robot's server stops the motors.</source>
        <translation>Das Netz ist still; der Server des Roboters stoppt die Motoren.</translation></message>
    <message><source>{0} and {1} more</source>
        <translation>{0} und {1} weitere</translation></message>
    <message><source>Apply: {0}</source>
        <translation>Anwenden: {0}</translation></message>
    <message><source>Stop: {0}</source>
        <translation>Stopp: {0}</translation></message>
    <message><source>{0} ({1} failed)</source>
        <translation>{0} ({1} fehlgeschlagen)</translation></message>
    <message><source>The connection is not responding, so the stop could not be sent.</source>
        <translation>Die Verbindung reagiert nicht, daher konnte der Stopp nicht gesendet werden.</translation></message>
    <message><source>The stop may not have reached the {0} that was driven at {1}: another board responded. If a motor of that board is still turning, cut its power.</source>
        <translation>Ob ein Stopp das an {1} angesteuerte Board ({0}) erreicht hat, ist nicht bekannt: Ein anderes Board hat geantwortet. Falls sich am angesteuerten Board noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>Another board responds now: {0}, at {1}.</source>
        <translation>Jetzt antwortet ein anderes Board: {0}, an {1}.</translation></message>
    <message><source>The connection to {0} was lost before a stop was confirmed. The board now at this port has confirmed a stop. If this is another board, cut the power of the first board.</source>
        <translation>Die Leitung zu {0} brach ab, bevor ein Stopp bestätigt war. Das Board an diesem Port hat einen bestätigt; falls es ein anderes Board ist, trennen Sie die Motorversorgung des ersten.</translation></message>
    <message><source>The connection is not responding.</source>
        <translation>Die Verbindung reagiert nicht.</translation></message>
    <message><source>The guardian process is sending the stop now.</source>
        <translation>Der Wächterprozess sendet ihn jetzt.</translation></message>
    <message><source>The guardian process stopped the motors, and the board confirmed it.</source>
        <translation>Der Wächterprozess hat die Motoren gestoppt, und das Board hat das bestätigt.</translation></message>
    <message><source>The board that was lost while it was driven is back.</source>
        <translation>Das Board, dessen Verbindung beim Fahren abbrach, ist wieder da.</translation></message>
    <message><source>This may be another board: the settings of {0}, at {1}, differ from those of the board that was driven.</source>
        <translation>Das ist vielleicht ein anderes Board: {0}, an {1}, speichert nicht die Einstellungen des Boards, das angesteuert wurde.</translation></message>
    <message><source>{0}, device {1}</source>
        <translation>{0}, Gerät {1}</translation></message>
    <message><source>{0} The motors were stopped. Arm the motors again to continue.</source>
        <translation>{0} Die Motoren wurden gestoppt. Geben Sie sie wieder frei, um fortzufahren.</translation></message>
    <message><source>A setting of the board changed, so the motors were stopped.</source>
        <translation>Eine Einstellung des Boards hat sich geändert, daher wurden die Motoren gestoppt.</translation></message>
    <message><source>The board was restarted, so the motors were stopped.</source>
        <translation>Das Board wurde neu gestartet, daher wurden die Motoren gestoppt.</translation></message>
    <message><source>Connect to a board first.</source>
        <translation>Verbinden Sie zuerst ein Board.</translation></message>
    <message><source>Settings are being written.</source>
        <translation>Einstellungen werden geschrieben.</translation></message>
    <message><source>The motors were stopped and stay locked for another {0:.0f} s.</source>
        <translation>Nach einem Stopp sind die Motoren noch {0:.0f} s gesperrt.</translation></message>
    <message><source>Another control is driving now.</source>
        <translation>Jetzt steuert ein anderes Bedienelement.</translation></message>
    <message><source>{0} A test needs serial control.</source>
        <translation>{0} Ein Test braucht die serielle Steuerung.</translation></message>
    <message><source>Stop the motors first ({0}).</source>
        <translation>Bringen Sie zuerst die Motoren zur Ruhe ({0}).</translation></message>
    <message><source>coast</source>
        <translation>auslaufen</translation></message>
    <message><source>no limit</source>
        <translation>keine Grenze</translation></message>
    <message><source>Serial timeout is off: motors keep turning if the cable or this computer fails.</source>
        <translation>Das serielle Timeout ist aus: Die Motoren drehen sich weiter, wenn das Kabel oder dieser Computer ausfällt.</translation></message>
    <message><source>Serial timeout is off, and the guardian process could not be started: motors keep turning if the cable, this computer or this program fails.</source>
        <translation>Das serielle Timeout ist aus, und der Wächterprozess konnte nicht gestartet werden: Die Motoren drehen sich weiter, wenn das Kabel, dieser Computer oder dieses Programm ausfällt.</translation></message>
    <message><source>brake, {0}</source>
        <translation>bremsen, {0}</translation></message>
    <message><source>forward</source>
        <translation>vorwärts</translation></message>
    <message><source>reverse</source>
        <translation>rückwärts</translation></message>
    <message><source>no current sensing in joint mode</source>
        <translation>keine Strommessung im Parallelbetrieb</translation></message>
    <message><source>limit {0:.1f} A</source>
        <translation>Grenze {0:.1f} A</translation></message>
    <message><source>Serial timeout is on, but did not stop the motors of this board when it was tested: motors keep turning if the cable or this computer fails.</source>
        <translation>Das serielle Timeout ist an, hat die Motoren dieses Boards bei dem Versuch aber nicht gestoppt: Sie drehen sich weiter, wenn das Kabel oder dieser Computer ausfällt.</translation></message>
    <message><source>channel {0} at {1} (overridden)</source>
        <translation>Kanal {0} auf {1} (durch Vorrang ohne Wirkung)</translation></message>
    <message><source>UART-Error Shutdown is off: motors may keep turning if the cable or this computer fails, although the serial timeout is on (twin).</source>
        <translation>„Abschaltung bei UART-Fehlern“ ist aus: Die Motoren drehen sich vielleicht weiter, wenn das Kabel oder dieser Computer ausfällt, obwohl das serielle Timeout an ist (Zwilling).</translation></message>
    <message><source>UART-Error Shutdown is off, and the serial timeout did not stop the motors of this board when it was tested: motors keep turning if the cable or this computer fails.</source>
        <translation>„Abschaltung bei UART-Fehlern“ ist aus, und das serielle Timeout hat die Motoren dieses Boards nicht gestoppt, als es ausprobiert wurde: Sie drehen sich weiter, wenn das Kabel oder dieser Computer ausfällt.</translation></message>
    <message><source>The guardian process could not be started: if this program fails, motors keep turning until the serial timeout of {0:g} s expires.</source>
        <translation>Der Wächterprozess konnte nicht gestartet werden: Fällt dieses Programm aus, drehen sich die Motoren für die Dauer des seriellen Timeouts von {0:g} s weiter.</translation></message>
    <message><source>The serial timeout of {0:g} s is short for a network port: one late reply stops the motors while you drive. Set a longer timeout, or connect the board to this computer.</source>
        <translation>Das serielle Timeout von {0:g} s ist kurz für einen Netzwerkport: Eine einzige späte Antwort stoppt die Motoren beim Fahren. Stellen Sie ein längeres ein oder schließen Sie das Board an diesen Computer an.</translation></message>
    <message><source>The serial timeout of {0:g} s is short for {1} baud: one lost reply stops the motors while you drive. Set a longer timeout or a higher baud rate.</source>
        <translation>Das serielle Timeout von {0:g} s ist kurz für {1} Baud: Eine einzige verlorene Antwort stoppt die Motoren beim Fahren. Stellen Sie ein längeres oder eine höhere Baudrate ein.</translation></message>
    <message><source>left stick, sideways</source>
        <translation>linker Knüppel, seitwärts</translation></message>
    <message><source>left stick, up and down</source>
        <translation>linker Knüppel, auf und ab</translation></message>
    <message><source>right stick, sideways</source>
        <translation>rechter Knüppel, seitwärts</translation></message>
    <message><source>right stick, up and down</source>
        <translation>rechter Knüppel, auf und ab</translation></message>
    <message><source>left trigger</source>
        <translation>linker Trigger</translation></message>
    <message><source>right trigger</source>
        <translation>rechter Trigger</translation></message>
    <message><source>left shoulder</source>
        <translation>linke Schultertaste</translation></message>
    <message><source>right shoulder</source>
        <translation>rechte Schultertaste</translation></message>
    <message><source>left stick pressed</source>
        <translation>linker Knüppel gedrückt</translation></message>
    <message><source>right stick pressed</source>
        <translation>rechter Knüppel gedrückt</translation></message>
    <message><source>D-pad up</source>
        <translation>Steuerkreuz oben</translation></message>
    <message><source>D-pad down</source>
        <translation>Steuerkreuz unten</translation></message>
    <message><source>D-pad left</source>
        <translation>Steuerkreuz links</translation></message>
    <message><source>D-pad right</source>
        <translation>Steuerkreuz rechts</translation></message>
    <message><source>A (the bottom button)</source>
        <translation>A, die unterste von vier</translation></message>
    <message><source>B (the right button)</source>
        <translation>B, die rechte von vier</translation></message>
    <message><source>X (the left button)</source>
        <translation>X, die linke von vier</translation></message>
    <message><source>Y (the top button)</source>
        <translation>Y, die oberste von vier</translation></message>
    <message><source>Arm the motors first.</source>
        <translation>Geben Sie zuerst die Motoren frei.</translation></message>
    <message><source>Driving with a gamepad was switched off.</source>
        <translation>Das Fahren mit dem Gamepad wurde ausgeschaltet.</translation></message>
    <message><source>Another gamepad was selected.</source>
        <translation>Ein anderes Gamepad wurde gewählt.</translation></message>
    <message><source>The gamepad settings were changed.</source>
        <translation>Die Einstellungen des Gamepads wurden geändert.</translation></message>
    <message><source>No gamepad is connected. Plug in or switch on a gamepad.</source>
        <translation>Es ist kein Gamepad verbunden. Stecken Sie eines ein oder schalten Sie es ein.</translation></message>
    <message><source>Release the sticks: driving starts only once both axes have been at rest. A worn stick may need a wider dead zone.</source>
        <translation>Lassen Sie die Knüppel los: Das Fahren beginnt erst, wenn beide Achsen in Ruhe waren. Ein abgenutzter Knüppel braucht vielleicht eine größere Totzone.</translation></message>
    <message><source>Release {0}, then hold it to drive.</source>
        <translation>Lassen Sie {0} los und halten Sie sie dann zum Fahren gedrückt.</translation></message>
    <message><source>Hold {0} and move a stick to drive.</source>
        <translation>Halten Sie {0} gedrückt und bewegen Sie zum Fahren einen Knüppel.</translation></message>
    <message><source>Move a stick to drive.</source>
        <translation>Bewegen Sie zum Fahren einen Knüppel.</translation></message>
    <message><source>Driving. Release the sticks to stop.</source>
        <translation>Es wird gefahren. Lassen Sie die Knüppel los, um zu stoppen.</translation></message>
    <message><source>Driving. Release {0} to stop.</source>
        <translation>Es wird gefahren. Lassen Sie {0} los, um zu stoppen.</translation></message>
    <message><source>button {0}</source>
        <translation>Taste {0}</translation></message>
    <message><source>axis {0}</source>
        <translation>Achse {0}</translation></message>
    <message><source>The gamepad “{0}” was disconnected.</source>
        <translation>Das Gamepad „{0}“ wurde getrennt.</translation></message>
    <message><source>Active above {0}, halfway between neutral and maximum (inferred).</source>
        <translation>Aktiv über {0}, in der Mitte zwischen Neutralstellung und Maximum (erschlossen).</translation></message>
    <message><source>Active below {0}, halfway between neutral and minimum (inferred).</source>
        <translation>Aktiv unter {0}, in der Mitte zwischen Neutralstellung und Minimum (erschlossen).</translation></message>
    <message><source>At rest the switch is active.</source>
        <translation>In Ruhe ist er aktiv.</translation></message>
    <message><source>At rest the switch is off.</source>
        <translation>In Ruhe ist er aus.</translation></message>
    <message><source>Cannot continue: the stop of the motors is not confirmed. {0}</source>
        <translation>Es kann nicht weitergehen: Für die Motoren ließ sich kein Stopp bestätigen. {0}</translation></message>
    <message><source>The test has ended. Nothing in the board was changed.</source>
        <translation>Der Test ist beendet; er ändert nichts im Board.</translation></message>
    <message><source>Nothing was changed.</source>
        <translation>Es wurde nichts geändert.</translation></message>
    <message><source>&amp;Learn channels…</source>
        <translation>Kanäle &amp;einlernen…</translation></message>
    <message><source>These values are already stored.</source>
        <translation>Diese Werte sind schon gespeichert.</translation></message>
    <message><source>The board accepted the stop, but {0}. Check the motors. If a motor is turning, cut its power: something else is driving it, such as another controller on this line. Continue only if no motor is turning.</source>
        <translation>Das Board hat den Stopp angenommen, aber {0}. Prüfen Sie die Motoren: Dreht sich einer, treibt ihn etwas anderes an, etwa ein anderer Controller an dieser Leitung; trennen Sie dann die Motorversorgung. Fahren Sie nur fort, wenn sie sich nicht drehen.</translation></message>
    <message><source>The learned values are stored.</source>
        <translation>Das Eingelernte ist gespeichert.</translation></message>
    <message><source>The board is in {0} mode: the sticks drive the motors, and the board rejects settings. Switch the board off, remove the mode jumper and switch the board on.</source>
        <translation>Das Board ist im Modus {0}: Die Knüppel steuern die Motoren, und es lehnt Einstellungen ab. Schalten Sie es aus, ziehen Sie den Modus-Jumper ab und schalten Sie es ein.</translation></message>
    <message><source>The board is in {0} mode. Channel 5 has switched the motors to serial control; when its switch moves again, the sticks drive the motors. In this mode the board rejects settings. Switch the board off, remove the mode jumper and switch the board on.</source>
        <translation>Das Board ist im Modus {0}. Kanal 5 hat die Motoren der seriellen Leitung übergeben, aber mit der nächsten Bewegung seines Schalters steuern die Knüppel wieder die Motoren; außerdem lehnt das Board Einstellungen ab. Schalten Sie es aus, ziehen Sie den Modus-Jumper ab und schalten Sie es ein.</translation></message>
    <message><source>The board was started in another mode.</source>
        <translation>Das Board wurde in einem anderen Modus gestartet.</translation></message>
    <message><source>The motors were armed, so this has ended.</source>
        <translation>Die Motoren wurden freigegeben, daher wurde dies beendet.</translation></message>
    <message><source>The sticks drive the motors now: the channels are in control.</source>
        <translation>Die Knüppel steuern jetzt die Motoren: Die Kanäle haben die Kontrolle.</translation></message>
    <message><source>motor {0} draws {1:.1f} A</source>
        <translation>Motor {0} nimmt {1:.1f} A auf</translation></message>
    <message><source>The signal moved during sampling, between {0} and {1}. Release the stick and sample again.</source>
        <translation>Er hat sich während der Messung bewegt, zwischen {0} und {1}. Lassen Sie ihn los und messen Sie erneut.</translation></message>
    <message><source>Release the stick and sample again. If the drift continues, the stick or the transmitter is warming up or worn.</source>
        <translation>Lassen Sie ihn los und messen Sie erneut; bleibt es dabei, wird der Knüppel oder der Sender erst warm oder ist abgenutzt.</translation></message>
    <message><source>Move the transmitter closer, or check the antenna and the cable.</source>
        <translation>Bringen Sie den Sender näher heran oder prüfen Sie Antenne und Kabel.</translation></message>
    <message><source>At rest the noise is {0}: a deadband wide enough to hide this noise would take a quarter of the travel. Repair the cable, the supply or the stick first.</source>
        <translation>In Ruhe beträgt sein Rauschen {0}: Ein Totbereich, der es verdeckt, nähme ein Viertel des Wegs ein. Reparieren Sie zuerst das Kabel, die Versorgung oder den Knüppel.</translation></message>
    <message><source>An unconnected input behaves in the same way.</source>
        <translation>Auch ein Eingang, an dem nichts angeschlossen ist, verhält sich so.</translation></message>
    <message><source>Either nothing is connected to this input (its voltage is then meaningless), or its stick was not moved.</source>
        <translation>Entweder ist nichts daran angeschlossen (dann bedeutet seine Spannung nichts), oder das Angeschlossene wurde nicht bewegt.</translation></message>
    <message><source>At least {1} is needed: the deadband plus one count for each of the {2} speeds.</source>
        <translation>Nötig sind mindestens {1}: der Totbereich und je ein Count für die {2} Geschwindigkeiten.</translation></message>
    <message><source>Push the stick in the other direction, too. If this is not possible, the stick was at an end during sampling.</source>
        <translation>Drücken Sie ihn auch in die andere Richtung; geht das nicht, war er während der Messung in einer Endlage.</translation></message>
    <message><source>The stick moved in one direction only.</source>
        <translation>Er ging nur in eine Richtung.</translation></message>
    <message><source>Go back, push the stick all the way and hold this position for {0:.1f} s.</source>
        <translation>Gehen Sie zurück, drücken Sie ihn bis zum Anschlag und halten Sie ihn dort {0:.1f} s.</translation></message>
    <message><source>The stick moved {0} to one side, but only {1} to the other side.</source>
        <translation>Er ging {0} zur einen Seite, aber nur {1} zur anderen.</translation></message>
    <message><source>Was the stick pushed all the way?</source>
        <translation>Wurde er bis zum Anschlag gedrückt?</translation></message>
    <message><source>Should the channel be reversed?</source>
        <translation>Sollte er umgekehrt sein oder gerade nicht?</translation></message>
    <message><source>No signal: no valid pulse arrives.</source>
        <translation>Kein Signal: Es kommt kein gültiger Impuls an.</translation></message>
    <message><source>Is the transmitter on, and is the receiver connected to this channel?</source>
        <translation>Ist der Sender eingeschaltet und der Empfänger an diesen Kanal angeschlossen?</translation></message>
    <message><source>No signal.</source>
        <translation>Kein Signal.</translation></message>
    <message><source>The signal drifted up by {0} during sampling.</source>
        <translation>Er ist während der Messung um {0} nach oben gewandert.</translation></message>
    <message><source>The signal drifted down by {0} during sampling.</source>
        <translation>Er ist während der Messung um {0} nach unten gewandert.</translation></message>
    <message><source>The signal comes and goes: {0:.0%} of the samples had no valid pulse.</source>
        <translation>Das Signal kommt und geht: {0:.0%} der Messwerte hatten keinen gültigen Impuls.</translation></message>
    <message><source>Outlying pulses: {0} of {1}.</source>
        <translation>Impulse weit abseits aller anderen: {0} von {1}.</translation></message>
    <message><source>The radio link is poor, or the cable picks up noise.</source>
        <translation>Die Funkverbindung ist schlecht, oder das Kabel fängt Störungen ein.</translation></message>
    <message><source>About {0:.0%} of the pulses are lost (estimated: the value often repeats where it otherwise varies).</source>
        <translation>Etwa {0:.0%} der Impulse gehen verloren (geschätzt: Der Wert wiederholt sich oft, wo er sonst schwankt).</translation></message>
    <message><source>The board repeats the last value, so losses below a third, or losses in a steadier signal, cannot be detected.</source>
        <translation>Das Board wiederholt den letzten Wert; Verluste unter einem Drittel oder bei einem ruhigeren Signal bleiben daher unbemerkt.</translation></message>
    <message><source>At rest the noise is {0}, more than the deadband ({1}): the motor would creep.</source>
        <translation>In Ruhe beträgt das Rauschen {0}, mehr als der Totbereich ({1}): Der Motor würde kriechen.</translation></message>
    <message><source>A steady signal arrives, but it never moved.</source>
        <translation>Er hat sich nie bewegt, obwohl ein stetiges Signal ankommt.</translation></message>
    <message><source>Either another stick controls this channel, or the stick was not moved.</source>
        <translation>Entweder steuert ein anderer Knüppel diesen Kanal, oder der Knüppel wurde nicht bewegt.</translation></message>
    <message><source>This input does not change: it stays at {0}.</source>
        <translation>An diesem Eingang bewegt sich nichts: Er bleibt bei {0}.</translation></message>
    <message><source>This input does not change: it stays at {0}, an end of the measuring range.</source>
        <translation>An diesem Eingang bewegt sich nichts: Er bleibt bei {0}, einem Ende des Messbereichs.</translation></message>
    <message><source>The stick moved only {0} from its rest position.</source>
        <translation>Er ging nur {0} aus seiner Ruhelage.</translation></message>
    <message><source>The low end is only {0} from the rest position.</source>
        <translation>Die untere Endlage ist nur {0} von der Ruhelage entfernt.</translation></message>
    <message><source>The high end is only {0} from the rest position.</source>
        <translation>Die obere Endlage ist nur {0} von der Ruhelage entfernt.</translation></message>
    <message><source>The low end was only passed, not held.</source>
        <translation>Die untere Endlage wurde nur durchlaufen, nicht gehalten.</translation></message>
    <message><source>The high end was only passed, not held.</source>
        <translation>Die obere Endlage wurde nur durchlaufen, nicht gehalten.</translation></message>
    <message><source>Both ends were only passed, not held.</source>
        <translation>Beide Endlagen wurden nur durchlaufen, nicht gehalten.</translation></message>
    <message><source>The rest position ({0}) is not between the ends ({1} and {2}).</source>
        <translation>Seine Ruhelage ({0}) liegt nicht zwischen seinen Endlagen ({1} und {2}).</translation></message>
    <message><source>Was a trim moved? Begin again with the sticks at rest.</source>
        <translation>Wurde eine Trimmung verstellt? Beginnen Sie erneut mit den Knüppeln in Ruhe.</translation></message>
    <message><source>The stick rests at {0}: with this neutral, the output there would be {1}.</source>
        <translation>Er ruht bei {0}: Mit dieser Neutralstellung gäbe er dort {1} aus.</translation></message>
    <message><source>After release the stick rests at {0}, not at {1}, and the output there would be {2}.</source>
        <translation>Nach dem Loslassen ruht er bei {0}, nicht bei {1}, und gäbe dort {2} aus.</translation></message>
    <message><source>Was a hand on the stick during sampling, or was a trim moved?</source>
        <translation>War während der Messung eine Hand daran, oder wurde eine Trimmung verstellt?</translation></message>
    <message><source>Go back and sample the channel again, or use the new rest position.</source>
        <translation>Gehen Sie zurück und messen Sie ihn erneut, oder verwenden Sie die neue Ruhelage.</translation></message>
    <message><source>{0} is beyond {1}, the farthest value reached: the output cannot reach its full value.</source>
        <translation>{0} liegt jenseits der erreichten {1}: Es gibt keinen vollen Ausgang.</translation></message>
    <message><source>Beyond the rest position the motor speeds up again: at {0}, to {1} of {2} in either direction.</source>
        <translation>Jenseits der Ruhelage wird der Motor wieder schneller, unabhängig vom Vorzeichen: bei {0} bis auf {1} von {2}.</translation></message>
    <message><source>Check that no trim and no broken wire can move the signal there.</source>
        <translation>Prüfen Sie, dass weder eine Trimmung noch ein gebrochenes Kabel ihn dorthin bringen kann.</translation></message>
    <message><source>The rest position ({0}) is too close to the switching point ({1}).</source>
        <translation>Seine Ruhelage ({0}) liegt zu nah an seinem Schaltpunkt ({1}).</translation></message>
    <message><source>The channel may switch by itself.</source>
        <translation>Er kann von selbst schalten.</translation></message>
    <message><source>The switch is active in all its positions: none is beyond the switching point, {0}.</source>
        <translation>Er ist in allen seinen Stellungen aktiv: Keine liegt jenseits von {0}, wo er schaltet.</translation></message>
    <message><source>The switch is inactive in all its positions: none is beyond the switching point, {0}.</source>
        <translation>Er ist in allen seinen Stellungen inaktiv: Keine liegt jenseits von {0}, wo er schaltet.</translation></message>
    <message><source>In {0} mode safe-start would release the motors now.</source>
        <translation>Im Modus {0} würde Safe-Start die Motoren jetzt laufen lassen.</translation></message>
    <message><source>Ignored: the board holds this channel at neutral. There is nothing to test.</source>
        <translation>Ignoriert: Das Board hält ihn in Neutralstellung. Es gibt nichts zu testen.</translation></message>
    <message><source>Good.</source>
        <translation>Gut.</translation></message>
    <message><source>Only {0} was detected. Move the switch to its other position.</source>
        <translation>Nur „{0}“ wurde gesehen. Stellen Sie den Schalter in die andere Stellung.</translation></message>
    <message><source>Full output not reached yet. Push the stick all the way.</source>
        <translation>Voller Ausgang noch nicht erreicht. Drücken Sie ihn bis zum Anschlag.</translation></message>
    <message><source>Full output not reached yet: {0}.</source>
        <translation>Voller Ausgang noch nicht erreicht: {0}.</translation></message>
    <message><source>Full output reached. Let the stick rest for a moment.</source>
        <translation>Voller Ausgang erreicht. Lassen Sie ihn einen Moment ruhen.</translation></message>
    <message><source>In {0} mode safe-start would hold the motors now. {1}</source>
        <translation>Im Modus {0} würde Safe-Start die Motoren jetzt zurückhalten. {1}</translation></message>
    <message><source>Move the switch to all its positions.</source>
        <translation>Bringen Sie den Schalter in alle seine Stellungen.</translation></message>
    <message><source>Full output reached. Release the stick: at rest the output must be 0, but it is {0}.</source>
        <translation>Voller Ausgang erreicht. Lassen Sie ihn los: In Ruhe muss der Ausgang 0 sein, er ist aber {0}.</translation></message>
    <message><source>off</source>
        <translation>aus</translation></message>
    <message><source>on</source>
        <translation>an</translation></message>
    <message><source>The board is back. It has confirmed the stop.</source>
        <translation>Das Board ist wieder da. Es hat den Stopp bestätigt.</translation></message>
    <message><source>The board is back. It has confirmed the stop. It received nothing for {0:.0f} s: did its Serial Timeout stop the motor during that time?</source>
        <translation>Das Board ist wieder da. Es hat den Stopp bestätigt. {0:.0f} s lang hat es nichts empfangen: Hat sein serielles Timeout den Motor inzwischen gestoppt?</translation></message>
    <message><source>It stopped</source>
        <translation>Er hat gestoppt</translation></message>
    <message><source>It kept turning</source>
        <translation>Er drehte sich weiter</translation></message>
    <message><source>brake</source>
        <translation>bremsen</translation></message>
    <message><source>motor {0}</source>
        <translation>Motor {0}</translation></message>
    <message><source>left</source>
        <translation>links</translation></message>
    <message><source>right</source>
        <translation>rechts</translation></message>
    <message><source>auxiliary {0}</source>
        <translation>Hilfsmotor {0}</translation></message>
    <message><source>Hexadecimal, such as 9F 07</source>
        <translation>Hexadezimal, zum Beispiel 9F 07</translation></message>
    <message><source>A stop would not reach that board: address device {0}.</source>
        <translation>Ein Stopp würde dieses Board nicht erreichen: Adressieren Sie Gerät {0}.</translation></message>
    <message><source>{0}: {1}</source>
        <translation>{0}: {1}</translation></message>
    <message numerus="yes"><source>and %n more packet(s)</source>
        <translation><numerusform>und %n weiteres Paket</numerusform><numerusform>und %n weitere Pakete</numerusform></translation></message>
    <message><source>Every board on this line would store the value: address device {0}.</source>
        <translation>Jedes Board an dieser Leitung würde es speichern: Adressieren Sie Gerät {0}.</translation></message>
    <message><source>Every board on this line would store the value: select a board.</source>
        <translation>Jedes Board an dieser Leitung würde es speichern: Wählen Sie eines davon aus.</translation></message>
    <message><source>Sent {0}; the reply is {1}.</source>
        <translation>{0} gesendet; die Antwort ist {1}.</translation></message>
    <message><source>Sent {0}; there was no reply.</source>
        <translation>{0} gesendet; es kam keine Antwort.</translation></message>
    <message><source>{0} (may move a motor)</source>
        <translation>{0} (kann einen Motor bewegen)</translation></message>
    <message><source>{0} (stored at once, without a snapshot)</source>
        <translation>{0} (sofort gespeichert, ohne Sicherungskopie)</translation></message>
    <message><source>Sent by hand: {0}</source>
        <translation>Von Hand gesendet: {0}</translation></message>
    <message><source>Parameter</source>
        <translation>Parameter</translation></message>
    <message><source>Motors and speed ramp</source>
        <translation>Motoren und Geschwindigkeitsrampe</translation></message>
    <message><source>Braking</source>
        <translation>Bremsen</translation></message>
    <message><source>Current</source>
        <translation>Strom</translation></message>
    <message><source>PWM</source>
        <translation>PWM</translation></message>
    <message><source>Inputs</source>
        <translation>Eingänge</translation></message>
    <message><source>Serial</source>
        <translation>Seriell</translation></message>
    <message><source>System</source>
        <translation>System</translation></message>
    <message><source>{0} ({1} modified)</source>
        <translation>{0} ({1} geändert)</translation></message>
    <message><source>Motors 1 and 2 {0}</source>
        <translation>{0} Motor 1 und 2</translation></message>
    <message><source>{0}: {1} is not a valid value.</source>
        <translation>{0}: {1} ist kein gültiger Wert.</translation></message>
    <message><source>Switching frequency of the motor's PWM. Low frequencies make the motor whine and heat up; frequencies above the driver's rating heat the driver. Type a number or use the arrow keys. The board stores the nearest frequency that it supports.</source>
        <translation>Wie oft pro Sekunde die PWM des Motors schaltet. Niedrige Frequenzen pfeifen und erwärmen den Motor, Frequenzen über dem Nennwert des Treibers erwärmen den Treiber. Geben Sie eine Zahl ein oder benutzen Sie die Pfeiltasten. Das Board speichert die nächste Frequenz, mit der es schalten kann.</translation></message>
    <message><source>This firmware has also stored wire values outside this range: {0}.</source>
        <translation>Diese Firmware hat darüber hinaus gespeichert: Bytewert {0}.</translation></message>
    <message><source>(twin): documented for Pololu's qik 2s12v10, which has the same motor drivers.</source>
        <translation>(Zwilling): dokumentiert für den qik 2s12v10 von Pololu, der dieselben Motortreiber hat.</translation></message>
    <message><source>(inferred): not confirmed by any document.</source>
        <translation>(erschlossen): Kein Dokument bestätigt es.</translation></message>
    <message><source>PWM Frequency</source>
        <translation>PWM-Frequenz</translation></message>
    <message><source>Takes effect when the board is switched off and on.</source>
        <translation>Wird wirksam, wenn das Board aus- und eingeschaltet wird.</translation></message>
    <message><source>{0} to {1}</source>
        <translation>{0} bis {1}</translation></message>
    <message><source>{0} PWM Frequency</source>
        <translation>PWM-Frequenz {0}</translation></message>
    <message><source>not given</source>
        <translation>nicht angegeben</translation></message>
    <message><source>not read</source>
        <translation>nicht gelesen</translation></message>
    <message><source>{0}, was {1}</source>
        <translation>{0}, war {1}</translation></message>
    <message><source>{0} · default: {1}</source>
        <translation>{0} · Standard: {1}</translation></message>
    <message><source>User's guide</source>
        <translation>Benutzerhandbuch des Boards</translation></message>
    <message><source>{0} differs: {1}.</source>
        <translation>{0} weicht ab: {1}.</translation></message>
    <message><source>Reset to default: {0}</source>
        <translation>Auf Standardwert zurücksetzen: {0}</translation></message>
    <message><source>{0}: {1}.</source>
        <translation>{0}: {1}.</translation></message>
    <message><source>{0:.0f} Hz</source>
        <translation>{0:.0f} Hz</translation></message>
    <message><source>prescaler {0}, maximum {1}</source>
        <translation>Vorteiler {0}, Maximum {1}</translation></message>
    <message><source>Range: {0}{1}.</source>
        <translation>Bereich: {0}{1}.</translation></message>
    <message><source>Default: {0}{1}.</source>
        <translation>Standardwert: {0}{1}.</translation></message>
    <message><source>User's guide, section {0}</source>
        <translation>Benutzerhandbuch, Abschnitt {0}</translation></message>
    <message><source>wire {0}</source>
        <translation>Bytewert {0}</translation></message>
    <message><source>Wire value: {0}.</source>
        <translation>Bytewert: {0}.</translation></message>
    <message><source>The meaning of the wire values is undocumented{0}.</source>
        <translation>Keine Quelle sagt, was die Bytewerte bedeuten{0}.</translation></message>
    <message><source>Still active: {0}.</source>
        <translation>Noch aktiv: {0}.</translation></message>
    <message><source>{0} {1}</source>
        <translation>{0} {1}</translation></message>
    <message><source>Set up as {0}</source>
        <translation>Eingerichtet als {0}</translation></message>
    <message><source>Recording {0} ended: the board or its input source has changed.</source>
        <translation>Aufzeichnung {0} beendet: Das Board oder seine Eingangsquelle hat sich geändert.</translation></message>
    <message><source>The records of this board cannot be used. {0}</source>
        <translation>Die Daten zu diesem Board lassen sich nicht verwenden. {0}</translation></message>
    <message><source>calibration of channel {0}: {1}</source>
        <translation>Kalibrierung von Kanal {0}: {1}</translation></message>
    <message><source>Setting</source>
        <translation>Einstellung</translation></message>
    <message><source>Wire</source>
        <translation>Bytewert</translation></message>
    <message><source>Result</source>
        <translation>Ergebnis</translation></message>
    <message><source>stored</source>
        <translation>gespeichert</translation></message>
    <message><source>Note: {0}</source>
        <translation>Notiz: {0}</translation></message>
    <message><source>{0}; it is shown as Western European text. Check the characters that are not plain letters; Save writes UTF-8</source>
        <translation>{0}; sie wird als westeuropäischer Text angezeigt. Prüfen Sie die Zeichen, die keine einfachen Buchstaben sind; beim Speichern wird UTF-8 geschrieben</translation></message>
    <message><source>{0} is left out because it could not be read from the board.</source>
        <translation>{0} wird ausgelassen: Der Wert konnte nicht vom Board gelesen werden.</translation></message>
    <message><source>The {0} calibrations are left out: the board accepts them only while its input source is {0}.</source>
        <translation>Die Kalibrierungen ({0}) werden ausgelassen: Das Board nimmt sie nur an, solange seine Eingangsquelle {0} ist.</translation></message>
    <message><source>These settings are for a {0}, not a {1}</source>
        <translation>Diese Einstellungen sind für einen {0}, nicht für einen {1}</translation></message>
    <message><source>Reset to factory defaults</source>
        <translation>Auf Werkseinstellungen zurücksetzen</translation></message>
    <message><source>There are no settings to compare with</source>
        <translation>Es gibt keine Einstellungen zum Vergleichen</translation></message>
    <message><source>Note on {0}</source>
        <translation>Notiz zu {0}</translation></message>
    <message><source>Discard edits</source>
        <translation>Änderungen verwerfen</translation></message>
    <message><source>Unapplied edits cannot be saved for the next start. {0}</source>
        <translation>Nicht angewendete Änderungen können nicht für den nächsten Start gesichert werden. {0}</translation></message>
    <message><source>Restore edits</source>
        <translation>Änderungen wiederherstellen</translation></message>
    <message><source>Edits of this board</source>
        <translation>Änderungen an diesem Board</translation></message>
    <message><source>Name</source>
        <translation>Name</translation></message>
    <message><source>Note</source>
        <translation>Notiz</translation></message>
    <message><source>Before</source>
        <translation>Vor</translation></message>
    <message><source>Board</source>
        <translation>Board</translation></message>
    <message><source>No.</source>
        <translation>Nr.</translation></message>
    <message><source>damaged</source>
        <translation>beschädigt</translation></message>
    <message><source>today {0}</source>
        <translation>heute {0}</translation></message>
    <message><source>yesterday {0}</source>
        <translation>gestern {0}</translation></message>
    <message><source>This snapshot is damaged and cannot be restored. {0}</source>
        <translation>Diese Sicherungskopie ist beschädigt und kann nicht wiederhergestellt werden. {0}</translation></message>
    <message><source>The board accepts changes in serial mode only: switch the board off, remove the mode jumper, and switch the board on. Your edits are kept.</source>
        <translation>Das Board nimmt Änderungen nur im seriellen Modus an: Schalten Sie es aus, ziehen Sie den Modus-Jumper ab, schalten Sie es ein. Änderungen bleiben erhalten.</translation></message>
    <message><source>Nothing was written because no snapshot could be saved first. {0}</source>
        <translation>Es wurde nichts geschrieben, weil zuvor keine Sicherungskopie gespeichert werden konnte. {0}</translation></message>
    <message><source>Nothing was written: without a device number, the write would reach every board on this line. Select a board first.</source>
        <translation>Es wurde nichts geschrieben: Ohne Gerätenummer würde es mehrere Boards erreichen. Wählen Sie eines der Boards an dieser Leitung aus.</translation></message>
    <message><source>Nothing else was written. {0}</source>
        <translation>Mehr wurde nicht geschrieben. {0}</translation></message>
    <message numerus="yes"><source>Apply of %n setting(s)</source>
        <translation><numerusform>Anwenden von %n Einstellung</numerusform><numerusform>Anwenden von %n Einstellungen</numerusform></translation></message>
    <message><source>{0} set</source>
        <translation>{0} gesetzt</translation></message>
    <message><source>Joint mode: both outputs drive one motor, so there is nothing to identify.</source>
        <translation>Parallelbetrieb: Beide Ausgänge treiben einen Motor, es gibt also nichts herauszufinden.</translation></message>
    <message><source>Lift the robot so that its wheels turn freely, then confirm this here.</source>
        <translation>Heben Sie den Roboter an, sodass sich die Räder frei drehen, und bestätigen Sie das hier.</translation></message>
    <message><source>The wheels may touch the ground.</source>
        <translation>Die Räder berühren vielleicht den Boden.</translation></message>
    <message><source>The assistant was closed.</source>
        <translation>Der Assistent wurde geschlossen.</translation></message>
    <message><source>Another step of the assistant was opened.</source>
        <translation>Ein anderer Schritt des Assistenten wurde geöffnet.</translation></message>
    <message><source>Set up my robot</source>
        <translation>Meinen Roboter einrichten</translation></message>
    <message><source>Speed setpoint {0}</source>
        <translation>Geschwindigkeitssollwert {0}</translation></message>
    <message><source>Channel {0}</source>
        <translation>Kanal {0}</translation></message>
    <message><source>{0} channel {1}</source>
        <translation>Kanal {1} ({0})</translation></message>
    <message><source>expected a number of counts (3750) or a value with a unit (1500us, 2.5V), not {0}</source>
        <translation>es sind Counts (3750) oder etwas wie 1500us oder 2.5V, nicht {0}</translation></message>
    <message><source>minimum {0} is above neutral {1}</source>
        <translation>Minimum {0} liegt über der Neutralstellung {1}</translation></message>
    <message><source>neutral {0} is above maximum {1}</source>
        <translation>Neutralstellung {0} liegt über dem Maximum {1}</translation></message>
    <message><source>minimum and maximum are both {0}; they must differ</source>
        <translation>Minimum und Maximum sind beide {0}; sie müssen verschieden sein</translation></message>
    <message><source>{0} is {1}; a calibration value must be 0 to {2}</source>
        <translation>{0} ist {1}; ein Kalibrierwert ist 0 bis {2}</translation></message>
    <message><source>calibration: {0}</source>
        <translation>Kalibrierung: {0}</translation></message>
    <message><source>a channel mask must be 0 to {0}, not {1}</source>
        <translation>eine Kanalmaske ist 0 bis {0}, nicht {1}</translation></message>
    <message><source>parameter number</source>
        <translation>Parameternummer</translation></message>
    <message><source>{0:#04x} is not a TReX mode (R, A, r or a)</source>
        <translation>{0:#04x} ist kein Modus eines TReX (R, A, r oder a)</translation></message>
    <message><source>the request came back instead of a status</source>
        <translation>statt eines Status kam die Anfrage zurück</translation></message>
    <message><source>the motor number must be 1 or 2, not {0}</source>
        <translation>die Motoren haben die Nummern 1 und 2, nicht {0}</translation></message>
    <message><source>{0} is not the signature of a TReX</source>
        <translation>{0} ist nicht die Signatur eines TReX</translation></message>
    <message><source>a write must end in 55 2A, not {0}</source>
        <translation>ein Schreibbefehl endet mit 55 2A, nicht {0}</translation></message>
    <message><source>speed of the auxiliary motor</source>
        <translation>Geschwindigkeit des Hilfsmotors</translation></message>
    <message><source>the channel number must be 1 to 5, not {0}</source>
        <translation>die Kanäle haben die Nummern 1 bis 5, nicht {0}</translation></message>
    <message><source>the control flag must be 0 or 1, not {0}</source>
        <translation>0 oder 1 gibt an, wer die Motoren steuert, nicht {0}</translation></message>
    <message><source>{0:#04x} names channels that a TReX does not have</source>
        <translation>{0:#04x} nennt Kanäle, die ein TReX nicht hat</translation></message>
    <message><source>a parameter number must be 0 to 127, not {0}</source>
        <translation>ein Parameter ist 0 bis 127, nicht {0}</translation></message>
    <message><source>{0} is not a TReX result code (0 to 3)</source>
        <translation>{0} ist kein Ergebniscode eines TReX (0 bis 3)</translation></message>
    <message><source>parameter value</source>
        <translation>Parameterwert</translation></message>
    <message><source>device number</source>
        <translation>Gerätenummer</translation></message>
    <message><source>Boards that are driven together need different device numbers.</source>
        <translation>Boards, die gemeinsam gefahren werden, brauchen eigene Nummern.</translation></message>
    <message><source>The board needs a device number that no other device on the line has.</source>
        <translation>Das Board braucht eine Nummer, die kein anderes Gerät hat.</translation></message>
    <message><source>{0!r} are not valid board settings</source>
        <translation>{0!r} sind keine Einstellungen eines Boards</translation></message>
    <message><source>Measured currents may be off by 20 % (twin).</source>
        <translation>Das Board misst Ströme vielleicht um 20 % falsch (Zwilling).</translation></message>
    <message><source>The stop is not confirmed. If a motor is still turning, cut its power.</source>
        <translation>Der Stopp ist nicht bestätigt. Falls sich noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>The stop was sent, but has no effect yet: the channels control the motors until channel 5 gives control to serial commands. Release the sticks, or cut the power.</source>
        <translation>Der Stopp wurde gesendet, aber die Kanäle steuern die Motoren: Er wirkt erst, wenn Kanal 5 die Steuerung an serielle Befehle übergibt. Lassen Sie die Knüppel los, oder trennen Sie die Motorversorgung.</translation></message>
    <message><source>minimum</source>
        <translation>Minimum</translation></message>
    <message><source>neutral</source>
        <translation>neutral</translation></message>
    <message><source>maximum</source>
        <translation>Maximum</translation></message>
    <message><source>deadband</source>
        <translation>Totbereich</translation></message>
    <message><source>get signature</source>
        <translation>Signatur lesen</translation></message>
    <message><source>get mode</source>
        <translation>Modus lesen</translation></message>
    <message><source>get serial control flag</source>
        <translation>lesen, ob die Motoren seriell gesteuert werden</translation></message>
    <message><source>get and clear status bits</source>
        <translation>Statusbits lesen und löschen</translation></message>
    <message><source>get and clear UART error bits</source>
        <translation>UART-Fehlerbits lesen und löschen</translation></message>
    <message><source>get currents of both motors</source>
        <translation>Ströme beider Motoren lesen</translation></message>
    <message><source>get channels with a changed calibration</source>
        <translation>lesen, welche Kalibrierungen vom Standardwert abweichen</translation></message>
    <message><source>null command (no effect)</source>
        <translation>Nullbefehl: nichts</translation></message>
    <message><source>RC mode</source>
        <translation>RC-Modus</translation></message>
    <message><source>analog mode</source>
        <translation>Analogmodus</translation></message>
    <message><source>serial mode, RC inputs</source>
        <translation>serieller Modus, RC-Eingänge</translation></message>
    <message><source>serial mode, analog inputs</source>
        <translation>serieller Modus, Analogeingänge</translation></message>
    <message><source>rejected: no such parameter (code 1)</source>
        <translation>abgelehnt: kein solcher Parameter (Code 1)</translation></message>
    <message><source>rejected: this value is not allowed (code 2)</source>
        <translation>abgelehnt: Dieser Wert ist nicht erlaubt (Code 2)</translation></message>
    <message><source>rejected: not in serial mode (code 3)</source>
        <translation>abgelehnt: nicht im seriellen Modus (Code 3)</translation></message>
    <message><source>RC mode: a radio receiver drives the motors.</source>
        <translation>RC-Modus: Ein Funkempfänger steuert die Motoren.</translation></message>
    <message><source>Analog mode: voltages (joysticks, potentiometers) drive the motors.</source>
        <translation>Analogmodus: Spannungen (Joysticks, Potentiometer) steuern die Motoren.</translation></message>
    <message><source>Serial mode, with inputs read as RC pulses.</source>
        <translation>Serieller Modus, Eingänge als RC-Impulse gelesen.</translation></message>
    <message><source>Serial mode, with inputs read as voltages.</source>
        <translation>Serieller Modus, Eingänge als Spannungen gelesen.</translation></message>
    <message><source>motor 1 (mixed: turn)</source>
        <translation>Motor 1 (mit Mischer: lenken)</translation></message>
    <message><source>motor 2 (mixed: forward)</source>
        <translation>Motor 2 (mit Mischer: vor und zurück)</translation></message>
    <message><source>auxiliary motor</source>
        <translation>Hilfsmotor</translation></message>
    <message><source>flip switch</source>
        <translation>Umdrehschalter</translation></message>
    <message><source>serial override switch</source>
        <translation>Vorrangschalter (serielle Befehle)</translation></message>
    <message><source>Serial commands control the motors (serial mode).</source>
        <translation>Serielle Befehle steuern die Motoren (serieller Modus).</translation></message>
    <message><source> Joint mode: both drivers work together as motor 1, and commands for motor 2 are ignored.</source>
        <translation> Parallelbetrieb: Beide Treiber arbeiten zusammen als Motor 1, Befehle für Motor 2 werden ignoriert.</translation></message>
    <message><source>accelerate</source>
        <translation>beschleunigen</translation></message>
    <message><source>set</source>
        <translation>setzen</translation></message>
    <message><source>no TReX</source>
        <translation>kein TReX</translation></message>
    <message><source>set calibration of channel {0}: {1}</source>
        <translation>Kalibrierung von Kanal {0} setzen: {1}</translation></message>
    <message><source>{0} motor 1 to {1}, motor 2 to {2}</source>
        <translation>{0}: Motor 1 {1}, Motor 2 {2}</translation></message>
    <message><source>Serial commands control the motors: channel 5 overrides the other inputs.</source>
        <translation>Serielle Befehle steuern die Motoren: Kanal 5 hat Vorrang vor den anderen Eingängen.</translation></message>
    <message><source>motor {0}: {1:.2f} A</source>
        <translation>Motor {0}: {1:.2f} A</translation></message>
    <message><source>all channels</source>
        <translation>alle Kanäle</translation></message>
    <message><source>no channel</source>
        <translation>kein Kanal</translation></message>
    <message><source>parameter {0:#04x}, which {1} has</source>
        <translation>Parameter {0:#04x}, den {1} hat</translation></message>
    <message><source>yes</source>
        <translation>ja</translation></message>
    <message><source>no</source>
        <translation>nein</translation></message>
    <message><source>motor {0}: {1} counts</source>
        <translation>Motor {0}: {1} Counts</translation></message>
    <message><source>no {0}</source>
        <translation>kein {0}</translation></message>
    <message><source>get raw inputs of {0}</source>
        <translation>Rohwerte der Eingänge lesen: {0}</translation></message>
    <message><source>get remapped inputs of {0}</source>
        <translation>umgerechnete Eingänge lesen: {0}</translation></message>
    <message><source>get current of motor {0}</source>
        <translation>Strom von Motor {0} lesen</translation></message>
    <message><source>get calibration of channel {0}</source>
        <translation>Kalibrierung von Kanal {0} lesen</translation></message>
    <message><source>get {0}</source>
        <translation>{0} lesen</translation></message>
    <message><source>set {0} to {1}</source>
        <translation>{0} auf {1} setzen</translation></message>
    <message><source>{0} motor {1} to {2}</source>
        <translation>{0}: Motor {1} {2}</translation></message>
    <message><source>{0} auxiliary motor to {1}</source>
        <translation>{0}: Hilfsmotor {1}</translation></message>
    <message><source>The {0} channels control the motors. Serial commands take effect only when channel 5 gives control to them. For serial mode, switch the board off, remove the mode jumper and switch the board on again.</source>
        <translation>Die Kanäle ({0}) steuern die Motoren. Serielle Befehle wirken erst, wenn Kanal 5 ihnen die Steuerung übergibt; für den seriellen Modus schalten Sie das Board aus, ziehen Sie den Modus-Jumper ab und schalten Sie es ein.</translation></message>
    <message><source>analog</source>
        <translation>analog</translation></message>
    <message><source>brake with {0}</source>
        <translation>bremsen mit {0}</translation></message>
    <message><source>the PWM prescaler must be 0 to {0}, not {1}</source>
        <translation>der PWM-Vorteiler ist 0 bis {0}, nicht {1}</translation></message>
    <message><source>the model must be {0}, not {1!r}</source>
        <translation>die Modelle sind {0}, nicht {1!r}</translation></message>
    <message><source>brake duty</source>
        <translation>Bremsstärke</translation></message>
    <message><source>a motor's speed must be -127 to 127, not {0}</source>
        <translation>die Geschwindigkeit eines Motors ist -127 bis 127, nicht {0}</translation></message>
    <message><source>No TReX responds on {0}. Check that the board has power (an LED is lit), that the adapter's TX goes to SI and its RX to SO (an RS-232 adapter: to the RS-232 pins), that ground is connected, and that the serial settings match those of the board. If both LEDs blink together, the board is in learning mode: remove the SO–G jumper, then switch the board off and on.</source>
        <translation>An {0} antwortet kein TReX. Prüfen Sie, ob das Board Strom hat (eine LED leuchtet), ob TX des Adapters mit SI und RX mit SO verbunden ist (oder beide mit den RS-232-Pins, nie gemischt), ob die Masse verbunden ist und ob die seriellen Einstellungen des Boards diesen entsprechen. Wenn beide LEDs gemeinsam blinken, ist das Board im Lernmodus: Ziehen Sie den SO–G-Jumper ab, dann schalten Sie das Board aus und ein.</translation></message>
    <message><source>Everything sent on {0} comes back, and nothing else arrives. Either this is the RS-232 side of a board that is off or set to another baud rate, or the adapter's TX and RX are joined.</source>
        <translation>Alles, was an {0} gesendet wird, kommt zurück, sonst nichts. Entweder ist das die RS-232-Seite eines Boards, das ausgeschaltet oder auf eine andere Baudrate eingestellt ist, oder TX und RX des Adapters sind miteinander verbunden.</translation></message>
    <message><source>Something responds on {0}, but not like a TReX. {1} Usually the baud rate, parity or CRC differs from the board's setting, or another device is connected.</source>
        <translation>An {0} antwortet etwas, aber nicht wie ein TReX. {1} Meist weichen Baudrate, Parität oder CRC von der Einstellung des Boards ab, oder ein anderes Gerät ist angeschlossen.</translation></message>
    <message><source>The TReX on {0} is in its boot loader, waiting for new firmware. Check that the mix and SO–G jumpers are off, then switch the board off and on and connect again. Its serial settings may now be the factory defaults: 19200 baud, no parity, no CRC.</source>
        <translation>Der TReX an {0} ist im Bootloader und wartet auf neue Firmware. Prüfen Sie, ob Mix- und SO–G-Jumper abgezogen sind, schalten Sie dann das Board aus und ein und verbinden Sie erneut. Es hat jetzt vielleicht die seriellen Werkseinstellungen: 19200 Baud, keine Parität, kein CRC.</translation></message>
    <message><source>The device on {0} responds like a Pololu qik, not like a TReX. This program does not support it: select the port of the TReX, or connect the adapter to the TReX.</source>
        <translation>Das Gerät an {0} antwortet wie ein Pololu qik, nicht wie ein TReX. Dieses Programm unterstützt es nicht: Wählen Sie den Port des TReX, oder schließen Sie den Adapter am TReX an.</translation></message>
    <message><source>Several boards reply at once on {0} at {1}. “Find” tries every device number. If two boards have the same number, switch one of them off and give the other board a different number.</source>
        <translation>An {0} antworten mehrere Boards gleichzeitig mit {1}. „Suchen“ fragt jede Gerätenummer ab; von Boards mit derselben Nummer schalten Sie alle bis auf eines aus und geben diesem eine eigene.</translation></message>
    <message><source>A {1} responds on {0} at {2}, but this connection uses {3}. Connect with the settings of the board.</source>
        <translation>An {0} antwortet ein {1} mit {2}, diese Verbindung verwendet aber {3}. Verbinden Sie mit den Einstellungen des Boards.</translation></message>
    <message><source>A {1} responds on {0} with CRC polynomial {2}, but this connection uses {3}. Connect with the settings of the board.</source>
        <translation>An {0} antwortet ein {1} mit dem CRC-Polynom {2}, diese Verbindung verwendet aber {3}. Verbinden Sie mit den Einstellungen des Boards.</translation></message>
    <message><source>A {1} responds on {0}, but its device number is {2}, and this connection uses {3}. Connect with the settings of the board.</source>
        <translation>An {0} antwortet ein {1}, seine Gerätenummer ist aber {2}, und diese Verbindung verwendet {3}. Verbinden Sie mit den Einstellungen des Boards.</translation></message>
    <message><source>A {1} responds on {0}, but not every time: the line loses or corrupts bytes. Check the cable and the ground connection, keep motor leads away from the cable, then connect again.</source>
        <translation>An {0} antwortet ein {1} nur zeitweise: Die Leitung verliert oder verfälscht Bytes. Prüfen Sie Kabel und Masse, halten Sie Motorleitungen davon fern und verbinden Sie erneut.</translation></message>
    <message><source>No reply to {0}.</source>
        <translation>Keine Antwort auf {0}.</translation></message>
    <message><source>Incomplete reply to {0}: only {1} arrived.</source>
        <translation>Unvollständige Antwort auf {0}: Nur {1} kam an.</translation></message>
    <message><source>The reply {0} is corrupted: {1}.</source>
        <translation>Die Antwort {0} ist verfälscht: {1}.</translation></message>
    <message><source>Late replies arrived and cannot be matched to requests.</source>
        <translation>Verspätete Antworten kamen an und lassen sich keiner Anfrage zuordnen.</translation></message>
    <message><source>The board's replies to {0} differ each time: the line corrupts bytes, so the stored value is unknown. Check the cable and the ground connection, keep motor leads away from the cable, lower the baud rate, or use CRC.</source>
        <translation>Die Antworten des Boards auf {0} sind jedes Mal anders: Die Leitung verfälscht Bytes, daher ist nicht bekannt, was gespeichert ist. Prüfen Sie Kabel und Masse, halten Sie Motorleitungen davon fern, oder verwenden Sie eine niedrigere Baudrate oder CRC.</translation></message>
    <message><source>The stop was sent, but the board does not confirm it. If a motor is still turning, cut its power.</source>
        <translation>Der Stopp wurde gesendet, aber das Board bestätigt ihn nicht. Falls sich noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>The stop was sent and the board responds, but the line corrupts bytes. The stop is repeated until the line is quiet. If a motor is still turning, cut its power.</source>
        <translation>Der Stopp wurde gesendet und das Board antwortet, aber die Leitung verfälscht Bytes. Er wird wiederholt, bis die Leitung ruhig ist. Falls sich noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>The program did not respond for more than half a second.</source>
        <translation>Das Programm reagierte länger als eine halbe Sekunde nicht.</translation></message>
    <message><source>The motors that were driven draw no current: the board may have restarted.</source>
        <translation>Die angesteuerten Motoren nehmen keinen Strom auf: Vielleicht wurde das Board neu gestartet.</translation></message>
    <message><source>The guardian process ended, and another one could not be started.</source>
        <translation>Der Wächterprozess wurde beendet, und ein neuer konnte nicht gestartet werden.</translation></message>
    <message><source>Nothing was sent, because these bytes may move a motor. Arm the motors first.</source>
        <translation>Diese Bytes können einen Motor bewegen; es wurde nichts gesendet. Geben Sie zuerst die Motoren frei.</translation></message>
    <message><source>Nothing was sent, because these bytes may move a motor of another board, which a stop on this connection does not reach. Use device number {0} in the packet, or connect with the compact protocol.</source>
        <translation>Diese Bytes können einen Motor eines anderen Boards bewegen, das ein Stopp über diese Verbindung nicht erreicht; es wurde nichts gesendet. Adressieren Sie darin das Gerät {0}, oder verbinden Sie mit dem kompakten Protokoll.</translation></message>
    <message><source>Nothing was sent, because a stop was requested first.</source>
        <translation>Ein Stopp kam zuvor; es wurde nichts gesendet.</translation></message>
    <message><source>The program does not scan for other boards while motors are armed or may be moving. Stop the motors first.</source>
        <translation>Andere Boards werden nicht gesucht, solange Motoren freigegeben sind oder sich vielleicht bewegen. Stoppen Sie zuerst die Motoren.</translation></message>
    <message><source>Board {0} was not selected, because the current board has not confirmed its stop. If a motor is still turning, cut its power.</source>
        <translation>Board {0} wurde nicht ausgewählt, da für das jetzige kein Stopp bestätigt ist. Falls sich noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>Board {0} was not selected, because it does not respond. Check that it has power. The previous board is still selected.</source>
        <translation>Board {0} wurde nicht ausgewählt, da es nicht antwortet. Prüfen Sie, ob es Strom hat. Das vorher ausgewählte Board bleibt ausgewählt.</translation></message>
    <message><source>Another board on this line has the device number {0}. Select an unused number.</source>
        <translation>Ein anderes Board an dieser Leitung hat die Gerätenummer {0}. Wählen Sie eine freie Nummer.</translation></message>
    <message><source>Board {0} no longer follows the group: it stopped responding, was stopped, or restarted.</source>
        <translation>Board {0} folgt nicht mehr: Es verstummte, wurde gestoppt oder startete neu.</translation></message>
    <message><source>Board {0} is not one of the boards that are driven together here.</source>
        <translation>Board {0} gehört nicht zu denen, die hier gemeinsam gefahren werden.</translation></message>
    <message><source>While boards are driven together, you cannot change a device number, select a board, or send a packet that stores a setting. Connect to this board alone.</source>
        <translation>Boards, die gemeinsam gefahren werden, behalten ihre Nummern, keines kann ausgewählt werden, und kein eingegebenes Paket kann etwas speichern. Verbinden Sie sich mit diesem Board allein.</translation></message>
    <message><source>Another user drives this board. Ask that user to hand over control.</source>
        <translation>Ein anderer Benutzer fährt dieses Board. Bitten Sie darum, es zu übergeben.</translation></message>
    <message><source>You may watch this board and stop it, but not drive or change it.</source>
        <translation>Sie dürfen diesem Board zusehen und es stoppen, aber es nicht fahren oder ändern.</translation></message>
    <message><source>Only an owner may take over from another user.</source>
        <translation>Nur ein Eigentümer darf einem anderen Benutzer das Fahren abnehmen.</translation></message>
    <message><source>Control was handed over, or the heartbeat did not reach the robot.</source>
        <translation>Das Fahren wurde übergeben, oder das Lebenszeichen erreichte den Roboter nicht.</translation></message>
    <message><source>{0}: the board does not know this parameter (code 1); its firmware may be too old</source>
        <translation>{0}: Das Board kennt diesen Parameter nicht (Code 1); vielleicht ist seine Firmware zu alt dafür</translation></message>
    <message><source>{0}: the board rejects this value (code 2)</source>
        <translation>{0}: Das Board lehnt diesen Wert ab (Code 2)</translation></message>
    <message><source>{0}: the board is not in serial mode (code 3); switch it off, remove the mode jumper and switch it on again</source>
        <translation>{0}: Das Board ist nicht im seriellen Modus (Code 3); schalten Sie es aus, ziehen Sie den Modus-Jumper ab und schalten Sie es wieder ein</translation></message>
    <message><source>{0} could not be verified: wrote {1}, but read back {2}</source>
        <translation>{0} konnte nicht bestätigt werden: {1} geschrieben, aber {2} zurückgelesen</translation></message>
    <message><source>{0} could not be verified: read back {1}</source>
        <translation>{0} konnte nicht bestätigt werden: Zurückgelesen wurde {1}</translation></message>
    <message><source>{0} is for {1} inputs, but the board now reads {2} inputs</source>
        <translation>{0} gilt für die Eingangsquelle {1}, das Board liest jetzt aber {2}</translation></message>
    <message><source>Another board responds now: {0}. Nothing was written to it.</source>
        <translation>Jetzt antwortet ein anderes Board: {0}. Es wurde nichts darauf geschrieben.</translation></message>
    <message><source>Another board responds now: {0}. Settings may have been written to it. Compare it with its last snapshot.</source>
        <translation>Jetzt antwortet ein anderes Board: {0}. Vielleicht wurden Einstellungen darauf geschrieben; vergleichen Sie es mit seiner letzten Sicherungskopie.</translation></message>
    <message><source>The board no longer stores the settings that were read from it: it is another board, or its settings were changed in the meantime. Nothing was written.</source>
        <translation>Das Board speichert nicht mehr die Einstellungen, die von ihm gelesen wurden: Es ist ein anderes, oder es wurde inzwischen geändert. Es wurde nichts geschrieben.</translation></message>
    <message><source>The line corrupted bytes while {0} was being written, and another setting may have been changed instead. Read the board again and compare it with the last snapshot. {1}</source>
        <translation>Die Leitung hat Bytes verfälscht, während {0} geschrieben wurde; vielleicht wurde stattdessen eine andere Einstellung geändert. Lesen Sie das Board erneut und vergleichen Sie es mit der letzten Sicherungskopie. {1}</translation></message>
    <message><source>{0} settings differ from the values that were read before, so none was restored: another board may be connected.</source>
        <translation>{0} Einstellungen weichen vom zuvor Gelesenen ab, daher wurde keine wiederhergestellt: Vielleicht ist ein anderes Board angeschlossen.</translation></message>
    <message><source>The write was cancelled before this setting was written.</source>
        <translation>Das Schreiben wurde abgebrochen, bevor dies versucht wurde.</translation></message>
    <message><source>{0} {1} may have been reset to the factory default: after a power cycle, the board would run at {2}</source>
        <translation>{0} {1} wurde vielleicht auf die Werkseinstellung zurückgesetzt: Nach dem Aus- und Einschalten liefe das Board mit {2}</translation></message>
    <message><source>The board is not responding; scanning for it.</source>
        <translation>Das Board antwortet nicht; es wird gesucht.</translation></message>
    <message><source>Motor 2 over current limit</source>
        <translation>Motor 2 über der Stromgrenze</translation></message>
    <message><source>The current of motor 2 exceeded its limit, so the limiter reduced the speed of the motor.</source>
        <translation>Der Strom von Motor 2 überschritt seine Grenze, und die Strombegrenzung senkte die Geschwindigkeit.</translation></message>
    <message><source>Motor 2 fault</source>
        <translation>Treiberfehler Motor 2</translation></message>
    <message><source>The driver of motor 2 shut itself down because of overheating, a short circuit or low voltage.</source>
        <translation>Der Treiber von Motor 2 hat sich abgeschaltet: zu heiß, Kurzschluss oder Unterspannung.</translation></message>
    <message><source>Motor 1 over current limit</source>
        <translation>Motor 1 über der Stromgrenze</translation></message>
    <message><source>The current of motor 1 exceeded its limit, so the limiter reduced the speed of the motor.</source>
        <translation>Der Strom von Motor 1 überschritt seine Grenze, und die Strombegrenzung senkte die Geschwindigkeit.</translation></message>
    <message><source>Motor 1 fault</source>
        <translation>Treiberfehler Motor 1</translation></message>
    <message><source>The driver of motor 1 shut itself down because of overheating, a short circuit or low voltage.</source>
        <translation>Der Treiber von Motor 1 hat sich abgeschaltet: zu heiß, Kurzschluss oder Unterspannung.</translation></message>
    <message><source>UART error</source>
        <translation>UART-Fehler</translation></message>
    <message><source>A serial error occurred; the UART error bits show which.</source>
        <translation>Ein serieller Fehler trat auf; die UART-Fehlerbits zeigen, welcher.</translation></message>
    <message><source>Serial timeout</source>
        <translation>Serielles Timeout</translation></message>
    <message><source>No byte arrived within the Serial Timeout. The board should have stopped its motors.</source>
        <translation>Innerhalb des seriellen Timeouts kam kein Byte an. Das Board sollte seine Motoren gestoppt haben.</translation></message>
    <message><source>Format error</source>
        <translation>Formatfehler</translation></message>
    <message><source>A packet contained an unknown command, an unexpected command byte or an invalid data byte.</source>
        <translation>Ein Paket enthielt einen unbekannten Befehl, ein Befehlsbyte im Inneren oder ein ungültiges Datenbyte.</translation></message>
    <message><source>CRC error</source>
        <translation>CRC-Fehler</translation></message>
    <message><source>The CRC byte of a packet was wrong; the packet was discarded.</source>
        <translation>Das CRC-Byte eines Pakets war falsch; das Paket wurde verworfen.</translation></message>
    <message><source>Framing error</source>
        <translation>Rahmenfehler</translation></message>
    <message><source>A stop bit was missing: the baud rates differ, or the line is noisy.</source>
        <translation>Ein Stoppbit fehlte: Die Baudraten sind verschieden, oder die Leitung ist gestört.</translation></message>
    <message><source>Data overrun</source>
        <translation>Datenüberlauf</translation></message>
    <message><source>A byte arrived while the receive register was still full.</source>
        <translation>Ein Byte kam an, als das Empfangsregister noch voll war.</translation></message>
    <message><source>Parity error</source>
        <translation>Paritätsfehler</translation></message>
    <message><source>A byte had the wrong parity: the parity settings differ, or the line is noisy.</source>
        <translation>Ein Byte hatte die falsche Parität: Die Paritätseinstellungen sind verschieden, oder die Leitung ist gestört.</translation></message>
    <message><source>Read buffer overrun</source>
        <translation>Überlauf des Empfangspuffers</translation></message>
    <message><source>More bytes arrived than the board can buffer: something is sending while the board replies.</source>
        <translation>Es kamen mehr Bytes an, als das Board puffern kann; etwas sendet, während das Board antwortet.</translation></message>
    <message><source>Send buffer overrun</source>
        <translation>Überlauf des Sendepuffers</translation></message>
    <message><source>A reply was longer than the send buffer.</source>
        <translation>Eine Antwort war länger als der Sendepuffer.</translation></message>
    <message><source>{0} must be 0 to 127, not {1}</source>
        <translation>{0} ist 0 bis 127, nicht {1}</translation></message>
    <message><source>a CRC-7 polynomial must be 0x80 to 0xFF, not {0:#x}</source>
        <translation>ein CRC-7-Polynom ist 0x80 bis 0xFF, nicht {0:#x}</translation></message>
    <message><source>a data byte outside a packet</source>
        <translation>ein Datenbyte außerhalb eines Pakets</translation></message>
    <message><source>1 byte</source>
        <translation>1 Byte</translation></message>
    <message><source>the CRC is {0:02X}, not {1:02X}</source>
        <translation>der CRC-Wert ist {0:02X}, nicht {1:02X}</translation></message>
    <message><source>the packet is not complete</source>
        <translation>das Paket ist nicht vollständig</translation></message>
    <message><source>a command byte inside a packet</source>
        <translation>ein Befehlsbyte innerhalb eines Pakets</translation></message>
    <message><source>{0:#04x} is not a TReX command</source>
        <translation>{0:#04x} ist kein Befehl eines TReX</translation></message>
    <message><source>the echo should be {0}</source>
        <translation>das Echo müsste {0} sein</translation></message>
    <message><source>{0} bytes</source>
        <translation>{0} Bytes</translation></message>
    <message><source>{0} more than the reply has</source>
        <translation>{0} mehr, als die Antwort hat</translation></message>
    <message><source>UART settings must be a wire value from 0 to 127, not {0}</source>
        <translation>der Bytewert der UART-Einstellungen ist 0 bis 127, nicht {0}</translation></message>
    <message><source>the number of stop bits must be 1 or 2, not {0}</source>
        <translation>1 oder 2 Stoppbits, nicht {0}</translation></message>
    <message><source>UART settings {0:#04x} do not contain a valid baud rate</source>
        <translation>die UART-Einstellungen {0:#04x} nennen keine Baudrate</translation></message>
    <message><source>a TReX runs at {0} baud, not {1}</source>
        <translation>ein TReX läuft mit {0} Baud, nicht {1}</translation></message>
    <message><source>(twin)</source>
        <translation>(Zwilling)</translation></message>
    <message><source>(inferred)</source>
        <translation>(erschlossen)</translation></message>
    <message><source>none</source><comment>channels</comment>
        <translation>keine</translation></message>
    <message><source>channel {0}</source>
        <translation>Kanal {0}</translation></message>
    <message><source>channels {0}</source>
        <translation>Kanäle {0}</translation></message>
    <message><source>{0} {1} has no parameter {2!r}{3}</source>
        <translation>{0} {1} hat keinen Parameter {2!r}{3}</translation></message>
    <message><source>{0} must be {1}, not {2}</source>
        <translation>{0} ist {1}, nicht {2}</translation></message>
    <message><source>none, or any of channels 1 to 5, such as 1, 3</source>
        <translation>keiner oder einige der Kanäle 1 bis 5, zum Beispiel 1, 3</translation></message>
    <message><source>any of 1 to 5</source>
        <translation>beliebige aus 1 bis 5</translation></message>
    <message><source>baud, error detection, stop bits</source>
        <translation>Baud, Fehlererkennung, Stoppbits</translation></message>
    <message><source>a baud rate, error detection and stop bits (low four bits 0 to 10)</source>
        <translation>eine Baudrate, Fehlererkennung und Stoppbits (untere vier Bits 0 bis 10)</translation></message>
    <message><source>{0} to {1} (wire value {2} to {3})</source>
        <translation>{0} bis {1} (Bytewert {2} bis {3})</translation></message>
    <message><source>the table has no parameter {0!r}</source>
        <translation>die Tabelle enthält keinen Parameter {0!r}</translation></message>
    <message><source> or </source>
        <translation> oder </translation></message>
    <message><source>written as {0}, with a baud rate that the board supports</source>
        <translation>geschrieben wie {0}, mit einer Baudrate, die das Board unterstützt</translation></message>
    <message><source>; did you mean {0}?</source>
        <translation>; meinten Sie {0}?</translation></message>
    <message><source>{0} to {1} s to full speed, or {2}</source>
        <translation>{0} bis {1} s bis zur vollen Geschwindigkeit, oder {2}</translation></message>
    <message><source>channels 1 to 5 (wire value 0 to {0})</source>
        <translation>Kanäle 1 bis 5 (Bytewert 0 bis {0})</translation></message>
    <message><source>{0} (wire value {1} to {2})</source>
        <translation>{0} (Bytewert {1} bis {2})</translation></message>
    <message><source>{0} s to full speed</source>
        <translation>{0} s bis zur vollen Geschwindigkeit</translation></message>
    <message><source>{0} bytes are too many: at most {1} can be sent at once.</source>
        <translation>{0} Bytes sind zu viele: Höchstens {1} werden auf einmal gesendet.</translation></message>
    <message><source>Enter bytes in hexadecimal, such as 86 1F.</source>
        <translation>Welche Bytes? Geben Sie sie hexadezimal an, zum Beispiel 86 1F.</translation></message>
    <message><source>device {0}: {1}</source>
        <translation>Gerät {0}: {1}</translation></message>
    <message><source>not a TReX packet: {0}</source>
        <translation>kein TReX-Paket: {0}</translation></message>
    <message><source>“{0}” is not a sequence of hexadecimal bytes such as 86 1F.</source>
        <translation>„{0}“ ist keine Folge hexadezimaler Bytes wie 86 1F.</translation></message>
    <message><source>No board is served to this user at {0}:{1}. Check that `trexcmd serve` is running there. Also check the user in the address (trex://USER@…) and the secret (TREX_SECRET).</source>
        <translation>Bei {0}:{1} wird kein Board bereitgestellt, oder nicht für diesen Benutzer. Prüfen Sie, ob dort trexcmd serve läuft, den Benutzer in der Adresse (trex://USER@…) und sein Geheimnis (TREX_SECRET).</translation></message>
    <message><source>The server cannot listen at {0}: {1}</source>
        <translation>An {0} kann nicht gelauscht werden: {1}</translation></message>
    <message><source>{0} serves no board named {1} to this user.</source>
        <translation>{0} stellt diesem Benutzer kein Board namens {1} bereit.</translation></message>
    <message><source>It did not respond.</source>
        <translation>Er hat nicht geantwortet.</translation></message>
    <message><source>Boards on the network need additional packages: install trex-gui[remote] with pip or pipx.</source>
        <translation>Boards im Netz brauchen weitere Pakete: Installieren Sie trex-gui[remote] mit pip oder pipx.</translation></message>
    <message><source>unsolicited bytes</source>
        <translation>unaufgeforderte Bytes</translation></message>
    <message><source>unsolicited bytes; perhaps a late reply</source>
        <translation>unaufgeforderte Bytes; vielleicht eine verspätete Antwort</translation></message>
    <message><source>only the echo came back</source>
        <translation>nur das Echo kam zurück</translation></message>
    <message><source>corrupted: {0}</source>
        <translation>verfälscht: {0}</translation></message>
    <message><source>accepted values</source>
        <translation>akzeptierte Werte</translation></message>
    <message><source>{0} is left out: {1} means {2} to a {3}, but {4} to a {5}.</source>
        <translation>{0} wird ausgelassen: {1} bedeutet {2} für einen {3}, aber {4} für einen {5}.</translation></message>
    <message><source>1 parameter</source>
        <translation>1 Parameter</translation></message>
    <message><source>{0} parameters</source>
        <translation>{0} Parameter</translation></message>
    <message><source>{0} will change</source>
        <translation>{0} zu ändern</translation></message>
    <message><source>{0} match</source>
        <translation>{0} gleich</translation></message>
    <message><source>1 calibration</source>
        <translation>1 Kalibrierung</translation></message>
    <message><source>{0} calibrations</source>
        <translation>{0} Kalibrierungen</translation></message>
    <message><source>a {0} with firmware {1}</source>
        <translation>ein {0} mit Firmware {1}</translation></message>
    <message><source>{0} ({1}) is left out: {2} does not have this setting.</source>
        <translation>{0} ({1}) wird ausgelassen: {2} hat das nicht.</translation></message>
    <message><source>Calibration of {0}</source>
        <translation>Kalibrierung von {0}</translation></message>
    <message><source>{0} cannot be carried over</source>
        <translation>{0} nicht übertragbar</translation></message>
    <message><source>{0} note</source>
        <translation>Notiz zu {0}</translation></message>
    <message><source>For a {0}: {1} carried over, {2} changed, {3} left out.</source>
        <translation>Für einen {0}: {1} übernommen, {2} geändert, {3} ausgelassen.</translation></message>
    <message><source>Firmware {0} really runs at {1} baud when set to {2}.</source>
        <translation>Firmware {0} läuft bei eingestellten {2} Baud tatsächlich mit {1} Baud.</translation></message>
    <message><source>Rounded down to steps of {0}: {1} becomes {2}.</source>
        <translation>Auf Schritte von {0} abgerundet: {1} wird zu {2}.</translation></message>
    <message><source>A {0} with firmware {1} does not have this setting.</source>
        <translation>Ein {0} mit Firmware {1} hat das nicht.</translation></message>
    <message><source>The maximum for a {0} is {1}.</source>
        <translation>Ein {0} hat höchstens {1}.</translation></message>
    <message><source>The minimum for a {0} is {1}; 0 means off (twin).</source>
        <translation>Ein {0} hat mindestens {1}; 0 schaltet es aus (Zwilling).</translation></message>
    <message><source>The same value in steps of {0}: {1} becomes {2}.</source>
        <translation>Derselbe Wert in Schritten von {0}: {1} wird zu {2}.</translation></message>
    <message><source>these are settings of a {0}</source>
        <translation>dies sind Einstellungen eines {0}</translation></message>
    <message><source>the layout of this file cannot be changed in place; save the settings as a new file</source>
        <translation>diese Datei ist so geschrieben, dass sie sich nicht an Ort und Stelle ändern lässt; speichern Sie die Einstellungen als neue Datei</translation></message>
    <message><source>{0} {1}: the number of snapshots to keep is unknown, so none is removed.</source>
        <translation>{0} {1}: Wie viele Sicherungskopien behalten werden sollen, ist nicht bekannt, daher wird keine entfernt.</translation></message>
    <message><source>It does not name its board.</source>
        <translation>Sie nennt nicht, von welchem Board sie stammt.</translation></message>
    <message><source>It is empty.</source>
        <translation>Sie ist leer.</translation></message>
    <message><source>it cannot be removed</source>
        <translation>sie kann nicht entfernt werden</translation></message>
    <message><source>is damaged</source>
        <translation>ist beschädigt</translation></message>
    <message><source>A name cannot be a number like {0}, because numbers already identify snapshots.</source>
        <translation>{0} wäre die Nummer einer Sicherungskopie.</translation></message>
    <message><source>Another snapshot has the name {0}.</source>
        <translation>Eine andere Sicherungskopie heißt schon {0}.</translation></message>
    <message><source>is missing</source>
        <translation>fehlt</translation></message>
    <message><source>the limit must be 1 to 9999999 snapshots, not {0}</source>
        <translation>ein Verlauf behält mindestens eine Sicherungskopie, nicht {0}</translation></message>
    <message><source>At most {0} characters are allowed.</source>
        <translation>Höchstens {0} Zeichen sind möglich.</translation></message>
    <message><source>cannot be read ({0})</source>
        <translation>kann nicht gelesen werden ({0})</translation></message>
    <message><source>All {0} device numbers are already used in {1}.</source>
        <translation>Alle {0} Gerätenummern stehen in {1}.</translation></message>
    <message><source>Another program has changed {0}. Nothing was saved. Start again to continue this record.</source>
        <translation>Ein anderes Programm hat {0} geändert. Nichts wurde gespeichert. Beginnen Sie neu, um es fortzusetzen.</translation></message>
    <message><source>{0} is not a record of boards. Select another file.</source>
        <translation>{0} ist kein Protokoll von Boards. Wählen Sie eine andere Datei.</translation></message>
    <message><source>{0} is damaged: {1}.</source>
        <translation>{0} ist beschädigt: {1}.</translation></message>
    <message><source>the last line has no line break; was the file cut short?</source>
        <translation>die letzte Zeile hat kein Zeilenende; wurde die Datei abgeschnitten?</translation></message>
    <message><source>{count} more errors are not listed</source>
        <translation>{count} weitere Fehler sind nicht aufgeführt</translation></message>
    <message><source>there must be a name before the colon, not a list or a group</source>
        <translation>vor den Doppelpunkt gehört ein Name, keine Liste oder Gruppe</translation></message>
    <message><source>was already given in line {first}</source>
        <translation>wurde schon in Zeile {first} angegeben</translation></message>
    <message><source>{name} was already given in line {first}</source>
        <translation>{name} wurde schon in Zeile {first} angegeben</translation></message>
    <message><source>the first setting must be {wanted}, but this file has no product</source>
        <translation>die erste Einstellung ist {wanted}; in dieser Datei fehlt sie</translation></message>
    <message><source>must be the first setting of the file</source>
        <translation>muss die erste Einstellung der Datei sein</translation></message>
    <message><source>must be {models}, not {given}; did you mean {model}?</source>
        <translation>{models}, nicht {given}; meinten Sie {model}?</translation></message>
    <message><source>must be {models}, not {given}; these are not settings of a TReX</source>
        <translation>{models}, nicht {given}; das sind keine Einstellungen eines TReX</translation></message>
    <message><source>must be a version such as {newest}, not {given}</source>
        <translation>eine Version wie {newest}, nicht {given}</translation></message>
    <message><source>versions {oldest} to {newest} are known, but {given} is not</source>
        <translation>bekannt sind die Versionen {oldest} bis {newest}, {given} nicht</translation></message>
    <message><source>is a command to the board, not a setting</source>
        <translation>ist ein Befehl an das Board, keine Einstellung</translation></message>
    <message><source>must be {allowed}, not {given}{hint}</source>
        <translation>{allowed}, nicht {given}{hint}</translation></message>
    <message><source>should be {allowed}{grade}, not {given}; the board decides</source>
        <translation>{allowed}{grade}, nicht {given}; das Board entscheidet</translation></message>
    <message><source>a {product} has this setting only from firmware {since} on, but the file is for {firmware}</source>
        <translation>ein {product} hat sie ab Firmware {since}, diese Einstellungen sind für {firmware}</translation></message>
    <message><source>a {product} does not have this setting in any firmware</source>
        <translation>ein {product} hat sie mit keiner Firmware</translation></message>
    <message><source>there is no such setting{guess}</source>
        <translation>diese Einstellung gibt es nicht{guess}</translation></message>
    <message><source>must be written as {layout}, not {given}</source>
        <translation>wird {layout} geschrieben, nicht {given}</translation></message>
    <message><source>a calibration has no {field!r}{guess}</source>
        <translation>eine Kalibrierung hat kein {field!r}{guess}</translation></message>
    <message><source>{field} must be 0 to {highest}, not {given}</source>
        <translation>{field} ist 0 bis {highest}, nicht {given}</translation></message>
    <message><source>{fields} is missing</source>
        <translation>{fields} fehlt</translation></message>
    <message><source>{fields} are missing</source>
        <translation>{fields} fehlen</translation></message>
    <message><source>1 of {total} parameters is missing: {names}</source>
        <translation>1 von {total} Parametern fehlt: {names}</translation></message>
    <message><source>{count} of {total} parameters are missing: {names}</source>
        <translation>{count} von {total} Parametern fehlen: {names}</translation></message>
    <message><source>nothing</source>
        <translation>nichts</translation></message>
    <message><source>channels 1 to 5</source>
        <translation>Kanäle 1 bis 5</translation></message>
    <message><source>a list</source>
        <translation>eine Liste</translation></message>
    <message><source>a group of settings</source>
        <translation>eine Gruppe von Einstellungen</translation></message>
    <message><source>a block of text</source>
        <translation>ein Textblock</translation></message>
    <message><source>; write {0}</source>
        <translation>; schreiben Sie {0}</translation></message>
    <message><source>; write {1} for {0}</source>
        <translation>; {0} schreibt man {1}</translation></message>
    <message><source>{0}: {1} becomes {2}</source>
        <translation>{0}: {1} wird zu {2}</translation></message>
    <message><source>{0} in quotes</source>
        <translation>{0} in Anführungszeichen</translation></message>
    <message><source>{name} is off while a computer drives the motors: if the cable or the computer fails, the motors keep running at their last setpoint.</source>
        <translation>{name} ist aus, während ein Computer die Motoren steuert: Wenn das Kabel oder der Computer ausfällt, laufen die Motoren mit ihrem letzten Sollwert weiter.</translation></message>
    <message><source>Both required and ignored: {channels}. The signal controls nothing, but without the signal the motors may not run in RC mode (inferred).</source>
        <translation>Zugleich erforderlich und ignoriert: {channels}. Das Signal bewegt nichts, aber ohne es laufen die Motoren im RC-Modus vielleicht nicht (erschlossen).</translation></message>
    <message><source>The {end} of {channel}, {count}, is beyond {limit}, the last count that the board measures: full speed on that side is never reached.</source>
        <translation>Das {end} von {channel}, {count}, liegt jenseits von {limit}, dem letzten Count, den das Board misst: Die volle Geschwindigkeit auf dieser Seite wird nie erreicht.</translation></message>
    <message><source>After the next power cycle, the line settings of the board will be {new} instead of {now}. Programs that use the board must then use the new line settings.</source>
        <translation>Nach dem nächsten Aus- und Einschalten sind die Leitungseinstellungen des Boards {new}; jetzt sind sie {now}. Ändern Sie dann die Programme, die das Board verwenden.</translation></message>
    <message><source>Prescaler {0} gives {1}.</source>
        <translation>Der Vorteiler {0} ergibt {1}.</translation></message>
    <message><source>The deadband of {channel} reaches from neutral to its {ends}: there is nothing between standstill and full speed on that side.</source>
        <translation>Der Totbereich von {channel} reicht von der Neutralstellung bis zur Endlage ({ends}): Zwischen Stillstand und voller Geschwindigkeit liegt auf dieser Seite nichts.</translation></message>
    <message><source>A {board} set to {baud} baud really runs at {real} baud; firmware {fixed_in} corrects this. Programs must use {real} baud.</source>
        <translation>Ein {board}, auf {baud} Baud eingestellt, läuft tatsächlich mit {real} Baud; Firmware {fixed_in} behebt das. Programme müssen {real} Baud verwenden.</translation></message>
    <message><source>This computer's serial port does not support {baud} baud: after the next power cycle, the computer could no longer reach the board.</source>
        <translation>Der serielle Port dieses Computers unterstützt {baud} Baud nicht: Nach dem nächsten Aus- und Einschalten könnte er das Board nicht mehr erreichen.</translation></message>
    <message><source>{0} to {1}</source><comment>set a parameter</comment>
        <translation>{0} auf {1}</translation></message>
    <message><source>Set {0}</source>
        <translation>{0} setzen</translation></message>
    <message><source>{0} and {1}</source>
        <translation>{0} und {1}</translation></message>
    <message><source>{timeout} of {seconds} may not stop the motors if the cable or the computer fails: {shutdown} is off (twin).</source>
        <translation>{timeout} von {seconds} stoppt die Motoren vielleicht nicht, wenn das Kabel oder der Computer ausfällt: {shutdown} ist aus (Zwilling).</translation></message>
    <message><source>No effect in joint mode: {limits}. In this mode the board measures no current, so the motor is not protected.</source>
        <translation>Ohne Wirkung im Parallelbetrieb: {limits}. Das Board misst dann keinen Strom, der Motor ist also nicht geschützt.</translation></message>
    <message><source>{limit} is {value}, but its proportionality constant P, which sets how strongly the limiter reacts, is 0. Therefore, the limit may have no effect (inferred).</source>
        <translation>{limit} ist {value}, aber der zugehörige Proportionalfaktor P, also wie stark die Strombegrenzung reagiert, ist 0. Die Grenze hat dann vielleicht keine Wirkung (erschlossen).</translation></message>
    <message><source>{limit} is {value} and {ramp} is 0, so the speed changes at once. As soon as the current falls below the limit, the motor jumps back to its full target speed, so it may run in jerks (inferred).</source>
        <translation>{limit} ist {value}, und {ramp} ist 0, also sofort. Sobald der Strom unter die Grenze fällt, springt der Motor auf seine volle Sollgeschwindigkeit zurück und läuft dadurch vielleicht ruckweise (erschlossen).</translation></message>
    <message><source>The PWM of motor {motor} runs at {now} (inferred), but the motor driver of a {product} is rated for {highest}. Above this frequency, the driver gets hot.</source>
        <translation>Die PWM von Motor {motor} läuft mit {now} (erschlossen), der Motortreiber eines {product} ist aber nur für {highest} ausgelegt; darüber wird er heiß.</translation></message>
    <message><source>{name} is {value} instead of the default {default}, but CRC-7 is not switched on: no packet is checked with it.</source>
        <translation>{name} ist {value} statt des Standardwerts {default}, aber CRC-7 ist nicht eingeschaltet: Kein Paket wird damit geprüft.</translation></message>
    <message><source>With {value} as {name} the checksum of every packet is 0, so CRC-7 detects no errors at all.</source>
        <translation>Mit {value} als {name} ist die Prüfsumme jedes Pakets 0; CRC-7 erkennt dann überhaupt keine Fehler.</translation></message>
    <message><source>{0} with firmware {1}</source>
        <translation>{0} mit Firmware {1}</translation></message>
    <message><source>{0}, deadband {1}</source>
        <translation>{0}, Totbereich {1}</translation></message>
    <message><source>beyond a limit{0}: the board decides</source>
        <translation>jenseits einer Grenze{0}: Das Board entscheidet</translation></message>
    <message><source>a {0} has no {1}</source>
        <translation>ein {0} hat kein {1}</translation></message>
    <message><source>settings are plain 'key: value' lines</source>
        <translation>Einstellungen sind einfache Zeilen „schlüssel: wert“</translation></message>
    <message><source>this is nested too deeply; {0}</source>
        <translation>dies ist zu tief verschachtelt; {0}</translation></message>
    <message><source>there are no settings here; the first must be 'product: TReX'</source>
        <translation>hier sind keine Einstellungen; die erste ist 'product: TReX'</translation></message>
    <message><source>these are not settings of a TReX, which begin with 'product: TReX'</source>
        <translation>das sind keine Einstellungen eines TReX; diese beginnen mit „product: TReX“</translation></message>
    <message><source>a tab indents this line; indent it with spaces</source>
        <translation>diese Zeile ist mit einem Tabulator eingerückt; rücken Sie sie mit Leerzeichen ein</translation></message>
    <message><source>this is not a setting; {0}</source>
        <translation>dies ist keine Einstellung; {0}</translation></message>
    <message><source>the character U+{0:04X} is not allowed in a text file</source>
        <translation>das Zeichen U+{0:04X} gehört nicht in eine Textdatei</translation></message>
    <message><source>the text is incomplete or damaged here ({0}); {1}</source>
        <translation>der Text ist hier unvollständig oder beschädigt ({0}); {1}</translation></message>
    <message><source>there must be an ordinary space after the colon</source>
        <translation>geben Sie nach dem Doppelpunkt ein gewöhnliches Leerzeichen ein</translation></message>
    <message><source>a second document begins here; a settings file has only one</source>
        <translation>hier beginnt ein zweites Dokument; eine Einstellungsdatei hat nur eines</translation></message>
    <message><source>anchors (&amp; and *) are not allowed; {0}</source>
        <translation>Anker (&amp; und *) sind nicht erlaubt; {0}</translation></message>
    <message><source>tags (!) are not allowed; {0}</source>
        <translation>Tags (!) sind nicht erlaubt; {0}</translation></message>
    <message><source>there are more settings here than any board has</source>
        <translation>hier stehen mehr Einstellungen, als ein Board hat</translation></message>
    <message><source>this number cannot be read; {0}</source>
        <translation>diese Zahl ist nicht lesbar; {0}</translation></message>
    <message><source>merge keys (&lt;&lt;) are not allowed; {0}</source>
        <translation>Merge-Schlüssel (&lt;&lt;) sind nicht erlaubt; {0}</translation></message>
    <message><source>From the first setpoint until braking.</source>
        <translation>Vom ersten Sollwert bis zum Bremsen.</translation></message>
    <message><source>Runs the test while you hold the button with the mouse or the space bar</source>
        <translation>Führt den Prüflauf aus, solange sie mit der Maus oder der Leertaste gehalten wird</translation></message>
    <message><source>Open a saved test</source>
        <translation>Gespeicherten Prüflauf öffnen</translation></message>
    <message><source>Bench tests (*.csv);;All files (*)</source>
        <translation>Prüfläufe (*.csv);;Alle Dateien (*)</translation></message>
    <message><source>{0:%H:%M:%S}, motor {1}: {2}</source>
        <translation>{0:%H:%M:%S}, Motor {1}: {2}</translation></message>
    <message><source>Test to compare with</source>
        <translation>Prüflauf zum Vergleichen</translation></message>
    <message><source>&amp;Open…</source>
        <translation>Öffn&amp;en…</translation></message>
    <message><source>Sa&amp;ve…</source>
        <translation>&amp;Speichern…</translation></message>
    <message><source>&amp;Close</source>
        <translation>Sc&amp;hließen</translation></message>
    <message><source>The window of the bench test was closed.</source>
        <translation>Das Fenster des Prüflaufs wurde geschlossen.</translation></message>
    <message><source>{0} was not saved: {1}.</source>
        <translation>{0} wurde nicht gespeichert: {1}.</translation></message>
    <message><source>{0} was not opened: {1}.</source>
        <translation>{0} wurde nicht geöffnet: {1}.</translation></message>
    <message><source>Release to stop</source>
        <translation>Loslassen: Motor stoppt</translation></message>
    <message><source>Hold to run</source>
        <translation>Gedrückt halten: Motor läuft</translation></message>
    <message><source>Motor {0} is running: {1:.1f} of {2:g} s.</source>
        <translation>Motor {0} läuft: {1:.1f} von {2:g} s.</translation></message>
    <message><source>Armed. Hold the button to run the motor. The motor stops when you release the button.</source>
        <translation>Freigegeben. Halten Sie die Schaltfläche gedrückt: Der Motor läuft nur, solange sie gehalten wird.</translation></message>
    <message><source>Peak current</source>
        <translation>Spitzenstrom</translation></message>
    <message><source>The highest reading.</source>
        <translation>Der höchste Messwert.</translation></message>
    <message><source>Steady current</source>
        <translation>Stationärer Strom</translation></message>
    <message><source>At the end of the first phase at constant speed.</source>
        <translation>Am Ende der ersten konstanten Geschwindigkeit.</translation></message>
    <message><source>Mean current</source>
        <translation>Mittlerer Strom</translation></message>
    <message><source>Charge</source>
        <translation>Ladung</translation></message>
    <message><source>Setpoint to current</source>
        <translation>Sollwert bis Strom</translation></message>
    <message><source>Time until the first reading of at least two counts. It includes the delays of the line, the board and the measurement.</source>
        <translation>Bis zum ersten Messwert von zwei Counts: die Leitung, das Board und seine Messung.</translation></message>
    <message><source>Time until the current stayed within this percentage of the steady current, or within two counts of the steady current.</source>
        <translation>Bis der Strom innerhalb dieses Anteils am stationären Strom blieb, oder innerhalb von zwei Counts um ihn.</translation></message>
    <message><source>&amp;Bench test…</source>
        <translation>&amp;Prüflauf…</translation></message>
    <message><source>Compar&amp;e with</source>
        <translation>&amp;Vergleichen mit</translation></message>
    <message><source>Save bench test</source>
        <translation>Prüflauf speichern</translation></message>
    <message><source>Open bench test</source>
        <translation>Prüflauf öffnen</translation></message>
    <message><source>Aborted after {0:.2f} s: {1}</source>
        <translation>Abgebrochen nach {0:.2f} s: {1}</translation></message>
    <message><source>Released after {0:.2f} s.</source>
        <translation>Losgelassen nach {0:.2f} s.</translation></message>
    <message><source>The test is complete.</source>
        <translation>Der Prüflauf ist abgeschlossen.</translation></message>
    <message><source>the previous test</source>
        <translation>voriger Prüflauf</translation></message>
    <message><source>Figures of the test</source>
        <translation>Kennwerte des Prüflaufs</translation></message>
    <message><source>This test</source>
        <translation>Dieser Lauf</translation></message>
    <message><source>Compared</source>
        <translation>Vergleich</translation></message>
    <message><source>Change</source>
        <translation>Änderung</translation></message>
    <message><source>Saved as {0}.</source>
        <translation>Gespeichert als {0}.</translation></message>
    <message><source>Settled within {0:.0f} % after</source>
        <translation>Auf {0:.0f} % eingeschwungen nach</translation></message>
    <message><source>“Accelerate” uses the board's acceleration, brake duration and current limit. “Set at once” bypasses the acceleration and the brake duration, and briefly the current limit.</source>
        <translation>„Beschleunigen“ nutzt Beschleunigung, Bremsdauer und Stromgrenze des Boards; „Sofort setzen“ umgeht die ersten beiden und kurzzeitig auch die Grenze.</translation></message>
    <message><source>A single reading above this current stops and disarms all motors. A motor draws the most current when it starts.</source>
        <translation>Schon ein Messwert darüber stoppt und sperrt alle Motoren. Beim Anlaufen zieht ein Motor den höchsten Strom.</translation></message>
    <message><source>Abort also at the board's current &amp;limit</source>
        <translation>Auch an der Stromgrenze des &amp;Boards abbrechen</translation></message>
    <message><source>Stop when the board reports that its own current limit was exceeded.</source>
        <translation>Stoppt, wenn das Board meldet, dass seine eigene Stromgrenze überschritten wurde.</translation></message>
    <message><source>1 to {0}, full speed</source>
        <translation>1 bis {0}, volle Geschwindigkeit</translation></message>
    <message><source>Connect to a board to see its settings.</source>
        <translation>Verbinden Sie ein Board, um seine Einstellungen zu sehen.</translation></message>
    <message><source>Test</source>
        <translation>Prüflauf</translation></message>
    <message><source>&amp;Motor</source>
        <translation>&amp;Motor</translation></message>
    <message><source>Pro&amp;file</source>
        <translation>Pro&amp;fil</translation></message>
    <message><source>Direc&amp;tion</source>
        <translation>&amp;Richtung</translation></message>
    <message><source>&amp;Duration</source>
        <translation>&amp;Dauer</translation></message>
    <message><source>Se&amp;nt as</source>
        <translation>&amp;Gesendet als</translation></message>
    <message><source>Abort &amp;above</source>
        <translation>Abbr&amp;uch über</translation></message>
    <message><source>1 to {0}, the speed ceiling of the Motors page</source>
        <translation>1 bis {0}, die Höchstgeschwindigkeit der Seite „Motoren“</translation></message>
    <message><source>R&amp;ises in</source>
        <translation>Ans&amp;tieg in</translation></message>
    <message><source>&amp;Period</source>
        <translation>&amp;Periode</translation></message>
    <message><source>Appl&amp;y…</source>
        <translation>&amp;Anwenden…</translation></message>
    <message><source>Review and write all pending edits, including these</source>
        <translation>Alle ausstehenden Änderungen prüfen und schreiben, auch diese</translation></message>
    <message><source> s</source>
        <translation> s</translation></message>
    <message><source>Step: at once</source>
        <translation>Sprung: sofort</translation></message>
    <message><source>Ramp: rising linearly</source>
        <translation>Rampe: linear steigend</translation></message>
    <message><source>Reverse: back and forth</source>
        <translation>Umkehr: vor und zurück</translation></message>
    <message><source>Sine</source>
        <translation>Sinus</translation></message>
    <message><source>Forward</source>
        <translation>Vorwärts</translation></message>
    <message><source>Reverse</source>
        <translation>Rückwärts</translation></message>
    <message><source>Accelerate</source>
        <translation>Beschleunigen</translation></message>
    <message><source> A</source>
        <translation> A</translation></message>
    <message><source>Limit P</source>
        <translation>P der Stromgrenze</translation></message>
    <message><source>Se&amp;t at once</source>
        <translation>Sofort set&amp;zen</translation></message>
    <message><source>Settings of motor {0}</source>
        <translation>Einstellungen von Motor {0}</translation></message>
    <message><source>Not applied: {0}</source>
        <translation>Nicht angewendet: {0}</translation></message>
    <message><source>{0} (stored: {1})</source>
        <translation>{0} (gespeichert: {1})</translation></message>
    <message><source>The table contains the results as numbers.</source>
        <translation>Die Tabelle der Kennwerte enthält die Ergebnisse als Zahlen.</translation></message>
    <message><source>Speed setpoint against time</source>
        <translation>Geschwindigkeitssollwert über der Zeit</translation></message>
    <message><source>Motor current against time</source>
        <translation>Stromaufnahme über der Zeit</translation></message>
    <message><source>Setpoint</source>
        <translation>Sollwert</translation></message>
    <message><source>Planned</source>
        <translation>Geplant</translation></message>
    <message><source>A</source>
        <translation>A</translation></message>
    <message><source>Abort {0:g} A</source>
        <translation>Abbruch {0:g} A</translation></message>
    <message><source>Limit {0:g} A</source>
        <translation>Grenze {0:g} A</translation></message>
    <message><source>put it on</source>
        <translation>aufstecken</translation></message>
    <message><source>remove it</source>
        <translation>abziehen</translation></message>
    <message><source>Mode: off</source>
        <translation>Modus: ab</translation></message>
    <message><source>Mix: on</source>
        <translation>Mix: gesteckt</translation></message>
    <message><source>Mix: off</source>
        <translation>Mix: ab</translation></message>
    <message><source>SO–G: on</source>
        <translation>SO–G: gesteckt</translation></message>
    <message><source>SO–G: off</source>
        <translation>SO–G: ab</translation></message>
    <message><source>Mode: {0}</source>
        <translation>Modus: {0}</translation></message>
    <message><source>sticks learned</source>
        <translation>Knüppel gelernt</translation></message>
    <message><source>current limits</source>
        <translation>Stromgrenzen</translation></message>
    <message><source>serial timeout</source>
        <translation>serielles Timeout</translation></message>
    <message><source>Set &amp;up my robot…</source>
        <translation>Meinen &amp;Roboter einrichten…</translation></message>
    <message><source>If the cable fails</source>
        <translation>Wenn das Kabel ausfällt</translation></message>
    <message><source>Sh&amp;ow them</source>
        <translation>Anz&amp;eigen</translation></message>
    <message><source>The board</source>
        <translation>Das Board</translation></message>
    <message><source>Prob&amp;lems</source>
        <translation>Prob&amp;leme</translation></message>
    <message><source>joint: one motor</source>
        <translation>Parallelbetrieb: ein Motor</translation></message>
    <message><source>RS-232 (everything sent comes back)</source>
        <translation>RS-232 (alles Gesendete kommt zurück)</translation></message>
    <message><source>this firmware runs at half this baud rate</source>
        <translation>diese Firmware läuft mit der halben Baudrate</translation></message>
    <message><source>None since {0}.</source>
        <translation>Keine seit {0}.</translation></message>
    <message><source>network {0:.0f} ms</source>
        <translation>Netz {0:.0f} ms</translation></message>
    <message><source>not known</source>
        <translation>nicht bekannt</translation></message>
    <message><source>works with motor 1</source>
        <translation>arbeitet mit Motor 1</translation></message>
    <message><source>held by safe-start</source>
        <translation>vom Sicherheitsstart gehalten</translation></message>
    <message><source>not armed</source>
        <translation>nicht freigegeben</translation></message>
    <message><source>Mode jumper</source>
        <translation>Modus-Jumper</translation></message>
    <message><source>Mix jumper</source>
        <translation>Mix-Jumper</translation></message>
    <message><source>SO–G jumper</source>
        <translation>SO–G-Jumper</translation></message>
    <message><source>Serial line</source>
        <translation>Serielle Leitung</translation></message>
    <message><source>not responding</source>
        <translation>antwortet nicht</translation></message>
    <message><source>replies arrive</source>
        <translation>Antworten kommen an</translation></message>
    <message><source>Red</source>
        <translation>Rot</translation></message>
    <message><source>Green</source>
        <translation>Grün</translation></message>
    <message><source>unknown</source>
        <translation>unbekannt</translation></message>
    <message><source>channels drive</source>
        <translation>Kanäle steuern</translation></message>
    <message><source>unknown: move a stick to find out</source>
        <translation>nicht bekannt: Knüppel bewegen</translation></message>
    <message><source>one stick drives both motors</source>
        <translation>ein Knüppel steuert beide Motoren</translation></message>
    <message><source>each channel drives one motor</source>
        <translation>jeder Kanal hat seinen Motor</translation></message>
    <message><source>for RC and analog mode</source>
        <translation>für RC- und Analogmodus</translation></message>
    <message><source>flickers</source>
        <translation>flackert</translation></message>
    <message><source>{0:.0f} reads/s, {1:.1f} % answered</source>
        <translation>{0:.0f} Abfragen/s, {1:.1f} % beantwortet</translation></message>
    <message><source>CH{0}</source>
        <translation>K{0}</translation></message>
    <message><source>serial mode</source>
        <translation>serieller Modus</translation></message>
    <message><source>RC</source>
        <translation>RC</translation></message>
    <message><source>Analog</source>
        <translation>Analog</translation></message>
    <message><source>channel 5 selects serial</source>
        <translation>Kanal 5 übergibt</translation></message>
    <message><source>Channel {0}: {1}</source>
        <translation>Kanal {0}: {1}</translation></message>
    <message><source>{0} LED</source>
        <translation>LED {0}</translation></message>
    <message><source>may still turn</source>
        <translation>dreht sich vielleicht noch</translation></message>
    <message><source>selected</source>
        <translation>ausgewählt</translation></message>
    <message><source>responding</source>
        <translation>antwortet</translation></message>
    <message><source>reply unreadable</source>
        <translation>Antwort unlesbar</translation></message>
    <message><source>not scanned yet</source>
        <translation>noch nicht abgefragt</translation></message>
    <message><source>Click a board, or press Enter, to show it on every page. Motors stop first.</source>
        <translation>Klicken Sie auf ein Board oder drücken Sie Enter, um es auf jeder Seite zu zeigen. Zuvor werden die Motoren gestoppt.</translation></message>
    <message><source>Search for boards at all device numbers. No settings change</source>
        <translation>Für jede Gerätenummer abfragen, welches Board sie hat; es wird nichts geändert</translation></message>
    <message><source>Give the selected board another device number</source>
        <translation>Dem ausgewählten Board eine andere Gerätenummer geben</translation></message>
    <message><source>Drive several boards as one robot, with one pad and one Stop</source>
        <translation>Mehrere Boards als einen Roboter fahren, mit einem Feld und einem Stopp</translation></message>
    <message><source>Drive alone</source>
        <translation>Allein fahren</translation></message>
    <message><source>The line is first searched for the new number. If another board has this number, nothing is written. A board that is off or uses other serial settings cannot be found. If the number is free, a snapshot is saved and the new number is written. It takes effect at once.</source>
        <translation>Vor dem Schreiben wird die Leitung nach der neuen Nummer abgefragt: Hat ein anderes Board sie, wird nichts geschrieben. Ein ausgeschaltetes Board oder eines mit anderen seriellen Einstellungen kann nicht bemerkt werden. Die neue Nummer gilt sofort; vorher wird eine Sicherungskopie gespeichert.</translation></message>
    <message><source>Progress of the search</source>
        <translation>Fortschritt der Suche</translation></message>
    <message><source>Find boards</source>
        <translation>Boards suchen</translation></message>
    <message><source>Cancel</source>
        <translation>Abbrechen</translation></message>
    <message><source>Change number…</source>
        <translation>Nummer ändern…</translation></message>
    <message><source>Drive together…</source>
        <translation>Gemeinsam fahren…</translation></message>
    <message><source>Boards on this line</source>
        <translation>Boards an dieser Leitung</translation></message>
    <message><source>The board replied before. Check its power and its wires.</source>
        <translation>Es hat schon geantwortet. Prüfen Sie seine Stromversorgung und seine Leitungen.</translation></message>
    <message><source>More than one board seems to have this number. Switch off all of them except one, and give that board a different number.</source>
        <translation>Mehrere Boards scheinen diese Nummer zu haben. Schalten Sie alle bis auf eines aus und geben Sie diesem eine eigene Nummer.</translation></message>
    <message><source>The board already has this number.</source>
        <translation>Das Board hat diese Nummer schon.</translation></message>
    <message><source>armed</source>
        <translation>freigegeben</translation></message>
    <message><source>driven together</source>
        <translation>gemeinsam gefahren</translation></message>
    <message><source>deselecting …</source>
        <translation>wird verlassen …</translation></message>
    <message><source>selected, not responding</source>
        <translation>ausgewählt, antwortet nicht</translation></message>
    <message><source>selected, armed</source>
        <translation>ausgewählt, freigegeben</translation></message>
    <message><source>selected, may be moving</source>
        <translation>ausgewählt, bewegt sich vielleicht</translation></message>
    <message><source>&amp;New number:</source>
        <translation>&amp;Neue Nummer:</translation></message>
    <message><source>Change device nu&amp;mber…</source>
        <translation>&amp;Gerätenummer ändern…</translation></message>
    <message><source>&amp;Write number</source>
        <translation>Nummer &amp;schreiben</translation></message>
    <message><source>Taken: {0}.</source>
        <translation>Vergeben: {0}.</translation></message>
    <message><source>Board now</source>
        <translation>Board jetzt</translation></message>
    <message><source>After</source><comment>value</comment>
        <translation>Nachher</translation></message>
    <message><source>Nothing to write.</source>
        <translation>Nichts zu schreiben.</translation></message>
    <message numerus="yes"><source>&amp;Write to %n board(s)</source>
        <translation><numerusform>Auf %n Board &amp;schreiben</numerusform><numerusform>Auf %n Boards &amp;schreiben</numerusform></translation></message>
    <message><source>&amp;Write to boards</source>
        <translation>Auf Boards &amp;schreiben</translation></message>
    <message><source>&amp;End after this board</source>
        <translation>&amp;Nach diesem Board beenden</translation></message>
    <message><source>This file cannot be used: it has errors. Nothing was changed.</source>
        <translation>Diese Datei ist nicht verwendbar: Sie enthält Fehler. Es wurde nichts geändert.</translation></message>
    <message numerus="yes"><source>%n setting(s)</source>
        <translation><numerusform>%n Einstellung</numerusform><numerusform>%n Einstellungen</numerusform></translation></message>
    <message><source>read, with warnings</source>
        <translation>gelesen, mit Warnungen</translation></message>
    <message><source>read</source>
        <translation>gelesen</translation></message>
    <message><source>waiting</source>
        <translation>wartet</translation></message>
    <message><source>being read …</source>
        <translation>wird gelesen …</translation></message>
    <message><source>being written …</source>
        <translation>wird geschrieben …</translation></message>
    <message><source>written and verified</source>
        <translation>geschrieben und geprüft</translation></message>
    <message><source>not tried</source>
        <translation>nicht versucht</translation></message>
    <message><source>Changes</source>
        <translation>Änderungen</translation></message>
    <message><source>The settings are written to the checked boards one after another. A snapshot of each board is saved first. Each board keeps its device number and its serial settings. Writing ends at the first write error.</source>
        <translation>Jedes angekreuzte Board erhält diese Einstellungen, ein Board nach dem anderen, jeweils nach einer Sicherungskopie. Jedes behält seine Gerätenummer und seine seriellen Einstellungen. Der erste Fehler beim Schreiben beendet die Arbeit.</translation></message>
    <message><source>Close</source>
        <translation>Schließen</translation></message>
    <message><source>Writing ended because Stop was pressed.</source>
        <translation>„Motoren stoppen“ wurde gedrückt; das hat die Arbeit beendet.</translation></message>
    <message numerus="yes"><source>Written to %n board(s).</source>
        <translation><numerusform>Auf %n Board geschrieben.</numerusform><numerusform>Auf %n Boards geschrieben.</numerusform></translation></message>
    <message><source>Apply {0} to several boards</source>
        <translation>{0} auf mehrere Boards anwenden</translation></message>
    <message><source>File</source>
        <translation>Datei</translation></message>
    <message numerus="yes"><source>%n board(s) left out; see the Result column.</source>
        <translation><numerusform>%n Board ausgelassen; siehe Spalte „Ergebnis“.</numerusform><numerusform>%n Boards ausgelassen; siehe Spalte „Ergebnis“.</numerusform></translation></message>
    <message><source>Board {0}</source>
        <translation>Board {0}</translation></message>
    <message><source>{0}: beyond a limit that no document confirms (inferred). The board may reject the value or store a different value.</source>
        <translation>{0}: jenseits einer Grenze, die kein Dokument bestätigt (erschlossen). Das Board entscheidet: Es lehnt den Wert vielleicht ab oder speichert einen anderen.</translation></message>
    <message><source>Write an&amp;yway</source>
        <translation>&amp;Trotzdem schreiben</translation></message>
    <message><source>{0}, firmware {1}</source>
        <translation>{0}, Firmware {1}</translation></message>
    <message><source>The file is for a {0}, and the board is a {1}. Checked changes become edits.</source>
        <translation>Für einen {0}; das Board ist ein {1}. Werte mit Häkchen werden als Änderungen übernommen.</translation></message>
    <message numerus="yes"><source>{0}: %n change(s) pending. Review them, then write.</source>
        <translation><numerusform>{0}: %n Änderung steht an; prüfen Sie sie, um sie zu schreiben.</numerusform><numerusform>{0}: %n Änderungen stehen an; prüfen Sie sie, um sie zu schreiben.</numerusform></translation></message>
    <message><source>&amp;Edit the file instead</source>
        <translation>Stattdessen die Datei &amp;bearbeiten</translation></message>
    <message numerus="yes"><source>%n setting(s) differ, {0} match.</source>
        <translation><numerusform>%n Einstellung weicht ab, {0} gleich.</numerusform><numerusform>%n Einstellungen weichen ab, {0} gleich.</numerusform></translation></message>
    <message><source>Opens the converted settings as a new file with the same comments. {0} is not changed.</source>
        <translation>Öffnet die konvertierten Einstellungen als neue Datei, mit den Kommentaren dieser Datei. {0} bleibt, wie sie ist.</translation></message>
    <message><source>&amp;Convert</source>
        <translation>&amp;Konvertieren</translation></message>
    <message><source>Load settings from {0}</source>
        <translation>Einstellungen laden: {0}</translation></message>
    <message numerus="yes"><source>&amp;Load %n change(s)</source>
        <translation><numerusform>%n Änderung &amp;laden</numerusform><numerusform>%n Änderungen &amp;laden</numerusform></translation></message>
    <message numerus="yes"><source>&amp;Copy %n value(s) to {0}</source>
        <translation><numerusform>%n &amp;Wert nach {0} kopieren</numerusform><numerusform>%n &amp;Werte nach {0} kopieren</numerusform></translation></message>
    <message><source>Convert &amp;for:</source>
        <translation>Konvertieren &amp;für:</translation></message>
    <message><source>Board, as shown</source>
        <translation>Board, wie angezeigt</translation></message>
    <message><source>Not in the file and therefore unchanged: {0}.</source>
        <translation>Nicht in der Datei und daher unverändert: {0}.</translation></message>
    <message><source>Convert {0}</source>
        <translation>{0} konvertieren</translation></message>
    <message><source>In the file</source>
        <translation>In der Datei</translation></message>
    <message><source>{0} was not loaded: the board is no longer connected.</source>
        <translation>{0} wurde nicht geladen: Das Board ist nicht mehr verbunden.</translation></message>
    <message><source>Load {0}</source>
        <translation>{0} laden</translation></message>
    <message><source>Copy values from {0}</source>
        <translation>Werte aus {0} kopieren</translation></message>
    <message numerus="yes"><source>%n value(s) copied from {0}.</source>
        <translation><numerusform>%n Wert aus {0} kopiert.</numerusform><numerusform>%n Werte aus {0} kopiert.</numerusform></translation></message>
    <message><source>For a {0}</source>
        <translation>Für einen {0}</translation></message>
    <message><source>Resets every parameter with the board's own reset command when the board next starts</source>
        <translation>Setzt alle Parameter durch den Befehl des Boards zurück, bei seinem nächsten Start</translation></message>
    <message><source>&amp;Let the board reset itself…</source>
        <translation>Das Board sich selbst &amp;zurücksetzen lassen…</translation></message>
    <message><source>At its next start the board will reset every parameter, including the unchecked ones. The current settings of the board are saved first (File, History). Unapplied changes are discarded; Undo restores them.</source>
        <translation>Bei seinem nächsten Start setzt das Board alle Parameter zurück, auch die hier abgewählten. Seine jetzigen Einstellungen werden zuvor gesichert (Datei, Verlauf). Nicht angewendete Änderungen werden verworfen; „Rückgängig“ stellt sie wieder her.</translation></message>
    <message><source>The board would get device number {0}, which another board on this line already has. Both would reply at the same time, and neither could be read. Give the other board a different number first.</source>
        <translation>Es erhält die Gerätenummer {0}, die ein anderes Board an dieser Leitung hat: Beide würden gleichzeitig antworten, und keine der Antworten wäre lesbar. Geben Sie jenem Board zuerst eine andere Nummer.</translation></message>
    <message numerus="yes"><source>Write %n setting(s) to the board</source>
        <translation><numerusform>%n Einstellung in das Board schreiben</numerusform><numerusform>%n Einstellungen in das Board schreiben</numerusform></translation></message>
    <message><source>Writing. Leave the power on.</source>
        <translation>Schreiben läuft. Lassen Sie die Stromversorgung eingeschaltet.</translation></message>
    <message><source>A snapshot of all settings is saved first. Each value is read back.</source>
        <translation>Vorher wird eine Sicherungskopie aller Einstellungen gespeichert. Jeder Wert wird zurückgelesen.</translation></message>
    <message><source>{0} (device number {1}, {2})</source>
        <translation>{0} (Gerätenummer {1}, {2})</translation></message>
    <message><source>Progress of writing</source>
        <translation>Fortschritt beim Schreiben</translation></message>
    <message><source>Reset the &amp;board</source>
        <translation>&amp;Board zurücksetzen</translation></message>
    <message><source>{0} of {1}: {2}</source>
        <translation>{0} von {1}: {2}</translation></message>
    <message><source>{0} of {1} settings could not be verified and are still pending.</source>
        <translation>Konnte nicht bestätigt werden: {0} von {1}; noch ausstehend.</translation></message>
    <message><source>The value that was being written when the connection was lost may be the old one, the new one or, after a power cut, the default. It will be read again.</source>
        <translation>Der Wert, der gerade geschrieben wurde, als die Verbindung verloren ging, kann der alte, der neue oder, nach einem Stromausfall, der Standardwert sein. Er wird erneut gelesen.</translation></message>
    <message><source>Before</source><comment>value</comment>
        <translation>Vorher</translation></message>
    <message numerus="yes"><source>%n setting(s) written and verified.</source>
        <translation><numerusform>%n Einstellung geschrieben und geprüft.</numerusform><numerusform>%n Einstellungen geschrieben und geprüft.</numerusform></translation></message>
    <message><source>Saving a snapshot. Nothing has been written yet.</source>
        <translation>Sicherungskopie wird gespeichert. Noch ist nichts geschrieben.</translation></message>
    <message><source>No board is responding. The edits are kept.</source>
        <translation>Kein Board antwortet. Die Änderungen bleiben erhalten.</translation></message>
    <message><source>The board will reset itself at its next start, and values written now would be lost. Switch the board off and on first (Device, Make stored settings active).</source>
        <translation>Das Board setzt sich bei seinem nächsten Start selbst zurück und würde verlieren, was jetzt geschrieben wird. Schalten Sie es zuerst aus und ein (Gerät, Gespeicherte Einstellungen aktivieren).</translation></message>
    <message><source>These calibrations stay pending until the board uses their input source again: {0}.</source>
        <translation>Diese Kalibrierungen bleiben ausstehend, bis das Board ihre Eingangsquelle wieder verwendet: {0}.</translation></message>
    <message><source>Active only after the board is switched off and on: {0}.</source>
        <translation>Erst nach dem Aus- und Einschalten des Boards aktiv: {0}.</translation></message>
    <message><source>Restore factor&amp;y defaults…</source>
        <translation>&amp;Werkseinstellungen wiederherstellen…</translation></message>
    <message><source>Restore ser&amp;ial defaults…</source>
        <translation>Serielle Standardwerte wieder&amp;herstellen…</translation></message>
    <message numerus="yes"><source>&amp;Write %n setting(s)</source>
        <translation><numerusform>%n Einstellung &amp;schreiben</numerusform><numerusform>%n Einstellungen &amp;schreiben</numerusform></translation></message>
    <message><source>Channel calibrations are not changed.</source>
        <translation>Die Kalibrierungen der Kanäle bleiben.</translation></message>
    <message><source>The connection was lost.</source>
        <translation>Die Verbindung ist abgebrochen.</translation></message>
    <message><source>not attempted</source>
        <translation>nicht versucht</translation></message>
    <message><source>No source confirms these defaults: {0}.</source>
        <translation>Keine Quelle bestätigt den Standardwert von: {0}.</translation></message>
    <message><source>Both off</source>
        <translation>Beide aus</translation></message>
    <message><source>No power</source>
        <translation>Kein Strom</translation></message>
    <message><source>Check the supply and its leads. If only a blue LED is lit, the board has no firmware.</source>
        <translation>Prüfen Sie die Stromversorgung und ihre Leitungen. Wenn nur eine blaue LED leuchtet, hat das Board keine Firmware.</translation></message>
    <message><source>Red on</source>
        <translation>Rot an</translation></message>
    <message><source>Running: serial commands control the motors</source>
        <translation>In Betrieb, serielle Befehle steuern die Motoren</translation></message>
    <message><source>Compare the wires with the picture, then search with “Find”. The green LED lights while the board receives a command. If it never lights, nothing arrives.</source>
        <translation>Vergleichen Sie die Verdrahtung mit dem Bild, dann suchen Sie mit „Suchen“. Grün leuchtet, während das Board einen Befehl empfängt: Leuchtet es nie, kommt nichts an.</translation></message>
    <message><source>Green on, or flashing fast</source>
        <translation>Grün an oder schnell blinkend</translation></message>
    <message><source>Running: the channels control the motors</source>
        <translation>In Betrieb, die Kanäle steuern die Motoren</translation></message>
    <message><source>Proceed as above: the board also responds in RC and analog mode. The red LED lights while the board receives a command. Fast flashes mean safe-start. Five flashes at power-up show which channels are learned.</source>
        <translation>Wie oben: Das Board antwortet auch im RC- und im Analogmodus. Rot leuchtet, während es einen Befehl empfängt. Schnelles Blinken ist der Safe-Start; fünfmaliges Aufleuchten beim Einschalten zeigt, welche Kanäle eingelernt sind.</translation></message>
    <message><source>Both blink together, or both on</source>
        <translation>Beide blinken gemeinsam oder leuchten</translation></message>
    <message><source>Learning mode</source>
        <translation>Lernmodus</translation></message>
    <message><source>The board does not respond while it learns its channels. Remove the SO–G jumper, then switch the board off and on.</source>
        <translation>Das Board antwortet nicht, während es seine Kanäle einlernt. Ziehen Sie den SO–G-Jumper ab, dann schalten Sie das Board aus und ein.</translation></message>
    <message><source>Red and green alternate</source>
        <translation>Rot und Grün abwechselnd</translation></message>
    <message><source>Waiting for the boot loader handshake</source>
        <translation>Wartet auf den Handshake des Bootloaders</translation></message>
    <message><source>Switch the board off, remove the mix and SO–G jumpers, and switch it on. If its serial settings are lost, continue with the handshake instead.</source>
        <translation>Schalten Sie das Board aus, ziehen Sie Mix- und SO–G-Jumper ab und schalten Sie es ein. Oder machen Sie mit dem Handshake für verlorene serielle Einstellungen weiter.</translation></message>
    <message><source>Green flashes once a second</source>
        <translation>Grün blinkt einmal pro Sekunde</translation></message>
    <message><source>Boot loader, waiting for new firmware</source>
        <translation>Bootloader, wartet auf neue Firmware</translation></message>
    <message><source>Switch the board off and on, with the jumpers removed.</source>
        <translation>Schalten Sie das Board mit abgezogenen Jumpern aus und ein.</translation></message>
    <message><source>The mode jumper may also be on: the board responds in every mode.</source>
        <translation>Der Modus-Jumper darf auch stecken: Das Board antwortet in jedem Modus.</translation></message>
    <message><source>Jumpers</source>
        <translation>Jumper</translation></message>
    <message><source>Switch the board off. Remove the mode jumper. Put the mix and SO–G jumpers on.</source>
        <translation>Schalten Sie das Board aus. Ziehen Sie den Modus-Jumper ab. Stecken Sie Mix- und SO–G-Jumper auf.</translation></message>
    <message><source>Nothing: the board has no power.</source>
        <translation>Nichts: Das Board hat keinen Strom.</translation></message>
    <message><source>Switch on</source>
        <translation>Einschalten</translation></message>
    <message><source>Switch the board on.</source>
        <translation>Schalten Sie das Board ein.</translation></message>
    <message><source>Red and green alternate, about once a second.</source>
        <translation>Rot und Grün abwechselnd, etwa einmal pro Sekunde.</translation></message>
    <message><source>Nothing: the SO–G jumper connects SO to ground.</source>
        <translation>Nichts: Der SO–G-Jumper hält seine Leitung auf Masse.</translation></message>
    <message><source>Remove the mix jumper. Leave the power on.</source>
        <translation>Ziehen Sie den Mix-Jumper ab. Lassen Sie das Board eingeschaltet.</translation></message>
    <message><source>Red and green alternate, four times as fast.</source>
        <translation>Rot und Grün abwechselnd, viermal so schnell.</translation></message>
    <message><source>Remove the SO–G jumper. Leave the power on.</source>
        <translation>Ziehen Sie den SO–G-Jumper ab. Lassen Sie das Board eingeschaltet.</translation></message>
    <message><source>The boot loader answers each byte with a question mark. The serial settings should now be the factory settings.</source>
        <translation>Der Bootloader beantwortet jedes Byte mit einem Fragezeichen. Die seriellen Einstellungen sollten jetzt die Werkseinstellungen sein.</translation></message>
    <message><source>Connect</source>
        <translation>Verbinden</translation></message>
    <message><source>Switch the board off and on, with all three jumpers removed. Then connect at 19200 baud, without parity or CRC.</source>
        <translation>Schalten Sie das Board aus und ein, alle drei Jumper abgezogen. Dann verbinden Sie mit 19200 Baud, ohne Parität und CRC.</translation></message>
    <message><source>Five flashes, then red stays on.</source>
        <translation>Fünfmal Blinken, dann bleibt Rot an.</translation></message>
    <message><source>The TReX responds at the factory settings.</source>
        <translation>Der TReX antwortet mit den Werkseinstellungen.</translation></message>
    <message><source>Restores the factory serial settings (inferred). If the LEDs alternate for only three seconds, start again.</source>
        <translation>Stellt die seriellen Werkseinstellungen wieder her (abgeleitet). Wenn die LEDs nur drei Sekunden lang abwechselnd leuchten, beginnen Sie neu.</translation></message>
    <message><source>Connects at 19200 baud, without parity or CRC, to any device number</source>
        <translation>19200 Baud, ohne Parität und CRC, bei jeder Gerätenummer</translation></message>
    <message><source>&amp;Connect at factory settings</source>
        <translation>&amp;Mit Werkseinstellungen verbinden</translation></message>
    <message><source>What the LEDs show</source>
        <translation>Was die LEDs zeigen</translation></message>
    <message><source>Jumpers and LEDs</source>
        <translation>Jumper und LEDs</translation></message>
    <message><source>What this computer receives</source>
        <translation>Was dieser Computer empfängt</translation></message>
    <message><source>&amp;Find now</source>
        <translation>&amp;Jetzt suchen</translation></message>
    <message><source>&amp;Board does not respond…</source>
        <translation>&amp;Board antwortet nicht…</translation></message>
    <message><source>LEDs</source>
        <translation>LEDs</translation></message>
    <message><source>&amp;Next</source>
        <translation>&amp;Weiter</translation></message>
    <message><source>Show wire values, and settings that match</source>
        <translation>Bytewerte und übereinstimmende Einstellungen zeigen</translation></message>
    <message><source>Select &amp;all</source>
        <translation>&amp;Alle auswählen</translation></message>
    <message><source>Deta&amp;ils</source>
        <translation>E&amp;inzelheiten</translation></message>
    <message><source>Comparison of settings</source>
        <translation>Vergleich der Einstellungen</translation></message>
    <message numerus="yes"><source>%n count(s)</source>
        <translation><numerusform>%n Count</numerusform><numerusform>%n Counts</numerusform></translation></message>
    <message><source>Enter 0 to {0}, such as 2.5 V, 2500 mV or 512 counts.</source>
        <translation>Geben Sie 0 bis {0} ein, etwa 2,5 V, 2500 mV oder 512 Counts.</translation></message>
    <message><source>Not a value</source>
        <translation>Kein Wert</translation></message>
    <message><source>{0} is not a valid value. {1}</source>
        <translation>{0} ist kein gültiger Wert. {1}</translation></message>
    <message><source>Enter 0 to {0}, such as 1500 µs, 1.5 ms or 3750 counts.</source>
        <translation>Geben Sie 0 bis {0} ein, etwa 1500 µs, 1,5 ms oder 3750 Counts.</translation></message>
    <message><source>The nearest value that the board can store is {0}.</source>
        <translation>Am nächsten, was das Board speichern kann, liegt {0}.</translation></message>
    <message><source>&amp;Turn</source>
        <translation>&amp;Lenken</translation></message>
    <message><source>&amp;Forward</source>
        <translation>&amp;Vorwärts</translation></message>
    <message><source>blink {0}/s</source>
        <translation>blinkt {0}/s</translation></message>
    <message><source>alternate {0}/s</source>
        <translation>wechselt {0}/s</translation></message>
    <message><source>short flash {0}/s</source>
        <translation>blitzt {0}/s</translation></message>
    <message><source>The sticks control the motors.</source>
        <translation>Die Knüppel steuern die Motoren.</translation></message>
    <message><source>Safe-start: the motors wait until the sticks are centred.</source>
        <translation>Safe-Start: Die Motoren warten, bis die Knüppel in Mittelstellung sind.</translation></message>
    <message><source>Switches the power off for a second. At power-up, the board reads its jumpers and activates the stored settings</source>
        <translation>Eine Sekunde lang aus: Jumper werden gelesen, gespeicherte Einstellungen wirksam</translation></message>
    <message><source>A weak battery sags when the motors start, and the board resets</source>
        <translation>Eine schwache Batterie bricht ein, wenn die Motoren anlaufen, und das Board startet neu</translation></message>
    <message><source>Hold all sticks centred, as safe-start requires</source>
        <translation>Alle Knüppel in Mittelstellung halten, wie es der Safe-Start verlangt</translation></message>
    <message><source>The next byte reaches the board with this error, which the Problems page counts. Only a board with parity detects a parity error.</source>
        <translation>Das nächste Byte erreicht das Board mit diesem Fehler; „Probleme“ zählt ihn. Nur ein Board mit Parität erkennt einen Paritätsfehler.</translation></message>
    <message><source>An error of the serial line that the board reports</source>
        <translation>Ein Fehler der seriellen Leitung, den das Board meldet</translation></message>
    <message><source>The power is off: the board does not reply.</source>
        <translation>Die Stromversorgung ist aus: Das Board antwortet nicht.</translation></message>
    <message><source>RC mode.</source>
        <translation>RC-Modus.</translation></message>
    <message><source>Analog mode.</source>
        <translation>Analogmodus.</translation></message>
    <message><source>Safe-start: the motors wait for a signal on input {0}.</source>
        <translation>Safe-Start: Die Motoren warten auf ein Signal an Eingang {0}.</translation></message>
    <message><source>Safe-start: the motors wait until channel 5 no longer requests override.</source>
        <translation>Safe-Start: Die Motoren warten, bis Kanal 5 keinen Vorrang mehr anfordert.</translation></message>
    <message><source>Resets everything: stored settings, jumpers, sticks, loads and serial line faults</source>
        <translation>Setzt alles zurück: gespeicherte Einstellungen, Jumper, Knüppel, Lasten und Störungen der Leitung</translation></message>
    <message><source>Power on</source><comment>state</comment>
        <translation>Eingeschaltet</translation></message>
    <message><source>The board's power switch</source>
        <translation>Der Hauptschalter des Boards</translation></message>
    <message><source>Power cycle</source>
        <translation>Aus- und einschalten</translation></message>
    <message><source>Battery</source>
        <translation>Batterie</translation></message>
    <message><source>Move automatically</source>
        <translation>Selbsttätig bewegen</translation></message>
    <message><source>All sticks swing slowly. A stick that you move stays where you put it.</source>
        <translation>Alle Knüppel schwingen langsam; einer, den Sie bewegen, bleibt dann stehen</translation></message>
    <message><source>Centre</source>
        <translation>Mitte</translation></message>
    <message><source>Input {0}: {1}. Double-click to centre the stick, or press Delete to unplug the input.</source>
        <translation>Eingang {0}: {1}. Ein Doppelklick zentriert ihn, Entf zieht ihn ab.</translation></message>
    <message><source>If the cable is unplugged, the port disappears. Serial Timeout and UART-Error Shutdown should then stop the motors</source>
        <translation>Abgezogen verschwindet der Port: Serielles Timeout und „Abschaltung bei UART-Fehlern“ sollten die Motoren stoppen</translation></message>
    <message><source>The mode jumper, which the board reads at power-up</source>
        <translation>Der Modus-Jumper; das Board liest ihn beim Einschalten</translation></message>
    <message><source>The mix jumper: input 2 drives forward and input 1 turns. A change takes effect at once</source>
        <translation>Der Mix-Jumper: Eingang 2 fährt vorwärts, Eingang 1 lenkt; wirkt sofort</translation></message>
    <message><source>Connects SO to ground. If the mix jumper is also on, the board learns the calibration of its inputs at power-up</source>
        <translation>Verbindet SO mit Masse; zusammen mit Mix lernt das Board beim nächsten Einschalten die Kalibrierung der Eingänge ein</translation></message>
    <message><source>Factory state</source>
        <translation>Werkszustand</translation></message>
    <message><source>Mode is read at power-up; Mix takes effect at once.</source>
        <translation>Der Modus wird beim Einschalten gelesen; Mix wirkt sofort.</translation></message>
    <message><source>The wire from SO is broken: the board executes commands, but no reply arrives</source>
        <translation>Die Leitung von SO ist unterbrochen: Das Board führt Befehle aus, keine Antwort kommt an</translation></message>
    <message><source>This percentage of the bytes in each direction is corrupted. CRC detects the errors</source>
        <translation>Dieser Anteil der Bytes wird in beiden Richtungen verfälscht; CRC erkennt es</translation></message>
    <message><source>Supply</source>
        <translation>Versorgung</translation></message>
    <message><source>Error in one byte</source>
        <translation>Fehler eines Bytes</translation></message>
    <message><source>Corrupt one byte</source>
        <translation>Ein Byte verfälschen</translation></message>
    <message><source>Stick of input {0}</source>
        <translation>Knüppel von Eingang {0}</translation></message>
    <message><source>plugged in</source>
        <translation>eingesteckt</translation></message>
    <message><source>unplugged</source>
        <translation>ausgesteckt</translation></message>
    <message><source>LEDs of the board</source>
        <translation>LEDs des Boards</translation></message>
    <message><source>Makes the driver of motor {0} shut down, as when it is hot or shorted</source>
        <translation>Der Treiber von Motor {0} schaltet sich ab, wie bei Überhitzung oder Kurzschluss</translation></message>
    <message><source>Load of motor {0}</source>
        <translation>Last von Motor {0}</translation></message>
    <message><source>The current that motor {0} draws at full speed. At the right end of the slider, the motor stalls, which triggers current limits and faults</source>
        <translation>Der Strom, den Motor {0} bei voller Geschwindigkeit zieht; ganz rechts blockiert der Motor, was Strombegrenzung und Treiberfehler auslöst</translation></message>
    <message><source>Load</source>
        <translation>Last</translation></message>
    <message><source>Overrun</source>
        <translation>Überlauf</translation></message>
    <message><source>Input {0}</source>
        <translation>Eingang {0}</translation></message>
    <message><source>Plug of input {0}</source>
        <translation>Stecker von Eingang {0}</translation></message>
    <message><source>Unplug input {0}: an RC input becomes invalid after 0.1 s</source>
        <translation>Eingang {0} abziehen: Ein RC-Eingang ist 0,1 s später ungültig</translation></message>
    <message><source>switched off</source>
        <translation>ausgeschaltet</translation></message>
    <message><source>Fault</source>
        <translation>Störung</translation></message>
    <message><source>Findings about the settings</source>
        <translation>Befunde zu den Einstellungen</translation></message>
    <message numerus="yes"><source>and %n more</source>
        <translation><numerusform>und %n weiterer</numerusform><numerusform>und %n weitere</numerusform></translation></message>
    <message><source>Accept</source>
        <translation>Übernehmen</translation></message>
    <message><source>Show line {0}</source>
        <translation>Zeile {0} zeigen</translation></message>
    <message><source>These boards are armed, driven and stopped together as one robot. If one board no longer follows, the others stop.</source>
        <translation>Ein Feld, eine Freigabe und ein Stopp fahren diese Boards als einen Roboter. Ein Board, das nicht mehr folgt, stoppt die anderen.</translation></message>
    <message><source>&amp;Drive together</source>
        <translation>Gemeinsam &amp;fahren</translation></message>
    <message><source>no problem</source>
        <translation>kein Problem</translation></message>
    <message><source>reversed</source>
        <translation>umgekehrt</translation></message>
    <message><source>not driven</source>
        <translation>nicht gefahren</translation></message>
    <message><source>Board {0}, motor {1}</source>
        <translation>Board {0}, Motor {1}</translation></message>
    <message><source>Search times, boards, adapters (Ctrl+F)</source>
        <translation>Zeiten, Boards, Adapter suchen (Strg+F)</translation></message>
    <message><source>Name the snapshot (or double-click it). A named snapshot is never deleted automatically</source>
        <translation>Eine mit Namen bleibt, wie viele auch folgen; auch mit Doppelklick</translation></message>
    <message><source>Save a copy as a settings file</source>
        <translation>Eine Kopie als Einstellungsdatei speichern</translation></message>
    <message><source>There are no snapshots yet.

Before this program or trexcmd applies settings or restores defaults, all settings of the board are saved here. You can compare a snapshot with the board and restore some or all of its settings.</source>
        <translation>Es gibt noch keine Sicherungskopien.

Bevor Einstellungen angewendet oder Standardwerte wiederhergestellt werden, in diesem Fenster oder mit trexcmd, wird hier alles gesichert, was das Board speichert. Sie können eine Sicherungskopie mit dem Board vergleichen und ganz oder teilweise wiederherstellen.</translation></message>
    <message numerus="yes"><source>Permanently delete %n snapshot(s), the newest from {0}?</source>
        <translation><numerusform>%n Sicherungskopie von {0} endgültig löschen?</numerusform><numerusform>%n Sicherungskopien endgültig löschen, die neueste von {0}?</numerusform></translation></message>
    <message><source>Search snapshots</source>
        <translation>Sicherungskopien durchsuchen</translation></message>
    <message><source>No snapshot matches the search.</source>
        <translation>Keine Sicherungskopie passt zur Suche.</translation></message>
    <message><source>&amp;Name…</source>
        <translation>&amp;Name…</translation></message>
    <message><source>Save &amp;as…</source>
        <translation>Speichern un&amp;ter…</translation></message>
    <message><source>Snapshots</source>
        <translation>Sicherungskopien</translation></message>
    <message><source>Save a copy of the snapshot</source>
        <translation>Sicherungskopie als Datei speichern</translation></message>
    <message><source>&amp;History…</source>
        <translation>&amp;Verlauf…</translation></message>
    <message><source>A copy was saved to {0}.</source>
        <translation>Eine Kopie wurde in {0} gespeichert.</translation></message>
    <message><source>Nothing was saved. {0}</source>
        <translation>Es wurde nichts gespeichert. {0}</translation></message>
    <message><source>Push every stick all the way forward or right first, then all the way in the other direction. Move every switch to all its positions. Hold each end position until it is ticked, then click Next.</source>
        <translation>Drücken Sie jeden Knüppel zuerst ganz nach vorn oder rechts, dann ganz in die andere Richtung. Bewegen Sie Schalter in alle Stellungen. Halten Sie jede Endlage, bis ihr Häkchen erscheint, dann klicken Sie auf „Weiter“.</translation></message>
    <message><source>This takes at least {0:.1f} s: at {1} baud only {2:.1f} measurements arrive per second.</source>
        <translation>Das dauert mindestens {0:.1f} s: Bei {1} Baud kommen nur {2:.1f} Messungen pro Sekunde an.</translation></message>
    <message><source>Push every stick to all its ends, then release it. Move every switch to all its positions. The motors stay off.</source>
        <translation>Drücken Sie jeden Knüppel in alle seine Endlagen, dann lassen Sie ihn los. Bewegen Sie jeden Schalter in alle seine Stellungen. Die Motoren bleiben aus.</translation></message>
    <message><source>The board sends no measurements: the line is busy or disturbed. Waiting …</source>
        <translation>Das Board sendet keine Messungen: Die Leitung ist belegt oder gestört. Es wird gewartet …</translation></message>
    <message><source>Release every stick and set every switch to off. Then click Next.</source>
        <translation>Lassen Sie jeden Knüppel los und stellen Sie jeden Schalter auf Aus. Klicken Sie dann auf „Weiter“.</translation></message>
    <message><source>No channel is at rest. Click “Sample again”.</source>
        <translation>Kein Kanal ist in Ruhe. Klicken Sie auf „Erneut messen“.</translation></message>
    <message><source>Nothing was learned. Go back, or start over.</source>
        <translation>Es wurde nichts eingelernt. Gehen Sie zurück oder beginnen Sie neu.</translation></message>
    <message><source>No channel is selected.</source>
        <translation>Kein Kanal ist ausgewählt.</translation></message>
    <message><source>The board would reject the values of channel {0}: change them, or clear its check box.</source>
        <translation>Das Board würde die Werte von Kanal {0} ablehnen: Ändern Sie sie, oder entfernen Sie sein Häkchen.</translation></message>
    <message><source>Check the new values. Nothing has been written yet.</source>
        <translation>Prüfen Sie die neuen Werte. Noch wird nichts geschrieben.</translation></message>
    <message><source>Stop the motors</source>
        <translation>Motoren stoppen</translation></message>
    <message><source>Hands off</source>
        <translation>Loslassen</translation></message>
    <message><source>All ends</source>
        <translation>Alle Endlagen</translation></message>
    <message><source>Review</source>
        <translation>Prüfen</translation></message>
    <message><source>The new values are in the board. Stop the motors to test the values.</source>
        <translation>Die neuen Werte sind im Board. Ihr Test muss zuerst die Motoren stoppen.</translation></message>
    <message><source>Sample &amp;again</source>
        <translation>Erneut &amp;messen</translation></message>
    <message><source>Start this step &amp;again</source>
        <translation>Schritt neu &amp;beginnen</translation></message>
    <message><source>&amp;Start over</source>
        <translation>Neu &amp;beginnen</translation></message>
    <message><source>Test &amp;again</source>
        <translation>Erneut &amp;testen</translation></message>
    <message><source>Not every channel is at rest. Click “Sample again”, or Next to go on without channel {0}.</source>
        <translation>Nicht jeder Kanal ist in Ruhe. Klicken Sie auf „Erneut messen“ oder auf „Weiter“, um ohne Kanal {0} fortzufahren.</translation></message>
    <message><source>Every channel works as it should.</source>
        <translation>Alles ist, wie es sein soll.</translation></message>
    <message><source>Nothing to test: the board ignores this input (Ignored Channels).</source>
        <translation>Nichts zu testen: Das Board ignoriert diesen Eingang („Ignorierte Kanäle“).</translation></message>
    <message><source>The channels are good. But in {0} mode the motors would not start. {1}</source>
        <translation>Die Kanäle sind gut. Aber im Modus {0} würden die Motoren nicht anlaufen. {1}</translation></message>
    <message><source>Stop the motors and &amp;test</source>
        <translation>Motoren stoppen und &amp;testen</translation></message>
    <message><source>The motors are stopped: co&amp;ntinue</source>
        <translation>Die Motoren stehen still: &amp;fortfahren</translation></message>
    <message><source>Try &amp;again</source>
        <translation>&amp;Erneut versuchen</translation></message>
    <message><source>Stopping the motors. The board must confirm the stop.</source>
        <translation>Die Motoren werden gestoppt. Das Board muss den Stopp bestätigen.</translation></message>
    <message><source>Hands off. Sampling … {0:.1f} s</source>
        <translation>Knüppel loslassen. Messung läuft … {0:.1f} s</translation></message>
    <message><source>&amp;Test the sticks…</source>
        <translation>&amp;Knüppel testen…</translation></message>
    <message><source>&amp;Use these values…</source>
        <translation>Diese Werte &amp;verwenden…</translation></message>
    <message><source>{0} end: not reached yet</source>
        <translation>Endlage {0}: noch nicht erreicht</translation></message>
    <message><source>{0} end: hold this position</source>
        <translation>Endlage {0}: dort halten</translation></message>
    <message><source>{0} end: reached</source>
        <translation>Endlage {0}: erreicht</translation></message>
    <message><source>{0} end: not needed</source>
        <translation>Endlage {0}: nicht nötig</translation></message>
    <message><source>Calculated from the values in the board, separately for each channel. Two assumptions: outputs of up to 8 of 127 are neutral, and switches change halfway between neutral and the end (inferred).</source>
        <translation>Aus den Werten im Board berechnet, für jeden Kanal einzeln. Zwei Annahmen: Ausgaben bis 8 von 127 gelten als neutral, und Schalter schalten auf halbem Weg zwischen Neutral und Ende um (erschlossen).</translation></message>
    <message><source>Hold this position …</source>
        <translation>Dort halten …</translation></message>
    <message><source>No end reached yet.</source>
        <translation>Noch keine Endlage erreicht.</translation></message>
    <message><source>not sampled yet</source>
        <translation>noch nicht gemessen</translation></message>
    <message><source>low</source>
        <translation>unten</translation></message>
    <message><source>high</source>
        <translation>oben</translation></message>
    <message><source>Left out: the rest position is unknown.</source>
        <translation>Ausgelassen: Die Ruhelage ist nicht bekannt.</translation></message>
    <message><source>Not held. Hold this position for {0:.1f} s.</source>
        <translation>Nicht gehalten. Halten Sie ihn dort {0:.1f} s lang.</translation></message>
    <message><source>Reached: {0}.</source>
        <translation>Erreicht: {0}.</translation></message>
    <message><source>at rest: {0}, noise {1}</source>
        <translation>in Ruhe: {0}, Rauschen {1}</translation></message>
    <message numerus="yes"><source>%n earlier pending edit(s) will also be written.</source>
        <translation><numerusform>%n frühere ausstehende Änderung wird ebenfalls geschrieben.</numerusform><numerusform>%n frühere ausstehende Änderungen werden ebenfalls geschrieben.</numerusform></translation></message>
    <message><source>Input now {0}; output {1}.</source>
        <translation>Eingang jetzt {0}; Ausgang {1}.</translation></message>
    <message><source>&amp;Minimum</source>
        <translation>&amp;Minimum</translation></message>
    <message><source>&amp;Neutral</source>
        <translation>&amp;Neutralstellung</translation></message>
    <message><source>Ma&amp;ximum</source>
        <translation>Ma&amp;ximum</translation></message>
    <message><source>&amp;Deadband</source>
        <translation>&amp;Totbereich</translation></message>
    <message><source>was reversed</source>
        <translation>war umgekehrt</translation></message>
    <message><source>was not reversed</source>
        <translation>war nicht umgekehrt</translation></message>
    <message><source>&amp;Reversed</source>
        <translation>&amp;Umgekehrt</translation></message>
    <message><source>proposed</source>
        <translation>vorgeschlagen</translation></message>
    <message><source>as it was</source>
        <translation>bisher</translation></message>
    <message><source>The new values of this channel will be used.</source>
        <translation>Seine neuen Werte werden verwendet.</translation></message>
    <message><source>The channel was left out.</source>
        <translation>Der Kanal wurde ausgelassen.</translation></message>
    <message><source>This replaces a pending edit of the channel.</source>
        <translation>Dies ersetzt eine ausstehende Änderung des Kanals.</translation></message>
    <message><source>Channels</source>
        <translation>Kanäle</translation></message>
    <message><source>No signal now: the output is 0.</source>
        <translation>Jetzt kein Signal: Der Ausgang ist 0.</translation></message>
    <message><source>Nothing was learned.</source>
        <translation>Es wurde nichts eingelernt.</translation></message>
    <message><source>This channel keeps its old values.</source>
        <translation>Behält seine alten Werte.</translation></message>
    <message><source>Check this channel.</source>
        <translation>Prüfen Sie diesen Kanal.</translation></message>
    <message><source>Use &amp;channel {0}: {1}</source>
        <translation>&amp;Kanal {0} verwenden: {1}</translation></message>
    <message><source>Use {0} &amp;as neutral</source>
        <translation>{0} &amp;als Neutralstellung verwenden</translation></message>
    <message><source>{0}
was {1}</source>
        <translation>{0}
bisher {1}</translation></message>
    <message><source>{0} of channel {1}</source>
        <translation>{0} von Kanal {1}</translation></message>
    <message><source>These settings must match those of the board. A new board uses 19200 baud, no error detection and one stop bit. Changing them here does not change the board.</source>
        <translation>Dies müssen die Einstellungen sein, die das Board jetzt hat. Ein neues Board kommuniziert mit 19200 Baud, ohne Fehlererkennung, mit einem Stoppbit. Änderungen hier ändern nichts im Board.</translation></message>
    <message><source>&amp;Address one board by its device number (Pololu protocol)</source>
        <translation>Eines von mehreren Boards über seine &amp;Nummer ansprechen (Pololu-Protokoll)</translation></message>
    <message><source>Device numbers of other devices on this line, such as 0,1 (older Pololu motor and servo controllers). If you enter numbers, every packet has an address, no packet is sent to these numbers, and no other baud rate is tried.</source>
        <translation>Nummern anderer Geräte an dieser Leitung, etwa 0,1 (ältere Motor- und Servocontroller von Pololu). Ist eine angegeben, wird jedes Paket adressiert, an keine dieser Nummern, und keine andere Baudrate wird versucht.</translation></message>
    <message><source>&amp;Line:</source>
        <translation>&amp;Leitung:</translation></message>
    <message><source>CRC-7 &amp;polynomial:</source>
        <translation>CRC-7-&amp;Polynom:</translation></message>
    <message><source>&amp;Device number:</source>
        <translation>&amp;Gerätenummer:</translation></message>
    <message><source>Nu&amp;mbers of other devices:</source>
        <translation>Nu&amp;mmern anderer Geräte:</translation></message>
    <message><source>&amp;Restore defaults</source>
        <translation>Standard&amp;werte wiederherstellen</translation></message>
    <message><source>&amp;Line settings…</source>
        <translation>&amp;Leitungseinstellungen…</translation></message>
    <message><source>Arming without a timeout is remembered for this board. If the cable falls out, cut the power by hand.</source>
        <translation>Freigeben ohne Timeout wird für dieses Board gemerkt. Trennen Sie dann die Motorversorgung von Hand, wenn das Kabel herausfällt.</translation></message>
    <message><source>Arm with&amp;out a timeout</source>
        <translation>&amp;Ohne Timeout freigeben</translation></message>
    <message><source>Writes Serial Timeout and UART-Error Shutdown now: the board should stop its motors {0} s after the last byte. Other changes stay pending.</source>
        <translation>Schreibt jetzt „Serielles Timeout“ und „Abschaltung bei UART-Fehlern“: Das Board sollte seine Motoren {0} s nach dem letzten Byte stoppen. Andere Änderungen bleiben ausstehend.</translation></message>
    <message><source>Stops the motors and sends them no command until they are armed again</source>
        <translation>Stoppt die Motoren und sendet nichts, bis sie wieder freigegeben sind</translation></message>
    <message numerus="yes"><source>Review %n ch&amp;ange(s)…</source>
        <translation><numerusform>%n &amp;Änderung prüfen…</numerusform><numerusform>%n &amp;Änderungen prüfen…</numerusform></translation></message>
    <message><source>No ch&amp;anges</source>
        <translation>Keine &amp;Änderungen</translation></message>
    <message><source>Write the changed parameters into the board (Ctrl+Enter)</source>
        <translation>Die geänderten Parameter ins Board schreiben (Strg+Enter)</translation></message>
    <message><source>Arm the motors</source>
        <translation>Motoren freigeben</translation></message>
    <message><source>Writing …</source>
        <translation>Schreiben läuft …</translation></message>
    <message><source>Reconnect and stop</source>
        <translation>Neu verbinden und stoppen</translation></message>
    <message><source>Stop both motors and the auxiliary now (Esc, anywhere)</source>
        <translation>Beide Motoren und den Hilfsmotor sofort stoppen (Esc, überall)</translation></message>
    <message><source>Armed</source>
        <translation>Freigegeben</translation></message>
    <message><source>Disa&amp;rm</source>
        <translation>Freigabe a&amp;ufheben</translation></message>
    <message><source>A&amp;rm motors</source>
        <translation>Motoren fre&amp;igeben</translation></message>
    <message><source>Allows both motors and the auxiliary to be driven. Nothing moves yet</source>
        <translation>Gibt beide Motoren und den Hilfsmotor zum Fahren frei; noch bewegt sich nichts</translation></message>
    <message><source>Channels control the motors: Stop does not affect them.</source>
        <translation>Die Kanäle steuern die Motoren: „Motoren stoppen“ wirkt nicht auf die Motoren.</translation></message>
    <message><source>&amp;Write {0:g} s and arm</source>
        <translation>{0:g} s &amp;schreiben und freigeben</translation></message>
    <message><source>The board did not store the serial timeout.</source>
        <translation>Das Board hat das serielle Timeout nicht gespeichert.</translation></message>
    <message><source>&amp;Stop motors</source>
        <translation>Motoren &amp;stoppen</translation></message>
    <message><source>Write &amp;{0} s</source>
        <translation>&amp;{0} s schreiben</translation></message>
    <message><source>Why this value? Saved on this computer and in files.</source>
        <translation>Warum dieser Wert? Wird auf diesem Computer und in Dateien aufbewahrt.</translation></message>
    <message><source>Input source</source>
        <translation>Eingangsquelle</translation></message>
    <message><source>edited</source>
        <translation>geändert</translation></message>
    <message><source>the calibration of {0}</source>
        <translation>Kalibrierung von {0}</translation></message>
    <message><source>Re&amp;versed</source>
        <translation>&amp;Umgekehrt</translation></message>
    <message><source>The output changes its sign: forward and reverse are swapped</source>
        <translation>Der Ausgang wechselt das Vorzeichen: vorwärts und rückwärts sind vertauscht</translation></message>
    <message><source>Parab&amp;olic</source>
        <translation>&amp;Parabolisch</translation></message>
    <message><source>Gentle near neutral, steep near the ends</source>
        <translation>Sanft nahe der Neutralstellung, steil nahe den Endlagen</translation></message>
    <message><source>I&amp;gnored</source>
        <translation>Igno&amp;riert</translation></message>
    <message><source>Holds the channel at neutral regardless of its input. For channels without a cable</source>
        <translation>Bei jedem Eingang in Neutralstellung gehalten; für Kanäle ohne Kabel</translation></message>
    <message><source>Re&amp;quired in RC mode</source>
        <translation>Im RC-Modus erforder&amp;lich</translation></message>
    <message><source>The motors stop when the pulses of this channel are missing for half a second</source>
        <translation>Die Motoren werden gestoppt, wenn die Impulse dieses Kanals eine halbe Sekunde fehlen</translation></message>
    <message><source>Read the other input source</source>
        <translation>Die andere Eingangsquelle lesen</translation></message>
    <message><source>Ma&amp;ke active…</source>
        <translation>Akti&amp;vieren…</translation></message>
    <message><source>The values of this input source have not been read yet.</source>
        <translation>Seine Werte wurden noch nicht gelesen.</translation></message>
    <message><source>Ne&amp;utral</source>
        <translation>&amp;Neutralstellung</translation></message>
    <message><source>Dead&amp;band ±</source>
        <translation>Totb&amp;ereich ±</translation></message>
    <message><source>Stored: the board reads {0} after the next power cycle.</source>
        <translation>Gespeichert: Nach dem nächsten Aus- und Einschalten liest das Board {0}.</translation></message>
    <message><source>The values below were {0}.</source>
        <translation>Stand der Werte unten: {0}.</translation></message>
    <message><source>Read {0} after the next power cycle</source>
        <translation>Nach dem nächsten Aus- und Einschalten {0} lesen</translation></message>
    <message><source>Edited: apply the change, then power-cycle the board to read {0}.</source>
        <translation>Geändert: Wenden Sie es an, dann schalten Sie das Board aus und ein, damit es {0} liest.</translation></message>
    <message><source>Neutral</source>
        <translation>Neutralstellung</translation></message>
    <message><source>Output</source>
        <translation>Ausgang</translation></message>
    <message><source>Its handles can be dragged; the fields below set the same values.</source>
        <translation>Ihre Griffe lassen sich ziehen; die Felder darunter setzen dieselben Werte.</translation></message>
    <message><source>Curve of the channel</source>
        <translation>Kurve des Kanals</translation></message>
    <message><source>flip on</source>
        <translation>Umdrehen ein</translation></message>
    <message><source>override on</source>
        <translation>Vorrang ein</translation></message>
    <message><source>Inputs are read as {0}. They control the motors.</source>
        <translation>Die Eingänge werden als {0} gelesen. Sie steuern die Motoren.</translation></message>
    <message><source>&amp;All other channels</source>
        <translation>&amp;Alle anderen Kanäle</translation></message>
    <message><source>&amp;Reset to factory defaults</source>
        <translation>Auf &amp;Werkseinstellungen zurücksetzen</translation></message>
    <message><source>&amp;Discard the edits of this channel</source>
        <translation>Die Änderungen &amp;dieses Kanals verwerfen</translation></message>
    <message><source>Learn a&amp;ll…</source>
        <translation>&amp;Alle einlernen…</translation></message>
    <message><source>Test stic&amp;ks…</source>
        <translation>Knüppel te&amp;sten…</translation></message>
    <message><source>Live value</source>
        <translation>Aktueller Wert</translation></message>
    <message><source>Learn &amp;this channel…</source>
        <translation>Diesen &amp;Kanal einlernen…</translation></message>
    <message><source>Cop&amp;y and reset</source>
        <translation>Kopieren, &amp;zurücksetzen</translation></message>
    <message><source>No board responds. Your edits are saved for the next board of the same model.</source>
        <translation>Kein Board antwortet. Änderungen bleiben erhalten, bis ein Board derselben Art verbunden ist.</translation></message>
    <message><source>Inputs are read as {0}. In serial mode they are only shown.</source>
        <translation>Die Eingänge werden als {0} gelesen. Im seriellen Modus werden sie nur angezeigt.</translation></message>
    <message><source>&amp;Copy to</source>
        <translation>&amp;Kopieren auf</translation></message>
    <message><source>Assumed values: Pololu publishes no factory defaults</source>
        <translation>Angenommene Werte: Pololu veröffentlicht keine Werkseinstellungen</translation></message>
    <message><source>Connect to a board to see and change its calibrations.</source>
        <translation>Verbinden Sie ein Board, um seine Kalibrierungen zu sehen und zu ändern.</translation></message>
    <message><source>Inputs are read as {0}. Serial commands override them now.</source>
        <translation>Die Eingänge werden als {0} gelesen. Jetzt haben serielle Befehle Vorrang.</translation></message>
    <message><source>Discard edits of channel {0}</source>
        <translation>Änderungen an Kanal {0} verwerfen</translation></message>
    <message><source>Copy calibration of channel {0}</source>
        <translation>Kopie der Kalibrierung von Kanal {0}</translation></message>
    <message><source>learned</source>
        <translation>eingelernt</translation></message>
    <message><source>factory calibration</source>
        <translation>Werkskalibrierung</translation></message>
    <message><source>problem</source>
        <translation>Problem</translation></message>
    <message><source>{0:.0f} to {1:.0f} counts</source>
        <translation>{0:.0f} bis {1:.0f} Counts</translation></message>
    <message><source>Connect to a board to see its motor currents.</source>
        <translation>Verbinden Sie ein Board, um seine Motorströme zu sehen.</translation></message>
    <message><source>Motor currents</source>
        <translation>Motorströme</translation></message>
    <message><source>No board is connected. Select a port at the top of the main window and press Connect. If you have no hardware, select the demo board.</source>
        <translation>Kein Board ist verbunden. Wählen Sie oben im Hauptfenster einen Port und klicken Sie auf „Verbinden“; ohne Hardware wählen Sie das Demo-Board.</translation></message>
    <message><source>Joint mode: the board does not sense currents.</source>
        <translation>Parallelbetrieb: Das Board misst keine Ströme.</translation></message>
    <message><source>C&amp;urrents</source>
        <translation>St&amp;röme</translation></message>
    <message><source>One count of this board is {0:.0f} mA.</source>
        <translation>Ein Count entspricht bei diesem Board {0:.0f} mA.</translation></message>
    <message><source>Reset all counts and error times</source>
        <translation>Alle Zähler auf null setzen und vergessen, wann Fehler auftraten</translation></message>
    <message><source>A restart is detected if the board comes back in another mode, because its power was off in the meantime. A restart in the same mode is not detected. Returns after silence: {0}.</source>
        <translation>Das Board meldete sich in einem anderen Modus zurück, war also zwischendurch ohne Strom; einen Neustart im selben Modus meldet es nicht. Nach Stille zurückgekehrt: {0}.</translation></message>
    <message><source>Reset all co&amp;unts</source>
        <translation>Alle &amp;Zähler zurücksetzen</translation></message>
    <message><source>Reads per second</source>
        <translation>Lesevorgänge pro Sekunde</translation></message>
    <message><source>Connected for</source>
        <translation>Verbunden seit</translation></message>
    <message><source>The line is noisy and has no CRC, so a corrupted reply can look like this error.</source>
        <translation>Die Leitung ist gestört und hat kein CRC: Eine verfälschte Antwort sieht genauso aus.</translation></message>
    <message><source>Latched before connecting, perhaps by a search for the board; not counted.</source>
        <translation>Schon vor dem Verbinden gesetzt, vielleicht durch die Suche nach dem Board; nicht gezählt.</translation></message>
    <message><source>{0}, active now, stops the motors</source>
        <translation>{0}, jetzt aktiv, stoppt die Motoren</translation></message>
    <message><source>Answered, last {0:.0f} s</source>
        <translation>Beantwortet, letzte {0:.0f} s</translation></message>
    <message><source>{0}, no longer active</source>
        <translation>{0}, vorbei</translation></message>
    <message><source>⚠ means 80 % of the limit or more.</source>
        <translation>⚠ bedeutet 80 % der Grenze oder mehr.</translation></message>
    <message><source>Speed 0: the motor is not driven and coasts</source>
        <translation>Geschwindigkeit 0: Der Motor wird nicht angetrieben und läuft aus</translation></message>
    <message><source>Brake</source>
        <translation>Bremsen</translation></message>
    <message><source>{0}, speed</source>
        <translation>{0}, Geschwindigkeit</translation></message>
    <message><source>{0}, speed as a number</source>
        <translation>{0}, Geschwindigkeit als Zahl</translation></message>
    <message><source>{0}, speed zero</source>
        <translation>{0}, Geschwindigkeit null</translation></message>
    <message><source>{0}, brake</source>
        <translation>{0}, bremsen</translation></message>
    <message><source>{0}, current</source>
        <translation>{0}, Strom</translation></message>
    <message><source>Up to {0}, the speed ceiling</source>
        <translation>Bis {0}, der Höchstgeschwindigkeit</translation></message>
    <message><source>Hold an arrow key to drive while the pad has the focus.</source>
        <translation>Halten Sie eine Pfeiltaste, um zu fahren, solange das Fahrfeld den Fokus hat.</translation></message>
    <message><source>Hold Up or Down to drive. The motors cannot be driven separately.</source>
        <translation>Halten Sie „Pfeil auf“ oder „Pfeil ab“, um zu fahren; die Motoren können nicht getrennt drehen.</translation></message>
    <message><source>At rest.</source>
        <translation>In Ruhe.</translation></message>
    <message><source>Drive pad</source>
        <translation>Fahrfeld</translation></message>
    <message><source>back</source>
        <translation>zurück</translation></message>
    <message><source>{0} {1:.0%}, {2} {3:.0%}.</source>
        <translation>{0} {1:.0%}, {2} {3:.0%}.</translation></message>
    <message><source>ceiling {0:.0f} %</source>
        <translation>höchstens {0:.0f} %</translation></message>
    <message><source>Full deflection is {0:.0f} % of full speed.</source>
        <translation>Voller Ausschlag entspricht {0:.0f} % der vollen Geschwindigkeit.</translation></message>
    <message><source>The gamepad cannot drive while this window is open, but its stop button works.</source>
        <translation>Mit dem Gamepad kann nicht gefahren werden, solange dieses Fenster offen ist, aber seine Stopptaste wirkt.</translation></message>
    <message><source>Invert</source>
        <translation>Umkehren</translation></message>
    <message><source>Set up the gamepad</source>
        <translation>Gamepad einrichten</translation></message>
    <message><source>Assignment</source>
        <translation>Zuordnung</translation></message>
    <message><source>One axis drives, the other turns</source>
        <translation>Eine Achse fährt, eine lenkt</translation></message>
    <message><source>One axis for each motor</source>
        <translation>Eine Achse für jeden Motor</translation></message>
    <message><source>&amp;Hold to drive</source>
        <translation>Zum &amp;Fahren halten</translation></message>
    <message><source>&amp;Stop everything</source>
        <translation>&amp;Alles stoppen</translation></message>
    <message><source>St&amp;icks:</source>
        <translation>&amp;Knüppel:</translation></message>
    <message><source>&amp;Dead zone:</source>
        <translation>&amp;Totzone:</translation></message>
    <message><source>&amp;Expo:</source>
        <translation>&amp;Expo:</translation></message>
    <message><source>Without a hold button, bumping a stick drives the motors. The gamepad cannot drive while this window is open.</source>
        <translation>Ohne eine Taste zum Halten treibt ein angestoßener Knüppel die Motoren an. Mit dem Gamepad kann nicht gefahren werden, solange dieses Fenster offen ist.</translation></message>
    <message><source>none: moving a stick drives</source>
        <translation>keine: Ein bewegter Knüppel fährt</translation></message>
    <message><source>Live state</source>
        <translation>Aktueller Zustand</translation></message>
    <message><source>Travel around the centre that has no effect</source>
        <translation>Weg um die Mitte, der nichts bewirkt</translation></message>
    <message><source>0 %: linear. 100 %: cubic, finest around the centre</source>
        <translation>0 %: linear. 100 %: kubisch, am feinsten um die Mitte</translation></message>
    <message><source>&amp;Left motor</source>
        <translation>&amp;Linker Motor</translation></message>
    <message><source>Right &amp;motor</source>
        <translation>&amp;Rechter Motor</translation></message>
    <message><source>pressed</source>
        <translation>gedrückt</translation></message>
    <message><source>{0}: inverted</source>
        <translation>{0}: umgekehrt</translation></message>
    <message><source>&amp;Gamepad</source>
        <translation>Gam&amp;epad</translation></message>
    <message><source>Drive with a gamepad</source>
        <translation>Mit Gamepad fahren</translation></message>
    <message><source>Set &amp;up…</source>
        <translation>Ei&amp;nrichten…</translation></message>
    <message><source>Stop when behi&amp;nd another window</source>
        <translation>Hinter anderen Fenstern stop&amp;pen</translation></message>
    <message><source>The gamepad is being set up and cannot drive.</source>
        <translation>Das Gamepad wird eingerichtet; mit ihm kann nicht gefahren werden.</translation></message>
    <message><source>The gamepad drives only while the Motors page is open.</source>
        <translation>Mit dem Gamepad kann nur gefahren werden, solange die Seite „Motoren“ offen ist.</translation></message>
    <message><source>Another window is in front, so the gamepad cannot drive.</source>
        <translation>Ein anderes Fenster ist im Vordergrund, daher kann mit dem Gamepad nicht gefahren werden.</translation></message>
    <message><source>Stop the motors that the gamepad drives when the window loses the focus</source>
        <translation>Stoppen, was das Gamepad fährt, wenn das Fenster den Fokus verliert</translation></message>
    <message><source>Maximum speed that this program sends to this board. Full deflection of the pad, the keys or the gamepad gives this speed. Raising the ceiling does not speed up a running motor.</source>
        <translation>Höchste Geschwindigkeit, die dieses Programm an dieses Board sendet; voller Ausschlag von Fahrfeld, Tasten und Gamepad ergibt diese Geschwindigkeit. Höher setzen macht einen laufenden Motor nicht schneller.</translation></message>
    <message><source>&amp;Speed ceiling</source>
        <translation>Höchstgeschwi&amp;ndigkeit</translation></message>
    <message><source>Raise the ceiling once the motors turn the right way.</source>
        <translation>Erst erhöhen, wenn die Drehrichtung stimmt.</translation></message>
    <message><source>Held keys drive wherever the focus is on this page, except in number fields, tables and lists. Arrow keys then no longer move the sliders. While the pad has the focus, keys always drive.</source>
        <translation>Gehaltene Tasten fahren überall auf dieser Seite, wo auch der Fokus ist, außer in Zahlenfeldern, Tabellen und Listen; Schieberegler erhalten dann keine Pfeiltasten. Im Fahrfeld fahren sie immer.</translation></message>
    <message><source>Both motors &amp;linked</source>
        <translation>Beide Motoren ge&amp;koppelt</translation></message>
    <message><source>Either slider sets both motors, so the robot does not turn</source>
        <translation>Jeder Schieberegler setzt beide Motoren; der Roboter lenkt nicht</translation></message>
    <message><source>The motors run at different speeds: stop both, or set both to the same speed</source>
        <translation>Die Motoren laufen verschieden: Stoppen Sie beide, oder geben Sie beiden dieselbe Geschwindigkeit</translation></message>
    <message><source>Accelerate along the board's ra&amp;mp</source>
        <translation>Mit der &amp;Rampe des Boards beschleunigen</translation></message>
    <message><source>The board ramps speeds at the Acceleration setting and pauses for the brake duration before reversing</source>
        <translation>Das Board ändert Geschwindigkeiten mit einer Rampe nach der Einstellung „Beschleunigung“ und wartet vor dem Umkehren die Bremsdauer ab</translation></message>
    <message><source>Bypasses the ramp and the brake duration, and briefly the current limit</source>
        <translation>Umgeht Rampe und Bremsdauer, kurzzeitig auch die Strombegrenzung</translation></message>
    <message><source>Strength of braking with the Brake button, and after you release the pad, a key or a held slider. Stop always brakes fully</source>
        <translation>Wie stark „Bremsen“ und das Loslassen von Fahrfeld, Tasten und gehaltenen Schiebereglern bremsen; ein Stopp bremst immer voll</translation></message>
    <message><source>&amp;Brake strength</source>
        <translation>Bre&amp;msstärke</translation></message>
    <message><source>Loc&amp;k after Stop</source>
        <translation>&amp;Sperre nach Stopp</translation></message>
    <message><source>Stop when you lea&amp;ve this page</source>
        <translation>Beim Verl&amp;assen dieser Seite stoppen</translation></message>
    <message><source>Stop both motors and the auxiliary when another page is shown or the window is minimized</source>
        <translation>Beide Motoren und den Hilfsmotor stoppen, wenn eine andere Seite gezeigt oder das Fenster minimiert wird</translation></message>
    <message><source>Sliders return to &amp;zero</source>
        <translation>Regler gehen &amp;von selbst auf null</translation></message>
    <message><source>A slider drives its motor only while you hold the slider. Releasing the slider brakes the motor</source>
        <translation>Ein Schieberegler fährt nur, solange Sie ihn halten; Loslassen bremst seinen Motor</translation></message>
    <message><source>Drive with</source>
        <translation>Fahren mit</translation></message>
    <message><source>Arrow ke&amp;ys or WASD</source>
        <translation>Pfei&amp;ltasten oder WASD</translation></message>
    <message><source>E&amp;xtra options</source>
        <translation>E&amp;xtras</translation></message>
    <message><source>coast (0 %)</source>
        <translation>auslaufen (0 %)</translation></message>
    <message><source>none (0 s)</source>
        <translation>keine (0 s)</translation></message>
    <message><source>How long arming stays locked after Stop or Esc, so that a slider or key that is still held cannot restart a motor (0 to {0:g} s)</source>
        <translation>Wie lange die Freigabe nach einem Stopp oder Esc gesperrt bleibt, damit ein noch gehaltener Schieberegler oder eine gehaltene Taste keinen Motor wieder startet (0 bis {0:g} s)</translation></message>
    <message><source>stop after {0}</source>
        <translation>stoppen nach {0}</translation></message>
    <message><source>may keep turning</source>
        <translation>drehen vielleicht weiter</translation></message>
    <message><source>Ramp</source>
        <translation>Rampe</translation></message>
    <message><source>Brake before reversal</source>
        <translation>Bremsen vor Umkehr</translation></message>
    <message><source>Current limit</source>
        <translation>Stromgrenze</translation></message>
    <message><source>&amp;Open plot</source>
        <translation>Verla&amp;uf öffnen</translation></message>
    <message><source>How the board applies commands</source>
        <translation>So führt das Board Befehle aus</translation></message>
    <message><source>Armed: these controls move the motors.</source>
        <translation>Freigegeben: Diese Bedienelemente bewegen die Motoren.</translation></message>
    <message><source>Left</source>
        <translation>Links</translation></message>
    <message><source>Right</source>
        <translation>Rechts</translation></message>
    <message><source>Motor (joint)</source>
        <translation>Motor (Parallelbetrieb)</translation></message>
    <message><source>Brake with {0}</source>
        <translation>Mit {0} bremsen</translation></message>
    <message><source>one way</source>
        <translation>eine Richtung</translation></message>
    <message><source>The Motors page was left while a control was held.</source>
        <translation>Die Seite „Motoren“ wurde verlassen, während ein Bedienelement gehalten wurde.</translation></message>
    <message><source>The Motors page was left.</source>
        <translation>Die Seite „Motoren“ wurde verlassen.</translation></message>
    <message><source>keep turning</source>
        <translation>drehen weiter</translation></message>
    <message><source>Apply each change of one motor to both motors, in one step</source>
        <translation>Jede Änderung an einem Motor im selben Schritt auch am anderen vornehmen</translation></message>
    <message><source>No document confirms this limit. The board may accept other values.</source>
        <translation>Kein Dokument bestätigt diese Grenze. Über andere Werte entscheidet das Board.</translation></message>
    <message><source>Show the steps for switching the board off and on</source>
        <translation>Die Schritte zum Aus- und Einschalten des Boards zeigen</translation></message>
    <message><source>Detail&amp;s</source>
        <translation>Det&amp;ails</translation></message>
    <message><source>&amp;Both motors as one</source>
        <translation>Beide &amp;Motoren gemeinsam</translation></message>
    <message><source>Wire value</source>
        <translation>Bytewert</translation></message>
    <message><source>&amp;Try this value</source>
        <translation>Diesen Wert &amp;versuchen</translation></message>
    <message><source>Selected parameter</source>
        <translation>Ausgewählter Parameter</translation></message>
    <message><source>{0}, or speed steps such as {1}. The board stores the nearest time.</source>
        <translation>{0}. Das Board speichert die nächstliegende Zeit. Oder Geschwindigkeitsstufen, etwa {1}.</translation></message>
    <message><source>The PWM frequency must be {0}, not {1}.</source>
        <translation>Die PWM-Frequenz ist {0}, nicht {1}.</translation></message>
    <message><source>Baud rate</source>
        <translation>Baudrate</translation></message>
    <message><source>Error detection</source>
        <translation>Fehlererkennung</translation></message>
    <message><source>Stop bits</source>
        <translation>Stoppbits</translation></message>
    <message><source>CRC-7</source>
        <translation>CRC-7</translation></message>
    <message><source>unknown ({0})</source>
        <translation>unbekannt ({0})</translation></message>
    <message><source>{0}: channel {1}</source>
        <translation>{0}: Kanal {1}</translation></message>
    <message><source>Search parameters</source>
        <translation>Parameter suchen</translation></message>
    <message><source>Edit, then review. Nothing is written before the review.</source>
        <translation>Ändern, dann prüfen. Vorher wird nichts geschrieben.</translation></message>
    <message><source>&amp;Show all parameters</source>
        <translation>&amp;Alle Parameter anzeigen</translation></message>
    <message><source>All</source>
        <translation>Alle</translation></message>
    <message><source>Changed {0}</source>
        <translation>Geändert {0}</translation></message>
    <message><source>Not default {0}</source>
        <translation>Abweichend {0}</translation></message>
    <message><source>Findings {0}</source>
        <translation>Befunde {0}</translation></message>
    <message><source>Parameters</source>
        <translation>Parameter</translation></message>
    <message><source>Connect to a board to see its parameters.</source>
        <translation>Verbinden Sie ein Board, um seine Parameter zu sehen.</translation></message>
    <message><source>Factory defaults take effect after the next power cycle.</source>
        <translation>Die Werkseinstellungen gelten nach dem nächsten Aus- und Einschalten.</translation></message>
    <message><source>Stored, but not active until the board is switched off and on: {0}.</source>
        <translation>Gespeichert, aber erst nach dem Aus- und Einschalten des Boards aktiv: {0}.</translation></message>
    <message><source>No parameter matches.</source>
        <translation>Kein Parameter passt.</translation></message>
    <message><source>{0}: the motors stop.</source>
        <translation>{0}: Die Motoren halten an.</translation></message>
    <message><source>{0}: the motors may not stop.</source>
        <translation>{0}: Die Motoren halten vielleicht nicht an.</translation></message>
    <message><source>Speed after an accelerate command: {0}. The motor slows down at once.</source>
        <translation>Geschwindigkeit nach einem Beschleunigungsbefehl: {0}. Langsamer wird der Motor sofort.</translation></message>
    <message><source>Reversal by an accelerate command: {0}, then the ramp.</source>
        <translation>Umkehr durch einen Beschleunigungsbefehl: {0}, dann die Rampe.</translation></message>
    <message><source>Current of a starting motor, limit: {0}</source>
        <translation>Strom eines anlaufenden Motors, Grenze: {0}</translation></message>
    <message><source>{0}: the motors keep running.</source>
        <translation>{0}: Die Motoren laufen weiter.</translation></message>
    <message><source>Speed against the stick position, brake in the deadband: {0}</source>
        <translation>Geschwindigkeit über dem Knüppelweg, Bremse im Totbereich: {0}</translation></message>
    <message><source>Und&amp;o edit</source>
        <translation>Ve&amp;rwerfen</translation></message>
    <message><source>Edit</source>
        <translation>Bearbeiten</translation></message>
    <message><source>Try another &amp;wire value…</source>
        <translation>Anderen Byte&amp;wert versuchen…</translation></message>
    <message><source>Defa&amp;ult</source>
        <translation>&amp;Standardwert</translation></message>
    <message><source>Leave out of the fi&amp;le</source>
        <translation>In der Datei &amp;weglassen</translation></message>
    <message><source>Copy as “{0}”</source>
        <translation>Kopieren als „{0}“</translation></message>
    <message><source>{0}; the channels control the motors.</source>
        <translation>{0}; die Kanäle steuern die Motoren.</translation></message>
    <message><source>Serial mode with {0} inputs</source>
        <translation>Serieller Modus, Eingänge: {0}</translation></message>
    <message><source>{0} mode</source>
        <translation>Modus {0}</translation></message>
    <message><source>{0}.</source>
        <translation>{0}.</translation></message>
    <message><source>{0}; serial commands reach the motors.</source>
        <translation>{0}; serielle Befehle erreichen die Motoren.</translation></message>
    <message><source>{0}, setpoint {1}</source>
        <translation>{0}, Sollwert {1}</translation></message>
    <message><source>{0}, remapped {1}</source>
        <translation>{0}, umgerechnet {1}</translation></message>
    <message><source>brake {0}</source>
        <translation>Bremse {0}</translation></message>
    <message><source>Switch the board off for at least one second. Waiting for the board to stop responding …</source>
        <translation>Schalten Sie das Board für mindestens eine Sekunde aus. Warten, bis das Board nicht mehr antwortet …</translation></message>
    <message><source>The board still responds. A short interruption is not detected: leave the power off for a full second.</source>
        <translation>Das Board antwortet noch. Eine kurze Unterbrechung wird nicht erkannt: Lassen Sie es eine volle Sekunde ausgeschaltet.</translation></message>
    <message><source>Switch the board on again. Waiting for the board to respond …</source>
        <translation>Schalten Sie es wieder ein. Warten, bis es wieder antwortet …</translation></message>
    <message><source>The board is still not responding. Check its power and the cable. If both are fine, disconnect and press “Find…”, which tries every setting.</source>
        <translation>Das Board antwortet noch immer nicht. Prüfen Sie seine Stromversorgung und das Kabel. Wenn beides in Ordnung ist, trennen Sie die Verbindung und klicken Sie auf „Suchen…“; damit wird jede Einstellung versucht.</translation></message>
    <message><source>The connection was closed. Switch the board off and on, then connect again. If that fails, press “Find…”, which tries every setting.</source>
        <translation>Die Leitung wurde geschlossen. Schalten Sie das Board aus und ein und verbinden Sie es dann wieder; „Suchen…“ versucht jede Einstellung.</translation></message>
    <message><source>Connected again. The program cannot detect whether the board was switched off in the meantime. Confirm that it was, or switch the board off and on now.</source>
        <translation>Wieder verbunden. Das Programm kann nicht erkennen, ob das Board inzwischen ausgeschaltet war: Bestätigen Sie es, oder schalten Sie das Board jetzt aus und ein.</translation></message>
    <message><source>The board is back, and all stored settings are active.</source>
        <translation>Das Board ist wieder da, und alle gespeicherten Einstellungen sind aktiv.</translation></message>
    <message><source>I have &amp;switched the board off and on</source>
        <translation>Ich habe es aus- und &amp;eingeschaltet</translation></message>
    <message><source>Switch off</source>
        <translation>Ausschalten</translation></message>
    <message><source>Read again</source>
        <translation>Neu lesen</translation></message>
    <message><source>Switch the board off and on</source>
        <translation>Board aus- und einschalten</translation></message>
    <message><source>Power cycle completed.</source>
        <translation>Aus- und Einschalten abgeschlossen.</translation></message>
    <message><source>The board is back, but these settings are still not active: {0}.</source>
        <translation>Das Board ist wieder da, aber diese Einstellungen sind noch nicht aktiv: {0}.</translation></message>
    <message><source>The program then reconnects at {0}.</source>
        <translation>Das Programm verbindet sich dann neu mit {0}.</translation></message>
    <message numerus="yes"><source>Edited earlier but not applied: %n setting(s) of this {0} ({1}). Restore them as pending edits?</source>
        <translation><numerusform>Zuvor geändert, aber nicht angewendet: %n Einstellung dieses {0} ({1}). Als ausstehende Änderung wiederherstellen?</numerusform><numerusform>Zuvor geändert, aber nicht angewendet: %n Einstellungen dieses {0} ({1}). Als ausstehende Änderungen wiederherstellen?</numerusform></translation></message>
    <message><source>Settings are still being written. Close anyway? Unwritten settings are offered when the board is connected again.</source>
        <translation>Es werden noch Einstellungen geschrieben. Trotzdem schließen? Nicht geschriebene Einstellungen werden beim nächsten Verbinden des Boards angeboten.</translation></message>
    <message><source>Close anyway</source>
        <translation>Trotzdem schließen</translation></message>
    <message><source>Review and apply…</source>
        <translation>Prüfen und anwenden…</translation></message>
    <message><source>There are unapplied changes.</source>
        <translation>Es gibt nicht angewendete Änderungen.</translation></message>
    <message numerus="yes"><source>%n setting(s) of this {0} differ from the last applied values ({1}). They were lost or changed by another program, or this is another board.</source>
        <translation><numerusform>%n Einstellung dieses {0} weicht von der zuletzt angewendeten ab ({1}): verloren, von etwas anderem geändert, oder dies ist ein anderes Board.</numerusform><numerusform>%n Einstellungen dieses {0} weichen von den zuletzt angewendeten ab ({1}): verloren, von etwas anderem geändert, oder dies ist ein anderes Board.</numerusform></translation></message>
    <message><source>Keep the values of the board</source>
        <translation>Werte des Boards behalten</translation></message>
    <message><source>You may drive now: arm the motors.</source>
        <translation>Sie dürfen jetzt fahren: Geben Sie die Motoren frei.</translation></message>
    <message><source>{0} wants to drive. Handing over stops the motors.</source>
        <translation>{0} möchte fahren. Die Übergabe stoppt die Motoren.</translation></message>
    <message><source>Hand over</source>
        <translation>Übergeben</translation></message>
    <message><source>{0} is driving. Taking over stops the motors.</source>
        <translation>{0} fährt. Die Übernahme stoppt die Motoren.</translation></message>
    <message><source>Take over</source>
        <translation>Übernehmen</translation></message>
    <message><source>Save as a settings file…</source>
        <translation>Als Einstellungsdatei speichern…</translation></message>
    <message><source>Keep and close</source>
        <translation>Behalten und schließen</translation></message>
    <message><source>Discard and close</source>
        <translation>Verwerfen und schließen</translation></message>
    <message><source>Show…</source>
        <translation>Anzeigen…</translation></message>
    <message><source>A new board: its device number is not in the record.</source>
        <translation>Ein neues Board: Seine Gerätenummer steht in keiner Zeile des Protokolls.</translation></message>
    <message><source>Known: its device number and its calibrations are in the record.</source>
        <translation>Bekannt: Seine Gerätenummer und seine Kalibrierungen stehen im Protokoll.</translation></message>
    <message><source>Probably known: its device number is in the record, but with other calibrations.</source>
        <translation>Vermutlich bekannt: Seine Gerätenummer steht im Protokoll, mit anderen Kalibrierungen.</translation></message>
    <message><source>skipped</source>
        <translation>übersprungen</translation></message>
    <message><source>First device number</source>
        <translation>Erste Gerätenummer</translation></message>
    <message><source>The profile is a settings file. Each board gets the settings of the profile, a device number that no other board has, and a line in the record. The record is a CSV file. An existing file is extended.</source>
        <translation>Das Profil ist eine Einstellungsdatei. Jedes Board erhält ihre Einstellungen, eine Gerätenummer, die kein anderes hat, und eine Zeile im Protokoll: einer CSV-Datei, die fortgesetzt wird, wenn es sie schon gibt.</translation></message>
    <message><source>Boards have no serial number. A board whose device number is in the record keeps this number.</source>
        <translation>Boards haben keine Seriennummer. Eines, dessen Gerätenummer im Protokoll steht, behält sie.</translation></message>
    <message><source>Select…</source>
        <translation>Auswählen…</translation></message>
    <message><source>CSV files (*.csv);;All files (*)</source>
        <translation>CSV-Dateien (*.csv);;Alle Dateien (*)</translation></message>
    <message><source>Record of the boards</source>
        <translation>Protokoll der Boards</translation></message>
    <message><source>Finished boards</source>
        <translation>Fertige Boards</translation></message>
    <message><source>{0}, device number {1}: {2}</source>
        <translation>{0}, Gerätenummer {1}: {2}</translation></message>
    <message><source>What every board gets</source>
        <translation>Was jedes Board erhält</translation></message>
    <message><source>&amp;Profile:</source>
        <translation>Pro&amp;fil:</translation></message>
    <message><source>&amp;Record:</source>
        <translation>P&amp;rotokoll:</translation></message>
    <message><source>Then turn each &amp;motor while a button is held</source>
        <translation>Dann jeden &amp;Motor drehen, solange eine Taste gehalten wird</translation></message>
    <message><source>Plug in a board, and switch it on.</source>
        <translation>Stecken Sie ein Board an und schalten Sie es ein.</translation></message>
    <message><source>{0}: {1}. Unplug this board, and plug in the next board.</source>
        <translation>{0}: {1}. Ziehen Sie es ab und stecken Sie das nächste Board an.</translation></message>
    <message><source>Hold each button: does its motor turn?</source>
        <translation>Halten Sie jede Taste: Dreht ihr Motor?</translation></message>
    <message><source>Profile</source>
        <translation>Profil</translation></message>
    <message><source>Plug in</source>
        <translation>Anstecken</translation></message>
    <message><source>Write</source>
        <translation>Schreiben</translation></message>
    <message><source>Unplug</source>
        <translation>Abziehen</translation></message>
    <message><source>Set up boards in turn</source>
        <translation>Boards nacheinander einrichten</translation></message>
    <message><source>&amp;Names:</source>
        <translation>&amp;Namen:</translation></message>
    <message><source>&amp;First number:</source>
        <translation>Erste N&amp;ummer:</translation></message>
    <message><source>Profile for every board</source>
        <translation>Profil für jedes Board</translation></message>
    <message><source>This board cannot be set up. Unplug it.</source>
        <translation>Dieses Board kann nicht eingerichtet werden. Ziehen Sie es ab.</translation></message>
    <message><source>Connect to a board: use Connect or Find in the main window.</source>
        <translation>Verbinden Sie ein Board: mit „Verbinden“ oder „Suchen“ im Hauptfenster.</translation></message>
    <message><source>&amp;Write and check</source>
        <translation>Sch&amp;reiben und prüfen</translation></message>
    <message><source>M&amp;otors</source>
        <translation>M&amp;otoren</translation></message>
    <message><source>&amp;Start</source>
        <translation>&amp;Starten</translation></message>
    <message><source>Both &amp;turned</source>
        <translation>Beide dre&amp;hten</translation></message>
    <message><source>&amp;Try again</source>
        <translation>&amp;Erneut versuchen</translation></message>
    <message><source>The wheels are &amp;off the ground</source>
        <translation>Die Räder sind vom &amp;Boden abgehoben</translation></message>
    <message><source>Short, weak pulses while you hold the button with the mouse or the space bar</source>
        <translation>Kurze, schwache Impulse, solange Sie die Schaltfläche mit der Maus oder der Leertaste gedrückt halten</translation></message>
    <message><source>Armed. The motor turns in short, weak pulses while you hold the button.</source>
        <translation>Freigegeben. Der Motor dreht in kurzen, schwachen Impulsen, solange Sie gedrückt halten.</translation></message>
    <message><source>Motor {0} is driven in pulses. Release the button to stop the motor.</source>
        <translation>Motor {0} läuft in Impulsen. Lassen Sie die Schaltfläche los, um ihn zu stoppen.</translation></message>
    <message><source>Hold to turn motor {0}</source>
        <translation>Gedrückt halten: Motor {0} dreht</translation></message>
    <message><source>&amp;Keep 30 s around each fault and stop</source>
        <translation>30 s um &amp;jede Störung und jeden Stopp behalten</translation></message>
    <message><source>The seconds around “{0}” were saved as {1} (File, Open fault or stop).</source>
        <translation>Die Sekunden um „{0}“ wurden behalten. Datei, Störung oder Stopp öffnen: {1}</translation></message>
    <message><source>The seconds around “{0}” could not be saved. {1}</source>
        <translation>Die Sekunden um „{0}“ konnten nicht behalten werden. {1}</translation></message>
    <message><source>Start recording &amp;when the motors are armed</source>
        <translation>Aufzeichnung &amp;mit der Freigabe der Motoren starten</translation></message>
    <message><source>Nothing can be recorded: no board is connected.</source>
        <translation>Es kann nichts aufgezeichnet werden: Kein Board ist verbunden.</translation></message>
    <message><source>File, Open recording</source>
        <translation>Datei, Aufzeichnung öffnen</translation></message>
    <message><source>Open recor&amp;ding…</source>
        <translation>Auf&amp;zeichnung öffnen…</translation></message>
    <message><source>Open fa&amp;ult or stop…</source>
        <translation>Störung oder Sto&amp;pp öffnen…</translation></message>
    <message><source>Left wheel, forward</source>
        <translation>Linkes Rad, vorwärts</translation></message>
    <message><source>Right wheel, forward</source>
        <translation>Rechtes Rad, vorwärts</translation></message>
    <message><source>Left wheel, backward</source>
        <translation>Linkes Rad, rückwärts</translation></message>
    <message><source>Right wheel, backward</source>
        <translation>Rechtes Rad, rückwärts</translation></message>
    <message><source>Nothing</source>
        <translation>Nichts</translation></message>
    <message><source>Robots that “trexcmd serve” offers on this computer and on the local network.</source>
        <translation>Mit trexcmd serve bereitgestellt: von diesem Rechner und von anderen im lokalen Netz.</translation></message>
    <message numerus="yes"><source>%n robot(s) stopped.</source>
        <translation><numerusform>%n Roboter gestoppt.</numerusform><numerusform>%n Roboter gestoppt.</numerusform></translation></message>
    <message><source>Robot</source>
        <translation>Roboter</translation></message>
    <message><source>Driver</source>
        <translation>Steuerung</translation></message>
    <message><source>Problems</source>
        <translation>Probleme</translation></message>
    <message><source>Robots</source>
        <translation>Roboter</translation></message>
    <message><source>Stop &amp;all robots</source>
        <translation>&amp;Alle Roboter stoppen</translation></message>
    <message><source>&amp;Search again</source>
        <translation>Erneut s&amp;uchen</translation></message>
    <message><source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation></message>
    <message><source>Searching …</source>
        <translation>Suche läuft …</translation></message>
    <message><source>Stopping …</source>
        <translation>Wird gestoppt …</translation></message>
    <message><source>Robots on the net&amp;work…</source>
        <translation>Roboter im Net&amp;z…</translation></message>
    <message><source>No robots found.</source>
        <translation>Keine Roboter gefunden.</translation></message>
    <message><source>no board</source>
        <translation>kein Board</translation></message>
    <message><source>Stop not confirmed: {0}</source>
        <translation>Nicht bestätigt: {0}</translation></message>
    <message><source>{0}, not responding</source>
        <translation>{0}, antwortet nicht</translation></message>
    <message><source>Read the settings from the board and discard the edits made here?</source>
        <translation>Die Einstellungen vom Board lesen und die hier gemachten Änderungen verwerfen?</translation></message>
    <message><source>{0} is now one of the pending changes and takes effect after the board is switched off and on. This window then uses the new setting. Other programs on this line must also use the new setting.</source>
        <translation>{0} gehört jetzt zu den ausstehenden Änderungen. Die Einstellung gilt, nachdem das Board aus- und eingeschaltet wurde; dieses Fenster folgt dann. Andere Programme an dieser Leitung müssen sie auch verwenden.</translation></message>
    <message><source>Discard and reload</source>
        <translation>Verwerfen und neu laden</translation></message>
    <message><source>&amp;Add to the file</source>
        <translation>In die Datei &amp;aufnehmen</translation></message>
    <message><source>Not in the file: the board keeps its own calibration.</source>
        <translation>Nicht in der Datei: Das Board behält seine.</translation></message>
    <message><source>Bold: differs from the factory default.</source>
        <translation>Fett: weicht von der Werkseinstellung ab.</translation></message>
    <message><source>Key</source>
        <translation>Schlüssel</translation></message>
    <message><source>Value</source>
        <translation>Wert</translation></message>
    <message><source>Channel</source>
        <translation>Kanal</translation></message>
    <message><source>Printed {0} by TReX Studio.</source>
        <translation>Gedruckt {0} von TReX Studio.</translation></message>
    <message><source>Findings</source>
        <translation>Befunde</translation></message>
    <message><source>Calibrations</source>
        <translation>Kalibrierungen</translation></message>
    <message><source>None set.</source>
        <translation>Keine angegeben.</translation></message>
    <message><source>Convert values with units to wire values, and replace numbers that are out of range with the nearest valid number. The file changes only when you save it</source>
        <translation>Werte mit Einheiten als Bytewerte schreiben, und Zahlen außerhalb ihres Bereichs als die nächstliegende darin; die Datei ändert sich, wenn Sie speichern</translation></message>
    <message><source>&amp;Repair values</source>
        <translation>Werte &amp;reparieren</translation></message>
    <message><source>Text of the settings file</source>
        <translation>Text der Einstellungsdatei</translation></message>
    <message><source>“Save” writes this text. Comments and the order of the lines do not change. To change values, use the other pages.</source>
        <translation>„Speichern“ schreibt diesen Text. Kommentare und die Reihenfolge der Zeilen bleiben; ändern Sie Werte auf den anderen Seiten.</translation></message>
    <message><source>Chec&amp;k again</source>
        <translation>&amp;Erneut prüfen</translation></message>
    <message><source>Read the text again and list its errors</source>
        <translation>Den Text erneut lesen und seine Fehler auflisten</translation></message>
    <message><source>This file cannot be used. Correct the text here, then check it again. The other pages become available once the text has no errors.</source>
        <translation>Diese Datei kann nicht verwendet werden. Berichtigen Sie den Text hier und prüfen Sie ihn erneut; die anderen Seiten öffnen sich, sobald er keine Fehler mehr hat.</translation></message>
    <message><source>Line numbers</source>
        <translation>Zeilennummern</translation></message>
    <message><source>This is the text as it was opened, without your changes: {0}. Save offers to rewrite the file from the settings.</source>
        <translation>Dies ist der Text, wie er geöffnet wurde, ohne Ihre Änderungen: {0}. „Speichern“ bietet an, die Datei aus den Einstellungen neu zu schreiben.</translation></message>
    <message><source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation></message>
    <message><source>Text</source>
        <translation>Text</translation></message>
    <message><source>&amp;File</source>
        <translation>&amp;Datei</translation></message>
    <message><source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation></message>
    <message><source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation></message>
    <message><source>&amp;Device</source>
        <translation>&amp;Gerät</translation></message>
    <message><source>&amp;Save settings file…</source>
        <translation>Einstellungsdatei &amp;speichern…</translation></message>
    <message><source>Save as P&amp;DF…</source>
        <translation>&amp;Als PDF speichern…</translation></message>
    <message><source>Compare &amp;with:</source>
        <translation>&amp;Vergleichen mit:</translation></message>
    <message><source>Nothing could be repaired: correct the text in the lines named below.</source>
        <translation>Nichts konnte repariert werden: Berichtigen Sie den Text in den unten genannten Zeilen.</translation></message>
    <message><source>Tool bar</source>
        <translation>Werkzeugleiste</translation></message>
    <message><source>The file still has errors.</source>
        <translation>Sie hat noch Fehler.</translation></message>
    <message><source>Factory defaults</source>
        <translation>Werkseinstellungen</translation></message>
    <message><source>The text no longer has errors; all pages are available.</source>
        <translation>Der Text hat keine Fehler mehr; alle Seiten sind verfügbar.</translation></message>
    <message><source>Correct the rest in the text.</source>
        <translation>Berichtigen Sie den Rest im Text.</translation></message>
    <message><source>&amp;New…</source>
        <translation>&amp;Neu…</translation></message>
    <message><source>&amp;Save</source>
        <translation>&amp;Speichern</translation></message>
    <message><source>&amp;Convert for another board…</source>
        <translation>Für ein anderes Board &amp;konvertieren…</translation></message>
    <message><source>With another &amp;file…</source>
        <translation>Mit einer anderen &amp;Datei…</translation></message>
    <message><source>With the &amp;board</source>
        <translation>Mit dem &amp;Board</translation></message>
    <message><source>With factory &amp;defaults</source>
        <translation>Mit den &amp;Werkseinstellungen</translation></message>
    <message><source>&amp;Send to the board…</source>
        <translation>An das Board &amp;senden…</translation></message>
    <message><source>Not saved. {0}</source>
        <translation>Nicht gespeichert. {0}</translation></message>
    <message><source>{0}[*] – TReX settings file</source>
        <translation>{0}[*] – TReX-Einstellungsdatei</translation></message>
    <message><source>Repaired: {0}.</source>
        <translation>Repariert: {0}.</translation></message>
    <message><source>Not compared. {0}</source>
        <translation>Nicht verglichen. {0}</translation></message>
    <message><source>An autonomous robot: an on-board computer drives it, and no one is near enough to catch it</source>
        <translation>Ein Roboter ohne Fahrer: Ein Computer an Bord fährt ihn, und niemand kann ihn aufhalten</translation></message>
    <message><source>A rover driven by radio; a switch hands control to a computer</source>
        <translation>Ein ferngesteuerter Rover; ein Schalter übergibt ihn an einen Computer</translation></message>
    <message><source>A tank: two tracks, driven by radio with one stick</source>
        <translation>Ein Kettenfahrzeug: zwei Ketten, ferngesteuert mit einem Knüppel</translation></message>
    <message><source>Factory defaults of a {0}, firmware {1}</source>
        <translation>Werkseinstellungen eines {0}, Firmware {1}</translation></message>
    <message><source>&amp;Open settings file…</source>
        <translation>Einstellungsdatei ö&amp;ffnen…</translation></message>
    <message><source>&amp;Start the new file with:</source>
        <translation>Neue Datei &amp;beginnen mit:</translation></message>
    <message><source>The board as shown: {0}, firmware {1}</source>
        <translation>Das Board, wie angezeigt: {0}, Firmware {1}</translation></message>
    <message><source>Applied</source>
        <translation>Angewendet</translation></message>
    <message><source>&amp;New settings file…</source>
        <translation>&amp;Neue Einstellungsdatei…</translation></message>
    <message><source>Initial contents</source>
        <translation>Vorlagen</translation></message>
    <message><source>Settings applied {0}</source>
        <translation>Angewendete Einstellungen, {0}</translation></message>
    <message><source>Sample: {0}</source>
        <translation>Beispiel: {0}</translation></message>
    <message><source>is not a readable settings file.</source>
        <translation>ist keine lesbare Einstellungsdatei.</translation></message>
    <message><source>Calibrations that the board does not currently report remain in the file: {0}.</source>
        <translation>Kalibrierungen, die das Board jetzt nicht zeigt, wurden beibehalten: {0}.</translation></message>
    <message><source>The program {0} applies and verifies the displayed settings. Its first lines explain how to use the program.</source>
        <translation>{0} wendet die angezeigten Einstellungen an und prüft sie; lesen Sie die ersten Zeilen der Datei.</translation></message>
    <message><source>{0} was not saved again: it is still being saved.</source>
        <translation>{0} wurde nicht erneut gespeichert: Die Datei wird noch gespeichert.</translation></message>
    <message><source>&amp;Export as code…</source>
        <translation>Als &amp;Code exportieren…</translation></message>
    <message><source>The settings shown were saved in {0}.</source>
        <translation>Die angezeigten Einstellungen wurden in {0} gespeichert.</translation></message>
    <message><source>{0} was not saved: {1}</source>
        <translation>{0} wurde nicht gespeichert: {1}</translation></message>
    <message><source>{0} was not written: {1}</source>
        <translation>{0} wurde nicht geschrieben: {1}</translation></message>
    <message><source>holds settings of a {0}.</source>
        <translation>enthält Einstellungen eines {0}.</translation></message>
    <message><source>Swap the wire pairs of motors 1 and 2. Keep the order within each pair.</source>
        <translation>Vertauschen Sie das Drahtpaar von Motor 1 mit dem von Motor 2 (Reihenfolge beibehalten).</translation></message>
    <message><source>Swap the two wires of the left motor.</source>
        <translation>Vertauschen Sie die beiden Drähte des linken Motors.</translation></message>
    <message><source>Swap the two wires of the right motor.</source>
        <translation>Vertauschen Sie die beiden Drähte des rechten Motors.</translation></message>
    <message><source>No setting can make this change for serial commands, but your own program can.</source>
        <translation>Keine Einstellung bewirkt das für serielle Befehle; Ihr eigenes Programm kann es stattdessen tun.</translation></message>
    <message><source>No setting of the board can make this change.</source>
        <translation>Keine Einstellung des Boards bewirkt das.</translation></message>
    <message><source>Learning takes about two minutes, and the motors stay off. The next step needs the stick directions.</source>
        <translation>Etwa zwei Minuten; die Motoren bleiben aus. Der nächste Schritt braucht die Richtungen.</translation></message>
    <message><source>The stick is fully &amp;right now</source>
        <translation>Der Knüppel ist jetzt ganz &amp;rechts</translation></message>
    <message><source>The stick is fully &amp;forward now</source>
        <translation>Der Knüppel ist jetzt ganz &amp;vorn</translation></message>
    <message><source>Both sticks are fully &amp;forward now</source>
        <translation>Beide Knüppel sind jetzt ganz &amp;vorn</translation></message>
    <message><source>Wir&amp;es swapped – test again</source>
        <translation>&amp;Drähte vertauscht – erneut testen</translation></message>
    <message><source>Clear both answers and test the motors again</source>
        <translation>Beide Antworten vergessen und erneut herausfinden, welcher Motor welcher ist</translation></message>
    <message><source>Nothing has to change: the wheels follow the sticks.</source>
        <translation>Es muss nichts geändert werden: Die Räder folgen den Knüppeln.</translation></message>
    <message><source>Switch the motors' power off.</source>
        <translation>Schalten Sie die Motorversorgung aus.</translation></message>
    <message><source>The board learns your sticks</source>
        <translation>Das Board lernt Ihre Knüppel</translation></message>
    <message><source>Each channel is connected to an output of your receiver.</source>
        <translation>Jeder Kanal ist mit einem Ausgang Ihres Empfängers verbunden.</translation></message>
    <message><source>Channel 1 (motor 1)</source>
        <translation>Kanal 1 (Motor 1)</translation></message>
    <message><source>Channel 2 (motor 2)</source>
        <translation>Kanal 2 (Motor 2)</translation></message>
    <message><source>{0}: the direction is not known yet.</source>
        <translation>{0}: Richtung noch nicht bekannt.</translation></message>
    <message><source>{0}: the value rises.</source>
        <translation>{0}: Der Wert steigt.</translation></message>
    <message><source>{0}: the value falls.</source>
        <translation>{0}: Der Wert fällt.</translation></message>
    <message><source>{0}: the stick is still near its centre. Push the stick all the way.</source>
        <translation>{0}: Der Knüppel ist noch nahe der Mitte. Bewegen Sie ihn bis zum Anschlag.</translation></message>
    <message><source>Hold a button, then click what moved</source>
        <translation>Taste gedrückt halten, dann klicken, was sich bewegt hat</translation></message>
    <message><source>Nothing &amp;moved</source>
        <translation>N&amp;ichts hat sich bewegt</translation></message>
    <message><source>Click what this motor moved</source>
        <translation>Klicken Sie, was dieser Motor bewegt hat</translation></message>
    <message><source>Nothing turned: the next pulses are stronger (30 %). If that does not help, check the battery and the wires of this motor.</source>
        <translation>Nichts hat sich gedreht: Die nächsten Impulse sind stärker (30 %). Wenn das nicht hilft, prüfen Sie die Batterie und die Drähte dieses Motors.</translation></message>
    <message><source>Motor 1 drives the left wheel, motor 2 the right one, both forward.</source>
        <translation>Motor 1 treibt das linke Rad an, Motor 2 das rechte, beide vorwärts.</translation></message>
    <message><source>No wires have to be swapped, but the directions of the sticks are not known yet: go back to Sticks. Your answers are kept.</source>
        <translation>Es müssen keine Drähte vertauscht werden, aber die Richtungen der Knüppel sind noch nicht bekannt: Gehen Sie zurück zu „Knüppel“. Ihre Antworten bleiben erhalten.</translation></message>
    <message><source>Settings correct this; no wires have to be swapped.</source>
        <translation>Einstellungen berichtigen dies; es müssen keine Drähte vertauscht werden.</translation></message>
    <message><source>Already learned? Hold the sticks as a button says, then click the button:</source>
        <translation>Schon eingelernt? Drücken, halten und klicken:</translation></message>
    <message><source>Channel 1 (turns)</source>
        <translation>Kanal 1 (lenkt)</translation></message>
    <message><source>Channel 2 (drives)</source>
        <translation>Kanal 2 (fährt)</translation></message>
    <message><source>{0}: no signal arrives.</source>
        <translation>{0}: Es kommt kein Signal an.</translation></message>
    <message><source>not tried yet</source>
        <translation>noch nicht versucht</translation></message>
    <message><source>Nothing turned: the pulses stay below the speed ceiling of the Motors page. Raise the ceiling, or check the battery and the wires of this motor.</source>
        <translation>Nichts hat sich gedreht: Die Impulse bleiben unter der Höchstgeschwindigkeit der Seite „Motoren“. Erhöhen Sie diese, oder prüfen Sie die Batterie und die Drähte dieses Motors.</translation></message>
    <message><source>Two motors cannot drive the same wheel: try both buttons again.</source>
        <translation>Zwei Motoren können nicht dasselbe Rad antreiben: Versuchen Sie beide Schaltflächen erneut.</translation></message>
    <message><source>What did motor {0} move?</source>
        <translation>Was hat Motor {0} bewegt?</translation></message>
    <message><source>Is the transmitter on?</source>
        <translation>Ist der Sender eingeschaltet?</translation></message>
    <message><source>Motor &amp;{0}</source>
        <translation>Motor &amp;{0}</translation></message>
    <message numerus="yes"><source>“Next” adds %n change(s). Nothing is written until you apply the changes.</source>
        <translation><numerusform>„Weiter“ fügt %n Änderung hinzu. Geschrieben wird erst, wenn Sie sie anwenden.</numerusform><numerusform>„Weiter“ fügt %n Änderungen hinzu. Geschrieben wird erst, wenn Sie sie anwenden.</numerusform></translation></message>
    <message><source>&amp;Jumpers</source>
        <translation>&amp;Jumper</translation></message>
    <message><source>&amp;Sticks</source>
        <translation>&amp;Knüppel</translation></message>
    <message><source>&amp;Limits</source>
        <translation>&amp;Grenzen</translation></message>
    <message><source>T&amp;imeout</source>
        <translation>T&amp;imeout</translation></message>
    <message><source>You can skip any step. Nothing is written until you apply the changes at the end.</source>
        <translation>Jeder Schritt kann übersprungen werden. Nichts wird geschrieben, bevor Sie es am Ende anwenden.</translation></message>
    <message><source>Schematic drawing: see the user's guide for the positions on your board.</source>
        <translation>Schema: Das Benutzerhandbuch zeigt, wo Ihr Board sie hat.</translation></message>
    <message><source>The mix jumper is on: remove it, then push a stick.</source>
        <translation>Der Mix-Jumper ist gesteckt: Ziehen Sie ihn ab und bewegen Sie dann einen Knüppel.</translation></message>
    <message><source>The mix jumper is off: put it on, then push a stick.</source>
        <translation>Der Mix-Jumper ist ab: Stecken Sie ihn auf und bewegen Sie dann einen Knüppel.</translation></message>
    <message><source>Set the current that your motors can draw continuously; the presets are examples. Without a ramp, the current exceeds the limit for a moment.</source>
        <translation>Stellen Sie ein, was Ihre Motoren dauernd aufnehmen dürfen: Die Vorgaben sind Beispiele. Ohne Rampe überschreitet der Strom die Grenze für einen Augenblick.</translation></message>
    <message><source>The computer must send something at least twice within this time. UART-Error Shutdown is also switched on, because the timeout may need it (twin).</source>
        <translation>Lassen Sie den Computer in dieser Zeit mindestens zweimal etwas senden. „Abschaltung bei UART-Fehlern“ wird mit eingeschaltet, da das Timeout sie vielleicht braucht (Zwilling).</translation></message>
    <message><source>The changes of this step were not added. Open the step and click Next.</source>
        <translation>Seine Änderungen wurden nicht übernommen: Öffnen Sie den Schritt und klicken Sie auf „Weiter“.</translation></message>
    <message><source>For the first drive, keep the wheels off the ground: forward, back, left, right.</source>
        <translation>Fahren Sie zuerst mit den Rädern in der Luft: vor, zurück, links, rechts.</translation></message>
    <message><source>Switch the board off, set the mode jumper to {0}, and {1}.</source>
        <translation>Schalten Sie das Board aus, stecken Sie den Modus-Jumper auf {0} und {1}.</translation></message>
    <message><source>Switch on the transmitter, then the board.</source>
        <translation>Schalten Sie zuerst den Sender ein, dann das Board.</translation></message>
    <message><source>The motors stay off until the sticks are released (safe-start).</source>
        <translation>Die Motoren bleiben aus, bis die Knüppel losgelassen werden (Safe-Start).</translation></message>
    <message><source>Who drives your robot?</source>
        <translation>Wer steuert Ihren Roboter?</translation></message>
    <message><source>&amp;One stick</source>
        <translation>&amp;Ein Knüppel</translation></message>
    <message><source>&amp;Two sticks</source>
        <translation>Zwei &amp;Knüppel</translation></message>
    <message><source>&amp;A computer</source>
        <translation>Ein &amp;Computer</translation></message>
    <message><source>One stick drives and turns. The board mixes both.</source>
        <translation>Ein Knüppel fährt und lenkt. Das Board mischt beides.</translation></message>
    <message><source>One stick for each side of the robot, as in a tank.</source>
        <translation>Ein Knüppel für jede Seite des Roboters, wie bei einem Kettenfahrzeug.</translation></message>
    <message><source>Commands come over the serial line.</source>
        <translation>Befehle kommen über die serielle Leitung.</translation></message>
    <message><source>Move the jumpers as drawn</source>
        <translation>Jumper wie gezeichnet stecken</translation></message>
    <message><source>How should the motors start and stop?</source>
        <translation>Wie sollen die Motoren anfahren und anhalten?</translation></message>
    <message><source>As &amp;it is</source>
        <translation>W&amp;ie es ist</translation></message>
    <message><source>&amp;Tank</source>
        <translation>&amp;Kettenfahrzeug</translation></message>
    <message><source>Ro&amp;ver</source>
        <translation>Ro&amp;ver</translation></message>
    <message><source>&amp;Autonomous robot</source>
        <translation>Autonomer &amp;Roboter</translation></message>
    <message><source>off</source><comment>limit</comment>
        <translation>aus</translation></message>
    <message><source>In joint mode the board does not measure the current and cannot limit it.</source>
        <translation>Im Parallelbetrieb misst das Board keinen Strom und kann ihn daher nicht begrenzen.</translation></message>
    <message><source>This example was made for a {0}, which measures current in other units. Your board keeps its current limit.</source>
        <translation>Dieses Beispiel wurde für einen {0} erstellt, der den Strom in anderen Einheiten misst. Ihr Board behält seine Stromgrenze.</translation></message>
    <message><source>If the cable falls out, the board stops</source>
        <translation>Wenn sich das Kabel löst, stoppt das Board</translation></message>
    <message><source>What is left to do</source>
        <translation>Was noch zu tun ist</translation></message>
    <message><source>The positions are wrong or have not been checked.</source>
        <translation>Falsche Stellung oder nicht geprüft.</translation></message>
    <message><source>The directions of the sticks are not known.</source>
        <translation>Die Richtungen der Knüppel sind nicht bekannt.</translation></message>
    <message><source>This step was skipped, or its changes were undone.</source>
        <translation>Übersprungen, oder die Änderungen wurden rückgängig gemacht.</translation></message>
    <message><source>It is not known which motor drives which wheel.</source>
        <translation>Es ist nicht bekannt, welcher Motor welches Rad antreibt.</translation></message>
    <message><source>The motor settings depend on the directions of the sticks.</source>
        <translation>Die Einstellungen für die Motoren warten auf die Richtungen der Knüppel.</translation></message>
    <message><source>Leave the mode jumper off. You can send the first commands from the Motors page of this window.</source>
        <translation>Lassen Sie den Modus-Jumper weg. Die ersten Befehle können von der Seite „Motoren“ dieses Fensters kommen.</translation></message>
    <message><source>put the mix jumper on</source>
        <translation>stecken Sie den Mix-Jumper auf</translation></message>
    <message><source>leave the mix jumper off</source>
        <translation>lassen Sie den Mix-Jumper weg</translation></message>
    <message><source>The board does not respond: it may be switched off.</source>
        <translation>Das Board antwortet nicht: Es ist vielleicht ausgeschaltet.</translation></message>
    <message><source>No board is connected, so its jumpers cannot be checked.</source>
        <translation>Kein Board ist verbunden, daher können seine Jumper nicht geprüft werden.</translation></message>
    <message><source>This board was started without the mode jumper (serial mode).</source>
        <translation>Dieses Board wurde ohne Modus-Jumper gestartet (serieller Modus).</translation></message>
    <message><source>The mix jumper can be checked only in serial mode. In the present mode, a stick would drive the motors.</source>
        <translation>Der Mix-Jumper kann nur im seriellen Modus geprüft werden: Jetzt würde ein Knüppel die Motoren antreiben.</translation></message>
    <message><source>The board does not report the state of the mix jumper. Push a stick to one side to detect it.</source>
        <translation>Das Board meldet den Mix-Jumper nicht. Drücken Sie einen Knüppel zur Seite, um es zu sehen.</translation></message>
    <message><source>Current &amp;limit of each motor</source>
        <translation>&amp;Stromgrenze jedes Motors</translation></message>
    <message><source>&amp;Stop the motors after a silence of</source>
        <translation>Motoren &amp;stoppen nach einer Stille von</translation></message>
    <message><source>Go to this step</source>
        <translation>Zu diesem Schritt gehen</translation></message>
    <message><source>Then, by hand:</source>
        <translation>Danach von Hand:</translation></message>
    <message><source>The mix jumper is on.</source>
        <translation>Der Mix-Jumper ist gesteckt.</translation></message>
    <message><source>The mix jumper is off.</source>
        <translation>Der Mix-Jumper ist abgezogen.</translation></message>
    <message><source>{0} Then test the motors again.</source>
        <translation>{0} Testen Sie dann die Motoren erneut.</translation></message>
    <message><source>Select a snapshot to see what it would restore.</source>
        <translation>Wählen Sie eine Sicherungskopie aus, um zu sehen, was sie wiederherstellen würde.</translation></message>
    <message><source>This snapshot is from a {0}, but the connected board is a {1}. The snapshot cannot be restored.</source>
        <translation>Diese Sicherungskopie ist von einem {0}, und das Board hier ist ein {1}: Sie kann nicht wiederhergestellt werden.</translation></message>
    <message><source>Note: this snapshot is from device number {0}, and the connected board has number {1}.</source>
        <translation>Hinweis: Diese Sicherungskopie ist von Gerätenummer {0}, das Board hier hat Nummer {1}.</translation></message>
    <message><source>Now, with edits</source>
        <translation>Jetzt, mit Änderungen</translation></message>
    <message><source>Reading…</source>
        <translation>Lesen…</translation></message>
    <message><source>{0}, before {1}</source>
        <translation>{0}, vor: {1}</translation></message>
    <message numerus="yes"><source>&amp;Restore %n setting(s)…</source>
        <translation><numerusform>%n Einstellung &amp;wiederherstellen …</numerusform><numerusform>%n Einstellungen &amp;wiederherstellen …</numerusform></translation></message>
    <message><source>Nothing is selected for restoring.</source>
        <translation>Zum Wiederherstellen ist nichts ausgewählt.</translation></message>
    <message><source>To restore a snapshot, select only this snapshot.</source>
        <translation>Um eine der beiden wiederherzustellen, wählen Sie sie allein aus.</translation></message>
    <message><source>The board does not respond, so nothing can be restored.</source>
        <translation>Das Board antwortet nicht, daher kann nichts wiederhergestellt werden.</translation></message>
    <message><source>Settings are being written. Wait until writing ends.</source>
        <translation>Einstellungen werden geschrieben; warten Sie, bis das abgeschlossen ist.</translation></message>
    <message><source>No board is connected. Connect one to restore a snapshot.</source>
        <translation>Kein Board ist verbunden. Verbinden Sie eines, um eine Sicherungskopie wiederherzustellen.</translation></message>
    <message><source>Select one snapshot, or two to compare them.</source>
        <translation>Wählen Sie eine Sicherungskopie aus, oder zwei, um sie zu vergleichen.</translation></message>
    <message><source>Restore snapshot of {0}</source>
        <translation>Sicherungskopie von {0} wiederherstellen</translation></message>
    <message><source>No setting differs.</source>
        <translation>Keine Einstellung weicht ab.</translation></message>
    <message><source>Nothing was restored: {0}</source>
        <translation>Nichts wurde wiederhergestellt: {0}</translation></message>
    <message><source>Never connect RS-232 levels (±12 V) to SI and SO: they can destroy the board.</source>
        <translation>Verbinden Sie nie RS-232-Pegel (±12 V) mit SI und SO: Diese können das Board zerstören.</translation></message>
    <message><source>Set the board up through an adapter first: with the mode jumper on, it accepts no settings. BEC supplies at most 100 mA.</source>
        <translation>Richten Sie das Board zuerst über einen Adapter ein: Mit gestecktem Modus-Jumper nimmt es keine Einstellungen an. Der BEC liefert höchstens 100 mA.</translation></message>
    <message><source>TReX</source>
        <translation>TReX</translation></message>
    <message><source>RS-232 port</source>
        <translation>RS-232-Port</translation></message>
    <message><source>Receiver</source>
        <translation>Empfänger</translation></message>
    <message><source>Switch off the motor supply, or put the robot on blocks. Connecting and searching do not move a motor.</source>
        <translation>Schalten Sie die Motorversorgung aus oder bocken Sie den Roboter auf. Verbinden und Suchen bewegen keinen Motor.</translation></message>
    <message><source>No board at hand?</source>
        <translation>Kein Board zur Hand?</translation></message>
    <message><source>&amp;Try the demo</source>
        <translation>Demo aus&amp;probieren</translation></message>
    <message><source>Mode: remove it</source>
        <translation>Modus: abziehen</translation></message>
    <message><source>SO–G: remove it</source>
        <translation>SO–G: abziehen</translation></message>
    <message><source>Mode: set it to RC</source>
        <translation>Modus: auf RC stecken</translation></message>
    <message><source>BEC: feeds the receiver</source>
        <translation>BEC: speist den Empfänger</translation></message>
    <message><source>USB adapter, 3.3 or 5 V</source>
        <translation>USB-Adapter, 3,3 oder 5 V</translation></message>
    <message><source>RS-&amp;232 adapter</source>
        <translation>RS-&amp;232-Adapter</translation></message>
    <message><source>RC recei&amp;ver</source>
        <translation>&amp;RC-Empfänger</translation></message>
    <message><source>Open &amp;settings file…</source>
        <translation>&amp;Einstellungsdatei öffnen…</translation></message>
    <message><source>&amp;Open recording…</source>
        <translation>&amp;Aufzeichnung öffnen…</translation></message>
    <message><source>Go on without the changes of this step</source>
        <translation>Ohne die Änderungen dieses Schrittes fortfahren</translation></message>
    <message><source>&amp;Back</source>
        <translation>&amp;Zurück</translation></message>
    <message><source>S&amp;kip</source>
        <translation>Übers&amp;pringen</translation></message>
    <message><source>Plot of currents in its o&amp;wn window</source>
        <translation>Stromkurven in eigenem &amp;Fenster</translation></message>
    <message><source>Demo TReX</source>
        <translation>Demo-TReX</translation></message>
    <message><source>a settings file of a TReX</source>
        <translation>eine Einstellungsdatei eines TReX</translation></message>
    <message><source>a board</source>
        <translation>ein Board</translation></message>
    <message><source>B&amp;oard</source>
        <translation>Bo&amp;ard</translation></message>
    <message><source>&amp;Channels</source>
        <translation>&amp;Kanäle</translation></message>
    <message><source>&amp;Motors</source>
        <translation>&amp;Motoren</translation></message>
    <message><source>&amp;Parameters</source>
        <translation>&amp;Parameter</translation></message>
    <message><source>&amp;Discard all edits</source>
        <translation>Alle Änderungen &amp;verwerfen</translation></message>
    <message><source>R&amp;eload settings from device</source>
        <translation>Einstellungen vom Gerät &amp;neu laden</translation></message>
    <message><source>Review ch&amp;anges…</source>
        <translation>&amp;Änderungen prüfen…</translation></message>
    <message><source>Make stored settings acti&amp;ve…</source>
        <translation>Gespei&amp;cherte Einstellungen aktivieren…</translation></message>
    <message><source>Find &amp;other boards on this line</source>
        <translation>Weitere Boards an dieser Leitung s&amp;uchen</translation></message>
    <message><source>A&amp;pply a file to several boards…</source>
        <translation>&amp;Datei auf mehrere Boards anwenden…</translation></message>
    <message><source>Set up one board after anot&amp;her…</source>
        <translation>B&amp;oards nacheinander einrichten…</translation></message>
    <message><source>Lear&amp;n channels…</source>
        <translation>Kanäle &amp;einlernen…</translation></message>
    <message><source>&amp;Demo TReX panel</source>
        <translation>Bedienfeld des &amp;Demo-TReX</translation></message>
    <message><source>&amp;User's guide of the board (online)…</source>
        <translation>Ben&amp;utzerhandbuch des Boards (online)…</translation></message>
    <message><source>Gamepads need one more package. Install the package with {0}, then switch Gamepad on again.</source>
        <translation>Gamepads brauchen ein weiteres Paket. Installieren Sie es mit {0}, dann schalten Sie dies wieder ein.</translation></message>
    <message><source>Gamepads cannot be read on this computer: {0}.</source>
        <translation>Gamepads können hier nicht gelesen werden: {0}.</translation></message>
    <message><source>The program was suspended (Ctrl-Z)</source>
        <translation>Das Programm wurde angehalten (Strg-Z)</translation></message>
    <message><source>Internal error ({0})</source>
        <translation>Interner Fehler ({0})</translation></message>
    <message><source>The computer was asleep</source>
        <translation>Der Computer war im Ruhezustand</translation></message>
    <message><source>Stopping the motors before the computer sleeps</source>
        <translation>Motoren, die gestoppt werden können, werden gestoppt, bevor der Computer in den Ruhezustand geht</translation></message>
    <message><source>The screen was locked</source>
        <translation>Der Bildschirm wurde gesperrt</translation></message>
    <message><source>The computer is going to sleep</source>
        <translation>Der Computer geht in den Ruhezustand</translation></message>
    <message><source>The computer is shutting down</source>
        <translation>Der Computer wird heruntergefahren</translation></message>
    <message><source>The session is ending</source>
        <translation>Die Sitzung endet</translation></message>
    <message><source>Reconnected to {0}. No motor was started.</source>
        <translation>Wieder mit {0} verbunden. Kein Motor wurde gestartet.</translation></message>
    <message><source>{0} also has {1} open and may take replies. Close the port there.</source>
        <translation>{0} hat {1} ebenfalls geöffnet und kann Antworten abfangen. Schließen Sie den Port dort.</translation></message>
    <message><source>Connecting to {0} …</source>
        <translation>Verbinden mit {0} …</translation></message>
    <message><source>Disconnecting …</source>
        <translation>Trennen …</translation></message>
    <message><source>The cable of the Demo {0} is unplugged. Plug the cable in on the demo panel, then connect again.</source>
        <translation>Das Kabel des Demo-{0} ist ausgesteckt. Stecken Sie es auf seinem Bedienfeld ein und verbinden Sie dann wieder.</translation></message>
    <message><source>Replies lost</source>
        <translation>Verlorene Antworten</translation></message>
    <message><source>Noise on the line</source>
        <translation>Störungen auf der Leitung</translation></message>
    <message><source>The Demo {0} is not running. Press Connect.</source>
        <translation>Der Demo-{0} läuft nicht. Klicken Sie auf „Verbinden“.</translation></message>
    <message><source>The cable is unplugged. Plug it in, then press Connect.</source>
        <translation>Das Kabel ist ausgesteckt. Stecken Sie es ein und klicken Sie dann auf „Verbinden“.</translation></message>
    <message><source>The cable is plugged in again. Press Connect.</source>
        <translation>Das Kabel ist wieder eingesteckt. Klicken Sie auf „Verbinden“.</translation></message>
    <message><source>The Demo {0} is starting …</source>
        <translation>Der Demo-{0} startet …</translation></message>
    <message><source>The power is off. Switch it on, then press Connect.</source>
        <translation>Die Stromversorgung ist aus. Schalten Sie sie ein und klicken Sie dann auf „Verbinden“.</translation></message>
    <message><source>Demo {0} (no hardware)</source>
        <translation>Demo-{0} (simuliert)</translation></message>
    <message><source>Ending the search …</source>
        <translation>Suche wird beendet …</translation></message>
    <message><source>Looking for {0} at {1} on {2} …</source>
        <translation>Suche nach {0} mit {1} an {2} …</translation></message>
    <message><source>{0} on {1} at {2} (RS-232 side).</source>
        <translation>{0} an {1} mit {2} (RS-232-Seite).</translation></message>
    <message><source>{0} on {1} at {2}.</source>
        <translation>{0} an {1} mit {2}.</translation></message>
    <message><source>Search cancelled.</source>
        <translation>Suche abgebrochen.</translation></message>
    <message numerus="yes"><source>%n board(s) found.</source>
        <translation><numerusform>%n Board gefunden.</numerusform><numerusform>%n Boards gefunden.</numerusform></translation></message>
    <message><source>No board was found.</source>
        <translation>Kein Board wurde gefunden.</translation></message>
    <message><source>Opening {0} …</source>
        <translation>{0} wird geöffnet …</translation></message>
    <message><source>No reply on {0}. No other settings were tried, because other devices share the line.</source>
        <translation>Keine Antwort an {0}. Andere Geräte teilen sich die Leitung: Sonst wurde nichts versucht.</translation></message>
    <message><source>{0} with device number {1}</source>
        <translation>{0} mit Gerätenummer {1}</translation></message>
    <message><source>the Demo {0}</source>
        <translation>Demo-{0}</translation></message>
    <message><source>The simulator could not be started. Reinstall the program.</source>
        <translation>Der Simulator startet nicht. Installieren Sie das Programm neu.</translation></message>
    <message><source>The simulator exited immediately. {0}</source>
        <translation>Der Simulator hat sich sofort beendet. {0}</translation></message>
    <message><source>&amp;Undo {0}</source>
        <translation>&amp;Rückgängig: {0}</translation></message>
    <message><source>&amp;Redo {0}</source>
        <translation>&amp;Wiederherstellen: {0}</translation></message>
    <message><source>Show help for the message at the cursor</source>
        <translation>Die Hilfe zur Meldung in der Zeile mit dem Cursor zeigen</translation></message>
    <message><source>Search (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation></message>
    <message><source>Copy the selected rows, or everything shown</source>
        <translation>Die ausgewählten Zeilen kopieren, oder alles Angezeigte</translation></message>
    <message><source>Save a report for support; it is shown before it is written</source>
        <translation>Einen Bericht für den Support speichern; er wird vorher angezeigt</translation></message>
    <message><source>O&amp;nly problems</source>
        <translation>Nur &amp;Probleme</translation></message>
    <message><source>E&amp;xplain</source>
        <translation>E&amp;rklären</translation></message>
    <message><source>Messages, stops, lost connections and written settings will be listed here.</source>
        <translation>Meldungen, Stopps, verlorene Verbindungen und geschriebene Einstellungen werden hier aufgelistet.</translation></message>
    <message><source>Diagnostics</source>
        <translation>Diagnose</translation></message>
    <message><source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation></message>
    <message><source>Sa&amp;ve report…</source>
        <translation>&amp;Supportbericht speichern…</translation></message>
    <message><source>Lo&amp;g</source>
        <translation>Pr&amp;otokoll</translation></message>
    <message><source>T&amp;raffic</source>
        <translation>Date&amp;nverkehr</translation></message>
    <message><source>{0} of {1} shown</source>
        <translation>{0} von {1} angezeigt</translation></message>
    <message><source>Round trips in the last minute: up to {0:.0f} ms</source>
        <translation>Antwortzeiten der letzten Minute: bis {0:.0f} ms</translation></message>
    <message><source>Nothing has gone wrong since {0:%H:%M}.</source>
        <translation>Seit {0:%H:%M} ist kein Problem aufgetreten.</translation></message>
    <message><source>Connection</source>
        <translation>Verbindung</translation></message>
    <message><source>Nothing is connected.</source>
        <translation>Nichts ist verbunden.</translation></message>
    <message numerus="yes"><source>%n problem(s) active now</source>
        <translation><numerusform>%n Problem jetzt aktiv</numerusform><numerusform>%n Probleme jetzt aktiv</numerusform></translation></message>
    <message><source>Nothing else has gone wrong since {0:%H:%M}.</source>
        <translation>Seit {0:%H:%M} ist kein weiteres Problem aufgetreten.</translation></message>
    <message numerus="yes"><source>%n time(s), last at {0:%H:%M:%S}</source>
        <translation><numerusform>%n-mal, um {0:%H:%M:%S}</numerusform><numerusform>%n-mal, zuletzt um {0:%H:%M:%S}</numerusform></translation></message>
    <message><source>Show it</source>
        <translation>Anzeigen</translation></message>
    <message><source>C&amp;lear</source>
        <translation>&amp;Leeren</translation></message>
    <message><source>the name of a picture needs a file extension such as .png</source>
        <translation>Bilder brauchen eine Dateiendung wie .png</translation></message>
    <message><source>pictures cannot be written as {0}</source>
        <translation>Bilder lassen sich nicht als {0} schreiben</translation></message>
    <message><source>F&amp;ind…</source>
        <translation>Su&amp;chen…</translation></message>
    <message><source>Set up CRC…</source>
        <translation>CRC einrichten…</translation></message>
    <message><source>Progress</source>
        <translation>Fortschritt</translation></message>
    <message><source>A device such as /dev/ttyUSB0 or COM3, or a network port such as socket://host:port or rfc2217://host:port:</source>
        <translation>Ein Gerät wie /dev/ttyUSB0 oder COM3, oder ein Netzwerkport wie socket://host:port oder rfc2217://host:port:</translation></message>
    <message><source>Dis&amp;connect</source>
        <translation>&amp;Trennen</translation></message>
    <message><source>&amp;Port:</source>
        <translation>P&amp;ort:</translation></message>
    <message><source>How this computer talks to the board</source>
        <translation>Wie dieser Computer mit dem Board kommuniziert</translation></message>
    <message><source>Find a board whose line settings are unknown</source>
        <translation>Ein Board suchen, dessen Leitungseinstellungen unbekannt sind</translation></message>
    <message><source>Let the board detect corrupted bytes; the changes are shown before they are written</source>
        <translation>Das Board beschädigte Bytes erkennen lassen; zeigt zuerst, was geschrieben wird</translation></message>
    <message><source>Settings are still being written. Disconnect anyway? Unwritten settings stay pending.</source>
        <translation>Einstellungen werden noch geschrieben. Trotzdem trennen? Nicht geschriebene Einstellungen bleiben ausstehend.</translation></message>
    <message><source>Other port or address…</source>
        <translation>Anderer Port oder andere Adresse…</translation></message>
    <message><source>Not connected</source>
        <translation>Nicht verbunden</translation></message>
    <message><source>&amp;Find a board…</source>
        <translation>&amp;Board suchen…</translation></message>
    <message><source>Starting the Demo {0} …</source>
        <translation>Demo-{0} wird gestartet …</translation></message>
    <message><source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation></message>
    <message><source>{0} was not opened: its type is not supported. Supported: {1}.</source>
        <translation>{0} wurde nicht geöffnet: Dieser Dateityp wird nicht unterstützt. Unterstützt: {1}.</translation></message>
    <message><source>Recent &amp;files</source>
        <translation>Z&amp;uletzt verwendete Dateien</translation></message>
    <message><source>None of the {0} dropped files was opened. Drop one file at a time.</source>
        <translation>{0} Dateien wurden abgelegt, und keine wurde geöffnet: Legen Sie jeweils nur eine ab.</translation></message>
    <message><source>{0} is {1}. It was not opened, because this window is connected to {2}: disconnect, then open it again.</source>
        <translation>{0} ist {1}. Die Datei wurde nicht geöffnet, weil dieses Fenster mit {2} verbunden ist: Trennen Sie die Verbindung und öffnen Sie sie dann erneut.</translation></message>
    <message><source>{0} no longer exists and was removed from the recent files.</source>
        <translation>{0} ist nicht mehr vorhanden; der Eintrag wurde aus den zuletzt verwendeten Dateien entfernt.</translation></message>
    <message><source>a file of the {0}</source>
        <translation>eine Datei für {0}</translation></message>
    <message><source>Probes each port for every supported device, first at its likely settings, then at every baud rate, with every parity and with CRC. Probes never move a motor or change a setting of a TReX or an Aracna. Other devices on the line may react: enter their numbers in the line settings first. A TReX that receives probes at another rate counts UART errors, and stops its motors if it is set to do so.</source>
        <translation>Prüft an jedem Port, ob ein unterstütztes Gerät antwortet: jede Art mit ihren wahrscheinlichen Einstellungen, dann mit jeder Baudrate, mit jeder Parität und mit CRC. Ein TReX oder Aracna bewegt dabei keinen Motor und ändert keine Einstellung. Andere Geräte an der Leitung vielleicht schon: Geben Sie deren Nummern zuerst in den Leitungseinstellungen ein. Ein TReX, der Anfragen mit einer anderen Baudrate empfängt, zählt UART-Fehler und stoppt seine Motoren, wenn er so eingestellt ist.</translation></message>
    <message><source>The likely settings come first; a port without a reply takes about half a minute.</source>
        <translation>Die wahrscheinlichen Einstellungen kommen zuerst; ein Port ohne Antwort dauert etwa eine halbe Minute.</translation></message>
    <message><source>&amp;Full search: also try every CRC polynomial and every device number (takes a few minutes)</source>
        <translation>&amp;Vollständige Suche: auch jedes CRC-Polynom und jede Gerätenummer (einige Minuten)</translation></message>
    <message><source>C&amp;ancel</source>
        <translation>A&amp;bbrechen</translation></message>
    <message><source>C&amp;heck the board…</source>
        <translation>Board &amp;prüfen…</translation></message>
    <message><source>{0} – connected to this window</source>
        <translation>{0} – mit diesem Fenster verbunden</translation></message>
    <message><source>{0} is connected to this window, so it is not searched.</source>
        <translation>{0} ist mit diesem Fenster verbunden und wird daher nicht durchsucht.</translation></message>
    <message><source>Found devices</source>
        <translation>Gefundene Geräte</translation></message>
    <message><source>What the LEDs mean, how to wire the board, and how to restore serial settings</source>
        <translation>Was die LEDs bedeuten, die Drähte und wie serielle Einstellungen wiederhergestellt werden</translation></message>
    <message><source>Copy command</source>
        <translation>Befehl kopieren</translation></message>
    <message><source>Search &amp;on:</source>
        <translation>Suchen &amp;an:</translation></message>
    <message><source>This computer has no serial ports. Plug in an adapter.</source>
        <translation>Dieser Computer hat keine seriellen Ports. Stecken Sie einen Adapter ein.</translation></message>
    <message><source>Connect to {0}</source>
        <translation>Mit {0} verbinden</translation></message>
    <message><source>Help</source>
        <translation>Hilfe</translation></message>
    <message><source>TReX Studio</source>
        <translation>TReX Studio</translation></message>
    <message><source>&amp;Preferences…</source>
        <translation>Voreinstellun&amp;gen…</translation></message>
    <message><source>E&amp;xit</source>
        <translation>&amp;Beenden</translation></message>
    <message><source>Search every&amp;thing</source>
        <translation>Alles &amp;durchsuchen</translation></message>
    <message><source>&amp;Help</source>
        <translation>&amp;Hilfe</translation></message>
    <message><source>&amp;Save report for support…</source>
        <translation>&amp;Supportbericht speichern…</translation></message>
    <message><source>&amp;About</source>
        <translation>&amp;Info</translation></message>
    <message><source>{0} on {1}</source>
        <translation>{0} an {1}</translation></message>
    <message><source>{0} (demo)</source>
        <translation>{0} (Demo)</translation></message>
    <message><source>The window is closing</source>
        <translation>Das Fenster sollte geschlossen werden</translation></message>
    <message><source>&amp;Window</source>
        <translation>&amp;Fenster</translation></message>
    <message><source>As the system</source>
        <translation>Wie das System</translation></message>
    <message><source>Light</source>
        <translation>Hell</translation></message>
    <message><source>Dark</source>
        <translation>Dunkel</translation></message>
    <message><source>High contrast</source>
        <translation>Hoher Kontrast</translation></message>
    <message><source>Physical units (µs, V, %, s)</source>
        <translation>Physikalische Einheiten (µs, V, %, s)</translation></message>
    <message><source>Values of the board (counts, 0 to 127)</source>
        <translation>Werte des Boards (Counts, 0 bis 127)</translation></message>
    <message><source>&amp;Theme:</source>
        <translation>&amp;Design:</translation></message>
    <message><source>&amp;Font size:</source>
        <translation>S&amp;chriftgröße:</translation></message>
    <message><source>&amp;Language:</source>
        <translation>S&amp;prache:</translation></message>
    <message><source>Takes effect the next time the program starts</source>
        <translation>Gilt ab dem nächsten Start des Programms</translation></message>
    <message><source>&amp;Units:</source>
        <translation>&amp;Einheiten:</translation></message>
    <message><source>Determines which unit is shown first, and which unit applies to a number typed without one</source>
        <translation>Was zuerst gezeigt wird, und was eine ohne Einheit eingegebene Zahl bedeutet</translation></message>
    <message><source>Connect to known boards automat&amp;ically</source>
        <translation>Automatisch mit bekannten &amp;Boards verbinden</translation></message>
    <message><source>The program connects when it starts or when a known adapter is plugged in, if exactly one board responds. It does not connect after Disconnect or while another program uses the port. No motor moves.</source>
        <translation>Beim Programmstart und beim Einstecken eines Adapters, an dem schon ein Board gefunden wurde, wenn genau ein Board antwortet. Nicht nach „Trennen“, und nicht, solange ein anderes Programm den Port verwendet. Kein Motor bewegt sich.</translation></message>
    <message><source>{0} %</source>
        <translation>{0} %</translation></message>
    <message><source>The report contains only what is shown here. It is only saved as a file, never sent. Names of users and computers, network addresses and serial numbers of adapters are masked. Clear the check box of a file to leave it out.</source>
        <translation>Dies enthält der Bericht, und nichts anderes. Er wird nur als Datei gespeichert, nie gesendet. Namen von Benutzern und Computern, Netzwerkadressen und Seriennummern von Adaptern sind unkenntlich gemacht. Entfernen Sie das Häkchen bei einer Datei, um sie wegzulassen.</translation></message>
    <message><source>Collecting …</source>
        <translation>Zusammenstellen …</translation></message>
    <message><source>&amp;Save…</source>
        <translation>Spei&amp;chern…</translation></message>
    <message><source>Zip archives (*.zip)</source>
        <translation>ZIP-Archive (*.zip)</translation></message>
    <message><source>Files of the report</source>
        <translation>Dateien des Berichts</translation></message>
    <message><source>Content of the file</source>
        <translation>Inhalt der Datei</translation></message>
    <message><source>&amp;Files:</source>
        <translation>&amp;Dateien:</translation></message>
    <message><source>Con&amp;tent:</source>
        <translation>&amp;Inhalt:</translation></message>
    <message><source>The report was written to {0}.</source>
        <translation>Der Bericht wurde in {0} geschrieben.</translation></message>
    <message><source>{0} ({1} bytes)</source>
        <translation>{0} ({1} Bytes)</translation></message>
    <message><source>Search everything (Ctrl+K)</source>
        <translation>Alles durchsuchen (Strg+K)</translation></message>
    <message><source>Nothing was found.</source>
        <translation>Nichts wurde gefunden.</translation></message>
    <message><source>Hits</source>
        <translation>Treffer</translation></message>
    <message><source>Search every port and baud rate; no motor moves</source>
        <translation>Alle Ports und Baudraten durchsuchen; kein Motor bewegt sich</translation></message>
    <message><source>A simulated board: nothing can be damaged</source>
        <translation>Ein simuliertes Board: Nichts kann beschädigt werden</translation></message>
    <message><source>What is plugged in</source>
        <translation>Angeschlossen</translation></message>
    <message><source>No serial port was found. Plug in the adapter, and it will be listed here at once.</source>
        <translation>Kein serieller Port wurde gefunden. Stecken Sie den Adapter ein: Er erscheint hier sofort.</translation></message>
    <message><source>No response?</source>
        <translation>Keine Antwort?</translation></message>
    <message><source>Find &amp;my board…</source>
        <translation>&amp;Mein Board suchen…</translation></message>
    <message><source>Close the window</source>
        <translation>Fenster schließen</translation></message>
    <message><source>Pages of the help</source>
        <translation>Seiten der Hilfe</translation></message>
    <message><source>The program could not stop the motors itself. The guardian process sent a stop at {0}, but the board did not confirm the stop. If a motor is still turning, cut its power.</source>
        <translation>Das Programm konnte die Motoren nicht selbst stoppen. Der Wächterprozess hat einen Stopp gesendet ({0}), den das Board nicht bestätigt hat. Falls sich noch ein Motor dreht, trennen Sie die Motorversorgung.</translation></message>
    <message><source>The program could not stop the motors itself. The guardian process stopped them at {0}, and the board confirmed the stop.</source>
        <translation>Das Programm konnte die Motoren nicht selbst stoppen. Der Wächterprozess hat sie gestoppt ({0}), und das Board hat das bestätigt.</translation></message>
    <message><source>TReX Studio did not end properly last time. If it crashed, the support report shows where.</source>
        <translation>TReX Studio wurde beim letzten Mal nicht ordnungsgemäß beendet. Falls es abgestürzt ist, sagt ein Supportbericht, wo.</translation></message>
    <message><source>End the recording; motors and connection are not affected</source>
        <translation>Die Aufzeichnung beenden; Motoren und Verbindung sind nicht betroffen</translation></message>
    <message><source>Recorded to {0} ({1}). Use {2} to view it.</source>
        <translation>Aufgezeichnet in {0} ({1}). Zum Ansehen: {2}.</translation></message>
    <message><source>{0} is open; close its window before you overwrite it.</source>
        <translation>{0} ist geöffnet; schließen Sie das zugehörige Fenster, bevor Sie die Datei mit einer neuen Aufzeichnung überschreiben.</translation></message>
    <message><source>Save a cop&amp;y…</source>
        <translation>&amp;Kopie speichern…</translation></message>
    <message><source>Recording</source>
        <translation>Aufzeichnung</translation></message>
    <message><source>Recording  {0}  {1}</source>
        <translation>Aufzeichnung  {0}  {1}</translation></message>
    <message numerus="yes"><source>%n sample(s) lost: the disk is too slow</source>
        <translation><numerusform>%n Messwert verloren: Der Datenträger ist zu langsam</numerusform><numerusform>%n Messwerte verloren: Der Datenträger ist zu langsam</numerusform></translation></message>
    <message><source>Recordings (*{0})</source>
        <translation>Aufzeichnungen (*{0})</translation></message>
    <message><source>Playback speed</source>
        <translation>Wiedergabegeschwindigkeit</translation></message>
    <message><source>Time in the recording</source>
        <translation>Zeit in der Aufzeichnung</translation></message>
    <message><source>&amp;Pause</source>
        <translation>&amp;Pause</translation></message>
    <message><source>&amp;Play</source>
        <translation>&amp;Wiedergabe</translation></message>
    <message><source>Show the whole recording again</source>
        <translation>Wieder die ganze Aufzeichnung zeigen</translation></message>
    <message><source>Save every sample in the plot as CSV or MCAP</source>
        <translation>Alle Messwerte im Diagramm als CSV oder MCAP speichern</translation></message>
    <message><source>Save a copy, because old recordings of faults and stops are removed automatically</source>
        <translation>Diese Aufzeichnung behalten: Die ältesten von Störungen und Stopps werden entfernt</translation></message>
    <message><source>Stop loading or exporting</source>
        <translation>Laden oder Exportieren abbrechen</translation></message>
    <message><source>Exporting, %p %</source>
        <translation>Exportieren, %p %</translation></message>
    <message><source>Reading, %p %</source>
        <translation>Lesen, %p %</translation></message>
    <message><source>This recording has no events.</source>
        <translation>Diese Aufzeichnung enthält keine Ereignisse.</translation></message>
    <message><source>This recording is not complete. {0}</source>
        <translation>Diese Aufzeichnung ist nicht vollständig. {0}</translation></message>
    <message><source>CSV for spreadsheets (*.csv)</source>
        <translation>CSV für Tabellenkalkulationen (*.csv)</translation></message>
    <message><source>MCAP for PlotJuggler and Foxglove (*.mcap)</source>
        <translation>MCAP für PlotJuggler und Foxglove (*.mcap)</translation></message>
    <message><source>The open recording cannot be overwritten. Select another file.</source>
        <translation>Die geöffnete Aufzeichnung kann nicht überschrieben werden. Wählen Sie eine andere Datei.</translation></message>
    <message><source>E&amp;vents</source>
        <translation>E&amp;reignisse</translation></message>
    <message><source>&amp;Export span…</source>
        <translation>&amp;Zeitbereich exportieren…</translation></message>
    <message><source>{0}, recorded {1}</source>
        <translation>{0}, aufgezeichnet {1}</translation></message>
    <message><source>{0} – recording</source>
        <translation>{0} – Aufzeichnung</translation></message>
    <message><source>The span was saved to {0}.</source>
        <translation>Der Zeitbereich wurde in {0} gespeichert.</translation></message>
    <message><source>{0}, {1} long</source>
        <translation>{0}, Dauer {1}</translation></message>
    <message><source>Show &amp;all</source>
        <translation>&amp;Alles zeigen</translation></message>
    <message><source>Exporting MCAP requires an optional package. Install it with: {0}</source>
        <translation>Der Export als MCAP braucht ein optionales Paket. Installieren Sie es mit: {0}</translation></message>
    <message><source>The curves show the last {0} of {1} samples. Exports contain all samples.</source>
        <translation>Die Kurven zeigen die letzten {0} von {1} Messwerten; Exporte enthalten alle.</translation></message>
    <message><source>{n} h</source>
        <translation>{n} h</translation></message>
    <message><source>{n} s</source>
        <translation>{n} s</translation></message>
    <message><source>{n} min</source>
        <translation>{n} min</translation></message>
    <message><source>now</source>
        <translation>jetzt</translation></message>
    <message><source>Low</source>
        <translation>Tief</translation></message>
    <message><source>Peak</source>
        <translation>Spitze</translation></message>
    <message><source>Mean</source>
        <translation>Mittel</translation></message>
    <message><source>RMS</source>
        <translation>RMS</translation></message>
    <message><source>Picture as &amp;PNG…</source>
        <translation>Bild als &amp;PNG…</translation></message>
    <message><source>Picture as &amp;SVG…</source>
        <translation>&amp;Bild als SVG…</translation></message>
    <message><source>Pictures on a &amp;light background</source>
        <translation>Bilder mit &amp;hellem Hintergrund</translation></message>
    <message><source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation></message>
    <message><source>Pictures (*.{0})</source>
        <translation>Bilder (*.{0})</translation></message>
    <message numerus="yes"><source>{0} sample(s) written to {1}.</source>
        <translation><numerusform>{0} Messwert in {1} geschrieben.</numerusform><numerusform>{0} Messwerte in {1} geschrieben.</numerusform></translation></message>
    <message><source>E&amp;xport</source>
        <translation>&amp;Export</translation></message>
    <message><source>Pictu&amp;re</source>
        <translation>&amp;Bild</translation></message>
    <message><source>Save what the plot shows as PNG or SVG</source>
        <translation>Was das Diagramm zeigt, als PNG oder SVG speichern</translation></message>
    <message><source>&amp;Visible range as CSV…</source>
        <translation>&amp;Sichtbarer Bereich als CSV…</translation></message>
    <message><source>&amp;Everything as CSV…</source>
        <translation>&amp;Alles als CSV…</translation></message>
    <message><source>There is nothing to export yet.</source>
        <translation>Es gibt noch nichts zu exportieren.</translation></message>
    <message><source>The picture was written to {0}.</source>
        <translation>Das Bild wurde in {0} geschrieben.</translation></message>
    <message><source>Limit</source>
        <translation>Grenze</translation></message>
    <message><source>In the visible span</source>
        <translation>Im sichtbaren Zeitbereich</translation></message>
    <message><source>Select an event to show it in the plot.</source>
        <translation>Ein ausgewähltes Ereignis wird im Diagramm gezeigt.</translation></message>
    <message><source>Curves and their figures</source>
        <translation>Kurven und ihre Kennwerte</translation></message>
    <message><source>No events yet. Stops, applied settings, faults and exceeded limits will be listed here.</source>
        <translation>Noch keine Ereignisse. Stopps, „Anwenden“, Störungen und Grenzen werden hier aufgelistet.</translation></message>
    <message><source>Select the curves to draw</source>
        <translation>Wählen Sie die Kurven aus, die gezeichnet werden</translation></message>
    <message><source>Now</source>
        <translation>Jetzt</translation></message>
    <message><source>Newest value; ⚠ means 80 % of the limit or more</source>
        <translation>Neuester Wert; ⚠ bedeutet 80 % der Grenze oder mehr</translation></message>
    <message><source>Root mean square in the visible span; determines the heat in wires</source>
        <translation>Effektivwert im sichtbaren Zeitbereich: was Drähte erwärmt</translation></message>
    <message><source>Current times time in the visible span, without gaps</source>
        <translation>Strom mal Zeit im sichtbaren Zeitbereich, ohne Lücken</translation></message>
    <message><source>Cursor</source>
        <translation>Cursor</translation></message>
    <message><source>To mark</source>
        <translation>Zur Marke</translation></message>
    <message><source>Difference between the mark and the cursor; click the plot or press M to set the mark</source>
        <translation>Von der Marke bis zum Cursor; klicken Sie in das Diagramm oder drücken Sie M, um sie zu setzen</translation></message>
    <message><source>Held</source>
        <translation>Gehalten</translation></message>
    <message><source>Highest value since Hold peaks was switched on</source>
        <translation>Höchster Wert, seit „Spitzen halten“ eingeschaltet wurde</translation></message>
    <message><source>{0}, {1}: {2}, near its limit</source>
        <translation>{0}, {1}: {2}, nahe der Grenze</translation></message>
    <message><source>{0}, {1}: {2}, over its limit</source>
        <translation>{0}, {1}: {2}, über der Grenze</translation></message>
    <message><source>No events</source>
        <translation>Keine Ereignisse</translation></message>
    <message><source>Apply</source>
        <translation>Anwenden</translation></message>
    <message><source>Timeout</source>
        <translation>Timeout</translation></message>
    <message><source>Line</source>
        <translation>Leitung</translation></message>
    <message><source>Events in the plot</source>
        <translation>Ereignisse im Diagramm</translation></message>
    <message><source>Names of the curves</source>
        <translation>Namen der Kurven</translation></message>
    <message><source>{0} ({1} from the mark)</source>
        <translation>{0} ({1} ab der Marke)</translation></message>
    <message><source>Blue</source>
        <translation>Blau</translation></message>
    <message><source>Orange</source>
        <translation>Orange</translation></message>
    <message><source>Yellow</source>
        <translation>Gelb</translation></message>
    <message><source>Purple</source>
        <translation>Violett</translation></message>
    <message><source>Teal</source>
        <translation>Türkis</translation></message>
    <message><source>Pink</source>
        <translation>Rosa</translation></message>
    <message><source>Grey</source>
        <translation>Grau</translation></message>
    <message><source>Text colour</source>
        <translation>Wie Text</translation></message>
    <message><source>A fixed range keeps plots comparable; peaks above it are cut off</source>
        <translation>Ein fester Bereich hält Diagramme vergleichbar; Spitzen darüber werden abgeschnitten</translation></message>
    <message><source>Range of the currents</source>
        <translation>Bereich der Ströme</translation></message>
    <message><source>La&amp;yout</source>
        <translation>La&amp;yout</translation></message>
    <message><source>&amp;Reset layout</source>
        <translation>Layout &amp;zurücksetzen</translation></message>
    <message><source>Time shown</source>
        <translation>Angezeigte Zeit</translation></message>
    <message><source>Pa&amp;use</source>
        <translation>&amp;Pause</translation></message>
    <message><source>Hold pea&amp;ks</source>
        <translation>&amp;Spitzen halten</translation></message>
    <message><source>&amp;Colours</source>
        <translation>Fa&amp;rben</translation></message>
    <message><source>Show the &amp;last</source>
        <translation>Die &amp;letzten</translation></message>
    <message><source>automatic</source>
        <translation>automatisch</translation></message>
    <message><source>Ran&amp;ge</source>
        <translation>Be&amp;reich</translation></message>
    <message><source>From now on, show the highest value of each curve as a line and in the table</source>
        <translation>Den höchsten Wert jeder Kurve ab jetzt halten, als Linie und als Zahl</translation></message>
    <message><source>Back to li&amp;ve</source>
        <translation>Zurück zu Li&amp;ve</translation></message>
    <message><source>Left and Right move the cursor, with Shift in large steps. The values at the cursor are read out here. M sets a mark, Plus and Minus zoom, and L returns to the live view.</source>
        <translation>Links und Rechts bewegen den Cursor, mit Umschalt in großen Schritten; seine Werte werden hier vorgelesen. M setzt eine Marke, Plus und Minus zoomen, L geht zurück zu Live.</translation></message>
    <message><source>Plot of currents and speeds against time</source>
        <translation>Diagramm der Ströme und Geschwindigkeiten über der Zeit</translation></message>
    <message><source>No data yet</source>
        <translation>Noch keine Daten</translation></message>
    <message><source>Also show the requests that the program repeats many times a second</source>
        <translation>Auch die Anfragen anzeigen, die das Programm viele Male pro Sekunde wiederholt</translation></message>
    <message><source>Remove all rows</source>
        <translation>Alle Zeilen entfernen</translation></message>
    <message><source>No row matches the search.</source>
        <translation>Keine Zeile passt zur Suche.</translation></message>
    <message><source>No faults so far.</source>
        <translation>Bisher keine Fehler.</translation></message>
    <message><source>Save the traffic log</source>
        <translation>Datenverkehrsprotokoll speichern</translation></message>
    <message><source>Text (*.txt *.tsv)</source>
        <translation>Text (*.txt *.tsv)</translation></message>
    <message numerus="yes"><source>{0} row(s) written to {1}.</source>
        <translation><numerusform>{0} Zeile in {1} geschrieben.</numerusform><numerusform>{0} Zeilen in {1} geschrieben.</numerusform></translation></message>
    <message><source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation></message>
    <message><source>Copy as &amp;Python</source>
        <translation>Als &amp;Python kopieren</translation></message>
    <message><source>Copy as &amp;Arduino sketch</source>
        <translation>Als &amp;Arduino-Sketch kopieren</translation></message>
    <message><source>Sa&amp;ve as text…</source>
        <translation>Als Te&amp;xt speichern…</translation></message>
    <message numerus="yes"><source>%n fault(s)</source>
        <translation><numerusform>%n Fehler</numerusform><numerusform>%n Fehler</numerusform></translation></message>
    <message><source>no faults</source>
        <translation>keine Fehler</translation></message>
    <message><source>polling hidden</source>
        <translation>Abfrage ausgeblendet</translation></message>
    <message><source>paused</source>
        <translation>angehalten</translation></message>
    <message><source>No traffic yet. While {0} is connected, this page lists every byte on the line and its meaning.</source>
        <translation>Noch kein Datenverkehr. Solange {0} verbunden ist, listet diese Seite jedes Byte auf der Leitung und seine Bedeutung auf.</translation></message>
    <message><source>No rows to save.</source>
        <translation>Keine Zeilen zum Speichern.</translation></message>
    <message><source>&amp;Show polling</source>
        <translation>Abf&amp;rage anzeigen</translation></message>
    <message><source>O&amp;nly faults</source>
        <translation>&amp;Nur Fehler</translation></message>
    <message><source>Show only failed transactions and line errors</source>
        <translation>Nur fehlgeschlagene Transaktionen und Leitungsfehler anzeigen</translation></message>
    <message><source>Stop adding rows; the traffic is still logged</source>
        <translation>Vorerst keine Zeilen hinzufügen; der Datenverkehr wird weiter protokolliert</translation></message>
    <message><source>events lost: {0}</source>
        <translation>verlorene Ereignisse: {0}</translation></message>
    <message><source>Send &amp;bytes</source>
        <translation>B&amp;ytes senden</translation></message>
    <message><source>Send these bytes unchanged (Enter)</source>
        <translation>Diese Bytes unverändert senden (Enter)</translation></message>
    <message><source>Bytes t&amp;o send:</source>
        <translation>&amp;Zu sendende Bytes:</translation></message>
    <message><source>Sent</source>
        <translation>Gesendet</translation></message>
    <message><source>Received</source>
        <translation>Empfangen</translation></message>
    <message><source>Took (ms)</source>
        <translation>Dauer (ms)</translation></message>
    <message><source>Meaning</source>
        <translation>Bedeutung</translation></message>
    <message><source>Traffic on the line</source>
        <translation>Datenverkehr auf der Leitung</translation></message>
    <message><source>Details of the selected row</source>
        <translation>Einzelheiten der ausgewählten Zeile</translation></message>
    <message><source>Select a row to see all its bytes.</source>
        <translation>Wählen Sie eine Zeile aus, um alle ihre Bytes zu sehen.</translation></message>
    <message numerus="yes"><source>took      {0:.1f} ms; %n byte(s) take {1:.1f} ms at this baud rate</source>
        <translation><numerusform>Dauer     {0:.1f} ms; %n Byte braucht {1:.1f} ms bei dieser Baudrate</numerusform><numerusform>Dauer     {0:.1f} ms; %n Bytes brauchen {1:.1f} ms bei dieser Baudrate</numerusform></translation></message>
    <message><source>Fault: {0}</source>
        <translation>Fehler: {0}</translation></message>
    <message><source>sent      {0}</source>
        <translation>gesendet  {0}</translation></message>
    <message><source>received  {0}</source>
        <translation>empfangen {0}</translation></message>
    <message><source>Columns</source>
        <translation>Spalten</translation></message>
    <message><source>Rows</source>
        <translation>Zeilen</translation></message>
    <message><source>{0} is still being saved. Close without waiting? Changes may be lost.</source>
        <translation>{0} wird noch gespeichert. Ohne zu warten schließen? Änderungen können verloren gehen.</translation></message>
    <message><source>Text files (*.txt);;All files (*)</source>
        <translation>Textdateien (*.txt);;Alle Dateien (*)</translation></message>
    <message><source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation></message>
    <message><source>Changed on disk</source>
        <translation>Auf dem Datenträger geändert</translation></message>
    <message><source>Still saving</source>
        <translation>Speichern läuft noch</translation></message>
    <message><source>Rewrite the file</source>
        <translation>Datei neu schreiben</translation></message>
    <message><source>Replace the file</source>
        <translation>Datei ersetzen</translation></message>
    <message><source>{0} was changed by another program since it was opened here. Overwrite those changes?</source>
        <translation>{0} wurde von einem anderen Programm geändert, seit die Datei hier geöffnet wurde. Sollen diese Änderungen überschrieben werden?</translation></message>
    <message><source>The changes cannot be merged into the text of the file: {0}.

Rewrite the file from the settings? Its comments will be lost.</source>
        <translation>Die Änderungen lassen sich nicht in den Text der Datei einfügen: {0}.

Soll die Datei aus den Einstellungen neu geschrieben werden? Ihre Kommentare gehen dabei verloren.</translation></message>
    <message><source>{0} {1} Replace it?</source>
        <translation>{0} {1} Ersetzen?</translation></message>
    <message><source>{0} has changes that are not saved. Save them?</source>
        <translation>{0} hat Änderungen, die nicht gespeichert sind. Sollen sie gespeichert werden?</translation></message>
    <message><source>already exists.</source>
        <translation>ist bereits vorhanden.</translation></message>
    <message><source>Error</source>
        <translation>Fehler</translation></message>
    <message><source>Information</source>
        <translation>Information</translation></message>
    <message><source>OK</source>
        <translation>OK</translation></message>
    <message><source>Not done</source>
        <translation>Nicht erledigt</translation></message>
    <message><source>Warning</source>
        <translation>Warnung</translation></message>
    <message><source>Reconnect</source>
        <translation>Neu verbinden</translation></message>
    <message><source>Stop them now</source>
        <translation>Jetzt stoppen</translation></message>
    <message><source>Connect with its settings</source>
        <translation>Mit seinen Einstellungen verbinden</translation></message>
    <message><source>Dismiss</source>
        <translation>Ausblenden</translation></message>
    <message><source>Copied</source>
        <translation>Kopiert</translation></message>
    <message><source>No message</source>
        <translation>Keine Meldung</translation></message>
    <message><source>All steps are done.</source>
        <translation>Alle Schritte sind erledigt.</translation></message>
    <message><source>Step {0} of {1}: {2}.</source>
        <translation>Schritt {0} von {1}: {2}.</translation></message>
    <message><source>Not done: {0}.</source>
        <translation>Nicht erledigt: {0}.</translation></message>
    <message numerus="yes"><source>%n line(s) copied.</source>
        <translation><numerusform>%n Zeile kopiert.</numerusform><numerusform>%n Zeilen kopiert.</numerusform></translation></message>
    <message><source>Internal error while processing this file ({0}).</source>
        <translation>Interner Fehler bei der Verarbeitung dieser Datei ({0}).</translation></message>
    <message><source>Internal error while recording ({0}). The recording has ended.</source>
        <translation>Interner Fehler beim Aufzeichnen ({0}). Die Aufzeichnung wurde beendet.</translation></message>
    <message><source>Internal error: the connection was closed.</source>
        <translation>Interner Fehler: Die Verbindung wurde geschlossen.</translation></message>
    <message><source>Device Number</source>
        <translation>Gerätenummer</translation></message>
    <message><source>The number that addresses this board in packets of the Pololu protocol. The board accepts compact packets whatever its number. Several boards on one line need different numbers.</source>
        <translation>Die Nummer, mit der Pakete des Pololu-Protokolls dieses Board ansprechen. Kompakte Pakete nimmt das Board unabhängig von seiner Nummer an. Mehrere Boards an einer Leitung brauchen verschiedene Nummern.</translation></message>
    <message><source>Required Channels</source>
        <translation>Erforderliche Kanäle</translation></message>
    <message><source>In RC mode, losing the signal of a required channel for more than 0.5 s puts the board into safe-start: the motors stop until the signal is back and the sticks are at neutral.</source>
        <translation>Im RC-Modus versetzt ein Signalausfall eines erforderlichen Kanals von mehr als 0,5 s das Board in den Safe-Start: Die Motoren stoppen, bis das Signal wieder da ist und die Knüppel in Neutralstellung sind.</translation></message>
    <message><source>Ignored Channels</source>
        <translation>Ignorierte Kanäle</translation></message>
    <message><source>An ignored channel is held at its neutral value, whatever is connected. Select the inputs that are not connected.</source>
        <translation>Ein ignorierter Kanal wird auf seinem Neutralwert gehalten, was auch immer angeschlossen ist. Wählen Sie die Eingänge aus, die nicht angeschlossen sind.</translation></message>
    <message><source>Reversed Channels</source>
        <translation>Umgekehrte Kanäle</translation></message>
    <message><source>Swaps forward and reverse of the selected channels.</source>
        <translation>Vertauscht vorwärts und rückwärts der ausgewählten Kanäle.</translation></message>
    <message><source>Parabolic Channels</source>
        <translation>Parabolische Kanäle</translation></message>
    <message><source>A parabolic channel responds gently near neutral and strongly near the ends (a parabola instead of a straight line).</source>
        <translation>Ein parabolischer Kanal reagiert nahe der Neutralstellung sanft und nahe den Enden stark (eine Parabel statt einer Geraden).</translation></message>
    <message><source>Motor 1 Deadband Brake PWM</source>
        <translation>Brems-PWM im Totbereich Motor 1</translation></message>
    <message><source>How hard the motor is braked while its channel is within the deadband: 100 % is a full brake, 0 lets the motor coast (inferred).</source>
        <translation>Wie stark der Motor gebremst wird, solange sein Kanal im Totbereich ist: 100 % ist volle Bremsung, bei 0 läuft der Motor aus (erschlossen).</translation></message>
    <message><source>Deadband Brake PWM</source>
        <translation>Brems-PWM im Totbereich</translation></message>
    <message><source>Motor 2 Deadband Brake PWM</source>
        <translation>Brems-PWM im Totbereich Motor 2</translation></message>
    <message><source>Serial Timeout</source>
        <translation>Serielles Timeout</translation></message>
    <message><source>The motors should stop when the board receives no byte for this long. It protects you when the computer or the cable fails. 0 switches it off. It may need UART-Error Shutdown (twin): leave that on.</source>
        <translation>Die Motoren sollten stoppen, wenn das Board so lange kein Byte empfängt. Das schützt Sie, wenn der Computer oder das Kabel versagt. 0 schaltet es aus. Vielleicht braucht es „Abschaltung bei UART-Fehlern“ (Zwilling): Lassen Sie diese an.</translation></message>
    <message><source>UART-Error Shutdown</source>
        <translation>Abschaltung bei UART-Fehlern</translation></message>
    <message><source>Whether a serial error (noise, wrong baud rate, malformed packet) stops the motors. The board still accepts commands. The next motor command starts them again (inferred). Switched off, it may disable the Serial Timeout, too (twin).</source>
        <translation>Ob ein serieller Fehler (Störung, falsche Baudrate, fehlerhaftes Paket) die Motoren stoppt. Das Board nimmt weiterhin Befehle an. Der nächste Motorbefehl startet sie wieder (erschlossen). Ist dies ausgeschaltet, ist vielleicht auch das serielle Timeout unwirksam (Zwilling).</translation></message>
    <message><source>The default of on is doubtful: public programs that send a stray byte with each command, or pause within a packet, would stutter with it.</source>
        <translation>Der Standardwert „ein“ ist zweifelhaft: Öffentliche Programme, die mit jedem Befehl ein überzähliges Byte senden oder innerhalb eines Pakets pausieren, würden damit stottern.</translation></message>
    <message><source>Motor 1 PWM Prescaler</source>
        <translation>PWM-Vorteiler Motor 1</translation></message>
    <message><source>Divides the clock of the motor's PWM. Together with PWM Maximum it sets the PWM frequency: lower frequencies whine and heat the motor, frequencies above the driver's rating heat the driver.</source>
        <translation>Teilt den Takt der PWM des Motors. Zusammen mit dem PWM-Maximum bestimmt er die PWM-Frequenz: Niedrigere Frequenzen pfeifen und erwärmen den Motor, Frequenzen über dem für den Treiber zulässigen Wert erwärmen den Treiber.</translation></message>
    <message><source>PWM Prescaler</source>
        <translation>PWM-Vorteiler</translation></message>
    <message><source>clock / 8</source>
        <translation>Takt / 8</translation></message>
    <message><source>clock / 64</source>
        <translation>Takt / 64</translation></message>
    <message><source>clock / 256</source>
        <translation>Takt / 256</translation></message>
    <message><source>clock / 1024</source>
        <translation>Takt / 1024</translation></message>
    <message><source>Motor 2 PWM Prescaler</source>
        <translation>PWM-Vorteiler Motor 2</translation></message>
    <message><source>Motor 1 PWM Maximum</source>
        <translation>PWM-Maximum Motor 1</translation></message>
    <message><source>The value at which the PWM counter starts again. Together with the prescaler it sets the PWM frequency: a smaller maximum gives a higher frequency.</source>
        <translation>Der Wert, bei dem der PWM-Zähler wieder von vorn beginnt. Zusammen mit dem Vorteiler bestimmt er die PWM-Frequenz: Ein kleineres Maximum ergibt eine höhere Frequenz.</translation></message>
    <message><source>PWM Maximum</source>
        <translation>PWM-Maximum</translation></message>
    <message><source>Motor 2 PWM Maximum</source>
        <translation>PWM-Maximum Motor 2</translation></message>
    <message><source>Auxiliary Motor PWM Maximum</source>
        <translation>PWM-Maximum Hilfsmotor</translation></message>
    <message><source>The value at which the PWM counter starts again: a smaller maximum gives a higher PWM frequency. No parameter sets the prescaler of this motor.</source>
        <translation>Der Wert, bei dem der PWM-Zähler wieder von vorn beginnt: Ein kleineres Maximum ergibt eine höhere PWM-Frequenz. Kein Parameter stellt den Vorteiler dieses Motors ein.</translation></message>
    <message><source>Motor 1 Acceleration</source>
        <translation>Beschleunigung Motor 1</translation></message>
    <message><source>How fast the speed may grow after an accelerate command, in speed steps (of 127) per 100 ms. 0 means at once. Slowing down in the same direction has no ramp.</source>
        <translation>Wie schnell die Geschwindigkeit nach einem Beschleunigungsbefehl zunehmen darf, in Geschwindigkeitsstufen (von 127) je 100 ms. 0 bedeutet sofort. Das Verlangsamen in derselben Richtung hat keine Rampe.</translation></message>
    <message><source>no ramp</source>
        <translation>keine Rampe</translation></message>
    <message><source>Acceleration</source>
        <translation>Beschleunigung</translation></message>
    <message><source>Motor 2 Acceleration</source>
        <translation>Beschleunigung Motor 2</translation></message>
    <message><source>Auxiliary Motor Acceleration</source>
        <translation>Beschleunigung Hilfsmotor</translation></message>
    <message><source>How fast the auxiliary motor may speed up after an accelerate command, in speed steps (of 127) per 100 ms. 0 means at once.</source>
        <translation>Wie schnell der Hilfsmotor nach einem Beschleunigungsbefehl schneller werden darf, in Geschwindigkeitsstufen (von 127) je 100 ms. 0 bedeutet sofort.</translation></message>
    <message><source>Motor 1 Brake Duration</source>
        <translation>Bremsdauer Motor 1</translation></message>
    <message><source>How long the motor is fully braked before an accelerate command reverses it.</source>
        <translation>Wie lange der Motor voll gebremst wird, bevor ein Beschleunigungsbefehl seine Richtung umkehrt.</translation></message>
    <message><source>no braking</source>
        <translation>kein Bremsen</translation></message>
    <message><source>Brake Duration</source>
        <translation>Bremsdauer</translation></message>
    <message><source>Motor 2 Brake Duration</source>
        <translation>Bremsdauer Motor 2</translation></message>
    <message><source>Motor 1 Current Limit</source>
        <translation>Stromgrenze Motor 1</translation></message>
    <message><source>Above this current the board lowers the motor's speed and latches an over-limit bit. Use accelerate commands with it: set commands bypass it for a moment. 0 switches it off (twin). Measured currents may be off by 20 % (twin). It has no effect in joint mode.</source>
        <translation>Über diesem Strom verringert das Board die Geschwindigkeit des Motors und setzt ein Überstrom-Bit, das gesetzt bleibt. Verwenden Sie dazu Beschleunigungsbefehle: Befehle, die sofort setzen, umgehen die Begrenzung für einen Augenblick. 0 schaltet sie aus (Zwilling). Das Board misst Ströme vielleicht um 20 % falsch (Zwilling). Im Parallelbetrieb hat sie keine Wirkung.</translation></message>
    <message><source>Current Limit</source>
        <translation>Stromgrenze</translation></message>
    <message><source>Motor 2 Current Limit</source>
        <translation>Stromgrenze Motor 2</translation></message>
    <message><source>Motor 1 Current Limit Proportionality Constant P</source>
        <translation>Proportionalfaktor P der Stromgrenze Motor 1</translation></message>
    <message><source>How strongly the limiter responds to each count above the limit. A large value reacts fast but may make the motor pulse (inferred).</source>
        <translation>Wie stark die Strombegrenzung auf jeden Count über der Grenze reagiert. Ein großer Wert reagiert schnell, kann den Motor aber pulsieren lassen (erschlossen).</translation></message>
    <message><source>Current Limit Proportionality Constant P</source>
        <translation>Proportionalfaktor P der Stromgrenze</translation></message>
    <message><source>Motor 2 Current Limit Proportionality Constant P</source>
        <translation>Proportionalfaktor P der Stromgrenze Motor 2</translation></message>
    <message><source>Enable UART Response Delay</source>
        <translation>UART-Antwortverzögerung einschalten</translation></message>
    <message><source>Makes the board wait 1 ms before it replies, for computers that switch slowly from sending to receiving.</source>
        <translation>Lässt das Board vor jeder Antwort 1 ms warten, für Computer, die langsam vom Senden auf Empfangen umschalten.</translation></message>
    <message><source>1 ms</source>
        <translation>1 ms</translation></message>
    <message><source>Motor Mode</source>
        <translation>Motormodus</translation></message>
    <message><source>Independent: two motors. Joint: both drivers together drive one stronger motor as motor 1, without current sensing and mixing.</source>
        <translation>Unabhängig: zwei Motoren. Parallelbetrieb: Beide Treiber zusammen treiben als Motor 1 einen stärkeren Motor an, ohne Strommessung und ohne Mischer.</translation></message>
    <message><source>independent</source>
        <translation>unabhängig</translation></message>
    <message><source>joint</source>
        <translation>Parallelbetrieb</translation></message>
    <message><source>Channel Input Source</source>
        <translation>Eingangsquelle der Kanäle</translation></message>
    <message><source>Whether the five inputs are read as RC pulses or as voltages while the board is in serial mode. In RC and analog mode the jumper decides.</source>
        <translation>Ob die fünf Eingänge als RC-Impulse oder als Spannungen gelesen werden, solange das Board im seriellen Modus ist. In den Modi RC und Analog entscheidet der Jumper.</translation></message>
    <message><source>CRC-7 Polynomial</source>
        <translation>CRC-7-Polynom</translation></message>
    <message><source>The polynomial of the checksum after every packet, used when CRC-7 is chosen in the UART settings. Its top bit is always 1.</source>
        <translation>Das Polynom der Prüfsumme nach jedem Paket; verwendet, wenn in den UART-Einstellungen CRC-7 gewählt ist. Sein höchstes Bit ist immer 1.</translation></message>
    <message><source>UART Settings</source>
        <translation>UART-Einstellungen</translation></message>
    <message><source>Baud rate, error detection (none, CRC-7 or parity) and stop bits of the serial line. A wrong setting makes the board unreachable until the program's settings match.</source>
        <translation>Baudrate, Fehlererkennung (keine, CRC-7 oder Parität) und Stoppbits der seriellen Leitung. Eine falsche Einstellung macht das Board unerreichbar, bis die Einstellungen des Programms dazu passen.</translation></message>
    <message><source>Reset All Parameters to Factory Defaults</source>
        <translation>Alle Parameter auf Werkseinstellungen zurücksetzen</translation></message>
    <message><source>Resets every parameter to its factory default at the next power cycle.</source>
        <translation>Setzt beim nächsten Aus- und Einschalten alle Parameter auf ihre Werkseinstellungen zurück.</translation></message>
</context>
</TS>
