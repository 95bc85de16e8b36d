"""Zip files that have the same bytes whenever they are made of the same files."""

from __future__ import annotations

import io
import time
import zipfile
from collections.abc import Mapping

EPOCH = 315532800  # 1980, where the times of zip files begin, in seconds since 1970


def zipped(files: Mapping[str, bytes], seconds: int) -> bytes:
    """The files by their paths, each with the same time, in the order of their names."""
    memory = io.BytesIO()
    when = time.gmtime(max(seconds, EPOCH))[:6]
    with zipfile.ZipFile(memory, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as made:
        for name, content in sorted(files.items()):
            entry = zipfile.ZipInfo(name, when)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o100644 << 16
            entry.create_system = 3
            made.writestr(entry, content)
    return memory.getvalue()
