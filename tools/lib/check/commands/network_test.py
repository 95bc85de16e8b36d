"""Commands that install nothing open no connection: strace proves it.

    python3 -m check.commands.network_test HN_CONFORM

Browsers are left out, since they ask by themselves which networks there are. Exit status: 0 it is so, 1 it is not, 77
strace is not here, or may not trace.
"""

from __future__ import annotations

import re
import subprocess
import sys
import unittest
from pathlib import Path

from base.pieces import is_deleted
from base.testing import Case, skipped_without
from base.tree import ROOT, TOOLS
from ship.recipes import RECIPES

# {} is an empty folder. The commands that install are conform, test, measure and others of setup.sh, those with NumPy
# (scientific-python), what has packages of npm, PyPI or cargo (pack npm, pack python, make site), and measure gpu
# --get-drivers.
COMMANDS = (*(["pack", name, "{}"] for name, recipe in RECIPES.items()
              if not recipe.command and name != "registries"),  # which takes a file of a release
            ["make", "catalog", "--check"], ["make", "freeze", "--check"], ["make", "golden", "--check", "--sample", "50"],
            ["make", "dimensions", "--check"], ["make", "vectors"],
            ["pick", "hn_fbm2"], *[["playground", "--out", "{}/page.html"]] * (not is_deleted("playground")), ["pick", "whole", "--out", "{}/all.glsl"],
            ["pick", "whole", "--language", "wgsl", "noise2d.glsl"])
OF_CONFORM = (["run", "--filter", "noise2d.perlin.lattice.fast.*", "--out", "{}/out"], ["web", "--out", "{}/web"])
OUTWARD = re.compile(r"connect\(.*AF_INET6?,(?!.*(?:\"127\.|\"::1\")).*")


def connections(command: list[str | Path], folder: Path) -> tuple[int, list[str]]:
    """The exit status of a command, and the hosts beyond this machine to which it and its processes connect."""
    record = folder / "strace"
    traced = ["strace", "-f", "--seccomp-bpf", "-qq", "-e", "trace=connect", "-o", record, *command]
    done = subprocess.run(traced, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return done.returncode, OUTWARD.findall(record.read_text(encoding="utf-8", errors="replace"))


class Network(Case):
    program: str

    def test_it_is_not_used(self) -> None:
        commands = [[TOOLS / name, *options] for name, *options in COMMANDS]
        commands += [[self.program, *options] for options in OF_CONFORM]
        for number, command in enumerate(commands):
            with self.subTest(command=command):
                made = self.folder / str(number)
                made.mkdir()
                filled = [str(part).replace("{}", str(made)) for part in command]
                self.assertEqual(connections(filled, self.folder), (0, []))

    def test_a_connection_is_told(self) -> None:
        """To an address that nobody has, by a socket that sends nothing."""
        code = "import socket; socket.socket({}, socket.SOCK_DGRAM).connect(({!r}, 443))"
        for family, address, expected in (("socket.AF_INET", "192.0.2.1", 1), ("socket.AF_INET", "127.0.0.1", 0)):
            status, found = connections([sys.executable, "-c", code.format(family, address)], self.folder)
            self.assertEqual(len(found), expected, found)


if __name__ == "__main__":
    Network.program = sys.argv.pop(1)
    with skipped_without(OSError, subprocess.CalledProcessError):  # Debian's package is strace
        subprocess.run(["strace", "-qq", "-o", "/dev/null", "true"], check=True, capture_output=True)
    unittest.main()
