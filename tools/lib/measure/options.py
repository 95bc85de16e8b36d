"""Options of the names of tools/measure that are Python: one line refuses bad usage, with the nearest right option."""

import argparse
import difflib
import re

UNKNOWN = re.compile(r"unrecognized arguments: (--[^\s=]+)")
NO_CHOICE = re.compile(r"invalid choice: '(?P<word>.*?)' \(choose from (?P<names>.*)\)$")


class Parser(argparse.ArgumentParser):
    def __init__(self, name: str, description: str | None):
        super().__init__(prog=f"tools/measure {name}", description=description,
                         formatter_class=argparse.RawDescriptionHelpFormatter)

    def error(self, message: str):
        """As tools/lib/setup.sh refuses the options of other commands."""
        if unknown := UNKNOWN.match(message):
            message = (f"there is no option {unknown[1]}{nearest(unknown[1], self._option_string_actions)}; "
                       f"{self.prog} --help tells more")
        elif choice := NO_CHOICE.search(message):
            message += nearest(choice["word"], re.findall(r"[^\s',]+", choice["names"]))
        self.exit(2, f"{self.prog}: {message}\n")


def nearest(word, names) -> str:
    """As " (did you mean --out?)", or nothing. The dashes of options make none of them alike."""
    bare = {name.lstrip("-"): name for name in names}
    near = difflib.get_close_matches(word.lstrip("-"), bare, 1)
    return f" (did you mean {bare[near[0]]}?)" if near else ""
