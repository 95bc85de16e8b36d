"""A page of the repository as a package has it, which a registry shows."""

from __future__ import annotations

import posixpath
import re
from pathlib import Path

from base.tree import ROOT, address, version

# A copy of the repository shows the text behind the comment, and a package the text in it.
OF_PACKAGES = re.compile(r"^<!-- in a package:\n(.*?)^-->\n.*?^<!-- end -->\n", re.MULTILINE | re.DOTALL)
# Code has brackets, too. Links into the page itself lead there in a package as well.
LINK = re.compile(r"^```.*?^```$|`[^`\n]*`|(?<=\]\()(?![\w+.-]+:|#)([^()\s#]+)(?=[)#])", re.MULTILINE | re.DOTALL)


def of_package(path: Path) -> str:
    """The page with links to the project, as it was in this version: a package does not have the files beside it."""
    files = f"{address()}/blob/v{version()}"
    folder = path.parent.relative_to(ROOT).as_posix()
    page = OF_PACKAGES.sub(r"\1", path.read_text(encoding="utf-8"))
    return LINK.sub(lambda found: f"{files}/{posixpath.normpath(posixpath.join(folder, found[1]))}" if found[1]
                    else found[0], page)
