"""Makes the package hashnoise_wgsl for WESL, and prints where it is.

    tools/wesl [--zip] [FOLDER]

It is hashnoise_wgsl-VERSION/ in FOLDER, which is build/wesl unless you name one; what was there is replaced. With --zip
it is hashnoise_wgsl-VERSION.zip in its place. npm and cargo both take the folder. It has every function, with HN_FAST
and with HN_FIXED; what a shader does not call is left out when it is linked. Nothing but Python is needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence

from ship.packing import command
from ship.wesl.files import NAME, package


def main(arguments: Sequence[str] | None = None) -> int:
    return command("wesl", __doc__, NAME, package, arguments)
