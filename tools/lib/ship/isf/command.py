"""Makes looks in the Interactive Shader Format (ISF), and prints where they are.

    tools/isf [--zip] [FOLDER]

They are hashnoise-isf-VERSION/ in FOLDER, which is build/isf unless you name one; what was there is replaced. With
--zip they are hashnoise-isf-VERSION.zip in its place. Each file is a generator with controls. Nothing but Python is
needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence

from ship.isf.files import NAME, package
from ship.packing import command


def main(arguments: Sequence[str] | None = None) -> int:
    return command("isf", __doc__, NAME, package, arguments)
