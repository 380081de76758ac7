"""Aracna, an eight-motor quadruped with a text protocol: the second device, the same layers.

Facts and their sources: the wiki page "Communication Protocol" of 22 Sep 2012, and what the
published firmware (CreativeMachinesLab/aracna, 2015) really does where the two differ.
"""
