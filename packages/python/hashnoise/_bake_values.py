"""The values of a file: where its points are, and what a function or an expression is there."""

import itertools
import math
import traceback
from contextlib import contextmanager
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal

import numpy as np

import hashnoise

from ._evaluate import AXES, fill, suggestion
from ._grids import field_of, options_of, words_of
from ._noises import NOISES
from ._sums import SUMS

FUNCTIONS = {**NOISES, **SUMS}
PIECE = 1 << 20  # points that are computed at a time
_EXPRESSION = "--expression"


class Stop(Exception):
    """The end of the program with an exit status, and a message."""

    def __init__(self, status, message):
        super().__init__(message)
        self.status = status


def component_names(count):
    """Of what has no names of its own."""
    return ["value"] if count == 1 else list("xyzw"[:count])


def pieces(size):
    """The rows and the columns of all points, in pieces that fit into memory: some rows, or a part of one."""
    width, rows = size[0], math.prod(size[1:])
    each = max(PIECE // width, 1)
    for row, column in itertools.product(range(0, rows, each), range(0, width, PIECE)):
        yield (row, min(row + each, rows)), (column, min(column + PIECE, width))


def places(origin, cells, size, index):
    """The cells of the points with these numbers along an axis, and the fractions in them.

    Point i is at origin + i * cells / size, rounded down to a multiple of 2^-24 of a cell, where the origin and the
    cells are rounded to multiples of 2^-32. All of it is whole numbers, so every machine has the same points, and the
    last one of a tile is followed by the first."""
    first, extent = (int(Decimal(number * 2.0**32).to_integral_value(ROUND_HALF_UP)) for number in (origin, cells))
    at = first + extent // size * index + extent % size * index // size  # no product needs more than 64 bits
    return (at >> 32).astype(np.int32), ((at >> 8 & 0xFFFFFF) * 2.0**-24).astype(np.float32)


def block(given, rows, columns):
    """The places of some points along each axis, as arrays that broadcast to (rows, columns); of a line to (columns,).
    Rows are numbered along y, from its end if that is wanted, then along z and w."""
    if len(given.size) == 1:
        indexes = [np.arange(*columns, dtype=np.int64)]
    else:
        row = np.arange(*rows, dtype=np.int64)[:, np.newaxis]
        indexes = [np.arange(*columns, dtype=np.int64)[np.newaxis]]
        for points in given.size[1:]:
            indexes.append(row % points)
            row = row // points
        if given.y_up:
            indexes[1] = given.size[1] - 1 - indexes[1]
    return [places(*along) for along in zip(given.origin, given.cells, given.size, indexes)]


def positions(axes):
    """The positions as float32."""
    return [(cell + fraction.astype(np.float64)).astype(np.float32) for cell, fraction in axes]


class Function:
    """A noise or a fractal, over any points of a file."""

    def __init__(self, given):
        field = field_of("bake", given.function, len(given.size), given.options)
        made = options_of("bake", given.function, given.options)
        made["instruction_set"] = None
        if made["arithmetic"] == "fast":  # the others have the same bits by all instruction sets
            made["instruction_set"] = field.instruction_set
        if "octaves" in made and made.get("detail") is None:
            made["octaves"] = made["octaves"] or SUMS["billow"].__kwdefaults__["octaves"]
        if not made.pop("fractal"):  # a noise, which the record names as the function
            del made["noise"]
        self.settings = {name: value for name, value in made.items() if value is not None}
        self.components, self.ranges = field.component_names, field.ranges
        self._field, self._threads = field, given.threads
        # The forms of fbm with a detail or a footprint take floats.
        self._as_floats = given.options.keys() & {"detail", "footprint"}

    def __call__(self, axes, shape):
        values = np.empty((len(self.components), *shape), np.float32)
        if self._as_floats:
            fill(self._field, positions(axes), [], values, self._threads)
        else:
            fill(self._field, [fraction for _, fraction in axes], [cell for cell, _ in axes], values, self._threads)
        return values


class Expression:
    """An expression of Python over the functions of the package."""

    def __init__(self, given):
        self._given, self._axes = given, []
        self._period = given.options.get("period", (0,) * len(given.size))
        self._names = {**{name: self._bound(function) for name, function in FUNCTIONS.items()}, "hashnoise": hashnoise,
                       "numpy": np, "seed": given.seed, "period": self._period}
        self.settings = {"expression": given.expression}
        with self._reporting(2):
            if given.source:
                self.settings["source"] = self._read(given.source)
                exec(compile(self.settings["source"], given.source, "exec"), self._names)
            self._code = compile(given.expression.strip(), _EXPRESSION, "eval")
        self.settings.update(arithmetic=given.arithmetic, seed=given.seed)
        if any(self._period):
            self.settings["period"] = self._period
        count = len(self._parts(block(given, (0, 1), (0, 1)), 2))
        if not 1 <= count <= 4:
            raise Stop(2, f"{_EXPRESSION} has {count} components, and must have 1 to 4")
        self.components = component_names(count)
        self.ranges = [None] * count

    def __call__(self, axes, shape):
        values = np.empty((len(self.components), *shape), np.float32)
        with self._reporting(1):
            for number, part in enumerate(self._parts(axes, 1)):
                values[number] = part
        return values

    def _parts(self, axes, status):
        self._axes = axes
        with self._reporting(status), np.errstate(all="ignore"):
            value = eval(self._code, {**self._names, **dict(zip(AXES, positions(axes)))})
            is_planes = isinstance(value, (tuple, list)) or np.ndim(value) > min(len(axes), 2)
            # An error of a part's shape or type is one of the first point, too.
            return [np.asarray(part, np.float32) for part in (value if is_planes else [value])]

    def _bound(self, function):
        """The function with the defaults of the command; without coordinates at the points that are computed."""
        def called(*coordinates, **options):
            given = self._given
            options = {"seed": given.seed, "arithmetic": given.arithmetic, "threads": given.threads or None, **options}
            if not coordinates and "points" not in options:
                cells, coordinates = zip(*self._axes)
                options = {"cell": cells, "period": self._period, **options}
            elif len(coordinates) == 1:  # on a line, whatever the shape of the array
                options["points"], coordinates = np.asarray(coordinates[0])[..., np.newaxis], ()
            return function(*coordinates, **options)
        return called

    @contextmanager
    def _reporting(self, status):
        """Any error of the text, with its place."""
        try:
            yield
        except Stop:
            raise
        except Exception as error:
            files = (self._given.source, _EXPRESSION)
            lines = [(frame.filename, frame.lineno) for frame in traceback.extract_tb(error.__traceback__)]
            if isinstance(error, SyntaxError):
                lines.append((error.filename, error.lineno))
            places = [f"--source {file}, line {line}" if file != _EXPRESSION else file
                      for file, line in lines if file in files]
            meant = suggestion(error.name, [*self._names, *AXES]) if isinstance(error, NameError) else ""
            raise Stop(status, f"{(places or [_EXPRESSION])[-1]}: {type(error).__name__}: {error}{meant}") from None

    @staticmethod
    def _read(path):
        try:
            with open(path, encoding="utf-8") as file:
                return file.read()
        except OSError as error:
            raise Stop(2, f"--source: cannot read {path}: {error.strerror}") from None


@dataclass
class Component:
    """A component of the file, and what was found in it."""

    name: str
    number: int  # among those of the function
    ends: tuple | None = None  # what 0 and 65535 stand for, in a file of words
    least: float = math.inf
    greatest: float = -math.inf
    nans: int = 0
    clamped: int = 0


class Values:
    """The values of pieces of the file, as the file has them."""

    def __init__(self, given, source, components, progress):
        self.source, self.components = source, components
        self._given, self._progress = given, progress

    def __call__(self, rows, columns):
        shape = (rows[1] - rows[0], columns[1] - columns[0])
        planes = self.source(block(self._given, rows, columns), shape)
        made = []
        for one in self.components:
            plane = planes[one.number]
            one.least = min(one.least, np.fmin.reduce(plane, axis=None))
            one.greatest = max(one.greatest, np.fmax.reduce(plane, axis=None))
            one.nans += int(np.count_nonzero(np.isnan(plane)))
            if one.ends:
                values = plane.astype(np.float64)
                one.clamped += int(np.count_nonzero((values < one.ends[0]) | (values > one.ends[1])))
                plane = words_of(values, *one.ends)
            made.append(plane)
        self._progress.update(math.prod(shape))
        return np.stack(made)

    def normalize(self):
        """Computes everything once, to find the ranges."""
        for rows, columns in pieces(self._given.size):
            self(rows, columns)
        for one in self.components:
            if not math.isfinite(one.greatest - one.least):
                raise Stop(1, f"--normalize: the values of {one.name} go from {one.least} to {one.greatest}; name the "
                              "range with --range")
            one.ends, one.nans = (float(one.least), float(one.greatest)), 0
