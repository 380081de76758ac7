"""Scripts of `packaging/` that import each other."""

import importlib
import sys
from types import ModuleType
from unittest.mock import patch

from tests.support.scripts import PACKAGING


def import_script(name: str) -> ModuleType:
    with patch.object(sys, "path", [str(PACKAGING), *sys.path]):
        return importlib.import_module(name)
