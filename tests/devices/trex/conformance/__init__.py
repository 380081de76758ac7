"""Conformance of the simulated board to the vendor's documentation, with a test for each sentence.

Expected values come only from the documents. The CRC is calculated by `oracle`. The docstring of a
test names its source and the facts that are only inferred. `trex.py` has the board under test, and
`harnesses.py` has the two ways to connect it.

Sources: CMD10 is the TReX 1.0 command documentation. F and FV are forum threads, MH is the manual
and C-SHARP is the companion program of the vendor.
"""
