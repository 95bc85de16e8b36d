"""Tests of the table of costs: that it can fail, and records hold the measured costs."""

from __future__ import annotations

import contextlib
import io
import signal
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base import costs
from check.costs import command

WITHIN = """kind,name,value,before
budget,tests,100,
run,conform,60,
speed,loop,0.1,
test,golden,50,49
test,twins,40,41
"""


class Table(unittest.TestCase):
    def problems(self, text: str, *tests: str) -> str:
        return "\n".join(costs.problems(costs.read(text), tests))

    def test_it_is_read_and_written_as_it_was(self) -> None:
        self.assertEqual(costs.written(costs.read(WITHIN)), WITHIN)

    def test_within_the_budget_nothing_is_said(self) -> None:
        self.assertEqual(self.problems(WITHIN, "golden", "twins"), "")

    def test_beyond_the_budget_it_says_what_grew(self) -> None:
        text = WITHIN.replace("test,twins,40,41", "test,twins,80,41\ntest,wheel,7,")
        self.assertRegex(self.problems(text, "golden", "twins", "wheel"),
                         r"^the tests of a default run take 137 s of processor time, and may take 100: "
                         r"twins went from 41 to 80 s; wheel is new with 7 s; golden went from 49 to 50 s\. Make them")

    def test_a_test_without_a_row(self) -> None:
        self.assertRegex(self.problems(WITHIN, "golden", "twins", "wheel"), r"^wheel has no row: run tools/test --record")

    def test_a_row_without_a_test(self) -> None:
        self.assertRegex(self.problems(WITHIN, "golden"), r"^twins is no test of a default run any more")

    def test_a_new_value_keeps_the_last_that_was_within_the_budget(self) -> None:
        tests = ("golden", "twins")
        once = costs.updated(costs.read(WITHIN), {("test", "twins"): 80}, tests)
        twice = costs.updated(once, {("test", "twins"): 90}, tests)
        for table, value in ((once, 80), (twice, 90)):
            self.assertEqual(table["test", "twins"], costs.Row(value, 40))
            self.assertEqual(table["test", "golden"], costs.Row(50, 50))
        back = costs.updated(costs.updated(twice, {("test", "twins"): 45}, tests), {}, tests)
        self.assertEqual(back["test", "twins"], costs.Row(45, 45))

    def test_the_row_of_a_test_that_is_gone_goes(self) -> None:
        self.assertNotIn(("test", "twins"), costs.updated(costs.read(WITHIN), {}, ("golden",)))

    def test_on_another_machine_everything_but_the_network_is_faster(self) -> None:
        table = costs.read(WITHIN) | {("packages", "each"): costs.Row(2.0)}
        faster = costs.rebased(table, table["speed", "loop"].value / 2)
        self.assertEqual(faster["test", "golden"], costs.Row(25, 24.5))
        self.assertEqual(faster["budget", "tests"].value, table["budget", "tests"].value / 2)
        self.assertEqual(faster["packages", "each"].value, 2)
        self.assertEqual(faster["speed", "loop"].value, table["speed", "loop"].value / 2)

    def test_a_table_of_another_form_is_refused(self) -> None:
        with self.assertRaisesRegex(ValueError, "the first line of the table must be kind,name,value,before"):
            costs.read("name,seconds\n")


BURN = "import time; end = time.process_time() + {}\nwhile time.process_time() < end: pass\n"


def burning(name: str, seconds: float, status: int = 0, **properties: object) -> dict:
    return {"name": name, "command": [sys.executable, "-c", f"{BURN.format(seconds)}raise SystemExit({status})"],
            "properties": [{"name": key, "value": value} for key, value in properties.items()]}


