"""tools/conform shards: it deals the parts to this machine or to hosts, and joins the results.

Scripts stand in for tools/conform, for the program that joins, and for ssh: a host is a folder here, which its HOME is.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from base.thorough import in_thorough_runs
from base.tree import ROOT, TOOLS, hn_conform

# Each run notes its arguments in one file; $HN_STATUS sets the status of a part, as in "2:4".
CONFORM = """while [ $# -gt 0 ]; do
  case $1 in --shard) shard=$2; shift;; --out) out=$2; shift;; *) rest="$rest<$1>";; esac
  shift
done
echo "$(basename "$PWD") $shard $rest" >>"$HN_NOTES"
echo "some words"
status=0
case " $HN_STATUS " in
  *" ${shard%/*}:"*) status=$(echo " $HN_STATUS " | sed "s/.* ${shard%/*}:\\([0-9]*\\) .*/\\1/");;
esac
[ $status -ge 2 ] || { mkdir -p "$out"; echo "results of $shard" >"$out/results.json"; }
exit $status"""
JOIN = """shift
while [ "$1" != --out ]; do cat "$1/results.json"; shift; done
exit ${HN_JOINED-0}"""
SSH = """[ "$1" = -o ] && shift 2
host=$1; shift
[ $host != gone ] || exit 255
HOME=$HN_HOSTS/$host; cd "$HOME"
exec "$@\""""


