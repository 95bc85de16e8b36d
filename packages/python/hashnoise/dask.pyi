"""The types of hashnoise.dask. Docstrings are beside the code."""

from typing import Any

import dask.array
import xarray

from . import _Arithmetic, _Dtype, _Metric, _Name, _Noise, _Number, _Numbers, _Vector, _Whole, _Wholes

__all__ = ["data_array", "grid"]

def grid(name: _Name, size: _Wholes, *, step: _Numbers, chunks: Any = "auto",
         arithmetic: _Arithmetic = "fixed", threads: _Whole = 1, origin: _Numbers = ...,
         cell: _Wholes | None = ..., seed: _Whole = ..., noise: _Noise | None = ..., octaves: _Whole | None = ...,
         lacunarity: _Number | None = ..., gain: _Number | None = ..., strength: _Number | None = ...,
         amplitude: _Number | None = ..., detail: _Number | None = ..., footprint: _Number | None = ...,
         period: _Wholes | None = ..., wave: _Vector | None = ..., phase: _Number | None = ...,
         jitter: _Number | None = ..., metric: _Metric | None = ..., dtype: _Dtype | None = ...,
         range: _Vector | None = ..., instruction_set: str | None = ...) -> dask.array.Array: ...
def data_array(name: _Name, size: _Wholes, *, step: _Numbers, cell_size: _Number = 1.0,
               unit: str = "cells", chunks: Any = ..., arithmetic: _Arithmetic = ..., threads: _Whole = ...,
               origin: _Numbers = ..., cell: _Wholes | None = ..., seed: _Whole = ...,
               noise: _Noise | None = ..., octaves: _Whole | None = ..., lacunarity: _Number | None = ...,
               gain: _Number | None = ..., strength: _Number | None = ..., amplitude: _Number | None = ...,
               detail: _Number | None = ..., footprint: _Number | None = ...,
               period: _Wholes | None = ..., wave: _Vector | None = ...,
               phase: _Number | None = ..., jitter: _Number | None = ..., metric: _Metric | None = ...,
               dtype: _Dtype | None = ..., range: _Vector | None = ...,
               instruction_set: str | None = ...) -> xarray.DataArray: ...
