"""Makes the parts of a release."""

from __future__ import annotations

import gzip
import hashlib
import os
import re
import shutil
import subprocess
import tempfile
from datetime import date
from pathlib import Path

from base.pieces import is_deleted
from base.tree import HN_CONFORM, ROOT, TOOLS, address, version
from catalog import copies
from catalog.tables import glsl
from proof.vectors.files import vectors_folder
from ship.page import relinked
from ship.recipes import RECIPES
from ship.release import sbom
from ship.zips import zipped
from translate.pick import pages as snippets
from translate.single_file.files import text


class NoRelease(Exception):
    """Something is not as a release needs it."""


def run(command: list[str | Path], **options) -> str:
    """A command's output; the message of a failure is the reason why there is no release."""
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False, **options)
    if done.returncode != 0:
        raise NoRelease(f"{Path(command[0]).name} {' '.join(map(str, command[1:]))} ended with status {done.returncode}")
    return done.stdout


def newest(changelog: str) -> tuple[str, str]:
    """The version of the changelog's first heading, and the day or other words behind it: "## 1.2.3 (2026-11-22)"."""
    found = re.search(r"^## (\S+)(?: \((.*)\))?", changelog, re.MULTILINE)
    return (found[1], found[2] or "") if found else ("", "")


def is_day(words: str) -> bool:
    try:
        return date.fromisoformat(words).isoformat() == words
    except ValueError:
        return False


def problems() -> list[str]:
    """Everything in the committed files that keeps them from being a release: the file, and what would be right."""
    found = copies.wrong()
    wanted = version()
    named, day = newest((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))
    if named != wanted or not is_day(day):
        found.append(f'CHANGELOG.md: the first heading is "## {named} ({day})", and must be "## {wanted} (DAY)" with '
                     "the day of the release, such as 2026-11-22")
    if not is_deleted("measuring"):
        from measure import stamps
        found += stamps.refusals()
    if not address():
        found.append("conformance/web/address.js: it has no address, and must have the project's; write it there, and run "
                     "tools/make catalog")
    return found


def notes(changelog: str, wanted: str) -> str:
    """The changelog's part on a version."""
    section = re.search(rf"^## {re.escape(wanted)} \(.*?\)\n+(.*?)(?=^## |\Z)", changelog, re.M | re.S)
    if not section:
        raise NoRelease(f'CHANGELOG.md has no part on {wanted}; it must have a heading like "## {wanted} (2026-11-22)"')
    # Links to the pages of the repository lead nowhere from a release.
    return f"# hashnoise {wanted}\n\n{relinked(section[1].rstrip(), lambda _: '')}\n"


