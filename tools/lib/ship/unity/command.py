"""Makes the package com.hashnoise.noise for Unity, and prints where it is.

    tools/unity [--zip] [FOLDER]

It is com.hashnoise.noise-VERSION/ in FOLDER, which is build/unity unless you name one; what was there is replaced. With
--zip it is com.hashnoise.noise-VERSION.zip in its place. Unity's Package Manager takes the folder. It has functions for
HLSL, for the Custom Function nodes of Shader Graph, and for C#, of what is asked for most. Nothing but Python is needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence

from ship.packing import command
from ship.unity.files import NAME, package


def main(arguments: Sequence[str] | None = None) -> int:
    return command("unity", __doc__, NAME, package, arguments)
