"""python -m hashnoise bake: writes a noise, a fractal or an expression as a picture, a volume, a texture or numbers."""

import argparse
import contextlib
import json
import math
import shutil
import signal
import sys
import time
import types
from pathlib import Path

import numpy as np

from . import __version__, _core
from . import _bake_mask as mask
from ._bake_files import FORMATS, LONGEST_SIDE, MOST_CHANNELS, PICTURES, check_path, files_of, open_image_io, write
from ._bake_values import FUNCTIONS, Component, Expression, Function, Stop, Values
from ._evaluate import METRICS, checked_threads, ruled_number
from ._grids import MOST_POINTS, no_function

NAME = "hashnoise bake"
MOST_CELLS = 1 << 30  # so that positions fit into 64 bits, in units of 2^-32
STATUSES = ("Exit status: 0 done, 1 values could not be computed or the file not be written, 2 bad usage, 4 a library "
            "is missing, 130 ended by Ctrl-C (SIGINT), 143 by SIGTERM, 129 by SIGHUP.")


def number(text):
    """A finite number; whole ones are an int."""
    for kind in (int, float):
        with contextlib.suppress(ValueError):
            if math.isfinite(value := kind(text)):
                return value
    raise argparse.ArgumentTypeError(f'"{text}" is not a number')


def axes(kind, least, most, example):
    """"1024x512": a number for each axis."""
    def numbers(text):
        with contextlib.suppress(ValueError):
            found = tuple(map(kind, text.split("x")))
            if len(found) <= 4 and all(least <= along <= most for along in found):
                return found
        raise argparse.ArgumentTypeError(f'"{text}": it takes a number from {least} to {most} for each of at most four '
                                         f"axes, as in {example}")
    return numbers


def ends(text):
    """"-1:1"."""
    with contextlib.suppress(ValueError):
        least, greatest = map(float, text.split(":"))
        if least < greatest and math.isfinite(greatest - least):
            return least, greatest
    raise argparse.ArgumentTypeError(f'"{text}": it takes two numbers, the smaller one first, as in --range -1:1')


def count(text):
    if not isinstance(found := number(text), int) or found < 1:
        raise argparse.ArgumentTypeError(f"{text} is not a whole number from 1 on")
    return found


# Each option, what stands for its value (nothing for a flag), what makes the value of it, or what it may be, and its help.
OPTIONS = {
    "in place of a function": (
        ("--expression", "PYTHON", str, "such as 'fbm() - 0.3 * cellular(seed=3)[0]': the functions at the points of the "
         "file; x, y, z and w, the positions in cells; seed, period and numpy. It is executed"),
        ("--source", "FILE", str, "Python with functions that the expression calls")),
    "parameters of the function, as in GLSL": (
        ("--noise", "NAME", str, "which a fractal sums; by default that of the function in GLSL"),
        ("--octaves", "N", number, "how many"),
        ("--lacunarity", "NUMBER", number, "by how much an octave is finer than the one before"),
        ("--gain", "NUMBER", number, "by how much an octave is weaker, a factor"),
        ("--strength", "NUMBER", number, "how strong"),
        ("--amplitude", "NUMBER", number, "how far, in cells"),
        ("--detail", "NUMBER", number, "octaves as a number with a fraction, in place of --octaves"),
        ("--footprint", "NUMBER", number, "the size of a pixel, in cells, which fades octaves out"),
        ("--wave", "X[xY...]", axes(float, -16, 16, "2.5x-1.5"), "waves per cell along each axis, as in 2.5x-1.5"),
        ("--bandwidth", "NUMBER", number, "how far the waves of points are from that, in waves per cell"),
        ("--phase", "NUMBER", number, "in turns"),
        ("--jitter", "NUMBER", number, "how far points are from the centres of their cells"),
        ("--metric", "NAME", str, ", ".join(METRICS)),
        ("--instruction-set", "NAME", str, "such as avx2; by default the widest of the processor. Values depend on it "
         "with --arithmetic fast alone")),
    "parameters": (
        ("--seed", "N", number, "different seeds give independent fields"),
        ("--period", "X[xY...]", axes(int, *_core.rules["period"], "8x8"),
         "cells after which the field repeats, along each axis or all; 0 for none"),
        ("--arithmetic", "NAME", str, "fixed, precise or fast. The default, fixed, has the same bits on every machine, and "
         "those of shaders with HN_FIXED")),
    "places": (
        ("--size", "X[xY...]", axes(int, 1, MOST_POINTS, "1024x1024, or 128x128x64 for a volume"),
         "points along each axis, one to four numbers, and as many dimensions; default 512x512. Of "
         "bluenoise one or two numbers, default 64"),
        ("--frames", "N", count, "of bluenoise: masks that are even over time, too; the last axis of the file"),
        ("--cells", "X[xY...]", axes(float, 0, MOST_CELLS, "8x4"), "along each axis, by default 8; one number is for x, "
         "and cells are as large along the others"),
        ("--origin", "X[xY...]", axes(float, -MOST_CELLS, MOST_CELLS, "1000000x-3.5"), "the first point, in cells"),
        ("--tile", None, None, "make the cells the period, so that the file repeats without a seam"),
        ("--y-up", None, None, "begin with the row of the greatest y, so that y grows upwards in a picture")),
    "the file": (
        ("--out", "FILE", Path, "its name"),
        ("--format", "NAME", tuple(FORMATS), "png (16 bits), exr (floats), f32 or r16 (planes of floats or of 16 bits, "
         "little-endian, without a header), ktx2 or ktx2-float (a texture); by default the ending of the name"),
        ("--components", "NAME,...", str, "which, as in f1,f2; all by default. Of bluenoise how many, 1 to 4"),
        ("--range", "LEAST:GREATEST", ends, "the values that become 0 and 65535; by default the range that the function "
         "documents. Once for all components, or once for each"),
        ("--normalize", None, None, "map the values that are there to 0 to 65535, in each component by itself"),
        ("--layout", "NAME", ("atlas", "slices"), "of a volume as a picture: atlas, one picture, or slices, one for each"),
        ("--columns", "N", count, "slices beside each other in an atlas; by default about a square"),
        ("--json", None, None, "print in JSON how the file was made"),
        ("--threads", "N", number, "how many; nothing in the file depends on it")),
}
NAMES = (*FUNCTIONS, mask.NAME)
DEFAULTS = {"seed": 0, "arithmetic": "fixed", "size": (512, 512), "cells": (8.0,), "range": []}
OF_FUNCTIONS = [name[2:].replace("-", "_") for name, *_ in OPTIONS["parameters of the function, as in GLSL"]]
# Their values may begin with a sign, which argparse takes for the beginning of an option.
SIGNED = ("--expression", "--origin", "--period", "--range", "--seed", *(f"--{name}" for name in OF_FUNCTIONS))


