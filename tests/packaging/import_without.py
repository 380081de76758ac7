"""Import the whole program while the modules named on the command line are missing."""

import importlib
import pkgutil
import sys
from typing import Any

hidden: dict[str, Any] = dict.fromkeys(sys.argv[1:])
sys.modules.update(hidden)  # importing them fails
package = importlib.import_module("trex_gui")
names = [module.name for module in pkgutil.walk_packages(package.__path__, "trex_gui.")]
optional = ["mcap.writer", "pygame.display", "pygame.event", "pygame.joystick"]
for module in [*names, *optional]:
    if not module.endswith("__main__"):
        importlib.import_module(module)
