"""Makes a site of docs/ and the other pages, with a search and the playground.

    tools/make site [--out DIR]      into build/site or DIR; a site there is replaced

Open DIR/index.html, from a disk or from a server. Nothing in it is fetched from anywhere else. Sphinx, which makes it,
is installed from PyPI into build/site-environment at first. Each link to a page, a heading or a file has to lead there.

Exit status: 0 done, 1 a link leads nowhere, or a page is in no group of tools/lib/ship/website/pages.py; 2 bad usage, 4
PyPI cannot be reached, or a part could not be made.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from base.pieces import is_deleted
from base.pypi import environment
from base.tree import ROOT, TOOLS
from base.usage import Parser
from ship.website import pages
from translate.pick import pages as snippets

HERE = Path(__file__).parent
ENVIRONMENT = ROOT / "build" / "site-environment"
MARK = "searchindex.js"  # by which a folder is known as a site
MORE = """
## On this site

- <a href="playground.html">The playground</a>
"""


class NoSite(Exception):
    """Why there is none, with an exit status."""

    def __init__(self, status: int, reason: str) -> None:
        super().__init__(reason)
        self.status = status


def playground(folder: Path) -> None:
    done = subprocess.run([TOOLS / "playground", "--out", folder / "playground.html"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise NoSite(4, f"tools/playground ended with status {done.returncode}: {done.stderr.strip()}")


def build(source: Path, out: Path) -> None:
    """Sphinx, for which a warning is an error."""
    shutil.copyfile(HERE / "conf.py", source / "conf.py")
    for name in ("extra", "static"):
        (source / name).mkdir(exist_ok=True)
    shutil.copyfile(HERE / "phone.css", source / "static" / "phone.css")
    sphinx = [ENVIRONMENT / "bin" / "python", "-m", "sphinx", "-b", "html", "-q", "-W", "--keep-going", "--no-color"]
    done = subprocess.run([*sphinx, "-d", source.with_name("doctrees"), source, out], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        said = re.sub(rf"{re.escape(str(source))}/", "", done.stderr)
        raise NoSite(1, said.strip())


def make(out: Path) -> None:
    if left := pages.ungrouped(pages.pages(ROOT)):
        raise NoSite(1, f"{', '.join(left)}: no group of tools/lib/ship/website/pages.py has it")
    if environment(ENVIRONMENT, HERE / "requirements.txt"):
        raise NoSite(4, "what makes the site could not be installed")
    out.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=out.parent, prefix=f".{out.name}.") as scratch:
        source, made = Path(scratch) / "source", Path(scratch) / "made"
        (source / "extra").mkdir(parents=True)
        has_playground = not is_deleted("playground")
        pages.write(ROOT, source, MORE * has_playground)
        for page in snippets.whole().iterdir():
            name = f"docs/reference/snippets/{page.name}"
            (source / name).write_text(pages.searched(name, page.read_text(encoding="utf-8")), encoding="utf-8")
        if has_playground:
            playground(source / "extra")
        shutil.copyfile(HERE / "live.js", source / "extra" / "live.js")
        build(source, made)
        for name in (".buildinfo", "objects.inv"):
            (made / name).unlink(missing_ok=True)
        shutil.rmtree(out, ignore_errors=True)
        shutil.move(made, out)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make site", __doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "site", metavar="DIR",
                        help="where it goes (default: build/site)")
    out = parser.parse_args(arguments).out
    if out.exists() and not (out / MARK).is_file() and (not out.is_dir() or any(out.iterdir())):
        parser.error(f"{out} is no site; name a new folder, an empty one, or one that this command has made")
    try:
        make(out.resolve())
    except NoSite as reason:
        print(f"tools/make site: {reason}", file=sys.stderr)
        return reason.status
    except OSError as error:
        parser.error(f"{error.filename}: {error.strerror}")
    print(out / "index.html")
    return 0


if __name__ == "__main__":
    sys.exit(main())
