"""The page: index.html of playground/ with the style, the modules and picked functions inside."""

from __future__ import annotations

import base64
import hashlib
import re
from collections.abc import Callable

from base.tree import ROOT, version
from ship.playground import picks

SOURCES = ROOT / "playground"
FIRST = "main.js"  # the module that imports the others
IMPORT = re.compile(r'^import \{[^}]*\} from "\./(\w+\.js)";\n', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(?:async )?(?:const|class|function)\b)", re.MULTILINE)
# Comments, indents and blanks behind signs, which browsers do not need. Behind code a comment has no quotes, so that it is in no text.
BLANK = re.compile(r"^(?: *//.*\n|\n| +)|(?<=[;,{(\[]) +// [^\"'`\n]*$", re.MULTILINE)
OF_STYLES = re.compile(r"/\*.*?\*/\n?|^(?:\n| +)|(?<=[:;,{]) (?=\S)", re.MULTILINE | re.DOTALL)
NAME = re.compile(r"^(?:async )?(?:const|let|class|function\*?) (\w+)", re.MULTILINE)


class Unfit(ValueError):
    """Modules that cannot stand in one script."""


def modules(name: str = FIRST, done: dict[str, str] | None = None) -> dict[str, str]:
    """The texts of the modules, each behind those that it imports. From a disk a page loads no module, so they become
    one script: without imports and exports, and with names that are different in all of them."""
    done = {} if done is None else done
    if name not in done:
        text = (SOURCES / name).read_text(encoding="utf-8")
        done[name] = ""  # against circles
        for imported in IMPORT.findall(text):
            modules(imported, done)
        del done[name]
        done[name] = EXPORT.sub("", IMPORT.sub("", text))
    return done


def script() -> str:
    names: dict[str, str] = {}
    texts = modules()
    for file, text in texts.items():
        if match := re.search(r"^(?:import|export)\b.*", text, re.MULTILINE):
            raise Unfit(f"playground/{file} has a line that the page cannot take: {match[0]}")
        if "</script" in text:
            raise Unfit(f"playground/{file} has </script in it, which ends the page's script")
        for name in NAME.findall(text):
            if name in names:
                raise Unfit(f"{name} is defined in playground/{names[name]} and in playground/{file}")
            names[name] = file
    return BLANK.sub("", "\n".join(texts.values()))


def hash_of(code: str) -> str:
    """By which the page's policy allows its script, and no other."""
    return "sha256-" + base64.b64encode(hashlib.sha256(code.encode()).digest()).decode("ascii")


def page(tell: Callable[[str], None] = lambda _: None) -> str:
    """Calls `tell` with a sentence before each step that takes long."""
    code = f"\n{script().strip()}\n"
    style = OF_STYLES.sub("", (SOURCES / "style.css").read_text(encoding="utf-8")).strip()
    looks = base64.b64encode((SOURCES / "looks.webp").read_bytes()).decode("ascii")
    parts = {"style": style, "looks": looks, "script": code, "hash": hash_of(code), "version": version(),
             "pieces": picks.kept_text(tell)}
    return re.sub(r"\{\{(\w+)\}\}", lambda match: parts[match[1]],
                  re.sub(r"^ +", "", (SOURCES / "index.html").read_text(encoding="utf-8"), flags=re.MULTILINE))
