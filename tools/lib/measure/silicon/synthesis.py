"""Synthesis of modules by Yosys, and their clock by nextpnr."""

from __future__ import annotations

import hashlib
import re
import subprocess
from pathlib import Path

from base.tree import ROOT
from translate.pick.verilog import CLOCK, Made

FOLDER = ROOT / "build" / "silicon"
# Chips of the family, the smallest first: name, option of nextpnr, tables of four inputs, multipliers.
CHIPS = (("ECP5-25", "--25k", 24288, 28), ("ECP5-45", "--45k", 43848, 72), ("ECP5-85", "--85k", 83640, 156))
MOST_USED = 0.9  # of a chip, for which wires are found
ECP5 = "synth_ecp5 -noflatten -top bench -json {0}.json; stat"
GENERIC = "synth -flatten -noabc -top {0}; abc -g cmos; opt_clean; stat -tech cmos"
NAND = 4  # transistors of the gate that counts as one


def bench(made: Made) -> str:
    """The module between registers, since chips have fewer pins than it has ports."""
    inputs = sum(port.width for port in made.read)
    outputs = sum(port.width for port in made.outputs)
    connected, at = [".clock(clock)"], 0
    for port in made.read:
        connected.append(f".{port.name}(inputs[{at + port.width - 1}:{at}])")
        at += port.width
    at = 0
    for port in made.outputs:
        connected.append(f".{port.name}(outputs[{at + port.width - 1}:{at}])")
        at += port.width
    return f"""
module bench (input wire clock, input wire in, input wire [7:0] which, output reg out);
  reg [{inputs - 1}:0] inputs;
  wire [{outputs - 1}:0] outputs;
  reg [{outputs - 1}:0] kept;
  always @(posedge clock) begin
    inputs <= {{inputs[{inputs - 2}:0], in}};
    kept <= outputs;
    out <= kept[which];
  end
  {made.name} one ({', '.join(connected)});
endmodule
"""


def counted(report: str, module: str) -> dict[str, int]:
    """The cells of a module, by their kinds, as Yosys prints them last."""
    part = report.rpartition(f"=== {module} ===")[2].partition("===")[0]
    return {kind: int(number) for kind, number in re.findall(r"^ +(\$?\w+) +(\d+)$", part, re.MULTILINE)}


def run(key: str, program: str | Path, *options: str) -> str:
    """Returns the output of a program, or the one that it had before for the same key and options."""
    name = hashlib.sha256("\n".join([key, Path(program).name, *options]).encode()).hexdigest()[:24]
    file = FOLDER / f"{name}.log"
    if not file.exists():
        done = subprocess.run([program, *options], cwd=FOLDER, capture_output=True, text=True, check=False)
        if done.returncode:
            shown = (done.stdout + done.stderr)[-2000:]
            raise RuntimeError(f"{' '.join([str(program), *options])} returned {done.returncode}:\n{shown}")
        file.write_text(done.stdout + done.stderr, encoding="utf-8")
    return file.read_text(encoding="utf-8")


def synthesised(made: Made, nextpnr: Path) -> dict[str, object]:
    """Its size, and the smallest chip that it fits; with its clock, if that is the smallest of all. Gates are those of a
    circuit whose products are left to Yosys."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    text = made.text() + bench(made)
    name = f"{made.name}-{hashlib.sha256(text.encode()).hexdigest()[:12]}"
    (FOLDER / f"{name}.v").write_text(text, encoding="ascii")
    cells = counted(run(text, "yosys", "-p", f"read_verilog {name}.v; {ECP5.format(name)}"), made.name)
    found: dict[str, object] = {
        "luts": cells.get("LUT4", 0) + 2 * cells.get("CCU2C", 0), "multipliers": cells.get("MULT18X18D", 0),
        "registers": cells.get("TRELLIS_FF", 0), "gates": "", "latency": made.pipeline.latency, "chip": "", "mhz": ""}
    if not made.choice.multipliers:
        generic = run(text, "yosys", "-p", f"read_verilog {name}.v; {GENERIC.format(made.name)}")
        found["gates"] = round(int(re.findall(r"Estimated number of transistors: +(\d+)", generic)[-1]) / NAND)
    chip = next((one for one in CHIPS if found["luts"] <= MOST_USED * one[2] and found["multipliers"] <= one[3]), None)
    found["chip"] = chip[0] if chip else ""
    if chip == CHIPS[0]:
        log = run(text, nextpnr, chip[1], "--package", "CABGA381", "--speed", "6", "--json", f"{name}.json", "--freq",
                  made.choice.clock or CLOCK, "--timing-allow-fail", "--seed", "1", "--lpf-allow-unconstrained")
        found["mhz"] = float(re.findall(r"Max frequency for clock .*?: ([\d.]+) MHz", log)[-1])
    return found
