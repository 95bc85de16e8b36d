"""Section 12 of docs/reference/contract.md: positions that are integers. All of it is exact in the library, too."""

from __future__ import annotations

from proof.oracle.hashes import signed


def clamped(setting: int) -> int:
    """Cells, or units."""
    return min(max(setting, 1), 65536)


def cell(position: int, cells: int, units: int) -> int:
    """hn_cell, along one axis."""
    return signed(position * clamped(cells) // clamped(units))


def fraction(position: int, cells: int, units: int) -> float:
    """hn_fraction, along one axis: in [0, 1)."""
    u = clamped(units)
    return 2**24 * (position * clamped(cells) % u) // u / 2**24
