"""Pages of what was measured: HTML from Jinja's templates, with frame.html around each."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import jinja2
from markupsafe import Markup

from base.tree import ROOT

STYLE = ROOT / "conformance" / "output" / "style.mustache"  # that of hn-conform's own pages


class Section(NamedTuple):
    """A part of a page by tables.html."""
    title: str
    text: str
    heads: Sequence[str] = ()
    rows: Sequence[Sequence[object]] = ()
    kind: str = "table"
    pictures: Sequence[tuple[str, str]] = ()  # their titles and files


def write(out: Path, template: Path, **values: object) -> None:
    """A name that the template has and the values lack is an error."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader([template.parent, Path(__file__).parent]),
                                     autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True, keep_trailing_newline=True)
    environment.globals["style"] = Markup(STYLE.read_text(encoding="utf-8"))
    text = environment.get_template(template.name).render(values)
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(text, encoding="utf-8")
