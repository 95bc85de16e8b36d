#!/usr/bin/env python3
"""hn-conform that is ended, stopped, started twice, or has no room for its results."""

import contextlib
import json
import os
import pathlib
import pty
import resource
import select
import shlex
import shutil
import signal
import subprocess
import time
import unittest

from program import CHEAP, PROGRAM, ROOT, ProgramTest

HAS_PAPER = (ROOT / "conformance" / "paper").is_dir()  # it can be deleted
ONE = ("--filter", CHEAP)
# Some seconds, and more than 100,000 bytes of journal. The cases are of one noise, so new noises do not change them.
MANY = ("--filter", "noise?d.perlin.*.fragment.gl*.golden", "--filter", "noise?d.perlin_cell.*.fragment.gl*.golden",
        "--filter", "noise?d.perlin*.fragment.gl*.twin", "--filter", "noise?d.perlin.*.gl*.range")


def wait_until(condition, what):
    deadline = time.monotonic() + 60
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"never: {what}")
        time.sleep(0.005)


def processes_in(session):
    """The processes of a session, less those that have ended and wait for their parent to look."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, its_session = stat.read_text().rpartition(")")[2].split()[:4]
        except OSError:
            continue  # it ended in the meantime
        if int(its_session) == session and state != "Z":
            found.append(int(stat.parent.name))
    return found


def displays_of(session):
    """The sockets of X servers that processes of a session have open."""
    paths = {}
    for line in pathlib.Path("/proc/net/unix").read_text().splitlines():
        inode, _, path = line.partition(" /tmp/.X11-unix/")
        if path:
            paths[f"socket:[{inode.split()[-1]}]"] = pathlib.Path("/tmp/.X11-unix", path)
    found = set()
    for process in processes_in(session):
        for file in pathlib.Path(f"/proc/{process}/fd").glob("*"):
            try:
                found.add(paths.get(os.readlink(file)))
            except OSError:
                continue  # it was closed in the meantime
    return found - {None}


class Ending(ProgramTest):
    def setUp(self):
        super().setUp()
        self.journal = self.out / "journal.jsonl"
        self.temporary = self.folder / "tmp"
        self.temporary.mkdir()

    def start(self, *arguments, most_bytes=None, stdout=subprocess.PIPE):
        """A process in a session of its own, as from a terminal. most_bytes: of each file that it writes."""
        def limit():
            if most_bytes:
                resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=stdout, stderr=subprocess.PIPE, text=True,
                                   start_new_session=True, preexec_fn=limit,
                                   env={**os.environ, "TMPDIR": str(self.temporary)})
        self.addCleanup(process.stderr.close)
        if process.stdout:
            self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def call(self, *arguments, **how):
        process = self.start(*arguments, **how)
        process.out, process.err = process.communicate(timeout=300)
        return process

    def cases_in_journal(self):
        return self.journal.read_text().count('"result"') if self.journal.exists() else 0

    def wait_for_cases(self, count):
        wait_until(lambda: self.cases_in_journal() >= count, "the run begins")

    def ended(self, process, *signals):
        """Sends them to the whole group, as a terminal does, and waits for the end."""
        for number in signals:
            os.killpg(process.pid, number)
        process.out, process.err = process.communicate(timeout=60)
        wait_until(lambda: not processes_in(process.pid), "all of its processes are gone")
        self.assertEqual(list(self.temporary.iterdir()), [])
        return process

    def expect_a_part(self, name, process):
        """The report of a run that was ended, and how to go on."""
        self.assertRegex(process.err, rf"{name} ended the run; \d+ of \d+ cases were not run\n")
        self.assertIn(f"{self.journal}; the same command with --resume goes on from there", process.err)
        self.assertIn(f"NOT THE WHOLE RUN: {self.out}/index.html", process.out)
        self.assertEqual({path.name for path in self.out.iterdir()},
                         {"results.json", "junit.xml", "index.html", "journal.jsonl"})
        runs = self.results()["runs"]
        self.assertTrue(any(run["cases"] for run in runs))
        for run in runs:
            self.assertEqual({case["status"] for case in run["cases"]} - {"pass", "unsupported"}, set())
            self.assertFalse(run["as_expected"] and "not_run" in run)
        self.assertGreater(sum(run.get("not_run", 0) for run in runs), 0)
        self.assertIn(f"{name} ended the run", (self.out / "junit.xml").read_text())
        self.assertIn("Not the whole run: ", (self.out / "index.html").read_text())

    def test_a_signal_to_the_group_leaves_what_ran_and_costs_no_case(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            with self.subTest(signal=number.name):
                process = self.start("run", "--out", self.out, "--jobs", 2, *MANY)
                self.wait_for_cases(20)
                self.ended(process, number)
                self.assertEqual(process.returncode, -number)
                self.expect_a_part(number.name, process)
                if number != signal.SIGINT:
                    shutil.rmtree(self.out)  # what is left is the same, and so is how it goes on
                    continue
                merged = self.call("merge", self.out, "--out", self.folder / "merged")
                self.assertEqual(merged.returncode, 1)
                self.assertIn("cases were not run", merged.err)
                before = self.cases_in_journal()
                self.assertGreaterEqual(before, 20)
                done = self.call("run", "--out", self.out, "--jobs", 2, *MANY, "--resume")
                self.assertEqual(done.returncode, 0, done.err)
                listed = self.listed(*MANY)
                run, = self.results()["runs"]
                self.assertEqual([case["id"] for case in run["cases"]], listed)
                self.assertFalse(self.journal.exists())

    def test_a_run_that_is_killed_leaves_no_process_and_is_resumed(self):
        command = ("run", "--out", self.out, "--jobs", 1, *MANY)
        process = self.start(*command)
        self.wait_for_cases(20)
        process.kill()
        process.communicate()
        wait_until(lambda: not processes_in(process.pid), "all of its processes are gone")
        lines = self.journal.read_text().splitlines()
        done = self.call(*command, "--seed", 2, "--resume")
        self.assertEqual(done.returncode, 2)
        self.assertIn("other settings: \"suite\"", done.err)
        self.assertEqual(self.call(*command, "--resume").returncode, 0)
        run, = self.results()["runs"]
        self.assertEqual([case["id"] for case in run["cases"]], self.listed(*MANY))
        # Earlier results stay as they were, to the time that each took.
        before = [json.loads(line)["report"]["result"] for line in lines if '"result"' in line and line.endswith("}")]
        after = {case["id"]: case for case in run["cases"]}
        self.assertGreaterEqual(len(before), 20)
        for case in before:
            self.assertEqual(after[case["id"]]["seconds"], case["seconds"])

    def test_ctrl_c_on_a_terminal(self):
        pid, terminal = pty.fork()
        if pid == 0:
            os.execv(PROGRAM, [PROGRAM, "run", "--out", str(self.out)])
        self.addCleanup(os.close, terminal)
        said = b""
        pressed = False
        while True:
            if not pressed and self.cases_in_journal() >= 20:
                os.write(terminal, b"\x03")
                pressed = True
            if not select.select([terminal], [], [], 0.01)[0]:
                continue
            try:
                said += os.read(terminal, 65536)
            except OSError:
                break  # nobody has it open any more
        _, status = os.waitpid(pid, 0)
        self.assertTrue(os.WIFSIGNALED(status), said[-500:])
        self.assertEqual(os.WTERMSIG(status), signal.SIGINT)
        self.assertIn(b"SIGINT ended the run", said)
        self.assertIn(b"--resume", said)
        wait_until(lambda: not processes_in(pid), "all of its processes are gone")

    def test_a_shell_sees_130_and_143(self):
        for name, number in (("INT", 130), ("TERM", 143)):
            out = self.folder / name
            self.journal = out / "journal.jsonl"
            shell = subprocess.Popen(["sh", "-c", f"timeout -s {name} --preserve-status 60 {PROGRAM} run --out {out} "
                                      f"--jobs 1 {shlex.join(MANY)}; echo $?"], text=True, stdout=subprocess.PIPE,
                                     stderr=subprocess.PIPE, start_new_session=True)
            self.wait_for_cases(1)
            # As if the time were over: timeout passes the signal on, twice, to us and to our group.
            for pid in processes_in(shell.pid):
                with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # what had a short task has ended
                    if pathlib.Path(f"/proc/{pid}/comm").read_text() == "timeout\n":
                        os.kill(pid, number - 128)
            said, complaints = shell.communicate(timeout=60)
            self.assertEqual(said.splitlines()[-1], str(number), complaints)
            self.assertIn("--resume", complaints)

    def test_a_server_that_a_driver_has_cleans_up(self):
        process = self.start("run", "--out", self.out, "--driver", "glfw", *MANY)
        self.wait_for_cases(5)
        displays = displays_of(process.pid)
        self.assertTrue(displays or os.environ.get("DISPLAY"))
        self.ended(process, signal.SIGINT)
        wait_until(lambda: not any(socket.exists() for socket in displays), "the display's socket is gone")
        self.expect_a_part("SIGINT", process)

    def test_before_there_are_results_one_line_is_all(self):
        for command in (("drivers",), ("bench", "--out", self.out),
                        *[("paper", "--out", self.out)] * HAS_PAPER):
            with self.subTest(command=command[0]):
                process = self.start(*command)
                if command[0] == "drivers":
                    wait_until(lambda: list(self.temporary.iterdir()), "it has a folder for its jobs")
                else:
                    wait_until(self.out.exists, "it has a folder for its results")
                    time.sleep(0.3)
                self.ended(process, signal.SIGINT)
                self.assertEqual(process.returncode, -signal.SIGINT)
                self.assertEqual(process.err.splitlines()[-1], "hn-conform: ended by SIGINT; no results are written")
                if self.out.exists():
                    self.assertEqual(list(self.out.iterdir()), [])
                    self.out.rmdir()

    def test_a_stop_costs_no_case(self):
        process = self.start("run", "--out", self.out, "--timeout", 2, *MANY)
        self.wait_for_cases(20)
        os.killpg(process.pid, signal.SIGSTOP)  # Ctrl-Z
        time.sleep(3)
        self.assertIsNone(process.poll())
        self.ended(process, signal.SIGCONT)
        self.assertEqual(process.returncode, 0, process.err)

    def test_what_is_ignored_stays_ignored(self):
        signal.signal(signal.SIGHUP, signal.SIG_IGN)  # as nohup does
        self.addCleanup(signal.signal, signal.SIGHUP, signal.SIG_DFL)
        process = self.start("run", "--out", self.out, "--filter", "noise2d.perlin.*.golden")
        self.wait_for_cases(5)
        self.ended(process, signal.SIGHUP)
        self.assertEqual(process.returncode, 0, process.err)

    def test_a_folder_that_is_in_use_is_refused_and_free_again_afterwards(self):
        earlier = self.call("run", "--out", self.folder / "earlier", *ONE)
        self.assertEqual(earlier.returncode, 0, earlier.err)
        first = self.start("run", "--out", self.out, *MANY)
        wait_until(self.journal.exists, "the run begins")
        os.killpg(first.pid, signal.SIGSTOP)  # so that it does not come to its end meanwhile
        for command in (("run",), ("run", "--resume"), ("merge", self.folder / "earlier"), ("bench",), ("web",),
                        *[("paper",)] * HAS_PAPER):
            with self.subTest(command=command):
                second = self.call(*command, "--out", self.out)
                self.assertEqual(second.returncode, 2)
                self.assertIn(f"the folder {self.out} is in use by process {first.pid} ({PROGRAM} run", second.err)
                self.assertEqual(len(second.err.splitlines()), 1)
        self.ended(first, signal.SIGKILL)
        for _ in range(2):
            self.assertEqual(self.call("run", "--out", self.out, *ONE).returncode, 0)

    def test_a_disk_that_is_full_during_the_run_ends_it_and_says_why(self):
        done = self.call("run", "--out", self.out, *MANY, most_bytes=6_000)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.err, rf"cannot write {self.journal}: File too large; \d+ of \d+ cases were not run\n")
        self.assertIn(f"{self.journal}; the same command with --resume goes on from there", done.err)
        self.assertNotIn("All as expected", done.out)
        done = self.call("run", "--out", self.out, *MANY, "--resume")
        self.assertEqual(done.returncode, 0, done.err)

    def test_results_for_which_there_is_no_room_are_written_later(self):
        done = self.call("run", "--out", self.out, *ONE, most_bytes=4096)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"cannot write {self.out}/index.html: File too large\n", done.err)
        self.assertIn("--resume", done.err)
        self.assertIn("1 pass", done.out)  # it is known, and printed
        self.assertEqual(list(self.out.glob("*.part")), [])
        self.assertEqual(self.call("run", "--out", self.out, *ONE, "--resume").returncode, 0)

    def test_no_room_from_the_beginning_is_bad_usage(self):
        done = self.call("run", "--out", self.out, *MANY, most_bytes=1000)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.err, f"hn-conform: cannot write {self.journal}: File too large\n")

    def test_what_cannot_be_printed_is_told_in_the_end(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for command in (("list",), ("run", "--out", self.out, *ONE)):
                done = self.call(*command, stdout=full)
                self.assertEqual(done.returncode, 1)
                self.assertIn("hn-conform: cannot write the standard output: No space left on device\n", done.err)
        self.assertTrue((self.out / "index.html").exists())


if __name__ == "__main__":
    unittest.main()
