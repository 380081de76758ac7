"""Aracna: a four-legged robot with eight motors and a text protocol.

Ref: wiki page "Communication Protocol" of 22 Sep 2012; published firmware
(CreativeMachinesLab/aracna, 2015). Where they differ, the firmware takes precedence.
"""
