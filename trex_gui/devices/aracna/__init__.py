"""Aracna, an eight-motor quadruped with a text protocol.

Ref: wiki page "Communication Protocol" of 22 Sep 2012, and the published firmware
(CreativeMachinesLab/aracna, 2015), which has priority.
"""
