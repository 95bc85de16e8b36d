"""What the tests of the tools share."""

from __future__ import annotations

import importlib.machinery
import importlib.util
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the tree stays clean: no __pycache__ beside the sources


def load_script(name: str):
    """A script of this folder as a module; its name has no suffix, so the loader must be named."""
    loader = importlib.machinery.SourceFileLoader(name, str(Path(__file__).resolve().parent / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    sys.modules[name] = module  # dataclasses look their module up by name
    loader.exec_module(module)
    return module