class Recording(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = Path(folder.name)
        self.path = self.build / "costs.csv"
        self.path.write_text(WITHIN)

    def record(self, *tests: dict, speed: float = 0.1) -> tuple[int, costs.Table, str]:
        text = io.StringIO()
        with (mock.patch.object(command, "listed", lambda *_: list(tests)), contextlib.redirect_stdout(text),
              mock.patch.object(command, "calibration", lambda *_: speed), contextlib.redirect_stderr(text)):
            status = command.record(self.build, self.path, ["-R", "."])
        return status, costs.read_file(self.path), text.getvalue()

    def test_processor_time_counts_and_not_what_a_test_waits(self) -> None:
        waiting = burning("golden", 0.3)
        waiting["command"][2] = "import time; time.sleep(2)\n" + waiting["command"][2]
        status, table, text = self.record(waiting, burning("twins", 0.1))
        self.assertEqual(status, 0, text)
        self.assertTrue(0.3 <= table["test", "golden"].value < 2, table)
        self.assertGreaterEqual(table["test", "twins"].value, 0.1)
        self.assertEqual(table["test", "golden"].before, 50)

    def test_what_a_test_starts_and_does_not_wait_for_counts_until_it_ends_or_is_ended(self) -> None:
        burnt = self.build / "burnt"
        for then, name in (("", "twins"), ("\ntime.sleep(600)", "golden")):
            starting = burning(name, 0)
            inner = f"{BURN.format(0.5)}open({str(burnt)!r}, 'w'){then}"
            starting["command"][2] = f"import subprocess, sys; subprocess.Popen([sys.executable, '-c', {inner!r}])"
            # The time is up when it has used its own, however busy the machine is.
            with mock.patch.object(command.time, "monotonic", lambda: command.LEFT + 1 if burnt.exists() else 0.0):
                status, table, text = self.record(starting)
            burnt.unlink()
            self.assertEqual(status, 0, text)
            # The system counts a process without a waiting parent in hundredths of a second, and the last are lost.
            self.assertGreaterEqual(table["test", name].value, 0.45)

    def test_a_test_may_be_interrupted_though_a_shell_has_this_in_the_background(self) -> None:
        test = burning("golden", 0)
        test["command"][2] = "import signal; raise SystemExit(signal.getsignal(signal.SIGINT) is signal.SIG_IGN)"
        before = signal.signal(signal.SIGINT, signal.SIG_IGN)
        try:
            status, _, text = self.record(test)
        finally:
            signal.signal(signal.SIGINT, before)
        self.assertEqual(status, 0, text)

    def test_on_a_machine_that_is_half_as_fast_a_second_counts_half(self) -> None:
        table = self.record(burning("golden", 1), burning("twins", 0), speed=0.2)[1]
        self.assertTrue(0.5 <= table["test", "golden"].value < 1, table)

    def test_a_machine_that_slows_down_is_asked_again(self) -> None:
        speeds = iter((0.1, 0.1, 0.3))  # of all cores, before the first test, and after it
        with (mock.patch.object(command, "calibration", lambda *_: next(speeds)),
              mock.patch.object(command, "STEADY", 0.5), contextlib.redirect_stdout(io.StringIO()),
              mock.patch.object(command, "listed", lambda *_: [burning("golden", 1)])):
            self.assertEqual(command.record(self.build, self.path, ["-R", "."]), 0)
        self.assertTrue(0.5 <= costs.read_file(self.path)["test", "golden"].value < 1)  # a second at half the speed

    def test_the_tests_of_a_program_of_gtest_are_one_row(self) -> None:
        tests = [burning(f"unit.A.{number}", 0.2) for number in range(2)]
        for test in tests:
            test["command"].append("--gtest_filter=A.*")
        table = self.record(*tests)[1]
        self.assertGreaterEqual(table["test", Path(sys.executable).name].value, 0.4)
        self.assertNotIn(("test", "golden"), table)

    def test_a_part_of_a_program_of_gtest_is_no_measure_of_it(self) -> None:
        tests = [burning(f"unit.A.{number}", 0) for number in range(2)]
        for test in tests:
            test["command"][0:1] = ["env", "--gtest_filter=A.*"]
        self.path.write_text(WITHIN + "test,env,30,\n")
        text = io.StringIO()
        with (mock.patch.object(command, "listed", lambda _, *options: tests[:1] if options else tests),
              mock.patch.object(command, "cost_of", lambda *_: (0, 5.0)), contextlib.redirect_stdout(text)):
            self.assertEqual(command.record(self.build, self.path, ["-R", "."]), 0)
        self.assertEqual(costs.read_file(self.path)["test", "env"].value, 30)
        self.assertIn("Only some tests of env were measured", text.getvalue())

    def test_a_test_that_fails_keeps_its_row(self) -> None:
        status, table, text = self.record(burning("golden", 0, status=1), burning("twins", 0))
        self.assertEqual(status, 1)
        self.assertEqual(table["test", "golden"].value, 50)
        self.assertIn("golden failed, and what it costs is not written", text)

    def test_a_test_that_is_skipped_keeps_its_row(self) -> None:
        skipped = burning("golden", 0, status=77, SKIP_RETURN_CODE=77)
        new = burning("new", 0, status=77, SKIP_RETURN_CODE=77)
        status, table, text = self.record(skipped, new, burning("twins", 0))
        self.assertEqual(status, 0, text)
        self.assertEqual(table["test", "golden"].value, 50)
        self.assertLess(table["test", "new"].value, 1)

    def test_what_other_commands_measured_is_kept(self) -> None:
        (self.build / "measured.csv").write_text("build,conform,7\npackages,each,0.5,\nbuild,conform,300,0.2\nsteps,conform,140,\n")
        table = self.record(burning("golden", 0))[1]
        self.assertEqual([table[key].value for key in (("packages", "each"), ("build", "conform"), ("steps", "conform"))],
                         [0.5, 150, 140])


class Machine(unittest.TestCase):
    def test_the_loop_takes_time(self) -> None:
        self.assertTrue(0.001 < command.calibration() < 10)

    def test_ctest_is_asked(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "CTestTestfile.cmake").write_text(
                'add_test(uses "true")\nset_tests_properties(uses PROPERTIES FIXTURES_REQUIRED made)\n'
                'add_test(other "true")\nadd_test(makes "true")\n'
                'set_tests_properties(makes PROPERTIES FIXTURES_SETUP made)\nadd_test(unit.A "true" "--gtest_filter=A")\n'
                'add_test(costs.table "false")\n')
            tests = command.listed(Path(folder))
            self.assertEqual([test["name"] for test in tests], ["makes", "other", "unit.A", "uses"])
            self.assertEqual([command.row_of(test) for test in tests], ["makes", "other", "true", "uses"])


if __name__ == "__main__":
    unittest.main()
