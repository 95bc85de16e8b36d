"""The form of Godot's Asset Store, filled in. Nobody has sent it yet.

Godot's manual has the fields, as read in November 2026:
https://github.com/godotengine/godot-docs/blob/master/community/asset_store/submitting_to_asset_store.rst
The AI disclosure is in faq.rst beside it. Pictures have at least 1280 by 720 pixels, and 16:9:
https://github.com/godotengine/godot-asset-store-tracker/issues/28, and 88.
"""

from __future__ import annotations

import re

from base.tree import ROOT, address, version
from ship.page import of_package, relinked

LEAST = "4.4"  # of Godot
PICTURE = ROOT / "docs" / "images" / "godot.jpg"
SUMMARY = "Procedural noise for shaders and GDScript: no texture, the same bits on every GPU"
TAGS = ("noise", "procedural", "shaders", "terrain", "visual-shader", "2d", "3d")
AI = ("Code, tests and pages were written with a large language model. Tests compare each function with values that a "
      "second implementation computed. The pictures are drawn by the code.")
FORM = """\
# The Asset Store's form for hashnoise {version}

<https://store.godotengine.org>, *Upload Asset*. The publisher and its URL slug are yours.

| field | fill in |
| --- | --- |
| Asset Name | hashnoise |
| Asset URL | hashnoise |
| Asset Summary | {summary} |
| Tags | {tags} |
| Asset type | Addon |
| License | MIT |
| Link to source code | {address} |
| AI usage disclosure | {ai} |
| Thumbnail, and the first screenshot | `hashnoise-godot-{version}-store.jpg` |
| File of the version | `hashnoise-godot-{version}.zip` |
| Name of the version | {version} |
| Minimum Godot version | {least} |
| Maximum Godot version | leave it empty |

## Detailed description

{description}
## Changelog

{changes}
"""


def changes(changelog: str) -> str:
    """The lines on Godot of a version's part."""
    part = re.search(rf"^## {re.escape(version())} .*?(?=^## |\Z)", changelog, re.MULTILINE | re.DOTALL)
    found = [relinked(line, lambda _: "") for line in (part[0] if part else "").splitlines()
             if line.startswith("- ") and "Godot" in line]
    return "\n".join([*found, f"- All changes: {f'{address()}/blob/v{version()}/' if address() else ''}CHANGELOG.md"])


def beside() -> dict[str, str | bytes]:
    """By the ends of their names."""
    page = of_package(ROOT / "packages" / "godot" / "addons" / "hashnoise" / "README.md").partition("\n\n")[2]
    form = FORM.format(version=version(), summary=SUMMARY, tags=", ".join(TAGS), address=address() or "the project's", ai=AI,
                       least=LEAST, description=page, changes=changes((ROOT / "CHANGELOG.md").read_text(encoding="utf-8")))
    return {"-store.md": form, "-store.jpg": PICTURE.read_bytes()}
