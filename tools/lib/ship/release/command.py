"""The command line of tools/pack release."""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
import textwrap
from pathlib import Path

from base.tree import ROOT, version
from base.usage import Parser, near
from proof.vectors.files import NoVectors
from ship.release.files import PARTS, NoRelease, Release, named, notes, problems, run

DESCRIPTION = textwrap.dedent("""\
    Makes all that a release has, from a clean tree: files for shaders, headers, packages, the playground, checksums.

    FOLDER is build/release/hashnoise-VERSION unless you name one; it must not exist. The version is that of
    glsl/hashnoise/config.glsl. The tree must be what is committed, CHANGELOG.md must begin with the version and its
    day, and every file that repeats the version or the project's address must have it; with --trial nothing of that
    has to be so. With --tag v1.2.3 the version must be that one.

    {parts}

    The same commit makes the same bytes. Compilers decide about the wheels of the Python package, so --wheels takes
    them from a folder: cibuildwheel makes them, on other machines, of the source distribution that is in the release.
    docs/develop/release.md describes what the files are.

    Exit status: 0 done, 1 there is no release (it prints why), 2 bad usage.""").format(
    parts=textwrap.fill(f"PARTS are names with commas between: {', '.join(PARTS)}. Parts that are not made are named at "
                        "the end.", 120, break_on_hyphens=False))


def parsed_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = Parser("tools/pack release", DESCRIPTION)
    parser.add_argument("--trial", action="store_true",
                        help="whatever is not committed, not dated or not of this version")
    parser.add_argument("--tag", metavar="NAME",
                        help="there is no release unless the version is that of this tag: v1.2.3")
    parser.add_argument("--wheels", type=Path, metavar="FOLDER", help="the wheels of the Python package, for the release")
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--only", metavar="PARTS", help="these parts, with commas between")
    chosen.add_argument("--without", metavar="PARTS", help="all parts but these")
    parser.add_argument("folder", type=Path, nargs="?", metavar="FOLDER",
                        default=ROOT / "build" / "release" / f"hashnoise-{version()}",
                        help="where it goes; it must not exist (default: build/release/hashnoise-VERSION)")
    parsed = parser.parse_args(arguments)
    listed = [name.strip() for name in (parsed.only or parsed.without or "").split(",") if name.strip()]
    for name in listed:
        if name not in PARTS:
            parser.error(f"there is no part {name}{near(name, PARTS) or '; there are ' + ', '.join(PARTS)}")
    parsed.parts = [name for name in PARTS if (name in listed if parsed.only is not None else name not in listed)]
    if not parsed.parts:
        parser.error(f"no part is left; there are {', '.join(PARTS)}")
    if parsed.tag not in (None, f"v{version()}"):
        parser.error(f"the version is {version()}, so its tag is v{version()} and not {parsed.tag}")
    wheels = sorted(parsed.wheels.glob("*.whl")) if parsed.wheels else []
    others = [path.name for path in wheels if not path.name.startswith(f"hashnoise-{version()}-")]
    if parsed.wheels and (others or not wheels or "python" not in parsed.parts):
        parser.error(f"--wheels {parsed.wheels} has {others[0] if others else f'{len(wheels)} wheels'}; it takes a folder "
                     f"of wheels named hashnoise-{version()}-....whl, and the part python")
    parsed.wheels = tuple(wheels)
    if parsed.folder.exists():
        parser.error(f"{parsed.folder} exists; name another folder, or remove it")
    try:
        parsed.folder.parent.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryDirectory(dir=parsed.folder.parent).cleanup()
    except OSError as error:
        parser.error(f"the folder {parsed.folder} cannot be made: {error.strerror}")
    return parsed


def make(folder: Path, parts: list[str], trial: bool, wheels: tuple[Path, ...]) -> None:
    """All of it, or nothing: the folder appears when everything is in it."""
    if not (ROOT / ".git").exists():
        raise NoRelease(f"{ROOT} is no git repository, and a release is made of a commit")
    changed = [f"{line[3:]}: it is not as it is committed"
               for line in run(["git", "-C", ROOT, "status", "--porcelain"]).splitlines()]
    if not trial and (wrong := [*changed, *problems()]):
        raise NoRelease("this tree is no release; --trial makes one all the same\n" + "\n".join(wrong))
    said = notes((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), version())  # before what takes minutes
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}.") as scratch:
        release = Release(Path(scratch) / "release", wheels)
        release.folder.mkdir()
        for part in parts:
            print(f"{part} ...", file=sys.stderr)
            release.make(part)
            if not named(part, {path.name for path in release.folder.iterdir()}, release.version):
                raise NoRelease(f"{part} was made, but has another name than version {release.version} must have")
        (release.folder / "NOTES.md").write_text(said, encoding="utf-8")
        release.materials()
        release.checksums()
        release.folder.chmod(0o755)
        shutil.move(release.folder, folder)


def main(arguments: list[str] | None = None) -> int:
    parsed = parsed_arguments(arguments)
    try:
        make(parsed.folder.resolve(), parsed.parts, parsed.trial, parsed.wheels)
    except (NoRelease, NoVectors) as error:
        print(f"tools/pack release: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"tools/pack release: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    left_out = [name for name in PARTS if name not in parsed.parts]
    left_out += ["wheels"] * ("python" in parsed.parts and not parsed.wheels)
    if left_out:
        print(f"Without {', '.join(left_out)}.", file=sys.stderr)
    if parsed.trial:
        print("This is a trial, not a release.", file=sys.stderr)
    print(parsed.folder)
    return 0