class Shards(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        self.copy(self.root / "here")
        self.hosts = self.root / "hosts"
        self.notes = self.root / "notes"
        self.program(self.root / "programs" / "ssh", SSH)
        self.program(self.root / "programs" / "cmake", "exit 0")
        self.program(self.root / "programs" / "ninja", "echo 'ninja: no work to do.'")
        self.program(self.root / "programs" / "dpkg-query", 'shift 3; for p; do echo "$p installed"; done')

    def program(self, path: Path, text: str) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)

    def copy(self, folder: Path) -> None:
        """A copy of the repository, as a host has it."""
        (folder / "tools" / "lib" / "base").mkdir(parents=True)
        for name in ("lib/base/shards.sh", "lib/base/setup.sh", "lib/base/progress.sh"):
            shutil.copy(TOOLS / name, folder / "tools" / name)
        (folder / "conformance" / "cli").mkdir(parents=True)
        shutil.copy(ROOT / "conformance" / "cli" / "options.cpp", folder / "conformance" / "cli")
        self.program(folder / "tools" / "conform", CONFORM)
        self.program(folder / "build" / "conformance" / "hn-conform", JOIN)

    def call(self, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
        self.notes.write_text("")
        return subprocess.run(
            [self.root / "here" / "tools" / "lib" / "base" / "shards.sh", *arguments], capture_output=True, text=True, check=False,
            cwd=self.root / "here", timeout=60,
            env={**os.environ, "PATH": f"{self.root / 'programs'}:{os.environ['PATH']}", "HN_HOSTS": str(self.hosts),
                 "HN_NOTES": str(self.notes), **environment})

    def noted(self) -> list[str]:
        return self.notes.read_text().splitlines()

    def test_here_one_after_another(self) -> None:
        done = self.call("3", "--filter", "* x", "--out=joined")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.noted(), [f"here {i}/3 <--filter><* x>" for i in (1, 2, 3)])
        self.assertTrue(done.stdout.endswith("results of 1/3\nresults of 2/3\nresults of 3/3\n"), done.stdout)
        self.assertTrue((self.root / "here" / "joined" / "shards" / "2" / "results.json").exists())

    def test_what_fails_is_in_the_joined_results(self) -> None:
        done = self.call("3", HN_STATUS="2:1", HN_JOINED="1")
        self.assertEqual((done.returncode, len(self.noted())), (1, 3))
        self.assertIn("results of 2/3", done.stdout)

    def test_without_a_verdict_no_more_parts_run_here(self) -> None:
        for status in (2, 130):
            with self.subTest(status=status):
                done = self.call("3", HN_STATUS=f"2:{status}")
                self.assertEqual((done.returncode, len(self.noted())), (status, 2))
                self.assertIn(f"Part 2 of 3 ended with status {status}", done.stderr)
                self.assertIn("results of 1/3", done.stdout)
                self.assertNotIn("results of 3/3", done.stdout)  # those of the run before

    def test_to_resume(self) -> None:
        self.call("3", HN_STATUS="2:130")
        done = self.call("3", "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.noted(), ["here 2/3 <--resume>", "here 3/3 <--resume>"])
        self.assertIn("results of 1/3", done.stdout)
        (self.root / "here" / "out" / "shards" / "3" / "journal.jsonl").touch()  # that part ended early
        self.call("3", "--resume")
        self.assertEqual(self.noted(), ["here 3/3 <--resume>"])

    def test_on_hosts(self) -> None:
        self.copy(self.hosts / "alice" / "hashnoise")
        self.copy(self.hosts / "bob" / "my sources")
        where = ("--host", "alice", "--host=bob:my sources")
        done = self.call(*where, "--filter", "a 'b' *")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(self.noted()),
                         ["hashnoise 1/2 <--filter><a 'b' *>", "my sources 2/2 <--filter><a 'b' *>"])
        self.assertTrue(done.stdout.endswith("results of 1/2\nresults of 2/2\n"), done.stdout)
        self.assertIn("alice: some words\n", done.stderr)  # and not among the results
        self.call("3", *where)
        self.assertEqual(sorted(self.noted()), ["hashnoise 1/3 ", "hashnoise 3/3 ", "my sources 2/3 "])
        done = self.call("3", *where, "--resume", HN_STATUS="1:4")  # nothing is left to run
        self.assertEqual((done.returncode, self.noted()), (0, []), done.stderr)
        self.assertIn("results of 3/3", done.stdout)

    def test_a_host_that_is_not_there(self) -> None:
        self.copy(self.hosts / "alice" / "hashnoise")
        (self.hosts / "empty").mkdir()
        for host, said in (("gone", "ssh cannot reach gone"), ("empty", "Part 2 of 3 on empty ended with status 4")):
            with self.subTest(host=host):
                done = self.call("3", "--host", "alice", "--host", host)
                self.assertEqual(done.returncode, 4, done.stderr)
                self.assertIn(said, done.stderr)
                self.assertTrue(done.stdout.endswith("results of 1/3\nresults of 3/3\n"), done.stdout)

    def test_bad_usage(self) -> None:
        for arguments, said in (
                ((), "give the number of parts"), (("0",), "there are 1 to 9999 parts, not 0"),
                (("--host",), "must be followed by a name"), (("2", "--shard", "1/2"), "it deals the shards itself"),
                (("--host=-oProxyCommand=x",), "is not HOST"),
                (("2", "--hots", "a"), "no option --hots (did you mean --host?)")):
            with self.subTest(arguments=arguments):
                done = self.call(*arguments)
                self.assertEqual((done.returncode, self.noted()), (2, []))
                self.assertIn(said, done.stderr)

    @in_thorough_runs  # two runs and what joins them have tests of their own
    @unittest.skipUnless(hn_conform(), "the suite is not built")
    def test_the_suite_itself(self) -> None:
        here = self.root / "here"
        self.program(here / "tools" / "conform", f'exec "{hn_conform()}" run "$@"')
        shutil.rmtree(here / "build" / "conformance")
        (here / "build" / "conformance").symlink_to(Path(hn_conform()).parent)
        done = self.call("2", "--filter", "bugs.fo*.gl330.defined")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("All as expected: out/index.html", done.stdout)
        results = (here / "out" / "results.json").read_text()
        self.assertIn("--shard 1/2", results)
        self.assertIn("--shard 2/2", results)


if __name__ == "__main__":
    unittest.main()
