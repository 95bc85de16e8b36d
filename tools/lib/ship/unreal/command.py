"""Makes the plugin for Unreal, and prints where it is.

    tools/unreal [--zip] [FOLDER]

It is hashnoise-unreal-VERSION/ in FOLDER, which is build/unreal unless you name one; what was there is replaced. With
--zip it is hashnoise-unreal-VERSION.zip in its place. A project has it in its folder Plugins. It has files of HLSL that
materials include, and the text of custom nodes, of what is asked for most. Nothing but Python is needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence

from ship.packing import command
from ship.unreal.files import NAME, package


def main(arguments: Sequence[str] | None = None) -> int:
    return command("unreal", __doc__, NAME, package, arguments)
