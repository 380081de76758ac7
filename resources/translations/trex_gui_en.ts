<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>trex_gui</name>
    <message numerus="yes"><source>%n time(s)</source>
        <translation><numerusform>once</numerusform><numerusform>%n times</numerusform></translation></message>
    <message numerus="yes"><source>Connected to Aracna: firmware {0}, %n motor(s).</source>
        <translation><numerusform>Connected to Aracna: firmware {0}, %n motor.</numerusform><numerusform>Connected to Aracna: firmware {0}, %n motors.</numerusform></translation></message>
    <message numerus="yes"><source>Clamped to the limits of the joints: %n step(s).</source>
        <translation><numerusform>Clamped to the limits of the joints: %n step.</numerusform><numerusform>Clamped to the limits of the joints: %n steps.</numerusform></translation></message>
    <message numerus="yes"><source>Playing %n step(s), {0}.</source>
        <translation><numerusform>Playing %n step, {0}.</numerusform><numerusform>Playing %n steps, {0}.</numerusform></translation></message>
    <message numerus="yes"><source>Aracna, firmware {0}, %n motor(s)</source>
        <translation><numerusform>Aracna, firmware {0}, %n motor</numerusform><numerusform>Aracna, firmware {0}, %n motors</numerusform></translation></message>
    <message numerus="yes"><source>%n step(s)</source>
        <translation><numerusform>%n step</numerusform><numerusform>%n steps</numerusform></translation></message>
    <message numerus="yes"><source>%n board(s) on this line.</source>
        <translation><numerusform>%n board on this line.</numerusform><numerusform>%n boards on this line.</numerusform></translation></message>
    <message numerus="yes"><source>%n unapplied edit(s) of the previous {0} saved. They are offered when that board is connected again.</source>
        <translation><numerusform>%n unapplied edit of the previous {0} saved. It is offered when that board is connected again.</numerusform><numerusform>%n unapplied edits of the previous {0} saved. They are offered when that board is connected again.</numerusform></translation></message>
    <message numerus="yes"><source>%n earlier change(s) still pending. Review them to write to this board.</source>
        <translation><numerusform>%n earlier change still pending. Review it to write to this board.</numerusform><numerusform>%n earlier changes still pending. Review them to write to this board.</numerusform></translation></message>
    <message numerus="yes"><source>%n edit(s) of the previous board saved. They return when that board is selected again.</source>
        <translation><numerusform>%n edit of the previous board saved. It returns when that board is selected again.</numerusform><numerusform>%n edits of the previous board saved. They return when that board is selected again.</numerusform></translation></message>
    <message numerus="yes"><source>and %n more packet(s)</source>
        <translation><numerusform>and %n more packet</numerusform><numerusform>and %n more packets</numerusform></translation></message>
    <message numerus="yes"><source>Apply of %n setting(s)</source>
        <translation><numerusform>Apply of %n setting</numerusform><numerusform>Apply of %n settings</numerusform></translation></message>
    <message numerus="yes"><source>&amp;Write to %n board(s)</source>
        <translation><numerusform>&amp;Write to %n board</numerusform><numerusform>&amp;Write to %n boards</numerusform></translation></message>
    <message numerus="yes"><source>%n setting(s)</source>
        <translation><numerusform>%n setting</numerusform><numerusform>%n settings</numerusform></translation></message>
    <message numerus="yes"><source>Written to %n board(s).</source>
        <translation><numerusform>Written to %n board.</numerusform><numerusform>Written to %n boards.</numerusform></translation></message>
    <message numerus="yes"><source>%n board(s) left out; see the Result column.</source>
        <translation><numerusform>%n board left out; see the Result column.</numerusform><numerusform>%n boards left out; see the Result column.</numerusform></translation></message>
    <message numerus="yes"><source>{0}: %n change(s) pending. Review them, then write.</source>
        <translation><numerusform>{0}: %n change is pending. Review it, then write.</numerusform><numerusform>{0}: %n changes are pending. Review them, then write.</numerusform></translation></message>
    <message numerus="yes"><source>%n setting(s) differ, {0} match.</source>
        <translation><numerusform>%n setting differs, {0} match.</numerusform><numerusform>%n settings differ, {0} match.</numerusform></translation></message>
    <message numerus="yes"><source>&amp;Load %n change(s)</source>
        <translation><numerusform>&amp;Load %n change</numerusform><numerusform>&amp;Load %n changes</numerusform></translation></message>
    <message numerus="yes"><source>&amp;Copy %n value(s) to {0}</source>
        <translation><numerusform>&amp;Copy %n value to {0}</numerusform><numerusform>&amp;Copy %n values to {0}</numerusform></translation></message>
    <message numerus="yes"><source>%n value(s) copied from {0}.</source>
        <translation><numerusform>%n value copied from {0}.</numerusform><numerusform>%n values copied from {0}.</numerusform></translation></message>
    <message numerus="yes"><source>Write %n setting(s) to the board</source>
        <translation><numerusform>Write %n setting to the board</numerusform><numerusform>Write %n settings to the board</numerusform></translation></message>
    <message numerus="yes"><source>%n setting(s) written and verified.</source>
        <translation><numerusform>%n setting written and verified.</numerusform><numerusform>%n settings written and verified.</numerusform></translation></message>
    <message numerus="yes"><source>&amp;Write %n setting(s)</source>
        <translation><numerusform>&amp;Write %n setting</numerusform><numerusform>&amp;Write %n settings</numerusform></translation></message>
    <message numerus="yes"><source>%n count(s)</source>
        <translation><numerusform>%n count</numerusform><numerusform>%n counts</numerusform></translation></message>
    <message numerus="yes"><source>and %n more</source>
        <translation><numerusform>and %n more</numerusform><numerusform>and %n more</numerusform></translation></message>
    <message numerus="yes"><source>Permanently delete %n snapshot(s), the newest from {0}?</source>
        <translation><numerusform>Permanently delete the snapshot from {0}?</numerusform><numerusform>Permanently delete %n snapshots, the newest from {0}?</numerusform></translation></message>
    <message numerus="yes"><source>%n earlier pending edit(s) will also be written.</source>
        <translation><numerusform>%n earlier pending edit will also be written.</numerusform><numerusform>%n earlier pending edits will also be written.</numerusform></translation></message>
    <message numerus="yes"><source>Review %n ch&amp;ange(s)…</source>
        <translation><numerusform>Review %n ch&amp;ange…</numerusform><numerusform>Review %n ch&amp;anges…</numerusform></translation></message>
    <message numerus="yes"><source>Edited earlier but not applied: %n setting(s) of this {0} ({1}). Restore them as pending edits?</source>
        <translation><numerusform>Edited earlier but not applied: %n setting of this {0} ({1}). Restore it as a pending edit?</numerusform><numerusform>Edited earlier but not applied: %n settings of this {0} ({1}). Restore them as pending edits?</numerusform></translation></message>
    <message numerus="yes"><source>%n setting(s) of this {0} differ from the last applied values ({1}). They were lost or changed by another program, or this is another board.</source>
        <translation><numerusform>%n setting of this {0} differs from the last applied value ({1}). It was lost or changed by another program, or this is another board.</numerusform><numerusform>%n settings of this {0} differ from the last applied values ({1}). They were lost or changed by another program, or this is another board.</numerusform></translation></message>
    <message numerus="yes"><source>%n robot(s) stopped.</source>
        <translation><numerusform>%n robot stopped.</numerusform><numerusform>%n robots stopped.</numerusform></translation></message>
    <message numerus="yes"><source>“Next” adds %n change(s). Nothing is written until you apply the changes.</source>
        <translation><numerusform>“Next” adds %n change. Nothing is written until you apply the change.</numerusform><numerusform>“Next” adds %n changes. Nothing is written until you apply the changes.</numerusform></translation></message>
    <message numerus="yes"><source>&amp;Restore %n setting(s)…</source>
        <translation><numerusform>&amp;Restore %n setting…</numerusform><numerusform>&amp;Restore %n settings…</numerusform></translation></message>
    <message numerus="yes"><source>%n board(s) found.</source>
        <translation><numerusform>%n board found.</numerusform><numerusform>%n boards found.</numerusform></translation></message>
    <message numerus="yes"><source>%n problem(s) active now</source>
        <translation><numerusform>%n problem active now</numerusform><numerusform>%n problems active now</numerusform></translation></message>
    <message numerus="yes"><source>%n time(s), last at {0:%H:%M:%S}</source>
        <translation><numerusform>%n time, at {0:%H:%M:%S}</numerusform><numerusform>%n times, last at {0:%H:%M:%S}</numerusform></translation></message>
    <message numerus="yes"><source>%n sample(s) lost: the disk is too slow</source>
        <translation><numerusform>%n sample lost: the disk is too slow</numerusform><numerusform>%n samples lost: the disk is too slow</numerusform></translation></message>
    <message numerus="yes"><source>{0} sample(s) written to {1}.</source>
        <translation><numerusform>{0} sample written to {1}.</numerusform><numerusform>{0} samples written to {1}.</numerusform></translation></message>
    <message numerus="yes"><source>{0} row(s) written to {1}.</source>
        <translation><numerusform>{0} row written to {1}.</numerusform><numerusform>{0} rows written to {1}.</numerusform></translation></message>
    <message numerus="yes"><source>%n fault(s)</source>
        <translation><numerusform>%n fault</numerusform><numerusform>%n faults</numerusform></translation></message>
    <message numerus="yes"><source>took      {0:.1f} ms; %n byte(s) take {1:.1f} ms at this baud rate</source>
        <translation><numerusform>took      {0:.1f} ms; %n byte takes {1:.1f} ms at this baud rate</numerusform><numerusform>took      {0:.1f} ms; %n bytes take {1:.1f} ms at this baud rate</numerusform></translation></message>
    <message numerus="yes"><source>%n line(s) copied.</source>
        <translation><numerusform>%n line copied.</numerusform><numerusform>%n lines copied.</numerusform></translation></message>
</context>
</TS>
