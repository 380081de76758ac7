<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
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
