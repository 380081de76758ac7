"""Say which boards store what a file says: python audit.py FILE PORT ...

The exit code is 1 if one does not, or does not reply.
"""

import sys

from trex_gui import StudioError, Trex

is_right = True
for port in sys.argv[2:]:
    try:
        with Trex(port) as trex:
            differing = trex.compare_settings(sys.argv[1])
    except StudioError as error:
        is_right = False
        print(f"{port}: {error}")
        continue
    is_right = is_right and not differing
    print(f"{port}: {', '.join(row.key for row in differing) or 'as the file'}")
sys.exit(not is_right)