class Parser(argparse.ArgumentParser):
    """Its errors are one line."""

    def error(self, message):
        raise Stop(2, f"{message.removeprefix('argument ')}; see --help")


def options():
    parser = Parser(prog=NAME, description=__doc__.partition(": ")[2].capitalize(), epilog=STATUSES, allow_abbrev=False)
    parser.add_argument("function", nargs="?", metavar="FUNCTION", help=f"one of {', '.join(NAMES)}; bluenoise is a mask")
    parser.add_argument("--version", action="version", version=__version__)
    for title, rows in OPTIONS.items():
        group = parser.add_argument_group(title)
        for name, value, kind, text in rows:
            owners = [function for function, made in FUNCTIONS.items() if name[2:] in made.__kwdefaults__]
            more = {"action": "store_true"} if not value else {
                "action": "append" if name == "--range" else "store", "metavar": value,
                **({"choices": kind} if isinstance(kind, tuple) else {"type": kind})}
            group.add_argument(*(("-o", name) if name == "--out" else (name,)), required=name == "--out", **more,
                               help=text if len(owners) in (0, len(FUNCTIONS)) else f"{text}; of {', '.join(owners)}")
    return parser


def parsed(arguments):
    """The options, each checked. Raises Stop."""
    words = []
    for word in map(str, arguments):
        if words and words[-1] in SIGNED:
            words[-1] += f"={word}"
        else:
            words.append(word)
    given = options().parse_args(words)
    if given.function == mask.NAME:
        mask.settle(given)
    elif given.function not in (None, *NAMES):
        raise Stop(2, no_function(given.function, NAMES))
    elif given.frames:
        raise Stop(2, f"--frames is for {mask.NAME}; name three axes in --size")
    for name, value in DEFAULTS.items():
        if getattr(given, name) is None:
            setattr(given, name, value)
    given.options = {name: getattr(given, name) for name in (*OF_FUNCTIONS, "arithmetic", "seed")
                     if getattr(given, name) is not None}
    given.threads = checked_threads("bake", given.threads)
    ruled_number("bake", "seed", given.seed)
    if given.expression is None:
        if not given.function or given.source:
            raise Stop(2, "a function is missing, such as fbm, or an --expression, which may have a --source; see --help")
    elif given.function:
        raise Stop(2, f'"{given.function}" is one argument too many: --expression stands in place of a function')
    elif found := given.options.keys() & OF_FUNCTIONS:
        raise Stop(2, f"--{min(found)} is for a function; write it into the --expression, as in fbm(octaves=6)")
    given.function = given.function or "expression"
    _find_places(given)
    _find_format(given)
    return given


