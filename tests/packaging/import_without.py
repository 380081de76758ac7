"""Import the whole program while the modules named on the command line are missing."""

import importlib
import pkgutil
import sys
from importlib.machinery import ModuleSpec
from typing import Any

hidden = tuple(sys.argv[1:])


class Finder:
    """Import finder that does not find the hidden modules."""

    def __init__(self, finder: Any) -> None:
        self._finder = finder

    def find_spec(self, name: str, *arguments: Any) -> ModuleSpec | None:
        if name.startswith(tuple(f"{module}." for module in hidden)) or name in hidden:
            return None
        spec: ModuleSpec | None = self._finder.find_spec(name, *arguments)
        return spec


sys.meta_path[:] = [Finder(finder) for finder in sys.meta_path]
package = importlib.import_module("trex_gui")
names = [module.name for module in pkgutil.walk_packages(package.__path__, "trex_gui.")]
optional = ["mcap.writer", "pygame.display", "pygame.event", "pygame.joystick"]
for module in [*names, *optional]:
    if not module.endswith("__main__"):
        importlib.import_module(module)
