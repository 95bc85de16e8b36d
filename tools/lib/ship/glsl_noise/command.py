"""Makes the package that stands in for npm's glsl-noise, and prints where it is.

    tools/glsl-noise [--zip] [FOLDER]

It is hashnoise-glsl-noise-VERSION/ in FOLDER, which is build/glsl-noise unless you name one; what was there is
replaced. With --zip it is hashnoise-glsl-noise-VERSION.zip in its place. npm installs the folder. Its files have the
names of glsl-noise, and functions with its names, which are noise of the library that looks alike. Nothing but Python
is needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence

from ship.glsl_noise.files import NAME, package
from ship.packing import command


def main(arguments: Sequence[str] | None = None) -> int:
    return command("glsl-noise", __doc__, NAME, package, arguments)
