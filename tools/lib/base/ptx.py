"""PTX, which NVIDIA's compilers write for GPUs, as C: so that a CPU runs what they made of a kernel.

A kernel is called for one thread, which the variables tid_x, ntid_x, ctaid_x and ctaid_y name. Its parameters are
pointers. It calls nothing, and shares nothing with other threads.
"""

from __future__ import annotations

import re

TYPES = {"pred": "int", "b16": "uint16_t", "b32": "uint32_t", "b64": "uint64_t", "u16": "uint16_t", "u32": "uint32_t",
         "u64": "uint64_t", "u128": "unsigned __int128", "s16": "int16_t", "s32": "int32_t", "s64": "int64_t", "f32": "float"}
FLAGS = ("-ffp-contract=off", "-fwrapv", "-fno-strict-aliasing", "-w")  # as PTX computes
PRELUDE = """
#include <math.h>
#include <stdint.h>
#include <string.h>
uint32_t tid_x, ntid_x, ctaid_x, ctaid_y;
static float to_float(uint32_t bits) { float x; memcpy(&x, &bits, 4); return x; }
static uint32_t to_bits(float x) { uint32_t bits; memcpy(&bits, &x, 4); return bits; }
static int32_t rzi_s32(float x) {
  return x != x ? 0 : x >= 2147483648.0f ? INT32_MAX : x < -2147483648.0f ? INT32_MIN : (int32_t)x;
}
static uint32_t rzi_u32(float x) { return x >= 4294967296.0f ? UINT32_MAX : x > 0.0f ? (uint32_t)x : 0; }
static uint32_t prmt(uint32_t a, uint32_t b, uint32_t which) {
  const uint64_t bytes = (uint64_t)b << 32 | a;
  uint32_t d = 0;
  for (int i = 0; i < 4; ++i) {
    const uint32_t byte = (uint32_t)(bytes >> (which >> 4 * i & 7) * 8) & 255;
    d |= (which >> 4 * i & 8 ? (byte >> 7) * 255 : byte) << 8 * i;
  }
  return d;
}
static uint32_t brev(uint32_t a) {
  uint32_t d = 0;
  for (int i = 0; i < 32; ++i) d |= (a >> i & 1) << (31 - i);
  return d;
}
static float min_f32(float a, float b) { return a == b && signbit(a) ? a : fminf(a, b); }
static float max_f32(float a, float b) { return a == b && signbit(a) ? b : fmaxf(a, b); }
"""
UNSIGNED_PLUS = {"add": "{0} + {1}", "sub": "{0} - {1}", "mul": "{0} * {1}", "mad": "{0} * {1} + {2}", "neg": "-{0}"}
# The operands have the type that ends the name of the operation. PTX shifts by more bits than there are, C does not.
OPERATIONS = {
    **UNSIGNED_PLUS, "fma": "fmaf({0}, {1}, {2})", "div": "{0} / {1}", "rem": "{0} % {1}", "rcp": "1.0f / {0}",
    "sqrt": "sqrtf({0})", "and": "{0} & {1}", "or": "{0} | {1}", "xor": "{0} ^ {1}", "not": "~{0}", "mov": "{0}",
    "cvta": "{0}", "prmt": "prmt({0}, {1}, {2})", "brev": "brev({0})",
    "shl": "{1} >= {bits} ? 0 : {0} << {1}", "shr": "{0} >> ({1} >= {bits} ? {bits} - 1 : {1}) >> ({1} >= {bits})",
    "shf": "{2} % 32 ? {1} << {2} % 32 | {0} >> (32 - {2} % 32) : {1}",
    "min": "{0} < {1} ? {0} : {1}", "max": "{0} > {1} ? {0} : {1}", "abs": "{0} < 0 ? -(uint32_t){0} : {0}",
    "min.f32": "min_f32({0}, {1})", "max.f32": "max_f32({0}, {1})", "abs.f32": "fabsf({0})", "not.pred": "!{0}"}
COMPARED = {"eq": "{0} == {1}", "ne": "{0} != {1}", "lt": "{0} < {1}", "le": "{0} <= {1}", "gt": "{0} > {1}",
            "ge": "{0} >= {1}", "neu": "{0} != {1}", "ltu": "!({0} >= {1})", "leu": "!({0} > {1})",
            "gtu": "!({0} <= {1})", "geu": "!({0} < {1})"}
