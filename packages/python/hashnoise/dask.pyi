"""The types of hashnoise.dask. Docstrings are beside the code."""

from collections.abc import Sequence
from typing import Any

import dask.array
import xarray

from . import _Arithmetic, _Dtype, _Metric, _Name, _Noise

__all__ = ["data_array", "grid"]

def grid(name: _Name, size: int | Sequence[int], *, step: float | Sequence[float], chunks: Any = "auto",
         arithmetic: _Arithmetic = "fixed", threads: int = 1, origin: float | Sequence[float] = ...,
         cell: int | Sequence[int] | None = ..., seed: int = ..., noise: _Noise | None = ..., octaves: int | None = ...,
         lacunarity: float | None = ..., gain: float | None = ..., strength: float | None = ...,
         amplitude: float | None = ..., detail: float | None = ..., footprint: float | None = ...,
         period: int | Sequence[int] | None = ..., wave: Sequence[float] | None = ..., phase: float | None = ...,
         jitter: float | None = ..., metric: _Metric | None = ..., dtype: _Dtype | None = ...,
         range: tuple[float, float] | None = ..., instruction_set: str | None = ...) -> dask.array.Array: ...
def data_array(name: _Name, size: int | Sequence[int], *, step: float | Sequence[float], cell_size: float = 1.0,
               unit: str = "cells", chunks: Any = ..., arithmetic: _Arithmetic = ..., threads: int = ...,
               origin: float | Sequence[float] = ..., cell: int | Sequence[int] | None = ..., seed: int = ...,
               noise: _Noise | None = ..., octaves: int | None = ..., lacunarity: float | None = ...,
               gain: float | None = ..., strength: float | None = ..., amplitude: float | None = ...,
               detail: float | None = ..., footprint: float | None = ...,
               period: int | Sequence[int] | None = ..., wave: Sequence[float] | None = ...,
               phase: float | None = ..., jitter: float | None = ..., metric: _Metric | None = ...,
               dtype: _Dtype | None = ..., range: tuple[float, float] | None = ...,
               instruction_set: str | None = ...) -> xarray.DataArray: ...
