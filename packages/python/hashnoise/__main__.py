"""python -m hashnoise bake ...: noise as files."""

import sys

from ._bake import program

if __name__ == "__main__":
    if sys.argv[1:2] != ["bake"]:
        print("hashnoise: the command is bake, as in: python -m hashnoise bake fbm -o heights.png", file=sys.stderr)
        sys.exit(2)
    sys.exit(program(sys.argv[2:]))
