"""The README's two commands on a Debian that has nothing but git: its smallest installation, made by debootstrap.

    python3 -m check.commands.bare_machine_test FOLDER

The folder gets the installation, and a clone of the commit that is checked out. Exit status: 0 both commands pass and
skip nothing but what CONTRIBUTING.md names, 1 not, 77 this is not root on a Debian, or debootstrap is missing.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from base.tree import ROOT

SKIPPED = 77
# Certificates of a network that has its own; programs find them by the variables.
CERTIFICATES = Path("/etc/ssl/certs/ca-certificates.crt")
VARIABLES = ("CURL_CA_BUNDLE", "GIT_SSL_CAINFO", "NODE_EXTRA_CA_CERTS", "PIP_CERT", "REQUESTS_CA_BUNDLE",
             "SSL_CERT_FILE")
# Mounts are of this process and its children alone.
ENTER = ('mount -t proc proc /proc && mount -t devpts devpts /dev/pts -o ptmxmode=0666 && mkdir -p /dev/shm && '
         'mount -t tmpfs tmpfs /dev/shm && cd /hashnoise && exec "$@"')


def faults(status: int, text: str, page: str) -> list[str]:
    """The faults of a run of tools/test by its exit status, its output, and the page that names what it may skip."""
    listed = re.search(r"^Skipped, in whole or in part:\n((?:  .*\n)+)", text, re.MULTILINE)
    found = [f"exit status {status}"] if status else []
    found += [line for line in (listed[1].splitlines() if listed else [])
              if f"`{line.split(':')[0].strip()}`" not in page]
    return found if re.search(r"^100% tests passed", text, re.MULTILINE) else [*found, "ctest printed no success"]


class Judgement(unittest.TestCase):
    def test_a_run_without_skips_passes(self) -> None:
        self.assertEqual(faults(0, "100% tests passed, 0 tests failed out of 7\n9 more tests run\n", ""), [])

    def test_faults_are_found(self) -> None:
        passed = "100% tests passed, 0 tests failed out of 7\n"
        shown = f"{passed}Skipped, in whole or in part:\n  a: there is no b\n  c: d\n9 more tests run\n"
        self.assertEqual(faults(0, shown, ""), ["  a: there is no b", "  c: d"])
        self.assertEqual(faults(0, shown, "only `c`, in part"), ["  a: there is no b"])
        self.assertEqual(faults(8, "86% tests passed\n", ""), ["exit status 8", "ctest printed no success"])


@unittest.skipUnless(__name__ == "__main__", "the test commands.bare_machine makes the installation")
class BareMachine(unittest.TestCase):
    top: Path

    @classmethod
    def setUpClass(cls) -> None:
        shutil.rmtree(cls.top, ignore_errors=True)
        cls.top.mkdir(parents=True)
        subprocess.run(["debootstrap", "--variant=minbase", "--include=ca-certificates,git", "bookworm", cls.top],
                       stdout=subprocess.DEVNULL, check=True)
        shutil.copy("/etc/resolv.conf", cls.top / "etc")
        if CERTIFICATES.exists():
            shutil.copy(CERTIFICATES, cls.top / CERTIFICATES.relative_to("/"))
        subprocess.run(["git", "clone", "--quiet", "--no-hardlinks", ROOT, cls.top / "hashnoise"], check=True)

    @classmethod
    def tearDownClass(cls) -> None:
        shutil.rmtree(cls.top, ignore_errors=True)

    def call(self, *command: str) -> tuple[int, str]:
        """The status and the output of a command in the clone, which also stands in the log of ctest."""
        environment = {"HOME": "/root", "LANG": "C.UTF-8", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "TERM": "dumb",
                       **{name: os.environ[name] for name in VARIABLES if name in os.environ}}
        enter = ["unshare", "--mount", "--pid", "--fork", "--kill-child", "chroot", self.top, "bash", "-c", ENTER, "bash"]
        done = subprocess.run([*enter, *command], env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        print(done.stdout)
        return done.returncode, done.stdout

    def test_1_the_suite_runs(self) -> None:
        self.assertEqual(self.call("tools/conform", "--out", "out")[0], 0)
        self.assertTrue((self.top / "hashnoise" / "out" / "index.html").is_file())

    def test_2_the_tests_pass_and_skip_nothing_else(self) -> None:
        page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
        self.assertEqual(faults(*self.call("tools/test"), page), [])


if __name__ == "__main__":
    BareMachine.top = Path(sys.argv.pop(1)).resolve()
    if os.geteuid() or not Path("/etc/debian_version").exists() or not shutil.which("debootstrap"):
        print("skipped: this takes root on a Debian, and debootstrap: apt-get install debootstrap")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
