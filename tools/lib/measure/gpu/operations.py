"""Measures what an operation costs: by shaders that do it over and over, and the slope between two lengths."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple


class Operation(NamedTuple):
    name: str  # of its subjects, and in the record
    title: str
    kind: str  # of x, y and z: "uint" or "float"
    step: str  # what x becomes; no compiler knows x, y and z
    setup: str = ""  # before the first step


# As authors write them. A step that a compiler would fold with the one before has a companion, which the title names.
OPERATIONS = (
    Operation("product32", "product of 32 bits", "uint", "x * y"),
    Operation("product24", "product of 24 bits, with a mask", "uint", "(x & 0xFFFFFFu) * y", "y &= 0xFFFFFFu;"),
    Operation("product_high", "upper half of a product of 32 bits", "uint", "upper_half(x, y)"),
    Operation("product_sum", "product of 32 bits, and sum", "uint", "x * y + z"),
    Operation("sum_xor", "sum, and exclusive or", "uint", "(x + y) ^ z"),
    Operation("shift", "shift", "uint", "x >> y", "y &= 1u;"),
    Operation("shift_xor", "shift by a constant, and exclusive or", "uint", "x ^ (x >> 15u)"),
    Operation("rotation_sum", "rotation, and sum", "uint", "(x << 13u | x >> 19u) + y"),
    Operation("to_float", "conversion to a float", "float", "float(floatBitsToUint(x))"),
    Operation("from_float", "conversion from a float", "float", "intBitsToFloat(int(x))"),
    Operation("fma", "product and sum of floats", "float", "x * y + z"),
    Operation("floor", "floor, and product", "float", "floor(x) * y"),
    Operation("fract", "fraction, and product", "float", "fract(x) * y"),
    Operation("max", "maximum, and product", "float", "max(x, z) * y"),
    Operation("select", "comparison, selection and product", "float", "(x < z ? y : x) * z"),
    Operation("division", "division", "float", "y / x"),
    Operation("root", "square root", "float", "sqrt(x)"),
    Operation("exponential", "power of two", "float", "exp2(x)"),
    Operation("sine", "sine", "float", "sin(x)"),
    Operation("texture", "texture, read where the one before points", "float", "texture(image, vec2(x, y)).r"),
)
CHAINS = (1, 8)  # that a shader has side by side
LENGTHS = (16, 48)  # of a chain; what a shader costs at its ends is in both
X = re.compile(r"\bx\b")
DECLARATIONS = """layout(set = 0, binding = 0) uniform sampler2D image;
uint upper_half(uint a, uint b) {
  uint upper, lower;
  umulExtended(a, b, upper, lower);
  return upper;
}"""


def shader(operation: Operation, chains: int, length: int) -> str:
    """A function chain(vec2 p) that does the operation so often, in chains that do not wait for each other."""
    uint = operation.kind == "uint"
    low, high = ("floatBitsToUint(p.x)", "floatBitsToUint(p.y)") if uint else ("p.x", "p.y")
    names = [f"x{chain}" for chain in range(chains)]
    total = (" ^ " if uint else " + ").join(names)
    lines = [f"{operation.kind} y = {high}, z = {low} + {high};", operation.setup,
             # No compiler may take the chains for the same, as fractions of x + 1.0 and x + 2.0 are.
             *(f"{operation.kind} {name} = {low} + {f'{2 * chain + 1}u' if uint else f'{0.37 * (chain + 1):.2f}'};"
               for chain, name in enumerate(names)),
             *(f"{name} = {X.sub(name, operation.step)};" for _ in range(length) for name in names),
             f"return {f'uintBitsToFloat({total})' if uint else total};"]
    return "\n".join([DECLARATIONS, "float chain(vec2 p) {", *lines, "}", ""])


def subject(operation: Operation, chains: int, length: int) -> str:
    """Its id. The last number is of the dimensions, which hn-conform adds."""
    return f"operation-{operation.name}-{chains}-{length}-2"


def is_operation(subject: str) -> bool:
    return subject.startswith("operation-")


def write_shaders(folder: Path) -> list[str]:
    """Writes them all; returns the arguments for which hn-conform compiles them."""
    arguments = []
    for operation in OPERATIONS:
        for chains in CHAINS:
            for length in LENGTHS:
                file = folder / f"{operation.name}-{chains}-{length}.glsl"
                file.write_text(shader(operation, chains, length), encoding="ascii")
                arguments += ["--against", f"{subject(operation, chains, length)[:-1]}={file}:chain(p)"]
    return arguments


def price(shortest: float, longest: float, chains: int) -> float:
    """Of one operation, from what the shaders of both lengths cost."""
    return (longest - shortest) / (LENGTHS[1] - LENGTHS[0]) / chains
