"""A page of the repository as a package has it, which a registry shows."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable
from pathlib import Path

from base.tree import ROOT, address, version

# A copy of the repository shows the text behind the comment, and a package the text in it.
OF_PACKAGES = re.compile(r"^<!-- in a package:\n(.*?)^-->\n.*?^<!-- end -->\n", re.MULTILINE | re.DOTALL)
# Code has brackets, too. Links into the page itself lead there in a package as well.
LINK = re.compile(r"^```.*?^```$|!?\[((?:!\[[^]]*\]\([^)]*\)|`[^`\n]*`|[^]`])*)\]"
                  r"\((?![\w+.-]+:|#)([^()\s#]+)(#[^()\s]*)?\)|`[^`\n]*`", re.MULTILINE | re.DOTALL)


def relinked(text: str, target: Callable[[str], str]) -> str:
    """The text with another target of each link to a file; where that is empty, with the words of the link alone."""
    def link(found: re.Match) -> str:
        if found[2] is None:
            return found[0]
        to = target(found[2])
        words = relinked(found[1], target)  # a picture has a link of its own
        return f"{'!' * found[0].startswith('!')}[{words}]({to}{found[3] or ''})" if to else words

    return LINK.sub(link, text)


def of_package(path: Path) -> str:
    """The page with links to the project, as it was in this version: a package does not have the files beside it. While the
    project has no address, the page has no such links."""
    files = f"{address()}/blob/v{version()}"
    folder = path.parent.relative_to(ROOT).as_posix()
    page = OF_PACKAGES.sub(r"\1", path.read_text(encoding="utf-8"))
    return relinked(page, lambda link: f"{files}/{posixpath.normpath(posixpath.join(folder, link))}" if address() else "")
