"""Serial protocol of the TReX: pure functions, frozen data and parsers. No I/O, clock or Qt."""
