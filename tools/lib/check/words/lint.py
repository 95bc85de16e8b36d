"""Finds words that make a reader read a sentence twice, in pages, comments, docstrings and messages.

    python3 -B -m check.words.lint [PREFIX]    prints each with its place; exit status 1 if there is one
    python3 -B -m check.words.lint --count     prints how often comments have each of the words of CEILINGS
"""

from __future__ import annotations

import fnmatch
import re
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from base.tree import ROOT, files

# Folders whose comments and messages are still to be rewritten. Empty this tuple once they are.
NOT_YET: tuple[str, ...] = ()
# Files, and the words that may stand there.
EXCEPTIONS: dict[str, str] = {
    "tools/lib/check/words/*": "*",    # the patterns, and the faults that tests plant
    "conformance/bench/bench*": "tell",            # "too fast to tell" is a value in records
    "tools/lib/measure/clock_test.py": "tell",
    "*/bench*": "told",                # as "cannot be told" is
    "*/record*": "told",
    "tools/lib/measure/c[lp]*": "told",
    "tools/lib/measure/paper/*": "told"}
LONGEST_CELL = 250  # letters
PATTERNS = {
    r"\b[Oo]f (?:which|whose)\b": "write two sentences",
    r"\b(?:[Ss]ays?|said|[Tt]ells?|told|asks|asked)\b": "programs print, write, return and read; pages list, state and document",
    r"(?:^[>*\-\d. ]*|[.:;!?][)\"]? |\| |\*\*)(?:What|That|Those) (?![^.]*\?)": "begin with the subject: the reader or the code",
    r"\b[Dd]earer\b": "costs more"}
# Words that comments of code may have so often. A ceiling may only fall: lower it if --count prints less.
CEILINGS = {
    r"\b[Ww]rit(?:es|ten) (?:it|them) of\b": (0, "generated from"),
    r"^(?:The same|Likewise)(?: (?:of|for|in|as|by|with|at|where)\b|[.,])": (4, "name the thing"),
    r"(?:^|[.:;!?]\)? )Of (?!course\b)": (62, "begin with the subject: the reader or the code"),
    r"\b(?:[Tt]hat|[Tt]hose) of\b": (304, "repeat the noun, or write a possessive"),
    r"\b[Ww]hat (?:is|are|was|it|they|the|an?|each|has)\b": (428, "write the noun")}