def _along(given, option, of_one=None):
    """The numbers of an option for the axes of --size; of one number alone the others follow, if they can."""
    numbers = getattr(given, option)
    if of_one and len(numbers) == 1:
        numbers = of_one(*numbers)
    if len(numbers) != len(given.size):
        raise Stop(2, f"--{option} has {len(numbers)} axes, and --size has {len(given.size)}; give one number for each"
                      f"{', or one for all' if of_one else ''}")
    return numbers


def _find_places(given):
    size = given.size
    given.cells = _along(given, "cells", lambda cells: (cells, *(cells * points / size[0] for points in size[1:])))
    if not all(0 < cells <= MOST_CELLS for cells in given.cells):
        raise Stop(2, f"--cells: {' x '.join(map(str, given.cells))} are not all more than 0 and at most {MOST_CELLS}")
    given.origin = _along(given, "origin") if given.origin else (0.0,) * len(size)
    if given.y_up and len(size) == 1:
        raise Stop(2, "--y-up is for a --size of two axes or more")
    if given.wave:
        given.options["wave"] = _along(given, "wave")
    if given.period:
        given.options["period"] = _along(given, "period", lambda period: (period,) * len(size))
    if given.tile:
        if given.period:
            raise Stop(2, "--tile makes the cells of the picture the period, and --period names another; leave one out")
        if not all(along.is_integer() for along in given.cells):
            raise Stop(2, f"--tile takes whole numbers of cells, and there are {' x '.join(map(str, given.cells))}; name "
                          f"them all, as in --cells {'x'.join('8' * len(size))}")
        given.options["period"] = tuple(map(int, given.cells))


