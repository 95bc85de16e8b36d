"""Makes a library of nodes for MaterialX, and prints where it is.

    tools/materialx [--zip] [FOLDER]

It is hashnoise-materialx-VERSION/ in FOLDER, which is build/materialx unless you name one; what was there is replaced.
With --zip it is hashnoise-materialx-VERSION.zip in its place. The folder `hashnoise` in it is what MaterialX loads:
nodes of what is asked for most, for its generators of GLSL, Metal's language, Slang and OSL. Nothing but Python is
needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence

from ship.materialx.files import NAME, package
from ship.packing import command


def main(arguments: Sequence[str] | None = None) -> int:
    return command("materialx", __doc__, NAME, package, arguments)
