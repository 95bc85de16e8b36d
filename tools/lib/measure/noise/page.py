"""The page of a judgement: each measure with its sentence, its number and a picture, and our own noise beside it."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from markupsafe import Markup

from base.png import png
from base.tree import version
from measure import page
from measure.noise import record
from measure.noise.measures import Finding
from measure.noise.noise import Sampler


def greys(values: np.ndarray) -> str:
    """A picture of numbers, from the least to the greatest."""
    finite = np.nan_to_num(values.astype(float))
    low, high = finite.min(), finite.max()
    bytes_ = ((finite - low) / max(high - low, 1e-30) * 255).astype(np.uint8)[::-1]
    data = png(values.shape[1], values.shape[0], np.repeat(bytes_[..., None], 3, -1).tobytes())
    return f'<img alt="" width="128" src="data:image/png;base64,{base64.b64encode(data).decode()}">'


def bars(counts: list[int]) -> str:
    most = max(max(counts), 1)
    shown = "".join(f'<rect x="{i}" y="{32 - 32 * count / most:.2f}" width="1" height="{32 * count / most:.2f}"/>'
                    for i, count in enumerate(counts))
    return f'<svg viewBox="0 0 {len(counts)} 32" width="128" fill="currentColor" aria-hidden="true">{shown}</svg>'


def picture(sampler: Sampler, finding: Finding) -> str:
    """The picture beside the number: the field around it where the measure is about places."""
    n = sampler.subject.dimensions
    x, y = np.eye(n)[:2]

    def field(origin: float, step: float) -> str:
        return greys(sampler.grid(np.full(n, origin), x * step, y * step)[:256, :256])

    if finding.measure == "values":
        return bars(finding.more["histogram"])
    if finding.measure == "range":
        return field(0.0, 1 / 32)
    if finding.measure == "repeats":
        return field(0.3, (finding.number or 256) / 63.7)
    if finding.measure == "far":
        return field(1e5, 1 / 32)
    if finding.measure == "mirrors":
        return field(-4.0, 1 / 32)
    if finding.measure == "directions":
        return greys(np.log(finding.more["spectrum"][128:384, 128:384] + 1e-9))
    if finding.measure == "jumps":
        # How much the next place differs: a jump is a line.
        values = sampler.grid(np.full(n, 0.0), x / 64, y / 64).astype(float)[:256, :257]
        return greys(np.abs(np.diff(values, n=2, axis=1)))
    return ""


def write(folder: Path, theirs: Sampler, ours: Sampler, found: Mapping[str, Finding], of_ours: Mapping[str, Finding],
          seconds: float, commit: str) -> None:
    def cell(sampler: Sampler, one: Finding | None) -> Markup | str:
        verdict = {None: "", True: "FAIL ", False: "pass "}[one.fails] if one else ""
        return one and Markup("{}<b>{:.4g}</b><br>{}<br>{}").format(verdict, one.number, one.sentence,
                                                                    Markup(picture(sampler, one))) or ""

    subject = theirs.subject
    text = (f"{subject.expression}, version {commit}, judged from values that Mesa's llvmpipe computed. The file has "
            f"{len(subject.text.encode()):,} bytes, and compiled in {seconds:.2f} s. Numbers are of a sample: what was not "
            "found may be there.")
    rows = [(name, cell(theirs, finding), cell(ours, of_ours.get(name))) for name, finding in found.items()]
    page.write(folder / "index.html", Path(page.__file__).with_name("tables.html"), title=subject.name, problems=(),
               facts={"hashnoise": version(), "renderer": theirs.renderer.version}, sections=[
                   page.Section("Measures", text, ("measure", subject.name, "hn_perlin, for comparison"), rows, "table dense")])
    record.put(folder / "judged.csv", theirs.subject, found.values(), theirs.renderer.version)
