"""Proves the numbers the documentation quotes about hn_perlin and the octave sums: range, Lipschitz constant, errors.

    tools/bounds           a table
    tools/bounds --json    the same as JSON

perlin.py proves the range and the Lipschitz constant, floats.py the error of the float arithmetic (HN_FAST
and HN_PRECISE), fixed.py that of the fixed (HN_FIXED); each says how.
"""

import argparse
import json
import math

from bounds.fixed import (error_parts, fade_errors, fixed_error, fixed_octave_tolerance, fixed_sine_error,
                          fixed_sine_largest, largest_intermediates, overshoot, range_loss)
from bounds.floats import (SINE_ARGUMENT_ERROR, error_bound, octave_tolerance, position_error, sine_bound, sine_largest,
                          sine_truncation_bound)
from bounds.perlin import (GRADIENTS, SCALE, SINE, SLOPE_WITNESS, STEPS, library_range, lipschitz_bound,
                          lipschitz_witness, range_bound, range_witness, sine_range)


def derive(dims, gradient):
    """All bounds of one dimension and kind of gradient, as a dictionary."""
    lipschitz = lipschitz_bound(dims, gradient)
    result = {"scale": gradient.scale[dims]}
    if gradient is SINE:
        result["range_at_most"] = sine_range(dims)
    else:
        witness, point, gradients = range_witness(dims)
        result |= {
            "range_at_most": range_bound(dims, SCALE[dims]),
            "range_of_the_library_at_most": library_range(dims),
            "range_attained": float(witness),
            "range_attained_at": point,
            "range_attained_with": {str(corner): list(map(float, g)) for corner, g in gradients.items()},
        }
    result |= {
        "lipschitz_at_most": lipschitz,
        "lipschitz_attained": lipschitz_witness(dims, gradient),
        "lipschitz_attained_at": SLOPE_WITNESS[gradient][dims],
    }
    for name, ulps in (("any_rounding", 1.0), ("to_nearest", 0.5)):
        cell_error = error_bound(dims, gradient, ulps)
        result["error_from_cell_" + name] = cell_error
        result["error_from_position_" + name] = position_error(cell_error, lipschitz, ulps)
    result["fixed_error"] = fixed_error(dims, gradient)
    result |= {f"fixed_error_of_{part}": float(error) for part, error in error_parts(dims, gradient).items()}
    result["fixed_beyond_the_range"] = float(range_loss(dims, gradient))
    result |= {f"fixed_{name.replace(' ', '_')}_over_2^31": float(value / 2**31)
               for name, value in largest_intermediates(dims, gradient).items()}
    return result


def derive_fade():
    """The fixed fade: how far it is off, and how far it leaves [0, 1]."""
    return {"error_from": float(fade_errors().min()), "error_to": float(fade_errors().max()), "overshoot": overshoot()}


def derive_sine():
    """The bounds of the sine itself."""
    return {
        "polynomial_error": sine_truncation_bound(),
        "argument_error": math.pi / 2 * SINE_ARGUMENT_ERROR,
        "error_any_rounding": sine_bound(),
        "error_to_nearest": sine_bound(0.5),
        "error_promised": SINE.component_error,
        "below_1_by_any_rounding": 1 - sine_largest(),
        "fixed_error": fixed_sine_error(),
        "fixed_largest": float(fixed_sine_largest()),
    }


OCTAVE_EXAMPLES = [  # kind, dims, p_max, octaves, lacunarity, gain, exact_positions
    ("fbm", 2, 16.0, 5, 2.0, 0.5, True),
    ("fbm", 2, 16.0, 5, 2.0, 0.5, False),
    ("fbm", 3, 16.0, 5, 2.0, 0.5, False),
    ("fbm", 3, 1024.0, 8, 2.0, 0.5, False),
    ("turbulence", 3, 16.0, 5, 1.9, 0.6, False),
    ("clouds", 2, 16.0, 5, 2.0, 0.5, False),
]


def print_numbers(result):
    for name, value in result.items():
        if isinstance(value, float) and name != "scale":
            print(f"  {name.replace('_', ' '):36} {value:.9g}")


def print_table(results, sine, fixed_fade):
    for (kind, dims), result in results.items():
        print(f"hn_perlin {dims}D, {kind} gradient, scale {result['scale'] * 1024:.0f}/1024")
        print_numbers(result)
        if "range_attained_at" in result:
            steps = STEPS[dims]
            print(f"  {'range attained at':36} {result['range_attained_at']} with the gradients (times {steps})")
            for corner, gradient in result["range_attained_with"].items():
                print(f"  {'':36} {corner}: {tuple(round(g * steps) for g in gradient)}")
        print(f"  {'lipschitz attained at':36} {result['lipschitz_attained_at']}")
    print("the sine of the sine gradient")
    print_numbers(sine)
    print("the fixed fade")
    print_numbers(fixed_fade)
    print("octave_tolerance(kind, dims, p_max, octaves, lacunarity, gain, exact_positions), octahedral and sine;")
    print("fixed_octave_tolerance of the same")
    for example in OCTAVE_EXAMPLES:
        tolerances = [of(*example, gradient) for of in (octave_tolerance, fixed_octave_tolerance)
                      for gradient in GRADIENTS]
        print(f"  {str(example):52} " + " ".join(f"{tolerance:<9.3g}" for tolerance in tolerances).rstrip())


def main():
    parser = argparse.ArgumentParser(description="Proves the range, Lipschitz constant and errors of hn_perlin.")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    as_json = parser.parse_args().json
    results = {(gradient.name, dims): derive(dims, gradient) for gradient in GRADIENTS for dims in SCALE}
    sine, fixed_fade = derive_sine(), derive_fade()
    if as_json:
        by_gradient = {g.name: {dims: results[g.name, dims] for dims in SCALE} for g in GRADIENTS}
        print(json.dumps({**by_gradient, "sine_itself": sine, "fixed_fade": fixed_fade}, indent=2))
    else:
        print_table(results, sine, fixed_fade)


if __name__ == "__main__":
    main()
