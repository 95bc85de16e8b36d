"""Starts what tools/measure measures by any Python that is new enough: command.py NAME [options]."""

import importlib
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the tree stays clean: no __pycache__ beside the sources
sys.path[0] = str(Path(__file__).resolve().parents[1])

from base import needs  # noqa: E402

needs.python()

folder = Path(__file__).resolve().parent / sys.argv[1]
sys.exit(importlib.import_module(f"measure.{sys.argv[1]}{'.command' * folder.is_dir()}").main(sys.argv[2:]))
