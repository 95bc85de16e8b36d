"""Commands that make a text of glsl/hashnoise/ have this in common: the names of files, of the user's functions and of
modules, the options for the knobs, and where the text goes."""

from __future__ import annotations

import argparse
import difflib
import errno
import os
import re
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from translate.settings import GRADIENTS, HASHES

ARITHMETICS = ("fast", "fixed", "precise")
IMPORT_PATH_HELP = "for Bevy and naga_oil: write #define_import_path NAME, so that #import NAME::hn_fbm2 finds it"


def import_path(text: str) -> str:
    if not re.fullmatch(r"[A-Za-z_]\w*(::[A-Za-z_]\w*)*", text):
        raise argparse.ArgumentTypeError("an import path is made of names with :: between them, such as game::noise, "
                                         f"not {text!r}")
    return text


def imported_as(path: str) -> str:
    """How a module begins that others import by that path, if there is one."""
    return f"#define_import_path {path}\n\n" if path else ""


def function_name(text: str) -> str:
    if not re.fullmatch(r"[A-Za-z_]\w*", text):
        raise argparse.ArgumentTypeError(f"a function has a name such as my_hash, not {text!r}")
    return text


def word(before: str) -> Callable[[str], str]:
    """An argument in lower case: fixed of Fixed, or of HN_FIXED, the library's name."""
    return lambda text: text.lower().removeprefix(before)


def add_options(parser: argparse.ArgumentParser, possible: Sequence[str], default: str | None, help_: str) -> None:
    """The options for the knobs. A command gives a reason when it refuses an arithmetic that is not possible."""
    hashes, gradients = (tuple(map(str.lower, names)) for names in (HASHES, GRADIENTS))
    parser.add_argument("--arithmetic", type=word("hn_"), choices=ARITHMETICS, default=default,
                        metavar=f"{{{','.join(map(word('hn_'), possible))}}}", help=help_)
    parser.add_argument("--hash", type=word("hn_hash_"), choices=hashes, default="lattice", metavar="NAME",
                        help=f"{', '.join(hashes)} (default: %(default)s)")
    parser.add_argument("--hash-function", metavar="NAME", type=function_name,
                        help="with --hash custom: your function, which takes and returns a uint")
    parser.add_argument("--gradient", type=word("hn_gradient_"), choices=gradients, default="octahedral",
                        help="default: %(default)s")


def check_name(parser: argparse.ArgumentParser, name: str, library: Path) -> None:
    """Refuses a name that is no file of the library, and suggests the nearest."""
    names = sorted(path.name for path in library.glob("*.glsl"))
    if name in names:
        return
    if f"{name}.glsl" in names:
        near = [f"{name}.glsl"]
    else:
        near = difflib.get_close_matches(name, names)
    hint = f"did you mean {' or '.join(near)}?" if near else f"there are: {', '.join(names) or 'no files'}"
    parser.error(f"there is no {name} in {library.name}/; {hint}")


def write(parser: argparse.ArgumentParser, text: str, out: Path | None) -> None:
    """To standard output, or into a file, whose folder is made if it is not there, and whose path is printed. The exit
    status is 2 if that is not possible."""
    if out is None:
        _print(parser, text)
        return
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(text, encoding="ascii")
    except OSError as error:
        parser.error(f"cannot write {out}: {error.strerror}")
    _print(parser, f"{out}\n")


def _print(parser: argparse.ArgumentParser, text: str) -> None:
    """All of it: a full disk shows when the buffer is written, which Python else does behind the last statement."""
    try:
        if sys.stdout is None:  # closed by the shell
            raise OSError(errno.EBADF, os.strerror(errno.EBADF))
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        if sys.stdout is not None:  # the rest goes nowhere, so that Python does not try again
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        parser.exit(2, f"{parser.prog}: cannot write the standard output: {error.strerror}\n")
