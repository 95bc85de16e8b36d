"""Writes the values of a file: as raw planes, as a texture, or as a picture."""

import itertools
import json
import os
import shutil
import struct
import zlib
from contextlib import contextmanager
from math import lcm, prod
from pathlib import Path

import numpy as np

from . import __version__
from ._bake_values import PIECE, Stop, pieces

FORMATS = {"png": "<u2", "exr": "<f4", "f32": "<f4", "r16": "<u2", "ktx2": "<u2", "ktx2-float": "<f4"}
PICTURES = ("png", "exr")
MOST_CHANNELS = 4
LONGEST_SIDE = 1 << 24  # of a picture; far beyond the pictures that programs read


def files_of(given):
    """The paths of the files: one, or one for each slice."""
    if given.layout != "slices":
        return [given.out]
    count = prod(given.size[2:])
    digits = max(3, len(str(count - 1)))
    return [given.out.with_name(f"{given.out.stem}.{number:0{digits}}{given.out.suffix}") for number in range(count)]


def write(given, values, record):
    """Writes all files, each whole or not at all. `values(rows, columns)` returns (components, rows, columns)."""
    texts = {"KTXwriter" if given.is_texture else "Software": f"hashnoise {__version__}, bake"}
    if given.format not in PICTURES:
        with whole(given.out) as part:
            _write_raw(part, given, values, {**texts, "hashnoise": json.dumps(record)})
        return
    slices = range(prod(given.size[2:]))
    for number, path in enumerate(files_of(given)):
        if given.layout == "slices":
            slices, record = (number,), {**record, "slice": number}
        with whole(path) as part:
            _write_picture(part, given, values, {**texts, "hashnoise": json.dumps(record)}, slices)


@contextmanager
def whole(path):
    """A file beside that of the path, which takes its place once it is written, and is gone if it is not."""
    target = Path(os.path.realpath(path))
    part = target.with_name(f"{target.name}.{os.getpid()}.part")
    try:
        part.touch(exist_ok=False)
        yield part
        if target.exists():
            shutil.copymode(target, part)
        os.replace(part, target)
    except OSError as error:
        raise Stop(1, f"cannot write {path.name}: {error.strerror or error}") from None
    finally:
        part.unlink(missing_ok=True)


def check_path(path):
    """Refuses a path that no file can be written to, before the work rather than after it."""
    if not path.parent.is_dir():
        raise Stop(2, f"--out {path}: there is no folder {path.parent}; make it, or name a file in another")
    if path.exists() and not path.is_file():
        raise Stop(2, f"--out {path}: it is {'a folder; name a file in it' if path.is_dir() else 'no regular file'}")
    if not os.access(path if path.exists() else path.parent, os.W_OK):
        raise Stop(2, f"--out {path}: you may not write to it")


def _write_raw(path, given, values, texts):
    """Planes one after the other; of a texture the components of each point, behind a header."""
    dtype, width, points = np.dtype(FORMATS[given.format]), given.size[0], prod(given.size)
    with open(path, "r+b") as file:
        begin = 0
        if given.is_texture:
            begin = file.write(ktx2_header(given.size, len(values.components), dtype, texts))
        for rows, columns in pieces(given.size):
            data = values(rows, columns).astype(dtype, copy=False)
            first = rows[0] * width + columns[0]
            if begin:
                file.seek(begin + first * len(data) * dtype.itemsize)
                file.write(np.moveaxis(data, 0, -1).tobytes())
                continue
            for number, plane in enumerate(data):
                file.seek((number * points + first) * dtype.itemsize)
                file.write(plane.tobytes())


def ktx2_header(size, components, dtype, texts):
    """The bytes in front of the texels, by https://registry.khronos.org/KTX/specs/2.0/ktxspec.v2.html."""
    is_float, bits = dtype.kind == "f", 8 * dtype.itemsize
    texel = components * dtype.itemsize
    # VK_FORMAT_R16_UNORM, R16G16_UNORM, ..., and VK_FORMAT_R32_SFLOAT, ...
    vulkan = ((100, 103, 106, 109) if is_float else (70, 77, 84, 91))[components - 1]
    # A basic descriptor of Khronos' Data Format: RGBSDA, no primaries, linear; a block is a texel, of one plane.
    samples = b"".join(
        struct.pack("<HBBIII", bits * i, bits - 1, (0, 1, 2, 15)[i] | (0xC0 if is_float else 0), 0,
                    *((0xBF800000, 0x3F800000) if is_float else (0, 0xFFFF))) for i in range(components))
    size_of_block = 24 + len(samples)
    descriptor = struct.pack("<IIHHBBBBIII", size_of_block + 4, 0, 2, size_of_block, 1, 0, 1, 0, 0, texel, 0) + samples
    pairs = b""
    for name, text in sorted(texts.items()):
        pair = f"{name}\0{text}\0".encode()
        pairs += struct.pack("<I", len(pair)) + pair + bytes(-len(pair) % 4)
    at = 80 + 24  # behind the header, and the index of one level
    end = at + len(descriptor) + len(pairs)
    texels = end + -end % lcm(texel, 4)
    length = prod(size) * texel
    header = b"\xABKTX 20\xBB\r\n\x1A\n" + struct.pack(
        "<9I4I2Q3Q", vulkan, dtype.itemsize, *(*size, 0, 0)[:3], 0, 1, 1, 0,  # no array, no cube, one level, not packed
        at, len(descriptor), at + len(descriptor), len(pairs), 0, 0, texels, length, length)
    return header + descriptor + pairs + bytes(texels - end)


