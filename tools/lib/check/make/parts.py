"""The table of generated files, which but for some of build/ are committed: each part, its inputs, and its maker. A
part stands below those that it needs."""

from __future__ import annotations

from typing import NamedTuple

from base import modules
from catalog.copies import LINES


class Part(NamedTuple):
    """Inputs and products are patterns from the top of the repository; the code that makes a part is an input, too, as
    far as it is imported by name."""
    name: str
    what: str
    takes: str  # of time, on two cores
    module: str  # its main() makes the part, and compares it with --check
    inputs: tuple[str, ...]
    products: tuple[str, ...]
    options: tuple[str, ...] = ()  # with which tools/make makes it
    check: tuple[str, ...] = ("--check",)  # with which it looks at the part; empty if nobody looks
    sample: bool = False  # that look takes a sample
    program: str = ""  # a target of CMake that it runs
    scientific: bool = False  # it needs numpy
    by_name: bool = False  # it is made only where it is named


LIBRARY = ("glsl/hashnoise/**/*.glsl", "glsl/hashnoise/**/*.h", "include/hashnoise/**/*.h*")
SUITE = ("src/base/*.[ch]pp", *(f"conformance/{room}/*.[ch]pp" for room in ("library", "expected")),
         "conformance/expected/*.inc", "catalog/*.toml")
PAGES = ("README.md", "docs/README.md", "docs/guide/gallery/README.md",
         *(f"docs/{page}.md" for page in (
             "guide/cellular", "guide/engines", "guide/languages", "guide/uniform",
             "measured/default-hash", "measured/hashes", "measured/judge",
             "measured/measuring", "measured/quality", "measured/results/README",
             "reference/fractals", "reference/knobs", "reference/noises")))
RECORDS = ("docs/measured/results/**/*.csv", "src/grid/*.*")

PARTS = tuple(part for part in (
    Part("catalog", "what the library, packages and pages have of catalog/, the version and the address", "a second",
         "catalog.command",
         ("catalog/*.toml", "glsl/hashnoise/config.glsl", "conformance/web/address.js", "CHANGELOG.md"),
         ("README.md", "docs/guide/javascript.md", "docs/reference/noises.md", "docs/reference/fractals.md",
          "glsl/hashnoise/fbm2d.glsl", "glsl/hashnoise/octaves2d.glsl", "include/hashnoise/detail/functions_of_glsl.h",
          "packages/python/hashnoise/**/*.py*", "playground/catalog.js", "src/grid/catalog.inc", *LINES)),
    Part("dimensions", "files of glsl/ that only include others, and what other dimensions have of the plane's text",
         "a second", "translate.dimensions.command", (),
         # config.glsl is by hand, and the products above this part are made of it.
         ("glsl/hashnoise/[!c]*.glsl", "glsl/hashnoise/c[!o]*.glsl", "glsl/hashnoise/detail/*")),
    Part("pages", "pictures, numbers and tables of pages", "half a minute", "ship.pages.command",
         (*PAGES, *LIBRARY, *RECORDS, "docs/guide/tutorial.md", "tools/lib/ship/pages/*.[ch]pp", "tools/lib/ship/*/files.py",
          "tools/lib/measure/tables.py", "catalog/*.toml", "packages/blender/nodes.py"),
         (*PAGES, "docs/images/*.png", "docs/guide/gallery/*.png", "packages/*/README.md")),
    Part("golden", "golden files, by the oracle", "five minutes", "proof.golden.command",
         ("catalog/*.toml", "tools/lib/proof/oracle/noises/*.py"), ("conformance/expected/golden/*.golden",),
         check=("--check", "--sample", "8"), sample=True),
    Part("errors", "the largest errors of noises and sums, by a search; and of functions of yours: tools/make errors FILE.glsl",
         "half an hour", "proof.errors.command",
         (*LIBRARY, "conformance/roundings/*.hpp", "tools/lib/proof/errors/*.*", "tools/lib/proof/bounds/*.cpp"),
         ("tools/lib/proof/errors/record.csv",), scientific=True, by_name=True),
    Part("bounds", "ranges, proven, and errors: bounds.inc, and the tables of docs/measured/accuracy.md",
         "seconds", "proof.bounds.command",
         (*LIBRARY, "docs/measured/accuracy.md", "docs/reference/knobs.md", "docs/reference/fractals.md",
          "tools/lib/proof/bounds/noises/*.py", "tools/lib/proof/bounds/kept.csv", "tools/lib/proof/errors/record.csv",
          "tools/lib/proof/bounds/*.cpp", "catalog/*.toml", "conformance/expected/golden/*.golden"),
         ("conformance/expected/bounds.inc", "docs/measured/accuracy.md"), scientific=True),
    Part("one-noise", "what docs/develop/one-noise.md quotes of Perlin noise", "seconds", "ship.pages.one_noise",
         ("docs/develop/one-noise.md", *LIBRARY, "docs/reference/contract.md", "docs/measured/accuracy.md",
          "docs/measured/results/gpu/costs.csv",
          "conformance/expected/golden/noise2d.perlin.golden"), ("docs/develop/one-noise.md",)),
    Part("freeze", "entries of new functions among what never changes", "seconds for each function", "check.frozen.command",
         (*LIBRARY, *SUITE, "docs/measured/accuracy.md", "tools/lib/ship/*/files.py", "packages/blender/nodes.py",
          "packages/npm/src/**/*.d.ts",
          "packages/python/hashnoise/*.pyi"),
         ("conformance/expected/frozen.csv", "conformance/expected/interface.csv"), sample=True, program="hn-frozen"),
    Part("snippets", "docs/reference/snippets: functions to paste", "half a minute", "translate.pick.pages",
         ("glsl/hashnoise/**/*.glsl",), ("docs/reference/snippets/*.md",)),
    Part("faults", "docs/measured/faults.md: which cases notice what drivers got wrong", "ten minutes", "check.faults.command",
         ("conformance/cases/bugs/*", "conformance/fault/*"), ("docs/measured/faults.md",),
         check=("--check", "--rows"), sample=True, program="hn-conform"),
    Part("vectors", "build/vectors: rows of golden files, for ports", "half a minute", "proof.vectors.command", (),
         ("build/vectors/*.json",), by_name=True, check=()),
    Part("measured", "what records of measurements are of another text; --check looks, too, and nothing is measured",
         "seconds", "measure.stamps", (*LIBRARY, *RECORDS, "catalog/*.toml"), (), by_name=True),
    Part("site", "a site of the pages, with what Sphinx needs from PyPI", "minutes", "ship.website.command", (),
         ("build/site/index.html",), by_name=True, check=()),
    Part("format", "C++, GLSL and Python, formatted", "seconds, and half a minute at first", "check.format.command", (),
         (), by_name=True, check=()),
) if modules.path_of(part.module).is_file())  # else it was deleted
