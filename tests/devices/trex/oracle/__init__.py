"""A second reading of the serial protocol, from the maker's documents alone.

Nothing in framing, remapping and device may import from `trex_gui`: they are here to disagree.
"""
