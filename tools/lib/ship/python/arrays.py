"""Makes the text of hashnoise.arrays, by tools/pick: a module for each arithmetic and each number of dimensions."""

from __future__ import annotations

import hashlib
import re
from concurrent.futures import ProcessPoolExecutor
from itertools import product

from base.tree import ROOT
from translate.pick.command import Choice, picked, read_library
from translate.pick.evaluate import Module

FOLDER = ROOT / "build" / "arrays"
NOISES = ROOT / "packages" / "python" / "hashnoise" / "_noises.py"
ARITHMETICS = ("fast", "fixed")
INPUTS = ("glsl/hashnoise/**/*.glsl", "packages/python/hashnoise/_noises.py", "tools/lib/translate/**/*.py",
          "tools/lib/ship/python/arrays.py")


def forms(module: Module, dimensions: int) -> list[str]:
    """The functions that the package calls: noises at a place, and the steps of loops. They make all others."""
    names = re.findall(r"^(\w+) = _noise\(", NOISES.read_text(encoding="utf-8"), re.M)
    places = [f"hn_{name}{phase}{dimensions}_place" for name in names for phase in ("", "_phase")]
    noises = [form for place in places for form in (place, f"{place}_phase", f"{place}_jitter", f"{place}_bandwidth")
              if form in module.forms and f"{form}_jitter" not in module.forms]
    steps = re.compile(r"hn_(place_of|place_in_cell|tile|octaves_of|add[a-z_]*|next|mean|density|shifts_of|slopes_of|"
                       rf"perlin_worley|curl_fbm){dimensions}(_(place|detail|footprint|shifts|slopes))?(_phase)?")
    return noises + [form for form in module.forms if steps.fullmatch(form)]


def text(arithmetic: str, dimensions: int) -> str:
    choice = Choice(language="python", arithmetic=arithmetic)
    return picked(forms(read_library(ROOT / "glsl" / "hashnoise", choice), dimensions), choice)


def make() -> None:
    """Unless they are there, of the same text."""
    stamp, digest = FOLDER.with_suffix(".made"), hashlib.sha256()
    for path in sorted(path for pattern in INPUTS for path in ROOT.glob(pattern)):
        digest.update(path.read_bytes())
    if stamp.is_file() and stamp.read_text() == digest.hexdigest():
        return
    FOLDER.mkdir(parents=True, exist_ok=True)
    kinds = [*product(ARITHMETICS, (3, 2, 4, 1))]  # those that take longest first
    with ProcessPoolExecutor() as pool:
        for (arithmetic, dimensions), made in zip(kinds, pool.map(text, *zip(*kinds))):
            (FOLDER / f"_{arithmetic}{dimensions}.py").write_text(made, encoding="utf-8")
    stamp.write_text(digest.hexdigest())


if __name__ == "__main__":
    make()
