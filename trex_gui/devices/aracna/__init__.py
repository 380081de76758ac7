"""Aracna, an eight-motor quadruped with a text protocol.

Facts come from the wiki page "Communication Protocol" of 22 Sep 2012 and from the published
firmware (CreativeMachinesLab/aracna, 2015); where they differ, the firmware counts.
"""
