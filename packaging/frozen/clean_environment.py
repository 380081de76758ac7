"""Run first in the frozen programs: programs that they start get the user's own libraries."""

import os

_OURS = "LD_LIBRARY_PATH"  # set by the loader, and read by the system before this runs
_USERS = f"{_OURS}_ORIG"

if _USERS in os.environ:
    os.environ[_OURS] = os.environ.pop(_USERS)
else:
    os.environ.pop(_OURS, None)
