"""Scripts of `packaging/`, loaded by path because a library is called `packaging` too."""

import importlib.util
import sys
from functools import cache
from pathlib import Path
from types import ModuleType

from trex_gui.core.resource_files import resource

PACKAGING = Path(__file__).parents[2] / "packaging"


def load_script(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"trex_{name}", PACKAGING / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look up their module
    spec.loader.exec_module(module)
    return module


@cache
def program_texts() -> frozenset[tuple[str, str]]:
    """Return each translatable text of the program, and its comment."""
    texts = load_script("translations").read(resource("translations") / "trex_gui_de.ts")
    return frozenset((text.source, text.comment) for text in texts)