def _bands(given, values, slices, count, dtype):
    """A picture of slices in rows, from above, as arrays of some rows of pixels. Where there is no slice it is 0."""
    width, height = (*given.size, 1)[:2]
    each = max(PIECE // (width * given.columns), 1)
    for row, first in itertools.product(range(0, len(slices), given.columns), range(0, height, each)):
        end = min(first + each, height)
        pixels = np.zeros((end - first, width * given.columns, count), dtype)
        for column, number in enumerate(slices[row:row + given.columns]):
            data = values((number * height + first, number * height + end), (0, width))
            pixels[:, column * width:(column + 1) * width, :len(data)] = np.moveaxis(data, 0, -1)
        yield pixels


def _write_png(file, size, count, texts, bands):
    """By https://www.w3.org/TR/png-3; the libraries of PyPI keep a picture in memory, or ignore that a disk is full."""
    def chunk(kind, data):
        file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))

    file.write(b"\x89PNG\r\n\x1a\n")
    chunk(b"IHDR", struct.pack(">IIBBBBB", *size, 16, {1: 0, 3: 2, 4: 6}[count], 0, 0, 0))
    for name, text in texts.items():
        chunk(b"tEXt", f"{name}\0{text}".encode("ascii"))
    packer = zlib.compressobj(3)  # the last bits of noise do not pack: more effort makes nothing smaller
    above = np.zeros((1, size[0] * count * 2), np.uint8)
    for pixels in bands:
        rows = pixels.astype(">u2").reshape(len(pixels), -1).view(np.uint8)
        filtered = rows - np.concatenate([above, rows[:-1]])
        chunk(b"IDAT", packer.compress(np.insert(filtered, 0, 2, axis=1).tobytes()))  # 2: what is above is subtracted
        above = rows[-1:]
    chunk(b"IDAT", packer.flush())
    chunk(b"IEND", b"")


def open_image_io():
    try:
        import OpenImageIO
    except ImportError as error:
        raise Stop(4, f"OpenImageIO writes EXR, and is not there ({error}): pip install 'hashnoise[bake]'") from None
    return OpenImageIO


def _write_exr(path, size, names, texts, bands):
    library = open_image_io()
    spec = library.ImageSpec(*size, len(names), "float")
    spec.channelnames = names
    for name, value in {**texts, "compression": "zip", "DateTime": ""}.items():  # no file has a date
        spec.attribute(name, value)
    file, y = library.ImageOutput.create("exr"), 0
    is_written = file.open(str(path), spec)
    for pixels in bands:
        is_written = is_written and file.write_scanlines(y, y + len(pixels), 0, pixels)
        y += len(pixels)
    # The end is read, since close() does not notice a disk that is full.
    if not (is_written and file.close() and (back := library.ImageInput.open(str(path))) and (
            back.read_scanlines(y - 1, y, 0, 0, len(names)) is not None)):
        raise OSError(f"OpenImageIO: {(file.geterror() or library.geterror()).strip()}")


def _write_picture(path, given, values, texts, slices):
    width, height = (*given.size, 1)[:2]
    size = (width * given.columns, height * -(-len(slices) // given.columns))
    # Programs look for the names of colours, and those that look for red look for blue, too.
    count = max(len(values.components), 3) if len(values.components) > 1 else 1
    bands = _bands(given, values, slices, count, np.dtype(FORMATS[given.format]))
    if given.format == "exr":
        names = "Y" if count == 1 else "RGBA"[:count] if count <= MOST_CHANNELS else [
            one.name for one in values.components]
        _write_exr(path, size, tuple(names), texts, bands)
        return
    with open(path, "r+b") as file:
        _write_png(file, size, count, texts, bands)
