<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
<context>
    <name>Apply</name>
    <message numerus="yes">
        <source>Apply of %n setting(s)</source>
        <translation>
            <numerusform>Apply of %n setting</numerusform>
            <numerusform>Apply of %n settings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DefaultsDialog</name>
    <message numerus="yes">
        <source>Review %n change(s)…</source>
        <translation>
            <numerusform>Review %n change…</numerusform>
            <numerusform>Review %n changes…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LearnDialog</name>
    <message numerus="yes">
        <source>Learn channel(s) {0} again</source>
        <translation>
            <numerusform>Learn channel {0} again</numerusform>
            <numerusform>Learn channels {0} again</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ParametersPage</name>
    <message numerus="yes">
        <source>%n pending change(s): click Apply settings to write.</source>
        <translation>
            <numerusform>%n pending change: click Apply settings to write.</numerusform>
            <numerusform>%n pending changes: click Apply settings to write.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) written and verified.</source>
        <translation>
            <numerusform>%n setting written and verified.</numerusform>
            <numerusform>%n settings written and verified.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReviewDialog</name>
    <message numerus="yes">
        <source>Write %n setting(s)</source>
        <translation>
            <numerusform>Write %n setting</numerusform>
            <numerusform>Write %n settings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) written and verified.</source>
        <translation>
            <numerusform>%n setting written and verified.</numerusform>
            <numerusform>%n settings written and verified.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) of the {0} will change.</source>
        <translation>
            <numerusform>%n setting of the {0} will change.</numerusform>
            <numerusform>%n settings of the {0} will change.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReviewPage</name>
    <message numerus="yes">
        <source>%n earlier pending edit(s) will be written, too.</source>
        <translation>
            <numerusform>%n earlier pending edit will be written, too.</numerusform>
            <numerusform>%n earlier pending edits will be written, too.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TrexWorkspace</name>
    <message numerus="yes">
        <source>%n setting(s) written and verified.</source>
        <translation>
            <numerusform>%n setting written and verified.</numerusform>
            <numerusform>%n settings written and verified.</numerusform>
        </translation>
    </message>
</context>
</TS>
