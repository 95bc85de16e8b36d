"""Writes and reads PNG files without a library."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path


def png(width: int, height: int, pixels: bytes) -> bytes:
    """The file of an image, whose pixels are red, green and blue, from the left and from above."""
    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    size = 3 * width
    lines = b"".join(b"\0" + pixels[i * size:(i + 1) * size] for i in range(height))  # 0: no filter
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)  # 8 bits, of three colours
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def read_png(path: Path) -> tuple[int, int, bytes]:
    """The width, the height and the bytes of a PNG file, of three channels."""
    data, position, packed = path.read_bytes(), 8, b""
    while position < len(data):
        size, kind = struct.unpack(">I4s", data[position:position + 8])
        chunk = data[position + 8:position + 8 + size]
        position += 12 + size
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", chunk[:10])
        packed += chunk if kind == b"IDAT" else b""
    if depth != 8 or colour not in (2, 6):
        raise ValueError(f"{path} has no bytes of colours")
    channels = 3 if colour == 2 else 4
    lines, above = zlib.decompress(packed), bytearray(width * channels)
    found = bytearray()
    for y in range(height):
        start = y * (width * channels + 1)
        kind, line = lines[start], bytearray(lines[start + 1:start + 1 + width * channels])
        for i, value in enumerate(line):
            left, up = line[i - channels] if i >= channels else 0, above[i]
            corner = above[i - channels] if i >= channels else 0
            near = min((abs(left + up - corner - side), order, side) for order, side in enumerate((left, up, corner)))[2]
            line[i] = (value + (0, left, up, (left + up) // 2, near)[kind]) & 255
        found += bytes(value for i, value in enumerate(line) if i % channels < 3)
        above = line
    return width, height, bytes(found)