CONVERTED = {"rzi.s32": "rzi_s32({0})", "rzi.u32": "rzi_u32({0})", "rzi.f32": "truncf({0})", "rmi.f32": "floorf({0})"}


def _operand(text: str, of: str) -> str:
    if text.startswith("0f"):
        value, is_float = f"to_float(0x{text[2:]}u)", True
    else:
        value, is_float = text.removeprefix("%").replace(".", "_"), text.startswith("%f")
    if of == "f32":
        return value if is_float else f"to_float({value})"
    return f"({TYPES[of]}){f'to_bits({value})' if is_float else value}"


def _statement(operation: str, operands: list[str]) -> str:
    name, *kinds = operation.split(".")
    of = kinds[-1] if kinds else ""
    if name == "ret":
        return "return;"
    if name == "bra":
        return f"goto {operands[0].removeprefix('$')};"
    if name in ("ld", "st"):
        place = operands[name == "ld"].strip("[]").removeprefix("%")
        if kinds[0] == "param":
            return f"{operands[0].removeprefix('%')} = (uint64_t){place};"
        place = f"*({TYPES[of]}*)({place})"
        return f"{operands[0].removeprefix('%')} = {place};" if name == "ld" else f"{place} = {_operand(operands[1], of)};"
    to, *operands = operands
    given = [_operand(operand, of) for operand in operands]
    if name == "setp":
        is_ordered = (kinds[0], of) == ("ne", "f32")  # a NaN is not
        expression, of = ("{0} < {1} || {0} > {1}" if is_ordered else COMPARED[kinds[0]]).format(*given), "pred"
    elif name == "selp":
        expression = "{2} ? {0} : {1}".format(*given[:2], _operand(operands[2], "pred"))
    elif name == "cvt":
        of = kinds[-2]
        rounded = kinds[0] if kinds[0] in ("rzi", "rmi") else ""
        expression = CONVERTED[f"{rounded}.{of}"].format(*given) if rounded else given[0]
    elif kinds[0] in ("wide", "hi"):
        bits, wide = int(of[1:]), TYPES[f"{of[0]}{2 * int(of[1:])}"]
        expression = f"({wide}){given[0]} * {given[1]}" + (f" >> {bits}" if kinds[0] == "hi" else "")
    else:
        if name in UNSIGNED_PLUS:
            given = [_operand(operand, of.replace("s", "u")) for operand in operands]
        if name in ("shl", "shr"):
            given[1] = _operand(operands[1], "u32")
        text = OPERATIONS[f"{name}.{of}" if f"{name}.{of}" in OPERATIONS else name]
        expression = text.format(*given, bits=of[1:])
    if to.startswith("%f") and of != "f32":
        expression = f"to_float({expression})"
    elif of == "f32" and not to.startswith("%f"):
        expression = f"to_bits({expression})"
    return f"{to.removeprefix('%')} = {expression};"


def to_c(ptx: str) -> str:
    """A function of C for each kernel of the text, with its name."""
    lines = [PRELUDE]
    for line in re.sub(r"//.*|^\s*\.(version|target|address_size|pragma).*", "", ptx, flags=re.MULTILINE).splitlines():
        line = line.strip()
        if entry := re.fullmatch(r"(?:\.visible )?\.entry (\w+)\(", line):
            lines.append(f"void {entry[1]}(")
        elif parameter := re.fullmatch(r"\.param \.u64 (?:\.ptr (?:\.global )?\.align \d+ )?(\w+)(,?)", line):
            lines.append(f"const void* {parameter[1]}{parameter[2]}")
        elif registers := re.fullmatch(r"\.reg \.(\w+)\s+%(\w+)<(\d+)>;", line):
            lines.append(f"{TYPES[registers[1]]} " + ", ".join(f"{registers[2]}{i}" for i in range(int(registers[3]))) + ";")
        elif label := re.fullmatch(r"\$(\w+):", line):
            lines.append(f"{label[1]}:;")
        elif statement := re.fullmatch(r"(?:@(!?)%(\w+)\s+)?([a-z][\w.]*)\s*(.*);", line):
            negated, condition, operation, operands = statement.groups()
            try:
                translated = _statement(operation, [operand.strip() for operand in operands.split(",")])
            except KeyError as error:
                raise ValueError(f"PTX that is not known: {line}") from error
            lines.append(f"if ({negated}{condition}) {translated}" if condition else translated)
        elif line in ("", ")", "{", "}"):
            lines.append(line)
        else:
            raise ValueError(f"PTX that is not known: {line}")
    return "\n".join(lines)
