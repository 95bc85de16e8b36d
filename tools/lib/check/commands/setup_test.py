"""Tests of tools/lib/base/setup.sh: the output of a command before it runs.

Scripts stand in for cmake, ninja, apt-get and dpkg-query, so that nothing is installed or built. A line is due every
fifth of a second here, in place of every ten seconds, and a step lasts until it has shown some, however busy the
machine is.
"""

from __future__ import annotations

import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base.tree import TOOLS

TICK = 0.2
LINES = 3
STEPS = 6  # the list of packages, their download and installation, the configuration, and two of the build
# A step ends when the test has read so many lines of it, or after a while: a second, unless HN_PATIENCE has more.
SLOW = ('n=0; until [ -e "$HN_READ" ] || [ $n -ge "${HN_PATIENCE:-20}" ]; do sleep 0.05; n=$((n + 1)); done; '
        'rm -f "$HN_READ"')
COMMANDS = ("conform", "bake", "measure clock", "measure paper", "test")
TABLE = """kind,name,value,before
speed,loop,0.1,
packages,each,2,
build,conform,100,
steps,conform,50,
build,bake,100,
steps,bake,50,
build,test,100,
steps,test,50,
run,conform,60,
"""
# As apt-get does, it closes the file of its progress for dpkg.
APT_GET = f"""fd=$(echo "$*" | sed 's/.*Status-Fd=\\([0-9]*\\).*/\\1/')
case "$*" in
  *update*) {SLOW};;
  *) eval "exec 9>&$fd"
     echo dlstatus:1:25.5:Retrieving >&9; {SLOW}; echo pmstatus:cmake:75.2:Unpacking >&9; {SLOW}
     eval "exec $fd>&-"
     echo Setting up cmake ... || exit 100;;
esac"""
CMAKE = f"""case "$*" in
  *--build*) echo '[1/2] first'; {SLOW}; echo '[2/2] second'; {SLOW};;
  *) {SLOW}
     folder=$(echo "$*" | sed 's/.*-B \\([^ ]*\\) .*/\\1/')
     mkdir -p "$folder"; touch "$folder/build.ninja";;
esac"""


