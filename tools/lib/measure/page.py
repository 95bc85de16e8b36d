"""Pages of what was measured: HTML from Jinja's templates, with frame.html around each."""

from __future__ import annotations

from pathlib import Path

import jinja2
from markupsafe import Markup

from base.tree import ROOT

STYLE = ROOT / "conformance" / "output" / "style.mustache"  # that of hn-conform's own pages


def write(out: Path, template: Path, **values: object) -> None:
    """A name that the template has and the values lack is an error."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader([template.parent, Path(__file__).parent]),
                                     autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True, keep_trailing_newline=True)
    environment.globals["style"] = Markup(STYLE.read_text(encoding="utf-8"))
    text = environment.get_template(template.name).render(values)
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(text, encoding="utf-8")
