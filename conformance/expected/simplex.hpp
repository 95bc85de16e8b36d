// How fast the second derivatives of simplex and of phasor noise change: how much a difference in place of a derivative
// may be off by.
#pragma once

namespace hn {

// A bound on the third derivative of hn_simplex along an axis, per cubed cell, of so many axes. The noise is twice
// continuously differentiable, so between the places where the third derivative jumps the bound holds for the change of
// the second as well.
double simplex_third_derivative(int axes);

// The bound for hn_phasor, along an axis along which so many waves run in a cell.
double phasor_third_derivative(int axes, double waves);

}  // namespace hn
