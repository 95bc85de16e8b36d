// How fast the second derivative of simplex noise changes: what a difference in place of a derivative may be off by.
#pragma once

namespace hn {

// A bound on the third derivative of hn_simplex along an axis, per cubed cell, of so many axes. The noise is twice
// continuously differentiable, so between the places where the third derivative jumps the bound holds for the change of
// the second as well.
double simplex_third_derivative(int axes);

}  // namespace hn
