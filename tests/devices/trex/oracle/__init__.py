"""Second implementation of the serial protocol, written only from the documents of Pololu.

`framing`, `remapping` and `device` must not import from `trex_gui`, so that errors show as
differences.
"""
