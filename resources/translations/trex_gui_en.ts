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
    <name>CompareDialog</name>
    <message numerus="yes">
        <source>%n setting(s) differ, {0} match.</source>
        <translation>
            <numerusform>%n setting differs, {0} match.</numerusform>
            <numerusform>%n settings differ, {0} match.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&amp;Take %n value(s) into {0}</source>
        <translation>
            <numerusform>&amp;Take %n value into {0}</numerusform>
            <numerusform>&amp;Take %n values into {0}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) taken from {0}.</source>
        <translation>
            <numerusform>%n value taken from {0}.</numerusform>
            <numerusform>%n values taken from {0}.</numerusform>
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
    <name>Device</name>
    <message numerus="yes">
        <source>%n earlier change(s) still pending. Click Apply to write to this board.</source>
        <translation>
            <numerusform>%n earlier change still pending. Click Apply to write to this board.</numerusform>
            <numerusform>%n earlier changes still pending. Click Apply to write to this board.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DeviceScanner</name>
    <message numerus="yes">
        <source>%n board(s) found.</source>
        <translation>
            <numerusform>%n board found.</numerusform>
            <numerusform>%n boards found.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n port(s) could not be searched (internal error).</source>
        <translation>
            <numerusform>%n port could not be searched (internal error).</numerusform>
            <numerusform>%n ports could not be searched (internal error).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FindingsPanel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suggestion(s)</source>
        <translation>
            <numerusform>%n suggestion</numerusform>
            <numerusform>%n suggestions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>HistoryDialog</name>
    <message numerus="yes">
        <source>Permanently delete %n snapshot(s), the newest of {0}?</source>
        <translation>
            <numerusform>Permanently delete the snapshot of {0}?</numerusform>
            <numerusform>Permanently delete %n snapshots, the newest of {0}?</numerusform>
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
    <name>LoadDialog</name>
    <message numerus="yes">
        <source>{0}: %n change(s) pending; Apply settings writes them.</source>
        <translation>
            <numerusform>{0}: %n change is pending; Apply settings writes it.</numerusform>
            <numerusform>{0}: %n changes are pending; Apply settings writes them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&amp;Load %n change(s)</source>
        <translation>
            <numerusform>&amp;Load %n change</numerusform>
            <numerusform>&amp;Load %n changes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>NameModel</name>
    <message numerus="yes">
        <source>%n step(s), {0:g} s</source>
        <translation>
            <numerusform>%n step, {0:g} s</numerusform>
            <numerusform>%n steps, {0:g} s</numerusform>
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
    <name>Robot</name>
    <message numerus="yes">
        <source>Connected to Aracna: firmware {0}, %n motor(s).</source>
        <translation>
            <numerusform>Connected to Aracna: firmware {0}, %n motor.</numerusform>
            <numerusform>Connected to Aracna: firmware {0}, %n motors.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n time(s)</source>
        <translation>
            <numerusform>once</numerusform>
            <numerusform>%n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Playing %n step(s), {0}.</source>
        <translation>
            <numerusform>Playing %n step, {0}.</numerusform>
            <numerusform>Playing %n steps, {0}.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RobotPlaybackWindow</name>
    <message numerus="yes">
        <source>Aracna, firmware {0}, %n motor(s)</source>
        <translation>
            <numerusform>Aracna, firmware {0}, %n motor</numerusform>
            <numerusform>Aracna, firmware {0}, %n motors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SnapshotPane</name>
    <message numerus="yes">
        <source>%n setting(s) would be restored, {0} match.</source>
        <translation>
            <numerusform>%n setting would be restored, {0} match.</numerusform>
            <numerusform>%n settings would be restored, {0} match.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) not in the snapshot would stay.</source>
        <translation>
            <numerusform>%n setting that is not in the snapshot would stay as it is.</numerusform>
            <numerusform>%n settings that are not in the snapshot would stay as they are.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There is no other snapshot of a {0} to compare with. This one has %n setting(s).</source>
        <translation>
            <numerusform>There is no other snapshot of a {0} to compare with. This one has %n setting.</numerusform>
            <numerusform>There is no other snapshot of a {0} to compare with. This one has %n settings.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) differ, {0} match.</source>
        <translation>
            <numerusform>%n setting differs, {0} match.</numerusform>
            <numerusform>%n settings differ, {0} match.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) would become edits; nothing is written before Apply.</source>
        <translation>
            <numerusform>%n setting would become an edit; nothing is written before Apply.</numerusform>
            <numerusform>%n settings would become edits; nothing is written before Apply.</numerusform>
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
