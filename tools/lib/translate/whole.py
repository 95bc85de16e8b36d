"""tools/pick whole: files of the library with all that they include, as one."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from translate.single_file import command as single_file
from translate.wgsl import command as wgsl


def main(arguments: Sequence[str]) -> int:
    """WGSL is translated, and has options of its own. In other languages the text stays as it is."""
    parser = argparse.ArgumentParser(prog="tools/pick whole", add_help=False)
    parser.add_argument("--language")
    given, others = parser.parse_known_args(arguments)
    return wgsl.main(others) if given.language == "wgsl" else single_file.main(arguments)