class Release:
    """The parts, made into a folder."""

    def __init__(self, folder: Path, wheels: tuple[Path, ...] = ()):
        self.folder, self.wheels = folder, wheels
        self.version = version()
        self.seconds = int(run(["git", "-C", ROOT, "log", "-1", "--format=%ct"]))
        self.environment = {**os.environ, "SOURCE_DATE_EPOCH": str(self.seconds)}

    def make(self, part: str) -> None:
        if own := getattr(self, part, None):
            own()
        else:
            recipe = RECIPES[part]
            run([TOOLS / "pack", part, *["--zip"] * recipe.has_folder, self.folder], env=self.environment)

    def python(self) -> None:
        """The source distribution, and the wheels that other machines have made of it."""
        run([TOOLS / "pack", "python", "--sdist", self.folder], env=self.environment)
        for wheel in self.wheels:
            shutil.copy(wheel, self.folder)

    def single(self) -> None:
        for language in ("glsl", "hlsl", "metal"):
            for ending, minify in ((language, False), (f"min.{language}", True)):
                made = text(["hashnoise.glsl"], language, minify=minify)
                (self.folder / f"hashnoise.{ending}").write_text(made, encoding="ascii")
        for name, arithmetic in (("hashnoise.wgsl", "HN_FAST"), ("hashnoise.fixed.wgsl", "HN_FIXED")):
            run([TOOLS / "pick", "whole", "--language", "wgsl", "--arithmetic", arithmetic, "--out", self.folder / name])

    def parts(self) -> None:
        """Each file that has public functions, with what it needs, for who wants no more than that."""
        names = sorted({name for function in glsl.declarations() for name in glsl.files_of(function.name)})
        files = {f"{language}/{Path(name).stem}.{language}": text([name], language, strip=True).encode("ascii")
                 for language in ("glsl", "hlsl", "metal") for name in names}
        (self.folder / f"hashnoise-{self.version}-parts.zip").write_bytes(zipped(files, self.seconds))

    def vectors(self) -> None:
        """The files that ports are checked with."""
        files = {f"vectors/{path.name}": path.read_bytes() for path in sorted(vectors_folder().glob("*.json"))}
        (self.folder / f"hashnoise-{self.version}-vectors.zip").write_bytes(zipped(files, self.seconds))

    def snippets(self) -> None:
        """Functions to paste, in each language. Links to other pages lead nowhere from there."""
        files = {f"snippets/{path.name}": relinked(path.read_text("utf-8"), lambda to: to.partition("../")[0]).encode()
                 for path in sorted(snippets.whole().iterdir())}
        (self.folder / f"hashnoise-{self.version}-snippets.zip").write_bytes(zipped(files, self.seconds))

    def headers(self) -> None:
        """The installed files of the library without compiled ones, so find_package takes it from where it is."""
        with tempfile.TemporaryDirectory() as scratch:
            log = {"stderr": subprocess.STDOUT}
            run(["cmake", "-S", ROOT, "-B", f"{scratch}/build", "-G", "Ninja", "-DHASHNOISE_GRID=OFF",
                 "-DHASHNOISE_CONFORMANCE=OFF", "-DHASHNOISE_TESTS=OFF", "-DHASHNOISE_INSTALL=ON",
                 "-DCMAKE_INSTALL_DOCDIR=."], **log)
            top = Path(scratch) / "headers" / f"hashnoise-{self.version}"
            run(["cmake", "--install", f"{scratch}/build", "--prefix", top], **log)
            shutil.copytree(vectors_folder(), top / "share/hashnoise/vectors", dirs_exist_ok=True)
            files = {path.relative_to(top.parent).as_posix(): path.read_bytes() for path in top.rglob("*") if path.is_file()}
            (self.folder / f"hashnoise-{self.version}-headers.zip").write_bytes(zipped(files, self.seconds))

    def source(self) -> None:
        """The committed files, and the vectors, so that builds from it need not make them."""
        name = f"hashnoise-{self.version}"
        added = [f"--add-file={path}" for path in sorted(vectors_folder().glob("*.json"))]
        packed = subprocess.run(["git", "-C", ROOT, "archive", "--format=tar", f"--prefix={name}/vectors/", *added,
                                 f"--prefix={name}/", "HEAD"], stdout=subprocess.PIPE, check=True).stdout
        (self.folder / f"{name}-source.tar.gz").write_bytes(gzip.compress(packed, mtime=self.seconds))

    def playground(self) -> None:
        run([TOOLS / "playground", "--out", self.folder / "playground.html"], env=self.environment)

    def check(self) -> None:
        """The page on which anybody checks a device. The program that makes it has the library inside, so it is built
        of what is there."""
        if not HN_CONFORM.exists():
            raise NoRelease(f"there is no {HN_CONFORM.relative_to(ROOT)}, which makes check.html; tools/conform builds it")
        run(["cmake", "--build", HN_CONFORM.parents[1], "--target", "hn-conform"])
        with tempfile.TemporaryDirectory() as scratch:
            run([HN_CONFORM, "web", "--out", scratch])
            (self.folder / "check.html").write_bytes((Path(scratch) / "index.html").read_bytes())

    def materials(self) -> None:
        """The parts of the release, for those who have to list them."""
        files = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        try:
            made = sbom.text(sbom.bom(self.version, self.seconds, files, sbom.of_others()))
        except sbom.Unknown as error:
            raise NoRelease(str(error)) from error
        (self.folder / f"hashnoise-{self.version}.cdx.json").write_text(made, encoding="ascii")

    def checksums(self) -> None:
        """In the form of sha256sum, which also checks them."""
        lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(self.folder.iterdir())]
        (self.folder / "SHA256SUMS").write_text("".join(lines), encoding="ascii")


# check is first: it alone needs what another command builds, and the rest takes eleven minutes.
PARTS = ("check", "single", "parts", "vectors", "headers", "source",
         *(name for name in RECIPES if name not in ("registries", "release")),
         *["playground"] * (not is_deleted("playground")), "snippets")
# Files that each must have, so that a tool that makes something else is noticed.
NAMES = {"single": r"hashnoise(\.min|\.fixed)?\.(glsl|hlsl|metal|wgsl)", "parts": r"hashnoise-VERSION-parts\.zip",
         "vectors": r"hashnoise-VERSION-vectors\.zip",
         "snippets": r"hashnoise-VERSION-snippets\.zip",
         "headers": r"hashnoise-VERSION-headers\.zip",
         "source": r"hashnoise-VERSION-source\.tar\.gz", "npm": r"hashnoise-VERSION\.tgz",
         "python": r"hashnoise-VERSION\.tar\.gz",
         **{name: rf"{re.escape(recipe.zip_name)}-VERSION\.zip" for name, recipe in RECIPES.items() if recipe.name},
         "playground": r"playground\.html", "check": r"check\.html"}


def named(part: str, names: set[str], wanted: str) -> set[str]:
    """Which of the names are a part's."""
    pattern = re.compile(NAMES[part].replace("VERSION", re.escape(wanted)))
    return {name for name in names if pattern.fullmatch(name)}
