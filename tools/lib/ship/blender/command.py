"""Makes the add-on for Blender, and prints where it is.

    tools/blender [--zip] [--wheel FILE] [FOLDER]

It is hashnoise-blender-VERSION/ in FOLDER, which is build/blender unless you name one; what was there is replaced. With
--zip it is hashnoise-blender-VERSION.zip in its place, which Blender 4.2 and later install from the disk as an
extension. It has node groups for Cycles, and an operator that displaces meshes by the Python package. Nothing but
Python is needed. With --wheel it has a wheel of that package, which Blender then installs with it: tools/wheel makes
one for this machine. It must be for the Python of your Blender, which is 3.11 in 4.2 and in 5.0.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence

from ship.blender.files import NAME, package
from ship.packing import command


def main(arguments: Sequence[str] | None = None) -> int:
    return command("blender", __doc__, NAME, package, arguments, wheel="the Python package, which it then has")
