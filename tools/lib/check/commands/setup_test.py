"""Tests of tools/lib/base/setup.sh: what commands print and refuse before they run.

Scripts stand in for cmake, apt-get and others, so that nothing is installed or built. A line of progress is due every
fifth of a second here, in place of every ten seconds, and a step lasts until it has shown one, however busy the machine
is.
"""

from __future__ import annotations

import os
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
from pathlib import Path
from unittest import mock

from base.pieces import is_deleted
from base.tree import ROOT, TOOLS
from base.versions import folders

STEPS = 6  # the list of packages, their download and installation, the configuration, and two of the build
SLOW = 'n=0; until [ -e "$HN_READ" ] || [ $n = 600 ]; do sleep 0.05; n=$((n + 1)); done; rm -f "$HN_READ"'
# As apt-get does, it closes the file of its progress for dpkg.
APT_GET = """fd=$(echo "$*" | sed 's/.*Status-Fd=\\([0-9]*\\).*/\\1/')
case "$*" in
  *update*) SLOW;;
  *) eval "exec 9>&$fd"
     echo dlstatus:1:25.5:Retrieving >&9; SLOW; echo pmstatus:cmake:75.2:Unpacking >&9; SLOW
     eval "exec $fd>&-"
     echo Setting up cmake ... || exit 100;;
esac"""
CMAKE = "case \"$*\" in *--build*) echo '[1/2] first'; SLOW; echo '[2/2] second'; SLOW;; *) SLOW;; esac"
DEBIANS = "c++ (Debian 12.2.0-14+deb12u1) 12.2.0"
CONFORM = "conformance/hn-conform"
# The program behind each, in build/, and its arguments; but not of what was deleted.
COMMANDS = {"bake": ("bake/bin/python", "-I -m hashnoise bake --help"), "conform": (CONFORM, "run --help"),
            "measure clock": (CONFORM, "bench --help"), "measure paper": (CONFORM, "paper --help")}
COMMANDS = {name: of for name, of in COMMANDS.items() if (TOOLS / name.split()[0]).exists() and
            not (name == "measure paper" and is_deleted("paper"))}
# By tools/lib/base/scientific-python.
SCIENTIFIC = {f"measure {name}": f"measure/{name}" for name in ("hashes", "noise", "uniform")
              if not is_deleted("measuring")}
TEXTS = ("conformance/cli/options.cpp",
         *["packages/python/hashnoise/_bake.py"] * (not is_deleted("baker")),
         *(f"tools/lib/{room}/command.py" for room in SCIENTIFIC.values()))
FILES = ("base/setup.sh", "base/packages.txt", "base/scientific-python", "base/node", "base/usage.py")


