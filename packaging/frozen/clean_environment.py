"""Runtime hook that restores the library path for child processes."""

import os

_CURRENT = "LD_LIBRARY_PATH"  # set by the loader; the system has read it before this hook runs
_ORIGINAL = f"{_CURRENT}_ORIG"  # value of the user, saved by the loader

if _ORIGINAL in os.environ:
    os.environ[_CURRENT] = os.environ.pop(_ORIGINAL)
else:
    os.environ.pop(_CURRENT, None)
