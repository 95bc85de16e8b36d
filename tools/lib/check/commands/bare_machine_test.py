"""The README's two commands on a Debian that has nothing but git: its smallest installation, made by debootstrap.

    python3 -m check.commands.bare_machine_test FOLDER [options of ctest]

The folder gets the installation, and a clone of the commit that is checked out, at the path that it has here. With
options, such as -R rust, tools/test alone is run, with these. FOLDER-packages keeps Debian's packages for the next run,
and where CCACHE_DIR or build/ccache has objects of the same compiler, it is used.

Exit status: 0 the commands pass and skip what CONTRIBUTING.md names, 1 not, 77 this is not root on a Debian, or
debootstrap or git's folder is missing.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from base.testing import SKIPPED
from base.tree import ROOT, TOOLS

# Certificates of a network that has its own; programs find them by the variables.
CERTIFICATES = Path("/etc/ssl/certs/ca-certificates.crt")
VARIABLES = ("CURL_CA_BUNDLE", "GIT_SSL_CAINFO", "NODE_EXTRA_CA_CERTS", "PIP_CERT", "REQUESTS_CA_BUNDLE",
             "SSL_CERT_FILE")
PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
ARCHIVES = "/var/cache/apt/archives"
# Mounts are of this process and its children alone. The first arguments are the new root, the folder to start in, and
# pairs of a folder here and its place there.
OUTSIDE = ('top=$1 inside=$2; shift 2; while [ "$1" != -- ]; do mkdir -p "$1" "$top$2" && '
           'mount --bind "$1" "$top$2" && shift 2; done; exec chroot "$top" bash -c "$0" "$inside" "$@"')
# As in a container: without /sys pocl cannot start. debootstrap has made the nodes of /dev.
INSIDE = ('mount -t proc proc /proc && mount -t sysfs sysfs /sys -o ro && mount -t devpts devpts /dev/pts -o ptmxmode=0666 && '
          'mkdir -p /dev/shm && mount -t tmpfs tmpfs /dev/shm && cd "$0" && shift && exec "$@"')


def named(page: str) -> set[str]:
    """The tests that a page lists as skipped."""
    return set(re.findall(r"^- `([\w.]+)`, which", page, re.MULTILINE))


def faults(status: int, text: str, page: str) -> list[str]:
    """The faults of a run of tools/test by its exit status, its output, and the page that names skipped tests."""
    listed = re.search(r"^Skipped, in whole or in part:\n((?:  .*\n)+)", text, re.MULTILINE)
    skipped = {line.split(":")[0].strip(): line for line in (listed[1].splitlines() if listed else [])}
    ran = set(re.findall(r"^ *\d+/\d+ +Test +#\d+: (\S+)", text, re.MULTILINE))
    found = [f"exit status {status}"] if status else []
    found += [line for name, line in skipped.items() if name not in named(page)]
    found += [f"{name} skipped nothing" for name in sorted((named(page) & ran) - skipped.keys())]
    return found if re.search(r"^100% tests passed", text, re.MULTILINE) else [*found, "ctest printed no success"]


class Judgement(unittest.TestCase):
    def test_a_run_without_skips_passes(self) -> None:
        self.assertEqual(faults(0, "100% tests passed, 0 tests failed out of 7\n9 more tests run\n", ""), [])

    def test_faults_are_found(self) -> None:
        passed = ("1/2 Test #1: a ...   Passed   0.01 sec\n2/2 Test  #2: c ...***Skipped\n"
                  "100% tests passed, 0 tests failed out of 2\n")
        shown = f"{passed}Skipped, in whole or in part:\n  a: there is no b\n  c: d\n9 more tests run\n"
        page = "These are:\n\n- `c`, which wants `d`\n- `e`, which does not run here\n"
        self.assertEqual(faults(0, shown, ""), ["  a: there is no b", "  c: d"])
        self.assertEqual(faults(0, shown, page), ["  a: there is no b"])
        self.assertEqual(faults(0, shown, page + "- `a`, which wants `b`\n"), [])
        self.assertEqual(faults(0, passed, page), ["c skipped nothing"])
        self.assertEqual(faults(8, "86% tests passed\n", ""), ["exit status 8", "ctest printed no success"])

    def test_the_page_names_tests(self) -> None:
        self.assertGreater(len(named(PAGE)), 0)
        for name in named(PAGE):  # of a folder, or of a module
            path = TOOLS.joinpath("lib", *name.split(".")[1:])
            self.assertTrue(path.is_dir() or path.with_name(f"{path.name}_test.py").is_file(), name)


@unittest.skipUnless(__name__ == "__main__", "the test commands.bare_machine makes the installation")
class BareMachine(unittest.TestCase):
    top: Path
    options: list[str]

    @classmethod
    def setUpClass(cls) -> None:
        shutil.rmtree(cls.top, ignore_errors=True)
        cls.top.mkdir(parents=True)
        cls.packages = cls.top.with_name(f"{cls.top.name}-packages")
        cls.packages.mkdir(exist_ok=True)
        subprocess.run(["debootstrap", "--variant=minbase", "--include=ca-certificates,git",
                        f"--cache-dir={cls.packages}", "bookworm", cls.top], stdout=subprocess.DEVNULL, check=True)
        shutil.copy("/etc/resolv.conf", cls.top / "etc")
        if CERTIFICATES.exists():
            shutil.copy(CERTIFICATES, cls.top / CERTIFICATES.relative_to("/"))
        cls.clone = cls.top / ROOT.relative_to("/")
        subprocess.run(["git", "clone", "--quiet", "--no-hardlinks", ROOT, cls.clone], check=True)

    @classmethod
    def tearDownClass(cls) -> None:
        shutil.rmtree(cls.top, ignore_errors=True)

    def call(self, *command: str) -> tuple[int, str]:
        """The status and the output of a command in the clone, which also stands in the log of ctest."""
        cache = os.environ.get("CCACHE_DIR", str(ROOT / "build" / "ccache"))
        environment = {"HOME": "/root", "LANG": "C.UTF-8", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "TERM": "dumb",
                       **{name: value for name, value in os.environ.items()
                          if name in VARIABLES or name.startswith("CCACHE_")}}
        mounted = [self.packages, ARCHIVES, cache, cache]
        enter = ["unshare", "--mount", "--pid", "--fork", "--kill-child", "bash", "-euc", OUTSIDE, INSIDE]
        done = subprocess.run([*enter, self.top, ROOT, *mounted, "--", *command], env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        print(done.stdout)
        return done.returncode, done.stdout

    def test_1_the_suite_runs(self) -> None:
        if self.options:
            self.skipTest("tools/test alone has the options")
        self.assertEqual(self.call("tools/conform", "--out", "out")[0], 0)
        self.assertTrue((self.clone / "out" / "index.html").is_file())

    def test_2_the_tests_pass_and_skip_what_is_named(self) -> None:
        self.assertEqual(faults(*self.call("tools/test", *self.options), PAGE), [])


if __name__ == "__main__":
    BareMachine.top = Path(sys.argv.pop(1)).resolve()
    BareMachine.options = sys.argv[1:]
    if (os.geteuid() or not all(map(os.path.exists, ("/etc/debian_version", ROOT / ".git")))
            or not shutil.which("debootstrap")):
        print("skipped: this takes root on a Debian, a clone, and debootstrap: apt-get install debootstrap")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
