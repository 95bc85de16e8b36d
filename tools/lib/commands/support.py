"""Here is what the tests of the commands share."""

from __future__ import annotations

import importlib.machinery
import importlib.util
import sys

from tree import TOOLS


def load_script(name: str):
    """A command as a module; its name has no suffix, so the loader must be named."""
    loader = importlib.machinery.SourceFileLoader(name, str(TOOLS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    sys.modules[name] = module  # dataclasses look their module up by name
    loader.exec_module(module)
    return module
