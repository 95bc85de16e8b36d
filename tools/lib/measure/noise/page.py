"""The page of a judgement: each measure with its sentence, its number and a picture, and our own noise beside it."""

from __future__ import annotations

import base64
import html
import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from base.png import png
from base.tree import version
from measure.noise.measures import Finding
from measure.noise.noise import Sampler

STYLE = """body{font:16px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;width:100%}
td,th{text-align:left;vertical-align:top;padding:.5rem;border-top:1px solid #ccc}
.FAIL{color:#a00;font-weight:bold}.pass{color:#060}
img,svg{width:8rem;image-rendering:pixelated;display:block;margin-top:.3rem}
code{background:#eee}@media(prefers-color-scheme:dark){body{background:#181818;color:#ddd}code{background:#333}
.FAIL{color:#f77}.pass{color:#7d7}}"""


def greys(values: np.ndarray) -> str:
    """A picture of numbers, from the least to the greatest."""
    finite = np.nan_to_num(values.astype(float))
    low, high = finite.min(), finite.max()
    bytes_ = ((finite - low) / max(high - low, 1e-30) * 255).astype(np.uint8)[::-1]
    data = png(values.shape[1], values.shape[0], np.repeat(bytes_[..., None], 3, -1).tobytes())
    return f'<img alt="" src="data:image/png;base64,{base64.b64encode(data).decode()}">'


def bars(counts: list[int]) -> str:
    most = max(max(counts), 1)
    shown = "".join(f'<rect x="{i}" y="{32 - 32 * count / most:.2f}" width="1" height="{32 * count / most:.2f}"/>'
                    for i, count in enumerate(counts))
    return f'<svg viewBox="0 0 {len(counts)} 32" width="128" fill="currentColor" aria-hidden="true">{shown}</svg>'


def picture(sampler: Sampler, finding: Finding) -> str:
    """What shows the number: the field around it where the measure is about places."""
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
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for name, finding in found.items():
        cells = [cell(theirs, finding), cell(ours, of_ours[name]) if name in of_ours else ""]
        rows.append(f"<tr><th scope=row>{name}</th>{''.join(f'<td>{one}</td>' for one in cells)}</tr>")
    size = len(theirs.subject.text.encode())
    title = html.escape(theirs.subject.name)
    (folder / "index.html").write_text(
        f'<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f"<title>{title}</title><style>{STYLE}</style><h1>{title}</h1>"
        f"<p><code>{html.escape(theirs.subject.expression)}</code>, version {html.escape(commit)}</p>"
        f"<p>Judged by hashnoise {version()}, from values that Mesa's llvmpipe computed. The file has {size:,} bytes, "
        f"and compiled in {seconds:.2f} s. Numbers are of a sample: what was not found may be there.</p>"
        f"<table><tr><th></th><th>{title}</th><th>hn_perlin, for comparison</th></tr>{''.join(rows)}</table></html>\n",
        encoding="utf-8")
    (folder / "judge.json").write_text(json.dumps(
        {"noise": theirs.subject.name, "expression": theirs.subject.expression, "version": commit,
         "dimensions": theirs.subject.dimensions, "hashnoise": version(), "bytes": size,
         "compile seconds": round(seconds, 3), "measures": {name: record(finding) for name, finding in found.items()}},
        indent=1) + "\n", encoding="utf-8")


def cell(sampler: Sampler, finding: Finding) -> str:
    verdict = {None: "", True: '<span class="FAIL">FAIL</span> ', False: '<span class="pass">pass</span> '}
    return (f"{verdict[finding.fails]}<strong>{finding.number:.4g}</strong><br>{html.escape(finding.sentence)}"
            f"{picture(sampler, finding)}")


def record(finding: Finding) -> dict[str, object]:
    return {"fails": finding.fails, "number": round(finding.number, 9), "sentence": finding.sentence,
            **{name: value for name, value in finding.more.items() if name != "spectrum"}}