ANY = re.compile(r"[Oo]f (?:which|whose)|[Ss]ays?|said|[Tt]ells?|told|asks|asked|What|That|Those|[Dd]earer")
MADE_FILES = re.compile(r"^docs/(?:reference/snippets|measured/results)/|(?:^|/)(?:forms|bounds|facts|catalog)\.inc$|corpus")
MADE = re.compile(r"^<!-- (?!tools/make catalog: |end )[^\n]* -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)
WHOLLY_MADE = re.compile(r"`tools/make \w+` writes this page|`hn-conform list --checks` prints this page")
CODE = re.compile(r"^```.*?^```$|^ {4,}\S.*?$", re.MULTILINE | re.DOTALL)
QUOTED = re.compile(r"`[^`\n]*`|\]\([^)\n]*\)|\{[^{}\n]*\}")  # and values within strings
STRINGS = r"'(?:\\.|[^'\\\n])*'|\"(?:\\.|[^\"\\\n])*\""
# Comments and strings, by the endings of files. A file without an ending is a shell script or a Python program.
TEXTS = {
    ("py", "pyi", "sh", "cmake", "txt", "toml", "yml", "in", "gd", ""): re.compile(
        rf"\"\"\".*?\"\"\"|'''.*?'''|{STRINGS}|(?<![$\w{{])#[^\n]*", re.DOTALL),
    ("cpp", "hpp", "h", "c", "inc", "glsl", "vert", "hlsl", "metal", "wgsl", "js", "mjs", "ts", "rs", "cs", "osl", "shader"): re.compile(
        rf"R\"(\w*)\(.*?\)\1\"|{STRINGS}|`[^`]*`|//[^\n]*|/\*.*?\*/", re.DOTALL),
    ("html", "mustache", "md"): re.compile(r".+", re.DOTALL)}
BY_ENDING = {ending: pattern for endings, pattern in TEXTS.items() for ending in endings}
STRING = re.compile(r"[rbfRu]*(?:\"(?!\"\")|'(?!'')|`)")
MARKS = re.compile(r"^[rbfRu]*[\"'`]+|^[#/*!\s]+|^ *\*+ ")


def blank(found: re.Match[str]) -> str:
    """As many lines, so that the lines below keep their numbers."""
    return "\n" * found[0].count("\n")


def allowed(name: str, words: str) -> bool:
    return any(fnmatch.fnmatch(name, file) and fnmatch.fnmatch(words, known) for file, known in EXCEPTIONS.items())


def faults_of_line(name: str, number: int, line: str) -> Iterator[str]:
    for pattern, remedy in PATTERNS.items():
        for found in re.finditer(pattern, line):
            words = found[0].strip("|*.:;!?)\">- ")
            if not allowed(name, words):
                yield f"{name}:{number}: '{words}': {remedy}"


def faults(name: str, page: str) -> Iterator[str]:
    """The faults of a page, without its code and the parts that are made of records, of code or of other pages."""
    if WHOLLY_MADE.search(page):
        return
    lines = CODE.sub(blank, MADE.sub(blank, page)).splitlines()
    if name.startswith("docs/") and not re.match(r"[A-Z`*\[]", next(filter(None, lines[1:]), "")):
        yield f"{name}:1: begin with a sentence that states what the page is for"
    for number, line in enumerate(lines, 1):
        yield from faults_of_line(name, number, "" if line.startswith("#") else QUOTED.sub("``", line))
        for cell in line.split(" | ") if line.startswith("|") and name.startswith("docs/") else ():
            if len(cell.strip("| ")) > LONGEST_CELL:
                yield f"{name}:{number}: a cell of {len(cell.strip('| '))} letters: split the row, or write prose below the table"


def faults_of_code(name: str, text: str) -> Iterator[str]:
    """The faults of comments, and of strings that have a blank: other strings are names."""
    for found in BY_ENDING[ending(name)].finditer(text):
        if ANY.search(found[0]) and " " in found[0].strip("\"'`"):
            first = text.count("\n", 0, found.start()) + 1
            for number, line in enumerate(found[0].split("\n"), first):
                yield from faults_of_line(name, number, QUOTED.sub("``", MARKS.sub("", line)))


def counts_of_code(name: str, text: str) -> Counter[str]:
    """How often comments have the words of CEILINGS."""
    counts: Counter[str] = Counter()
    for found in BY_ENDING[ending(name)].finditer(text):
        for line in () if STRING.match(found[0]) else found[0].split("\n"):
            words = QUOTED.sub("``", MARKS.sub("", line))
            counts.update({pattern: len(re.findall(pattern, words)) for pattern in CEILINGS})
    return counts


def ending(name: str) -> str:
    return Path(name).suffix[1:]


def texts(root: Path, prefix: str) -> Iterator[tuple[str, str]]:
    for name in files(root):
        if name.startswith(prefix) and not name.startswith(NOT_YET) and not MADE_FILES.search(name) and ending(name) in BY_ENDING:
            yield name, (root / name).read_text(encoding="utf-8", errors="replace")


def is_page(name: str) -> bool:
    return name.endswith(".md") or name == "llms.txt"


def counts_of_tree(root: Path = ROOT, prefix: str = "") -> Counter[str]:
    return sum((counts_of_code(name, text) for name, text in texts(root, prefix) if not is_page(name) and not allowed(name, "")),
               Counter())


def faults_of_tree(root: Path = ROOT, prefix: str = "") -> Iterator[str]:
    for name, text in texts(root, prefix):
        if is_page(name):
            yield from faults(name, text)
        elif ANY.search(text):
            yield from faults_of_code(name, text)
    counts = counts_of_tree(root, prefix)
    for pattern, (ceiling, remedy) in CEILINGS.items():
        if counts[pattern] > ceiling:
            yield f"comments have '{pattern}' {counts[pattern]} times, and may {ceiling} times: {remedy}"


if __name__ == "__main__":
    if "--count" in sys.argv:
        print("\n".join(f"{count} {pattern}" for pattern, count in counts_of_tree().items()))
        sys.exit()
    messages = list(faults_of_tree(prefix=sys.argv[1] if len(sys.argv) > 1 else ""))
    print("\n".join(messages) or "no such words")
    sys.exit(bool(messages))
