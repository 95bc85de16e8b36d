"""Makes the vectors: rows of the golden files as JSON, for ports of the library to other languages.

    tools/make vectors

Each file of build/vectors is FUNCTION.json, and index.json lists them; docs/develop/porting.md describes their
contents. g++ compiles what computes the bounds of floats, with the library fmt. The files stay as they are if nothing
has changed that they are made of. tools/pack calls this for the packages that have them.

Exit status: 0 done, 2 bad usage, 4 they cannot be made.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from base.usage import Parser
from proof.vectors.files import NoVectors, vectors_folder


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make vectors", __doc__)
    parser.parse_args(arguments)
    try:
        print(vectors_folder())
    except (NoVectors, OSError) as error:
        parser.exit(4, f"tools/make vectors: {error}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