class Machine:
    """A copy of the commands, with nothing built, on a machine without packages."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.tools = root / "tools"
        self.tools.mkdir()
        shutil.copytree(TOOLS / "lib" / "measure", self.tools / "lib" / "measure")
        (self.tools / "lib" / "base").mkdir()
        for name in ("lib/base/setup.sh", "lib/base/progress.sh", "lib/base/scientific-python",
                     *{command.split()[0] for command in COMMANDS}):
            shutil.copy(TOOLS / name, self.tools / name)
        (self.tools / "costs.csv").write_text(TABLE)
        self.programs = root / "programs"
        self.program("dpkg-query", "exit 1")
        self.program("sudo", 'shift; [ "$1" = true ] || exec "$@"')  # sudo -n
        self.program("apt-get", APT_GET)
        self.program("cmake", CMAKE)
        self.program("ninja", "echo '[1/25] one'; echo '[25/25] last'")
        for name in ("clang++", "g++", "ctest"):
            self.program(name, "exit 0")
        self.program("python3", 'case "$*" in *measure*) echo it runs;; esac')
        for path in ("conformance/hn-conform", "src/bake/hn-bake"):
            self.program(root / "build" / path, "echo it runs")
        self.environment = {**os.environ, "HOME": "/nowhere", "PATH": f"{self.programs}:{os.environ['PATH']}",
                            "HN_PROGRESS_SECONDS": str(TICK)}
        self.environment.pop("CCACHE_DIR", None)
        self.read = root / "read"
        self.environment["HN_READ"] = str(self.read)

    def program(self, name: str | Path, text: str) -> None:
        path = self.programs / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)

    def run(self, command: str) -> tuple[int, str, int]:
        """The status of a command, its output through a pipe, and how many of its steps showed that they go on."""
        program, *name = command.split()
        lines, step, times, steps = [], "", 0, 0
        with subprocess.Popen([self.tools / program, *name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, env=self.environment) as process:
            for line in process.stdout:
                lines.append(line)
                of = re.sub(r" \d+:\d\d( of about .*)?\n", "", line)
                step, times = of, times + 1 if of == step else 1
                if times == LINES:
                    steps += 1
                    self.read.touch()
        return process.returncode, "".join(lines), steps


def with_signals() -> None:
    """A job in the background of a shell ignores some of them."""
    for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)


class Setup(unittest.TestCase):
    def setUp(self) -> None:
        self.machine = self.new_machine()

    def new_machine(self) -> Machine:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        return Machine(Path(scratch.name))

    def at_once(self) -> None:
        """Steps that do not concern times are short."""
        for name, text in (("apt-get", APT_GET), ("cmake", CMAKE)):
            self.machine.program(name, text.replace(SLOW, "true"))

    def change(self, pattern: str, text: str) -> None:
        file = self.machine.tools / "lib" / "base" / "progress.sh"
        old = file.read_text()
        new = re.sub(pattern, text, old, flags=re.MULTILINE)
        self.assertNotEqual(old, new)
        file.write_text(new)

    def test_no_command_is_silent_for_long(self) -> None:
        machines = [self.new_machine() for _ in COMMANDS]
        for machine in machines:
            machine.environment["HN_PATIENCE"] = "6000"
        with ThreadPoolExecutor(len(COMMANDS)) as pool:
            runs = pool.map(lambda machine, command: machine.run(command), machines, COMMANDS)
            for command, (status, shown, steps) in zip(COMMANDS, runs):
                with self.subTest(command=command):
                    self.assertEqual((status, steps), (0, STEPS), shown)
                    first = shown.splitlines()[0]
                    self.assertRegex(first, rf"^tools/{command} installs \d+ Debian packages, builds and runs\.")
                    self.assertIn("build/setup.log", first)
                    self.assertRegex(shown, r"Installing \d+ packages.* 25 % downloaded \d+:\d\d")
                    self.assertRegex(shown, r"Installing \d+ packages.* 75 % installed \d+:\d\d")
                    self.assertRegex(shown, r"Building 25 steps.* \[1/2\] \d+:\d\d of about 0:")

    def test_a_silent_step_is_noticed(self) -> None:
        self.change("^readonly progress_ms=.*$", "readonly progress_ms=999999")
        status, shown, steps = self.machine.run("conform")
        self.assertEqual((status, steps), (0, 0), shown)

    def test_the_first_line_says_how_long_it_takes_here(self) -> None:
        self.at_once()
        self.assertRegex(self.machine.run("conform")[1],
                         r"The whole takes about \d+:\d\d minutes here \(packages \d:\d\d, build \d+:\d\d, run \d+:\d\d\)\.")

    def test_the_estimate_follows_what_is_seen(self) -> None:
        # The table has 85 seconds; the machine takes 573, each part as long.
        seen = {("", 0): 85, ("[0/100]", 60): 145, ("[1/100]", 5.73): 109, ("[10/100]", 57.3): 309,
                ("[25/100]", 143.25): 573, ("[080/100]", 458.4): 573, ("[100/100]", 573): 573}
        lines = "; ".join(f"at='{at}' forecast {round(gone * 1000)}" for at, gone in seen)
        done = subprocess.run(["bash", "-c", f"source tools/lib/base/setup.sh; expected=85; {lines}"],
                              cwd=self.machine.root, capture_output=True, text=True, check=True)
        self.assertEqual([int(line) for line in done.stdout.split()], list(seen.values()))

    def test_without_a_table_it_says_what_but_not_how_long(self) -> None:
        self.at_once()
        (self.machine.tools / "costs.csv").unlink()
        status, shown, _ = self.machine.run("conform")
        self.assertEqual(status, 0, shown)
        self.assertNotIn("about", shown)

    def test_where_all_is_there_nothing_is_built(self) -> None:
        self.at_once()
        self.machine.program("dpkg-query", 'shift 3; for package; do echo "$package installed"; done')
        self.machine.program("ninja", "echo 'ninja: no work to do.'")
        (self.machine.root / "build" / "build.ninja").touch()
        status, shown, _ = self.machine.run("conform")
        self.assertEqual(status, 0, shown)
        self.assertIn("tools/conform has nothing to build and runs.", shown)
        self.assertNotIn("Building", shown)
        self.assertNotIn("Installing", shown)

    def test_only_what_is_missing_is_installed(self) -> None:
        self.at_once()
        self.machine.program("dpkg-query", 'shift 3; for package; do [ $package = cmake ] || echo "$package installed"; done')
        shown = self.machine.run("conform")[1]
        self.assertIn("tools/conform installs 1 Debian packages", shown)
        self.assertIn("Installing 1 packages", shown)

    def test_a_failure_shows_the_end_of_the_log(self) -> None:
        self.at_once()
        self.machine.program("cmake", "echo '-- some line'; echo 'CMake Error: no such thing'; exit 1")
        status, shown, _ = self.machine.run("conform")
        self.assertEqual(status, 4)
        self.assertIn("CMake Error: no such thing", shown)
        self.assertRegex(shown, r"The build could not be configured; all of the output is in \S+build/setup\.log")
        self.assertNotIn("it runs", shown)

    def test_packages_that_cannot_be_installed_are_named(self) -> None:
        self.at_once()
        self.machine.program("apt-get", 'case "$*" in *install*) echo "E: no network"; exit 100;; esac')
        status, shown, _ = self.machine.run("conform")
        self.assertEqual(status, 4)
        self.assertIn("E: no network", shown)
        self.assertRegex(shown, "apt-get could not install these packages: .*nlohmann-json3-dev")

    def test_scripts_of_packages_print_into_the_log(self) -> None:
        self.at_once()
        self.assertEqual(self.machine.run("conform")[0], 0)
        self.assertIn("Setting up cmake ...\n", (self.machine.root / "build" / "setup.log").read_text())

    def test_the_compiler_of_hlsl_is_fetched_from_debian(self) -> None:
        for name in ("debian", "tree"):
            shutil.copy(TOOLS / "lib" / "base" / f"{name}.py", self.machine.tools / "lib" / "base")
        (self.machine.programs / "python3").unlink()
        self.machine.program("vkd3d-compiler", "exit 1")
        self.machine.program("apt-get", 'echo "E: no network"; exit 100')
        done = subprocess.run(["bash", "-c", "source tools/lib/base/setup.sh; find_vkd3d"], cwd=self.machine.root,
                              env=self.machine.environment, capture_output=True, text=True, check=False)
        self.assertRegex(done.stderr, "skipped: (there is no |apt-get cannot read the list of sid at .*\n.*no network)")

    def test_a_line_that_comes_in_parts_is_one_in_the_log(self) -> None:
        self.at_once()
        self.machine.program("cmake", f"printf 'half a'; sleep {2 * TICK}; printf ' line'; exit 1")
        self.assertEqual(self.machine.run("conform")[0], 4)
        self.assertIn("half a line\n", (self.machine.root / "build" / "setup.log").read_text())

    def test_what_a_build_from_nothing_takes_is_kept(self) -> None:
        self.at_once()
        busy = "(ulimit -t 2; while :; do :; done) 2>/dev/null"  # two seconds of the processor, however busy that is
        self.machine.program("cmake", f"{CMAKE.replace(SLOW, 'true')}\n{busy}\nexit 0")
        self.assertEqual(self.machine.run("conform")[0], 0)
        rows = [line.split(",") for line in (self.machine.root / "build" / "measured.csv").read_text().splitlines()]
        self.assertEqual([row[:2] for row in rows],
                         [["packages", "each"], ["build", "conform"], ["steps", "conform"]])
        self.assertGreater(float(rows[1][2]), 0)  # of processor time, in whole seconds
        self.assertEqual(rows[2][2], "25")

    def test_a_signal_ends_what_a_command_started(self) -> None:
        job = '[ "$1" = --help ] || { echo "[1/2] first"; touch "$HN_STARTED"; sleep 100; echo it runs on; }'
        for command, program, number in (("bake", "cmake", signal.SIGTERM), ("bake", "cmake", signal.SIGINT),
                                         ("measure paper", "cmake", signal.SIGHUP),
                                         ("test", "cmake", signal.SIGTERM), ("test", "ctest", signal.SIGTERM)):
            with self.subTest(command, program=program):
                self.machine = self.new_machine()
                self.at_once()
                self.machine.program(program, job)
                self.assert_ends([self.machine.tools / command.split()[0], *command.split()[1:]], number)

    def test_a_signal_ends_what_a_command_of_python_started(self) -> None:
        text = "import subprocess; subprocess.run(['sh', '-c', 'touch $HN_STARTED; sleep 100 & wait'])"
        (self.machine.root / "job.py").write_text(text)
        for command in ([sys.executable, "-c", f"from base import needs; needs.python(3, 9); {text}"],
                        [TOOLS / "lib" / "base" / "scientific-python", "-m", "job"]):
            self.machine.environment = {**os.environ, "PYTHONPATH": f"{TOOLS / 'lib'}:{self.machine.root}"}
            with self.subTest(command):
                self.assert_ends(command, signal.SIGTERM)

    def assert_ends(self, command: Sequence[str | Path], number: int) -> None:
        """All that the command starts has a pipe open, whose other end is read until nobody has."""
        started = self.machine.root / "started"
        started.unlink(missing_ok=True)
        reading, writing = os.pipe()
        with open(reading, "rb") as end, subprocess.Popen(
                command, pass_fds=[writing], preexec_fn=with_signals, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                env={**self.machine.environment, "HN_STARTED": str(started)}) as process:
            os.close(writing)
            while process.poll() is None and not started.exists():
                time.sleep(0.01)
            process.send_signal(number)
            self.assertEqual(process.wait(), -number)
            self.assertTrue(select.select([end], [], [], 60)[0], "what it started runs on")

    def test_on_a_terminal_one_line_is_rewritten(self) -> None:
        terminal, other_end = pty.openpty()
        process = subprocess.Popen([self.machine.tools / "conform"], stdout=other_end, stderr=other_end,
                                   env=self.machine.environment)
        os.close(other_end)
        shown = b""
        while True:
            try:
                part = os.read(terminal, 4096)
            except OSError:  # Linux raises where others end the file
                break
            if not part:
                break
            shown += part
        os.close(terminal)
        self.assertEqual(process.wait(), 0)
        text = shown.decode()
        self.assertEqual(text.count("\n"), 2, text)  # the first line, and the program's output
        self.assertRegex(text, r"\rBuilding 25 steps \[\d/2\] \d+:\d\d of about 0:\d\d\x1b\[K")
        self.assertTrue(text.endswith("\r\x1b[Kit runs\r\n"), text)


if __name__ == "__main__":
    unittest.main()
