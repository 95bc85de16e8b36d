"""Makes the Rust crate hashnoise, and prints where it is.

    tools/crate [--zip] [--only MODULES] [FOLDER]

It is hashnoise-VERSION/ in FOLDER, which is build/rust unless you name one; what was there is replaced. With --zip it
is hashnoise-rust-VERSION.zip in its place. It has what tools/pick writes of the functions that are asked for most, with
HN_FAST and with HN_FIXED, and the vectors to which `cargo test` holds it. Nothing but Python is needed. It takes some
minutes. --only place,perlin,hash makes some modules, which is for tests: place and hash are always needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

import argparse
import difflib
from collections.abc import Sequence

from ship.packing import Destination, add_arguments
from ship.rust.files import MODULES, package
from tree import version

ALL = (*MODULES, "hash")
NEEDED = ("place", "hash")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="tools/crate", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser, "build/rust")
    parser.add_argument("--only", default=",".join(ALL), metavar="MODULES", help=f"of {', '.join(ALL)}")
    given = parser.parse_args(arguments)
    destination = Destination(parser, given)
    modules = [*dict.fromkeys(name.strip() for name in given.only.split(","))]
    for name in modules:
        if name not in ALL:
            near = difflib.get_close_matches(name, ALL, 1)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(ALL)}"
            parser.error(f"there is no module {name}; {hint}")
    for name in NEEDED:
        if name not in modules:
            parser.error(f"the others need the module {name}")
    print(destination.write(f"hashnoise-{version()}", f"hashnoise-rust-{version()}.zip", package(modules)))
    return 0
