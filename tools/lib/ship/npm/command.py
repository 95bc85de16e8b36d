"""Writes the files of the npm package into a folder: python3 -m npm.command FOLDER. tools/npm packs them."""

import sys
from pathlib import Path

import needs

needs.python(3, 9)

from ship.npm.files import package  # noqa: E402
from ship.npm.twin import Failed, compiled  # noqa: E402


def main() -> int:
    folder = Path(sys.argv[1])
    try:
        files = package(compiled())
    except Failed as error:
        print(error, file=sys.stderr)
        return 1
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
