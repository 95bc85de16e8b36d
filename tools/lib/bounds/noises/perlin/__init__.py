"""hn_perlin: exact.py (its range and slope), floats.py and fixed.py (its errors)."""

from __future__ import annotations

from bounds.floats import position_error
from bounds.gradients import GRADIENTS, OCTAHEDRAL, SINE, Gradient
from bounds.noises import Derived
from bounds.noises.perlin.exact import (SCALE, SLOPE_WITNESS, STEPS, library_range, lipschitz_bound, lipschitz_witness,
                                        range_bound, range_witness, sine_range)
from bounds.noises.perlin.fixed import error_parts, fixed_error, largest_intermediates, range_loss
from bounds.noises.perlin.floats import error_bound
from bounds.table import rounded_up, shortest

DIMENSIONS = (2, 3)


def derive(dims: int, gradient: Gradient) -> Derived:
    lipschitz, cell_error = lipschitz_bound(dims, gradient), error_bound(dims, gradient)
    error = position_error(cell_error, lipschitz)
    if gradient is SINE:
        promise = exact = of_library = sine_range(dims)
    else:
        promise, exact, of_library = 1.0, range_bound(dims, SCALE[OCTAHEDRAL][dims]), library_range(dims)
    return Derived(promise, exact, lipschitz, cell_error, error, exact + error, fixed_error(dims, gradient),
                   of_library + range_loss(dims, gradient), error_parts(dims, gradient))


def quotes() -> list[tuple[str, str]]:
    """What prose states of its range."""
    exact = [shortest(range_bound(dims, SCALE[OCTAHEDRAL][dims]), digits) for dims, digits in ((2, 6), (3, 5))]
    library = [str(rounded_up(library_range(dims), 5)) for dims in DIMENSIONS]
    witness = [str(-rounded_up(-float(range_witness(dims)[0]), 5)) for dims in DIMENSIONS]
    return [("docs/knobs.md", f"2D noise stays below {exact[0]} and 3D noise below {exact[1]}."),
            ("docs/knobs.md", f"gradients that reach {' and '.join(witness)};"),
            ("docs/accuracy.md", f"the noise stays below {' and '.join(library)};"),
            ("docs/accuracy.md", f"it reaches {' and '.join(witness)}.")]


def describe(dims: int, gradient: Gradient) -> dict[str, object]:
    numbers = {
        "scale": SCALE[gradient][dims],
        "lipschitz_attained": lipschitz_witness(dims, gradient),
        "lipschitz_attained_at": SLOPE_WITNESS[gradient][dims],
        "error_from_cell_to_nearest": error_bound(dims, gradient, 0.5),
        "fixed_beyond_the_range": range_loss(dims, gradient),
    }
    if gradient is OCTAHEDRAL:
        witness, point, gradients = range_witness(dims)
        numbers |= {"range_of_the_library_at_most": library_range(dims), "range_attained": float(witness),
                    "range_attained_at": point, f"range_attained_with_gradients_times_{STEPS[dims]}":
                    {str(corner): [int(g * STEPS[dims]) for g in gradients[corner]] for corner in gradients}}
    return numbers
