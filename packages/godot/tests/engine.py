"""A real Godot: where it is, and how it runs a script on each of its renderers without a screen.

    python3 packages/godot/tests/engine.py    downloads one, if there is none; 77 if it cannot be had here
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools" / "lib"))

from base.debian import Missing, chosen  # noqa: E402
from base.testing import skipped_without  # noqa: E402

OLDEST = (4, 4)
# Godot prints this when it starts with a renderer. It goes on with OpenGL where there is no Vulkan.
RENDERERS = {"gl_compatibility": re.compile(r"^OpenGL API .* - Compatibility - Using Device: (.*)$", re.MULTILINE),
             "forward_plus": re.compile(r"^Vulkan .* - Forward\+ - Using Device #\d+: (.*)$", re.MULTILINE),
             "mobile": re.compile(r"^Vulkan .* - Forward Mobile - Using Device #\d+: (.*)$", re.MULTILINE)}
WRONG = re.compile(r"^(?:\w+ )?ERROR:.*(?:\n .*)*", re.MULTILINE)


class Failure(Exception):
    """The errors in it."""


def find() -> tuple[str, str]:
    """The program, and its version."""
    program = chosen("godot")
    try:
        done = subprocess.run([program, "--version"], capture_output=True, text=True, check=False, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise Missing(f"{program} cannot be run: {error}") from error
    version = done.stdout.strip()
    number = re.match(r"(\d+)\.(\d+)", version)
    if not number:
        raise Missing(f"{program} --version prints no version, but {version or done.stderr.strip()!r}")
    if (int(number[1]), int(number[2])) < OLDEST:
        raise Missing(f"{program} is Godot {version}; the add-on is for 4.4 and later")
    return program, version


@contextmanager
def display() -> Iterator[str]:
    """A display for the windows: that of the user's, or one of Xvfb's own."""
    if os.environ.get("DISPLAY"):
        yield os.environ["DISPLAY"]
        return
    if not shutil.which("Xvfb"):
        raise Missing("there is no display (DISPLAY is not set), and no Xvfb to make one")
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x720x24", "-nolisten", "tcp"],
        pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise Missing("Xvfb does not start")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


class Engine:
    """A Godot with a display."""

    def __init__(self, program: str, shown_on: str, home: Path):
        self.program, self.shown_on, self.home = program, shown_on, home

    def environment(self) -> dict[str, str]:
        found = {**os.environ, "DISPLAY": self.shown_on, "HOME": str(self.home), "XDG_DATA_HOME": str(self.home),
                 "XDG_CONFIG_HOME": str(self.home), "XDG_CACHE_HOME": str(self.home)}
        found.pop("WAYLAND_DISPLAY", None)
        return found

    def import_files(self, project: Path) -> None:
        """As the editor does when it opens a project."""
        subprocess.run([self.program, "--headless", "--path", str(project), "--import"], capture_output=True, check=True,
                       timeout=600, env=self.environment())

    def edit(self, project: Path) -> str:
        """The editor's output until a plugin of the project ends it."""
        done = subprocess.run([self.program, "--editor", "--path", str(project), "--rendering-method", "gl_compatibility",
                               "--display-driver", "x11", "--audio-driver", "Dummy"], capture_output=True, text=True,
                              errors="replace", check=True, timeout=600, env=self.environment())
        return done.stdout + done.stderr

    def run(self, project: Path, renderer: str, script: str, *arguments: str, options: tuple[str, ...] = ()) -> str:
        """Godot's output while it runs a script of the project; an error of its own, and another renderer, are a
        Failure."""
        command = [self.program, "--path", str(project), "--rendering-method", renderer, *options, "--display-driver", "x11",
                   "--audio-driver", "Dummy", "--disable-vsync", "--script", script, "--", *arguments]
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False, timeout=600,
                                  env=self.environment())
        except subprocess.TimeoutExpired as error:
            raise Failure(f"{script} takes more than ten minutes with {renderer}") from error
        said = done.stdout + done.stderr
        device = RENDERERS[renderer].search(said)
        if not device:
            raise Failure(f"Godot does not run with {renderer}:\n{said[:2000]}")
        if done.returncode != 0 or WRONG.search(said):
            raise Failure("\n".join(WRONG.findall(said))[:3000] or f"exit status {done.returncode}:\n{said[-2000:]}")
        print(f"{renderer}: {device[1]}", file=sys.stderr)
        return said


def main(*cases: type[unittest.TestCase]) -> None:
    """Runs tests that have an `engine`; 77 where there is none."""
    with skipped_without(), tempfile.TemporaryDirectory() as home:
        program, version = find()
        with display() as shown_on:
            print(f"Godot {version}")
            for case in cases:
                case.engine = Engine(program, shown_on, Path(home))
            suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromTestCase(case) for case in cases)
            sys.exit(not unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful())


if __name__ == "__main__":
    with skipped_without():
        print(*find())
