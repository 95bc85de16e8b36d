"""Lines that repeat the version, or the address of the project: of files that can read neither glsl/hashnoise/config.glsl
nor conformance/web/address.js, and of pages, because users copy them."""

from __future__ import annotations

import re

from base.tree import ROOT, address, site, version

ANY = {"VERSION": r"\d+\.\d+\.\d+", "RELEASED": r"\d+\.\d+\.\d+", "MAJOR": r"\d+", "MINOR": r"\d+",
       "ADDRESS": r'https://[^\s"`]+?', "SITE": r'https://[^\s"`]+?'}
NAME = re.compile("|".join(ANY))
# Each stands in its file, if that was not deleted, at least once. RELEASED is the last version that has a tag.
LINES = {file: lines for file, lines in {
    "CITATION.cff": ("\nversion: VERSION\n", "\nrepository-code: ADDRESS\n"),
    "docs/guide/build-systems.md": ("GIT_TAG vRELEASED`", "revision = vRELEASED`", "\nhashnoise/VERSION\n", "ADDRESS.git"),
    "docs/guide/playground.md": ("](SITE/playground.html)",),
    "docs/guide/godot.md": ("hashnoise-godot-VERSION.zip",),
    "docs/guide/javascript.md": ("hashnoise-VERSION.tgz",),
    "docs/reference/frozen.md": ("`hashnoise::vMAJOR_MINOR`", "`hashnoise::vMAJOR`"),
    "include/hashnoise/glsl.hpp": ("\n#define HN_I_NAMESPACE vMAJOR_MINOR\n", "\n#define HN_I_LIBRARY vMAJOR\n"),
    "packages/conan/conanfile.py": ('    url = "ADDRESS"', '    homepage = "ADDRESS"'),
    "packages/vcpkg/hashnoise/vcpkg.json": ('"version": "VERSION"', '"homepage": "ADDRESS"'),
    "pyproject.toml": ('Repository = "ADDRESS"', 'Issues = "ADDRESS/issues"', 'Changelog = "ADDRESS/blob/main/CHANGELOG.md"'),
    "README.md": ("](SITE/playground.html)",),
}.items() if (ROOT / file).is_file()}


def released() -> str:
    """The newest version that has a day in the changelog; before the first this one."""
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    found = re.search(r"^## ([\d.]+) \(\d{4}-\d\d-\d\d\)$", changelog, re.MULTILINE)
    return found[1] if found else version()


def values() -> dict[str, str]:
    major, minor, _ = version().split(".")
    return {"VERSION": version(), "RELEASED": released(), "MAJOR": major, "MINOR": minor, "ADDRESS": address(), "SITE": site(address())}


def filled(line: str) -> str:
    now = values()
    return NAME.sub(lambda name: now[name[0]], line)


def pattern(line: str) -> str:
    """The pattern of the line with any version and address."""
    return NAME.sub(lambda name: ANY[name[0]], re.escape(line))


def made(file: str, text: str) -> str:
    """The text of a file with the lines as they must be."""
    for line in LINES[file]:
        right = filled(line)
        text, count = re.subn(pattern(line), lambda _: right, text)
        if not count:
            raise LookupError(f"{file} must have {right.strip()}")
    return text


def wrong() -> list[str]:
    """The lines that are not as they must be, and the right ones."""
    found = []
    for file, lines in LINES.items():
        text = (ROOT / file).read_text(encoding="utf-8")
        for line in lines:
            right = filled(line)
            found += [f"{file}: {other.strip()} must be {right.strip()}; tools/make catalog writes it"
                      for other in re.findall(pattern(line), text) or ["the missing line"] if other != right]
    return found
