"""hn_perlin: exact.py (its range and slope), floats.py and fixed.py (its errors). hn_perlin_d is proven here, too, and
has its entry in perlin_d.py of the folder above."""

from __future__ import annotations

from proof.bounds.floats import position_error
from proof.bounds.gradients import OCTAHEDRAL, SINE, Gradient
from proof.bounds.noises import ProvenBounds
from proof.bounds.noises.perlin.exact import SCALE, lipschitz_bound, range_bound
from proof.bounds.noises.perlin.fixed import error_parts, fixed_error, largest_intermediates, range_loss  # noqa: F401
from proof.bounds.noises.perlin.floats import error_bound
from proof.bounds.table import shortest

CASES = (*((dims, OCTAHEDRAL) for dims in (1, 2, 3, 4)), *((dims, SINE) for dims in (2, 3)))


def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    exact, lipschitz = range_bound(dims, gradient), lipschitz_bound(dims, gradient)
    cell_error = error_bound(dims, gradient)
    error = position_error(cell_error, lipschitz)
    return ProvenBounds(exact if gradient is SINE else 1.0, exact, lipschitz, cell_error, error, exact + error,
                   fixed_error(dims, gradient), exact + range_loss(dims, gradient), error_parts(dims, gradient))


def quotes() -> list[tuple[str, str]]:
    """The claims of prose on its range."""
    exact = [shortest(range_bound(dims, OCTAHEDRAL), 5) for dims in (1, 2, 3, 4)]
    below = f"{', '.join(exact[:3])} and {exact[3]}"
    return [("docs/reference/knobs.md", f"noise stays below {below} in 1D to 4D."),
            ("docs/measured/accuracy.md", f"stays below {below}.")]


def describe(dims: int, gradient: Gradient) -> dict[str, object]:
    return {"scale": SCALE[gradient][dims], "error_from_cell_to_nearest": error_bound(dims, gradient, 0.5),
            "fixed_beyond_the_range": range_loss(dims, gradient)}