class Machine(unittest.TestCase):
    """A copy of the commands, with nothing built, on a machine without packages."""

    def setUp(self) -> None:
        self.root = Path(self.enterContext(tempfile.TemporaryDirectory()))
        for name in ("test", *{name.split()[0] for name in COMMANDS}, *(f"lib/{file}" for file in FILES)):
            self.copy(f"tools/{name}")
        if not is_deleted("measuring"):
            shutil.copytree(TOOLS / "lib" / "measure", self.root / "tools" / "lib" / "measure",
                            ignore=shutil.ignore_patterns("*.py"))
        self.programs, self.read = self.root / "programs", self.root / "read"
        for name, text in (("dpkg-query", "exit 1"), ("sudo", 'shift; [ "$1" = true ] || exec "$@"'),  # sudo -n
                           ("apt-get", APT_GET), ("cmake", CMAKE), ("g++", ""), ("ctest", ""), ("nproc", "echo 2")):
            self.program(name, text.replace("SLOW", "true"))
        self.environment = {**os.environ, "HOME": "/nowhere", "PATH": f"{self.programs}:{os.environ['PATH']}",
                            "HN_PROGRESS_SECONDS": "0.2", "HN_READ": str(self.read)}
        for name in ("CCACHE_DIR", "HN_VKD3D_COMPILER"):
            self.environment.pop(name, None)

    def copy(self, file: str) -> None:
        (self.root / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / file, self.root / file)

    def program(self, name: str | Path, text: str) -> None:
        """It notes that it was called."""
        path = self.programs / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\ntouch {self.root}/{path.name}.called\n{text}\n")
        path.chmod(0o755)

    def build_all(self) -> None:
        for path, _ in COMMANDS.values():
            self.program(self.root / "build" / path, 'echo "called with: $*"')

    def call(self, name: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        command, *part = name.split()
        return subprocess.run([self.root / "tools" / command, *part, *arguments], env=self.environment,
                              capture_output=True, text=True, check=False)

    def bash(self, text: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(["bash", "-c", f"source tools/lib/base/setup.sh; {text}"], cwd=self.root,
                              env=self.environment, capture_output=True, text=True, check=False)

    def log(self) -> str:
        return (self.root / "build" / "setup.log").read_text()


class Setup(Machine):
    def test_no_step_is_silent_for_long(self) -> None:
        self.program("apt-get", APT_GET.replace("SLOW", SLOW))
        self.program("cmake", CMAKE.replace("SLOW", SLOW))
        self.build_all()
        lines, steps, last = [], 0, ""
        with subprocess.Popen([self.root / "tools" / "conform"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, env=self.environment) as process:
            for line in process.stdout:
                lines.append(line)
                step = re.sub(r", \d+:\d\d\n", "", line)
                # A slow machine prints these two before the program wrote anything.
                early = step == "Building" or step.endswith("what they need")
                if step != line and step != last and not early:
                    steps, last = steps + 1, step
                    self.read.touch()
        shown = "".join(lines)
        self.assertEqual((process.returncode, steps), (0, STEPS), shown)
        self.assertRegex(lines[0], r"^tools/conform installs \d+ Debian packages, builds and runs\..*build/setup\.log")
        for pattern in (r"Installing \d+ .* 25 % downloaded, ", "75 % installed, ",
                        r"Building \[1/2\], \d:\d\d\n", "called with: run"):
            self.assertRegex(shown, pattern)
        # As the scripts of packages, which print into the log.
        self.assertIn("Setting up cmake ...\n", self.log())

    def test_only_what_is_missing_is_installed(self) -> None:
        self.program("dpkg-query", 'shift 3; for p; do [ $p = cmake ] || echo "$p installed"; done')
        shown = self.call("conform").stderr
        self.assertIn("tools/conform installs 1 Debian packages", shown)
        self.assertIn("Installing 1 packages", shown)
        self.program("dpkg-query", 'shift 3; for p; do echo "$p installed"; done')
        self.assertNotIn("nstall", self.call("conform").stderr)

    def test_a_step_that_fails_ends_the_command(self) -> None:
        self.build_all()
        for program, text, said, end in (
                ("cmake", "echo 'CMake Error: no such thing'; exit 1", "CMake Error: no such thing",
                 r"The build could not be configured; all of the output is in \S+build/setup\.log"),
                ("apt-get", 'case "$*" in *install*) echo "E: no network"; exit 100;; esac', "E: no network",
                 "apt-get could not install these packages: .*nlohmann-json3-dev")):
            with self.subTest(program):
                self.program(program, text)
                done = self.call("conform")
                self.assertEqual((done.returncode, done.stdout), (4, ""))
                self.assertIn(said, done.stderr)
                self.assertRegex(done.stderr, end)

    def test_a_second_command_compiles_nothing_again(self) -> None:
        """Each configures this tree, in one folder, and prints how it would compile the suite."""
        self.program("cmake", f"""case "$1" in
  --build) ninja -C "$2" -t commands hn-conform >{self.root}/lines;;
  -S) shift 2; exec {shutil.which("cmake")} -S {ROOT} "$@";;
esac""")
        lines = []
        for command in ("conform", "test"):
            self.call(command)
            lines.append((self.root / "lines").read_text().splitlines())
        self.assertGreater(len(lines[0]), 50)
        self.assertEqual(*lines)

    def test_warnings_are_errors_of_debians_compiler_alone(self) -> None:
        """It is c++, or the one of the build, if that is configured."""
        (self.root / "build").mkdir()
        cache = f"CMAKE_CXX_COMPILER:FILEPATH={self.programs}/second\n"
        for first, second, known in ((DEBIANS, "", True), ("c++ (GCC) 12.2.0", "", False), ("", DEBIANS, True),
                                     ("Debian clang version 14.0.6", "", False), (DEBIANS, "clang version 22.1", False)):
            with self.subTest(first, second=second):
                self.program("c++", f"echo '{first}'")
                self.program("second", f"echo '{second}'")
                (self.root / "build" / "CMakeCache.txt").write_text(cache * bool(second))
                self.assertEqual(self.bash("knows_compiler").returncode == 0, known)

    def test_the_compiler_of_hlsl_is_fetched_from_debian(self) -> None:
        for name in ("debian", "tree"):
            self.copy(f"tools/lib/base/{name}.py")
        self.program("vkd3d-compiler", "exit 1")
        self.program("apt-get", 'echo "E: no network"; exit 100')
        self.assertRegex(self.bash("find_vkd3d").stderr,
                         "skipped: (there is no |apt-get cannot read the list of sid at .*\n.*no network)")

    def test_only_what_compiles_hlsl_fetches_its_compiler(self) -> None:
        self.program("vkd3d-compiler", "echo vkd3d shader compiler version 1.10")
        self.build_all()
        called = self.root / "vkd3d-compiler.called"
        for wanted, *arguments in ((False, "--driver", "osmesa"), (False, "--driver", "glfw*", "--driver=webgl2"),
                                   (True, "--driver=all"), (True, "--driver", "vulkan:12"), (True, "--driver", "v*"),
                                   (True, "--driver=*:1"), (True, "--driver", "egl-gles", "--through", "vkd3d=/v")):
            with self.subTest(arguments):
                called.unlink(missing_ok=True)
                self.assertEqual(self.call("conform", *arguments).returncode, 0)
                self.assertEqual(called.exists(), wanted)

    def test_a_signal_ends_what_a_command_started(self) -> None:
        job = '[ "$1" = --help ] || { touch "$HN_STARTED"; sleep 100; echo it runs on; }'
        self.program("cmake", job)
        for command, number in (("conform", signal.SIGINT), ("measure paper", signal.SIGHUP), ("test", signal.SIGTERM)):
            if command not in (*COMMANDS, "test"):
                continue
            with self.subTest(command):
                name, *part = command.split()
                self.assert_ends([self.root / "tools" / name, *part], number)

    def test_a_signal_ends_what_a_command_of_python_started(self) -> None:
        text = "import subprocess; subprocess.run(['sh', '-c', 'touch $HN_STARTED; sleep 100 & wait'])"
        (self.root / "job.py").write_text(text)
        (self.root / "ctest").write_text('#!/bin/sh\ntouch "$HN_STARTED"\nsleep 100\n')
        (self.root / "ctest").chmod(0o755)
        self.environment = {**os.environ, "PYTHONPATH": f"{TOOLS / 'lib'}:{self.root}",
                            "PATH": f"{self.root}:{os.environ['PATH']}"}
        for command in ([sys.executable, "-c", f"from base import needs; needs.python(); {text}"],
                        [TOOLS / "lib" / "base" / "scientific-python", "-m", "job"],
                        [sys.executable, "-B", "-m", "check.tests.command", self.root]):
            with self.subTest(command):
                self.assert_ends(command, signal.SIGTERM)

    def assert_ends(self, command: Sequence[str | Path], number: int) -> None:
        """All that the command starts has a pipe open, whose other end is read until nobody has."""
        def with_signals() -> None:  # a job in the background of a shell ignores some of them
            for one in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
                signal.signal(one, signal.SIG_DFL)
        started = self.root / "started"
        started.unlink(missing_ok=True)
        reading, writing = os.pipe()
        with open(reading, "rb") as end, subprocess.Popen(
                command, pass_fds=[writing], preexec_fn=with_signals, stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL, env={**self.environment, "HN_STARTED": str(started)}) as process:
            os.close(writing)
            while process.poll() is None and not started.exists():
                time.sleep(0.01)
            process.send_signal(number)
            self.assertEqual(process.wait(), -number)
            self.assertTrue(select.select([end], [], [], 60)[0], "what it started runs on")

    def test_programs_of_debian_come_before_the_owners(self) -> None:
        own = self.root / "home" / "bin"
        for folder, version in ((own, "2.10.0"), (self.programs, "2.9.1")):
            self.program(folder / "tool", f"echo version {version}")
        self.program("python3", f"tool >>{self.root}/ran")
        self.environment |= {"HOME": str(own.parent), "PATH": f"{own}:{self.environment['PATH']}"}
        self.assertEqual(self.call("test").returncode, 0)
        first = "2.9.1" if Path("/etc/debian_version").exists() else "2.10.0"
        self.assertIn(f"version {first}\n", (self.root / "ran").read_text())
        with mock.patch.dict(os.environ, self.environment):
            self.assertEqual(folders("tool"), [str(self.programs), str(own)])


class Usage(Machine):
    def called(self) -> list[str]:
        return [path.stem for path in self.root.glob("*.called")]

    def test_help_installs_and_builds_nothing(self) -> None:
        for built in (False, True):
            for name, (program, called) in COMMANDS.items():
                for arguments in (("--help",), ("-h",), ("help",), ("--driver", "all", "--help")):
                    with self.subTest(name=name, arguments=arguments):
                        done = self.call(name, *arguments)
                        self.assertEqual((done.returncode, done.stderr), (0, ""))
                        self.assertIn(f"tools/{name} [options of {program.rpartition('/')[2]}", done.stdout)
                        self.assertIn("4 it could not be built", done.stdout)
                        self.assertIn(f"called with: {called}\n" if built else "is not built yet", done.stdout)
                        self.assertNotIn("#", done.stdout)
            self.assertEqual((self.root / "build").exists(), built)
            self.assertLessEqual({*self.called()}, {Path(program).name for program, _ in COMMANDS.values()})
            self.build_all()

    @unittest.skipUnless("bake" in COMMANDS, "tools/bake was deleted")
    def test_bake_without_arguments_prints_its_usage(self) -> None:
        # A build that was interrupted leaves a Python without the package.
        for text in ("", "echo no module named hashnoise >&2; exit 1"):
            if text:
                self.program(self.root / "build" / COMMANDS["bake"][0], text)
            done = self.call("bake")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertRegex(done.stderr, "(?s)^Writes noise as a picture.*bake/bin/python is not built yet")
        self.assertFalse((self.root / "build" / "setup.log").exists())

    def assert_refused(self, said: str, name: str, *arguments: str) -> None:
        done = self.call(name, *arguments)
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (2, "", f"tools/{name}: {said}; see tools/{name} --help\n"))
        self.assertFalse((self.root / "build").exists())

    def test_wrong_options_install_and_build_nothing(self) -> None:
        for file in TEXTS:
            self.copy(file)
        self.program("ctest", "echo '  -Q,--quiet  = Make ctest quiet.'")
        for name, arguments, option in (
                ("bake", ("fbm", "--octvaes", "3"), "--octvaes (did you mean --octaves?)"),
                ("measure clock", ("--baselien=x",), "--baselien (did you mean --baseline?)"),
                ("conform", ("--drivre", "all"), "--drivre (did you mean --driver?)"),
                ("conform", ("--no-such-thing",), "--no-such-thing"),
                # ctest takes any option, so that this would run the tests that are not thorough.
                ("test", ("--thorogh",), "--thorogh (did you mean --thorough?)"),
                ("test", ("--quite",), "--quite (did you mean --quiet?)")):
            if name not in (*COMMANDS, "test"):
                continue
            with self.subTest(name=name, arguments=arguments):
                self.assert_refused(f"there is no option {option}", name, *arguments)
        done = self.call("test", "--resume")
        self.assertEqual((done.returncode, done.stderr), (2, "tools/test: --resume goes with --thorough\n"))
        self.assertEqual([name for name in self.called() if name != "ctest"], [])

    def test_wrong_options_of_what_needs_scientific_python(self) -> None:
        """Neither Python here has it: the refusal comes before it is installed. Beginnings of options will do."""
        if not SCIENTIFIC:
            return
        file = self.root / "tools" / "lib" / "base" / "scientific-python"
        file.write_text(file.read_text().replace("/usr/bin/python3", "no-other-python"))
        self.program("python3", "exit 1")
        for name, room in SCIENTIFIC.items():
            self.copy(f"tools/lib/{room}/command.py")
            with self.subTest(name):
                self.assert_refused("there is no option --noize", name, "--noize")
        self.assertEqual(self.called(), ["python3"])
        self.assertEqual(self.call("measure hashes", "--qui", "--hash=FNV1").returncode, 4)
        self.assertIn("apt-get", self.called())

    def test_right_options_are_taken(self) -> None:
        """Whatever is an option of a program, by its --help, and what is none of it."""
        self.program("cmake", "exit 1")
        for file in TEXTS:
            self.copy(file)
        cases = [("conform", arguments) for arguments in (("--filter", "*--x"), ("-x",), ("--", "--no-such-thing"),
                                                          ("--out=--no-such-thing",), ("--filter", "*help*"))]
        for name, (program, shown) in COMMANDS.items():
            if (path := ROOT / "build" / program).exists():
                text = subprocess.run([path, *shown.split()], capture_output=True, text=True, check=True).stdout
                options = {*re.findall(r"^ +(?:-\w,)?(--[a-z-]+)", text, re.MULTILINE)} - {"--help"}
                self.assertGreater(len(options), 3)
                cases.append((name, sorted(options)))
        for name, arguments in cases:
            with self.subTest(name=name, arguments=arguments):
                self.assertEqual(self.call(name, *arguments).returncode, 4)
        (self.root / "conformance" / "cli" / "options.cpp").unlink()
        self.program("ctest", "exit 1")
        for name in ("conform", "test"):  # nobody can know
            self.assertEqual(self.call(name, "--no-text-has-it").returncode, 4)


class Node(Machine):
    @unittest.skipUnless(shutil.which("node"), "there is no node in PATH")
    def test_one_of_the_path_is_taken_if_it_is_new_enough(self) -> None:
        self.program("npm", "")
        self.program("python3", "exit 1")  # so there is no other
        self.program("node", f'exec {shutil.which("node")} --require {self.root}/version.cjs "$@"')
        for version, status in (("20.19.0", 4), ("22.11.0", 4), ("22.12.0", 0), ("24.1.0", 0)):
            with self.subTest(version):
                (self.root / "version.cjs").write_text(
                    f"Object.defineProperty(process, 'versions', {{value: {{node: '{version}'}}}});", encoding="ascii")
                done = self.call("lib/base/node", "node", "-p", "process.versions.node")
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertEqual(done.stdout, "" if status else f"{version}\n")
