"""What a candidate costs, and how random it is."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "randomness"))

import gate
import library
import noise
from candidates import Candidate, write
from judgement import Finding


class NotMeasured(Exception):
    pass


@dataclass
class Cost:
    """Of hn_perlin, against the empty shader; times as ratios to Perlin/Float of the same run, and their spread."""
    ratio: float
    spread: float
    spirv: int
    navi21: int | None   # inverse throughput: cycles of a compute unit per wave of 64
    instructions: int | None


@dataclass
class Result:
    candidate: Candidate
    costs: dict[int, Cost]            # by the number of dimensions
    worst: dict[int, Finding] | None  # the most improbable finding
    failed: dict[int, list[str]] | None
    noise: dict[int, dict[str, tuple[float, float]]] | None


def measure(candidate: Candidate, program: Path, rounds: int, gradient: bool) -> Result:
    """A hash is judged by the gate, unless it is one that HN_HASH names, which tools/quality judges; of a gradient the
    noise is measured."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        include = write(candidate, library.ROOT, folder)
        costs = bench(candidate, program, folder, rounds)
        if candidate.macros:
            return Result(candidate, costs, None, None, None)
        twin = library.build(candidate.name, [], include, folder)
        if gradient:
            return Result(candidate, costs, None, None,
                          {n: noise.measure(twin, n, 1 << 20).numbers for n in (2, 3)})
        findings = {n: gate.judge_twin(twin, n, gate.LEAST) for n in (2, 3)}
        return Result(candidate, costs, {n: min(found, key=lambda f: f.p) for n, found in findings.items()},
                      {n: sorted({f.test for f in found if not f.passed}) for n, found in findings.items()}, None)


def bench(candidate: Candidate, program: Path, folder: Path, rounds: int) -> dict[int, Cost]:
    knobs = candidate.macros[0].removeprefix("HN_HASH=HN_HASH_").lower() if candidate.macros else "lattice"
    command = [program, "bench", "--glsl", folder / "glsl", "--out", folder / "bench", "--rounds", str(rounds),
               "--filter", f"noise?d.perlin.{knobs}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise NotMeasured(f"{candidate.name}: hn-conform bench ended with {done.returncode}\n{done.stdout}{done.stderr}")
    subjects = {s["id"]: s for s in json.loads((folder / "bench" / "bench.json").read_text(encoding="utf-8"))["subjects"]}
    return {n: cost(subjects[f"noise{n}d.perlin.{knobs}"], subjects[f"empty{n}"]) for n in (2, 3)}


def cost(subject: dict, empty: dict) -> Cost:
    counts, nothing = subject["instructions"], empty["instructions"]

    def beyond(source: str, what: str) -> int | None:
        if source not in counts:
            return None  # RADV is not here
        return counts[source][what] - nothing[source][what]

    return Cost(subject["ratio"], subject["spread"], counts["spirv"] - nothing["spirv"],
                beyond("navi21", "inverse_throughput"), beyond("navi21", "instructions"))
