"""Makes the files of glsl/hashnoise/ that only name others: all noise of a dimension, the functions built on noise, and
the whole. From the text of the plane it makes the equal parts of other dimensions.

    tools/make dimensions [--check] [--glsl DIR]

`<noise>2d.glsl` is a noise on the plane, so noise2d.glsl includes it; every dimension has such a file. But a file that
includes another noise of its dimension, or detail/octave.glsl, is built on noise: then `<name>.glsl` includes
`<name>2d.glsl` and `<name>3d.glsl`. hashnoise.glsl includes the files of noise first, since a knob may name any noise
for functions built on it. After them it includes every file that no other file includes. detail/undef_guards.h takes
the guards of all files back, but config.glsl's, so that C++ can include the text once more for other types.

The text of the plane is by hand. Where another dimension has the same, but for the number of its axes, it is made: as a
whole file, such as fbm3d.glsl, which is marked at its top, or below a line in one of these forms:

    // From here octaves3d.glsl and octaves4d.glsl are generated from octaves2d.glsl.
    // Generated for 1, 3 and 4 dimensions from the lines above.

The first stands in all files that it names, and a line that begins with "// To here" ends its part; above the second, in a
file that has all dimensions, stands its source. tools/lib/translate/dimensions/rule.py describes the changes.

With --check nothing is written. Exit status: 0 done, 1 (--check) a file is not up to date, or the rule does not
cover it what another dimension has, 2 bad usage.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from base.tree import GLSL, glsl_files, included_from
from base.usage import Parser
from translate.dimensions.files import made as made_of_the_plane
from translate.dimensions.rule import Unclear

DIMENSIONAL = re.compile(r"[a-z]\w*(\d)d\.glsl")
UMBRELLA = re.compile(r"noise\dd\.glsl|hashnoise\.glsl")
INCLUDE = re.compile(r'^#include "([^"]+)"$', re.MULTILINE)
AGAIN = "detail/undef_guards.h"
MARK = "Made by tools/make."
OF_SUMS = "detail/octave.glsl"  # what includes it has the places of octaves


def guard_of(file: str) -> str:
    return f"HN_{Path(file).name.replace('.', '_').upper()}"


def includes_of(file: str, text: str) -> list[str]:
    return [included_from(file, name) for name in INCLUDE.findall(text)]


def umbrella(name: str, what: str, included: Sequence[str]) -> str:
    guard = guard_of(name)
    includes = "".join(f'#include "{file}"\n' for file in included)
    return (f"// hashnoise: {what}. {MARK}\n// SPDX-License-Identifier: MIT\n\n"
            f"#ifndef {guard}\n#define {guard}\n\n{includes}\n#endif\n")


def is_umbrella(file: str, text: str) -> bool:
    return UMBRELLA.fullmatch(file) is not None or text.partition("\n")[0].endswith(MARK)


def dimension_of(file: str) -> str:
    found = DIMENSIONAL.fullmatch(file)
    return found[1] if found else ""


def without_dimension(file: str) -> str:
    return file.removesuffix(f"{dimension_of(file)}d.glsl") + ".glsl"


def turns(file: str, name: str) -> bool:
    """Whether a file has the noise of another one with a phase."""
    form, noise = (re.sub(r"\dd\.glsl$", "", of) for of in (file, name))
    return form == noise.removesuffix("_d") + "_phase"


def is_built_on_noise(file: str, text: str) -> bool:
    """Whether it includes another noise of its dimension, or what sums have in common. A noise whose gradients turn is
    no other noise than the one without a phase."""
    dimension = dimension_of(file)
    included = includes_of(file, text)
    return dimension != "" and (OF_SUMS in included or any(
        dimension_of(name) == dimension and not turns(file, name) for name in included))


def umbrellas(texts: Mapping[str, str]) -> dict[str, str]:
    """The text of each file that only includes others, given the texts of all."""
    written = {file: text for file, text in sorted(texts.items()) if not is_umbrella(file, text)}
    built = [file for file, text in written.items() if is_built_on_noise(file, text)]
    made = {}
    for name in sorted({without_dimension(file) for file in built}):
        files = [file for file in built if without_dimension(file) == name]
        dimensions = " and ".join(f"{dimension_of(file)}D" for file in files)
        made[name] = umbrella(name, f"{Path(name).stem} in {dimensions}", files)

    parts = [file for file in written if file not in made]
    noises = [file for file in parts if dimension_of(file) and file not in built]
    of_noise = {}
    for dimension in sorted({dimension_of(file) for file in noises}):
        name = f"noise{dimension}d.glsl"
        of_noise[name] = umbrella(name, f"all noise in {dimension}D",
                                  [file for file in noises if dimension_of(file) == dimension])

    included = {name for file in parts for name in includes_of(file, texts[file])}
    others = [file for file in (*parts, *made) if file not in (*included, *noises, *built)]
    whole = umbrella("hashnoise.glsl", "the whole library", [*of_noise, *sorted(others)])
    return made | of_noise | {"hashnoise.glsl": whole}


def again(files: Sequence[str]) -> str:
    guards = "".join(f"#undef {guard}\n" for guard in sorted(guard_of(file) for file in files if file != "config.glsl"))
    return (f"// hashnoise: forgets which files were included, so that they can be for other types. {MARK}\n"
            f"// SPDX-License-Identifier: MIT\n\n{guards}")


def wrong(folder: Path) -> dict[str, str]:
    """The stale files of the folder: the text of each such file, empty for one that should not be there."""
    texts = {name: path.read_text(encoding="ascii") for name, path in glsl_files(folder).items()}
    same = made_of_the_plane(texts)
    made = umbrellas(texts | same) | same
    stale = {file: "" for file, text in texts.items() if is_umbrella(file, text) and file not in made}
    made[AGAIN] = again([file for file in {*texts, *made} if file not in stale])
    if (folder / AGAIN).exists():
        texts[AGAIN] = (folder / AGAIN).read_text(encoding="ascii")
    return stale | {file: text for file, text in made.items() if texts.get(file) != text}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make dimensions", __doc__)
    parser.add_argument("--check", action="store_true", help="only print which files are not what they should be")
    parser.add_argument("--glsl", type=Path, default=GLSL, help="the folder (default: %(default)s)")
    options = parser.parse_args(arguments)
    if not options.glsl.is_dir():
        parser.error(f"there is no folder {options.glsl}")
    try:
        found = wrong(options.glsl)
    except Unclear as unclear:
        print(unclear, file=sys.stderr)
        return 1
    for file, text in sorted(found.items()):
        if options.check:
            print(f"{file} is not what tools/make dimensions makes; run it, or if the file was edited by hand change the "
                  "text of the plane (...2d.glsl): tools/make dimensions replaces the file")
            continue
        print(f"{file} is {'replaced' if text else 'removed'}")
        if text:
            (options.glsl / file).write_text(text, encoding="ascii")
        else:
            (options.glsl / file).unlink()
    return 1 if options.check and found else 0


if __name__ == "__main__":
    sys.exit(main())
