"""Lines that repeat the version, or the address of the project: of files that can read neither glsl/hashnoise/config.glsl
nor conformance/web/address.js, and of pages, because users copy them."""

from __future__ import annotations

import re

from base.tree import ROOT, address, site, version

ANY = {"VERSION": r"\d+\.\d+\.\d+", "RELEASED": r"\d+\.\d+\.\d+", "MAJOR": r"\d+", "MINOR": r"\d+",
       "ADDRESS": r'https://[^\s"`]+?', "SITE": r'https://[^\s"`]+?'}
NAME = re.compile("|".join(ANY))
Line = str | tuple[str, str]
# Each stands in its file, if that was not deleted, at least once. RELEASED is the last version that has a tag. The second of
# a pair stands there as it is while the project has no address.
LINES: dict[str, tuple[Line, ...]] = {file: lines for file, lines in {
    "CITATION.cff": ("\nversion: VERSION\n", ("\nrepository-code: ADDRESS\nlicense: ", "\nlicense: ")),
    "docs/guide/build-systems.md": ("GIT_TAG vRELEASED`", "revision = vRELEASED`", "\nhashnoise/VERSION\n",
                                    ("ADDRESS.git", "ADDRESS")),
    "docs/guide/playground.md": (("Open it [on the site](SITE/playground.html), or `playground.html`",
                                  "Open `playground.html`"),),
    "docs/guide/godot.md": ("hashnoise-godot-VERSION.zip",),
    "docs/guide/javascript.md": ("hashnoise-VERSION.tgz",),
    "docs/reference/frozen.md": ("`hashnoise::vMAJOR_MINOR`", "`hashnoise::vMAJOR`"),
    "include/hashnoise/glsl.hpp": ("\n#define HN_I_NAMESPACE vMAJOR_MINOR\n", "\n#define HN_I_LIBRARY vMAJOR\n"),
    "packages/conan/conanfile.py": (('    url = "ADDRESS"\n    homepage = "ADDRESS"\n    topics', "    topics"),),
    "packages/vcpkg/hashnoise/vcpkg.json": ('"version": "VERSION"', ('"homepage": "ADDRESS",\n  "license"', '"license"')),
    "pyproject.toml": (('[project.urls]\nRepository = "ADDRESS"\nIssues = "ADDRESS/issues"\n'
                        'Changelog = "ADDRESS/blob/main/CHANGELOG.md"\n\n[project.opt', "[project.opt"),),
    "README.md": (("playground.png)](SITE/playground.html)", "playground.png)](docs/guide/playground.md)"),),
}.items() if (ROOT / file).is_file()}


def released() -> str:
    """The newest version that has a day in the changelog; before the first this one."""
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    found = re.search(r"^## ([\d.]+) \(\d{4}-\d\d-\d\d\)$", changelog, re.MULTILINE)
    return found[1] if found else version()


def values() -> dict[str, str]:
    major, minor, _ = version().split(".")
    return {"VERSION": version(), "RELEASED": released(), "MAJOR": major, "MINOR": minor, "ADDRESS": address(), "SITE": site(address())}


def filled(line: Line) -> str:
    now = values()
    if not isinstance(line, str):
        if not now["ADDRESS"]:
            return line[1]
        line = line[0]
    return NAME.sub(lambda name: now[name[0]], line)


def pattern(line: Line) -> str:
    """The pattern of the line with any version and address."""
    if not isinstance(line, str):
        return f"{pattern(line[0])}|{re.escape(line[1])}"
    return NAME.sub(lambda name: ANY[name[0]], re.escape(line))


def shown(line: str) -> str:
    """In a message, on one line."""
    return " ".join(line.split())


def made(file: str, text: str) -> str:
    """The text of a file with the lines as they must be."""
    for line in LINES[file]:
        right = filled(line)
        text, count = re.subn(pattern(line), lambda _: right, text)
        if not count:
            raise LookupError(f"{file} must have {shown(right)}")
    return text


def wrong() -> list[str]:
    """The lines that are not as they must be, and the right ones."""
    found = []
    for file, lines in LINES.items():
        text = (ROOT / file).read_text(encoding="utf-8")
        for line in lines:
            right = filled(line)
            found += [f"{file}: {shown(other)} must be {shown(right)}; tools/make catalog writes it"
                      for other in re.findall(pattern(line), text) or ["the missing line"] if other != right]
    return found
