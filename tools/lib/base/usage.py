"""Refusals of wrong arguments: status 2, and one line that has the nearest right name."""

from __future__ import annotations

import argparse
import difflib
import re
from collections.abc import Iterable, Sequence
from typing import NoReturn

NO_CHOICE = re.compile(r"invalid choice: '(?P<word>.*?)' \(choose from (?P<names>.*)\)$")


def near(word: str, names: Iterable[str]) -> str:
    """" (did you mean --zip?)", or nothing."""
    bare = {name.lstrip("-"): name for name in names}  # dashes are alike in all
    found = difflib.get_close_matches(word.lstrip("-"), bare, 1)
    return f" (did you mean {bare[found[0]]}?)" if found else ""


def whole(text: str, least: int = 1) -> int:
    """An argument that is a whole number from the least on."""
    if not text.isdecimal() or int(text) < least:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from {least} on")
    return int(text)


class Parser(argparse.ArgumentParser):
    """Of the options of a command. Its description is printed as it is."""

    def __init__(self, command: str, description: str):
        super().__init__(prog=command, description=description,
                         formatter_class=lambda prog: argparse.RawDescriptionHelpFormatter(prog, width=120))

    def error(self, message: str) -> NoReturn:
        if choice := NO_CHOICE.search(message):
            message += near(choice["word"], re.findall(r"[^\s',]+", choice["names"]))
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")

    def parse_args(self, args: Sequence[str] | None = None, namespace: argparse.Namespace | None = None):
        given, left = self.parse_known_args(args, namespace)
        for word in left:
            option = word.partition("=")[0]
            if option.startswith("-"):
                known = [name for action in self._actions for name in action.option_strings]
                self.error(f"there is no option {option}{near(option, known)}")
            self.error(f"{word} is one word too many")
        return given