def _find_format(given):
    name = given.format = given.format or given.out.suffix[1:].lower()
    if name not in FORMATS:
        raise Stop(2, f'--out "{given.out}" does not state the format; name one of {", ".join(FORMATS)} by --format')
    given.has_words = FORMATS[name] == "<u2"
    given.is_texture = name.startswith("ktx2")
    if given.is_texture and len(given.size) > 3:
        raise Stop(2, "--size: a texture has at most three axes; write .f32 or .r16")
    if given.normalize and given.range:
        raise Stop(2, "--normalize finds the range, and --range names it; leave one out")
    if not given.has_words and (given.normalize or given.range):
        raise Stop(2, f"--{'normalize' if given.normalize else 'range'} is for 16 bits; {name} holds the values as they are")
    if (given.layout or given.columns) and (name not in PICTURES or len(given.size) < 3):
        raise Stop(2, "--layout and --columns are for volumes in pictures: a --size of three or four axes, as PNG or EXR")
    slices, height, by_slice = math.prod(given.size[2:]), math.prod(given.size[1:2]), given.layout == "slices"
    if by_slice and given.columns:
        raise Stop(2, "--columns is for --layout atlas")
    given.columns = 1 if by_slice else min(given.columns or math.ceil(math.sqrt(slices * height / given.size[0])), slices)
    rows = 1 if by_slice else -(-slices // given.columns)
    if name in PICTURES and max(given.columns * given.size[0], rows * height) > LONGEST_SIDE:
        raise Stop(2, f"--size: a picture has at most {LONGEST_SIDE} pixels along a side; write .f32 or .r16")


def components_of(given, source):
    """The components that the file has, and what 0 and 65535 stand for in each, as far as it is known."""
    names = given.components.split(",") if given.components else source.components
    for name in names:
        if name not in source.components or names.count(name) > 1:
            raise Stop(2, f'--components: {given.function} has no component "{name}", or it stands there twice; it has '
                          f"{', '.join(source.components)}")
    if len(names) > MOST_CHANNELS and given.format not in ("exr", "f32", "r16"):
        raise Stop(2, f"{given.function} has {len(names)} components in {len(given.size)}D, and {given.format} has at "
                      f"most {MOST_CHANNELS}; choose some with --components, or write .exr, .f32 or .r16")
    found = [Component(name, source.components.index(name)) for name in names]
    if not given.has_words or given.normalize:
        return found
    ranges = given.range * len(names) if len(given.range) == 1 else given.range or [
        source.ranges[component.number] for component in found]
    if len(ranges) != len(names):
        raise Stop(2, f"--range stands there {len(ranges)} times, and there are {len(names)} components; give it once "
                      "for all of them, or once for each")
    for component, ends in zip(found, ranges):
        if ends is None:
            raise Stop(2, f"no range is documented for the component {component.name} of {given.function} with these "
                          f"settings, and {given.format} has 16 bits; name one with --range LEAST:GREATEST, let "
                          "--normalize find it, or write floats: .exr, .f32 or --format ktx2-float")
        component.ends = ends
    return found


def progress_of(given):
    """A line on a terminal; without tqdm there is none."""
    try:
        from tqdm import tqdm
    except ImportError:
        return contextlib.nullcontext(types.SimpleNamespace(update=lambda points: None))
    return tqdm(total=math.prod(given.size) * (1 + given.normalize), unit=" points", unit_scale=True, leave=False,
                disable=None)


def record_of(given, values):
    """How the file is made, for the file itself and for --json."""
    by = "given" if given.range else "normalized" if given.normalize else "documented"
    components = [{"name": one.name, **({"0": one.ends[0], "65535": one.ends[1], "range": by} if one.ends else {})}
                  for one in values.components]
    record = {"function": given.function, "dimensions": len(given.size), "settings": values.source.settings,
              "size": given.size, "cells": given.cells, "origin": given.origin, "tile": given.tile,
              "format": given.format, "version": __version__, "components": components}
    if given.y_up:
        record["y-up"] = True
    if given.format in PICTURES and len(given.size) > 2:
        record.update(slices=math.prod(given.size[2:]), columns=0 if given.layout == "slices" else given.columns)
    return record


def bake(given):
    start = time.monotonic()
    if given.format == "exr":
        open_image_io()
    for path in files_of(given):
        check_path(path)
    kind = Expression if given.expression is not None else mask.Mask if given.function == mask.NAME else Function
    source = kind(given)
    components = components_of(given, source)
    needed = math.prod(given.size) * len(components) * np.dtype(FORMATS[given.format]).itemsize
    free = shutil.disk_usage(given.out.resolve().parent).free
    if needed > free and given.format not in PICTURES:
        raise Stop(2, f"--size: {' x '.join(map(str, given.size))} points need {needed / 1e9:.3g} GB, and the disk has "
                      f"{free / 1e9:.3g} GB left")
    with progress_of(given) as progress:
        values = Values(given, source, components, progress)
        if given.normalize:
            values.normalize()
        record = record_of(given, values)
        write(given, values, record)
    _report(given, record, components, time.monotonic() - start)


def _report(given, record, components, seconds):
    for one in components:
        if one.nans:
            complain(f"warning: {one.nans} values of {one.name} are NaN{', and became 0' if one.ends else ''}")
        if one.clamped:
            complain(f"warning: {one.clamped} values of {one.name} are outside of {one.ends[0]:g} to {one.ends[1]:g}, "
                     f"and became its ends; they go from {one.least!s} to {one.greatest!s}")
    files = [str(path) for path in files_of(given)]
    if given.json:
        for component, one in zip(record["components"], components):
            for key, end in (("least", one.least), ("greatest", one.greatest)):
                component[key] = float(end) if math.isfinite(end) else None
            component.update(nan=one.nans, clamped=one.clamped)
        print(json.dumps({**record, "files": files, "seconds": seconds}, indent=1))
        return
    print(f"{files[0]}{f' to {files[-1]}' if len(files) > 1 else ''}: {given.function} of "
          f"{' x '.join(map(str, given.size))} points, {given.format}, in {seconds:.2f} s")
    for component, one in zip(record["components"], components):
        ends = f"; {one.ends[0]:g} to {one.ends[1]:g} ({component['range']}) became 0 to 65535" if one.ends else ""
        print(f"  {one.name}: {one.least!s} to {one.greatest!s}{ends}")


def complain(message):
    print(f"{NAME}: {message}", file=sys.stderr)


def main(arguments):
    """The program without its signals. Returns the exit status."""
    try:
        bake(parsed(arguments))
        sys.stdout.flush()
        return 0
    except Stop as stop:
        complain(stop)
        return stop.status
    except (TypeError, ValueError) as error:  # of an argument that the package checks
        if not str(error).startswith("bake: "):
            raise
        complain(str(error).removeprefix("bake: "))
        return 2
    except (MemoryError, OSError) as error:
        complain(f"cannot write the standard output, or there is not enough memory: {error}")
        sys.stdout = None  # or Python would write to it once more
        return 1


def program(arguments):
    """A signal leaves no half file."""
    def end(number, _):
        sys.exit(128 + number)

    for number in (signal.SIGINT, signal.SIGTERM, getattr(signal, "SIGHUP", signal.SIGTERM)):
        if signal.getsignal(number) != signal.SIG_IGN:  # as under nohup
            signal.signal(number, end)
    return main(arguments)
