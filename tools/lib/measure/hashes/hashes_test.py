"""The gate accepts what is random and rejects what is not, by the test meant for it; limits are derived."""

import re
import shutil
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

import numpy as np
from scipy import stats

from base.testing import Case, called
from base.thorough import THOROUGH, in_thorough_runs, some
from base.tree import ROOT
from base.twin import NotBuilt
from measure import stamps
from measure.hashes import command, controls, fields, gate, judgement, lags, library, streams, windows
from measure.hashes.controls import CONTROLS, GOOD
from measure.hashes.windows import BITS, Window

FOLDER = tempfile.TemporaryDirectory()
TWIN = library.build("LATTICE", [], Path(FOLDER.name))
BY_NAME = {control.name: control for control in CONTROLS}
# By finding the test of a window that makes it: the others are not calculated in a default run.
OF_WINDOWS = {"autocorrelation": windows.fourier, "spectral peak": windows.fourier, "blocks": windows.parts,
              "lines": windows.parts, "rectangles": lambda window: [windows.rectangles(window)],
              "copied lines": lambda window: [windows.copied_lines(window)],
              "copied runs": lambda window: [windows.copied_runs([window])]}
FEW = 1 << 12  # pairs of cells
SMALL = {} if THOROUGH else {2: 512, 3: 96}  # sides of windows


def rejecting(findings):
    return {finding.test for finding in findings if not finding.passed}


def first_window(hash_, n=2):
    return gate.sample(hash_, n, (-gate.SIDES[n] // 2,) * n, 0)


class Controls(unittest.TestCase):
    def test_every_test_of_the_gate_has_a_control(self):
        small = replace(gate.QUICK, samples=8, windows=1)
        with mock.patch.dict(gate.SIDES, {2: 64}), mock.patch.object(streams, "judge", return_value=[]):
            made = {finding.test for _, found in gate.judge(GOOD, 2, small) for finding in found}
        self.assertEqual(made | {"dieharder"}, {control.rejected_by for control in CONTROLS})

    @mock.patch.dict(gate.SIDES, SMALL)
    def test_windows(self):
        for turn, (name, function) in enumerate(OF_WINDOWS.items()):
            for control in CONTROLS:
                if control.rejected_by == name and not control.real:
                    for n in some([2, 3], turn):
                        self.assertIn(name, rejecting(function(first_window(control, n))), f"{control.name} in {n}D")

    def test_distances(self):
        for test, names in (("avalanche", ["weak_coordinate_bit"]), ("near returns", ["near_copies", "product"])):
            for turn, name in enumerate(names):
                for n in some([2, 3], turn):
                    self.assertEqual(rejecting(lags.judge(BY_NAME[name], n, FEW)), {test}, f"{name} in {n}D")

    @mock.patch.dict(gate.SIDES, SMALL)
    def test_seeds_and_components(self):
        for control, test in ((BY_NAME["seed_moves"], "seeds"), (BY_NAME["moved_component"], "components"),
                              (BY_NAME["first_factors"], "parities of components")):
            with mock.patch.object(windows, "judge", return_value=[]):
                seeds = gate.QUICK.seeds[:1 + (test == "seeds")]
                found = gate.of_windows(control, control.dimensions, gate.Effort(1, seeds, windows=0))
                self.assertEqual(rejecting(found), {test}, control.name)

    def test_dieharder(self):
        for control, rejected in ((GOOD, False), (BY_NAME["alike_bits"], True)):
            found = streams.p_values(101, 10, streams.stream(control, 2, "rows"))  # the runs of the STS
            self.assertEqual([p < judgement.ALPHA for _, p in found], [rejected], control.name)

    @in_thorough_runs
    def test_no_other_test_rejects_a_control(self):
        for control in (GOOD, *CONTROLS):
            found = [one for _, findings in gate.judge(control, control.dimensions, gate.QUICK) for one in findings]
            self.assertTrue(control.rejected_as_meant(found), f"{control.name}: {rejecting(found)}")

    def test_a_control_that_fails_otherwise_is_noticed(self):
        finding = judgement.Finding("lines", 9.0, 6.0, 0.0)
        self.assertTrue(BY_NAME["weak_row"].rejected_as_meant([finding]))
        for control in (GOOD, BY_NAME["wave"], BY_NAME["product"]):
            self.assertFalse(control.rejected_as_meant([finding]), control.name)


class Random(unittest.TestCase):
    def test_windows_of_random_words_are_accepted(self):
        for n, shape in ((2, (512, 512)), (3, (64, 64, 64))):
            for seed in some(range(3), n):
                words = np.random.Generator(np.random.Philox(seed)).integers(0, 1 << 32, shape, np.uint32)
                for bits in (BITS, BITS[:10]):
                    self.assertEqual(rejecting(windows.judge(Window(words, "", bits))), set(), (n, seed))

    def test_distances_of_a_strong_hash_are_accepted(self):
        self.assertEqual(rejecting(lags.judge(GOOD, 2, FEW)), set())

    def test_too_few_bits_are_copied_runs_of_floats(self):
        words = np.tile(np.random.default_rng(0).integers(0, 1 << 32, (64, 32), np.uint32), (1, 2))
        self.assertIn("copied runs", rejecting(windows.judge(Window(words, "", BITS[:10]))))


class Library(unittest.TestCase):
    def test_words_of_the_twin(self):
        cells = np.array([[-1, 2 ** 31 - 1], [-2 ** 31, 0]])
        one = TWIN.words(cells, 5)
        np.testing.assert_array_equal(one, TWIN.words(cells, np.array([5, 5])))
        self.assertFalse(np.array_equal(one, TWIN.words(cells, 6)))

    def test_a_window_of_the_default_hash_is_accepted(self):
        self.assertEqual(rejecting(windows.judge(first_window(TWIN))), set())

    @in_thorough_runs
    def test_a_library_without_its_product_is_rejected(self):
        include = changed(self, "detail/word.glsl", r"return join \* \(odd & 0x00FFFFFFu\);",
                          "return join ^ (odd & 0u);")
        twin = library.build("changed", [], include.parent, include)
        self.assertIn("autocorrelation", rejecting(windows.judge(first_window(twin))))

    def test_the_constants_that_spread_coordinates(self):
        include = changed(self, "detail/word.glsl", "#define HN_I_STEP_Y ",
                          r"#define HN_I_STEP_SUM_Y 0x12345677u  // of another join\n\g<0>")
        own = library.steps_of()
        self.assertEqual(library.steps_of(include), (own[0], (0x12345677, *own[1]), own[2]))


class Judgement(unittest.TestCase):
    """Limits follow from the distribution, as scipy has it."""

    def test_the_verdict_is_that_of_the_limit(self):
        for null in (stats.halfnorm(), stats.expon(), stats.poisson(2.0)):
            limit = judgement.peak("t", 0, null, 100).limit
            step = 1 if isinstance(null.dist, stats.rv_discrete) else limit * 1e-3
            self.assertTrue(judgement.peak("t", limit - step, null, 100).passed)
            self.assertFalse(judgement.peak("t", limit + step, null, 100).passed)
        limit = judgement.normal("t", np.zeros(50), times=2).limit
        self.assertAlmostEqual(limit, stats.norm.isf(2.0 ** -20 / 100 / 2), 9)
        self.assertFalse(judgement.peak("t", np.nan, stats.norm(), 100).passed)

    def test_what_is_rare(self):
        for count, passed in ((0, True), (1, True), (2, False)):
            self.assertEqual(judgement.rare("t", count, 1e-5).passed, passed)

    def test_random_lattices_reach_their_own_maximum(self):
        """The largest of so many values is as far out as it should be, in 29 of 100 lattices."""
        above = {"autocorrelation": 0, "spectral peak": 0}
        for seed in range(40):
            words = np.random.default_rng(seed).integers(0, 1 << 32, (64, 64), np.uint32)
            for found in windows.fourier(Window(words, "", (31,))):
                above[found.test] += found.p < (0.69 if found.test == "autocorrelation" else 0.35)
        # Opposite lags are the same, which halves the comparisons.
        for count in above.values():
            self.assertGreater(stats.binom.cdf(count, 40, 0.29), 1e-4)
            self.assertLess(stats.binom.cdf(count, 40, 0.29), 1 - 1e-4)

    def test_the_worst_finding_of_each_test(self):
        findings = [judgement.Finding(*found) for found in (("a", 1, 5, 1.0), ("a", 2, 5, 1.0), ("b", 6, 5, 0.0))]
        self.assertEqual([found.statistic for found in judgement.worst(findings)], [2, 6])


class Lags(unittest.TestCase):
    def test_lags_that_come_near(self):
        for step, in library.USUAL_STEPS:
            distances = np.arange(1, 1 << 16)
            away = np.abs((distances * step + (1 << 31)) % (1 << 32) - (1 << 31))
            nearest = np.minimum.accumulate(away)
            records = [1, *(distances[1:][nearest[1:] < nearest[:-1]])]
            self.assertEqual([lag for lag in lags.denominators(step) if lag < 1 << 16], records)
            self.assertEqual([lag * step % (1 << 32) for lag in lags.powers(step)],
                             [1 << k for k in range(lags.NEAR + 1)])
        self.assertIn(controls.NEAR_RETURN, lags.denominators(int(controls.PRIMES[0])))

    def test_lags_of_two_axes(self):
        rows = np.array(lags.near_returns(library.USUAL_STEPS, 2))
        both = rows[(rows != 0).all(axis=1)] * [step for step, in library.USUAL_STEPS[:2]] % (1 << 32)
        powers = {1 << k for k in range(lags.NEAR + 1)}
        self.assertEqual({tuple(row) for row in both},
                         {(power, way % (1 << 32)) for power in powers for way in (power, -power)})


class Streams(unittest.TestCase):
    def test_orders(self):
        i = np.arange(1 << 11)
        for n in (2, 3):
            cells = {name: order(i, n) for name, order in streams.ORDERS.items()}
            self.assertEqual(cells["rows"][1].tolist(), [1, *[0] * (n - 1)])
            self.assertEqual(cells["strides"][-1].tolist(), (cells["rows"][-1] << 12).tolist())
            changed = cells["Gray"][1:] ^ cells["Gray"][:-1]
            self.assertTrue(((changed != 0).sum(axis=1) == 1).all())
            self.assertTrue((changed & changed - 1 == 0).all())
            self.assertEqual(len({tuple(cell) for cell in cells["seeds"]}), 8)

    def test_a_stream_has_the_upper_halves_of_words(self):
        first = np.frombuffer(next(streams.stream(GOOD, 2, "seeds")), np.uint16)
        cells = np.tile([[0, 0], [1, 0], [1, 1], [0, 1], [2, 1], [3, 1], [3, 0], [2, 0]], (2, 1))
        seeds = np.repeat([0, 1], 8)
        np.testing.assert_array_equal(first[:16], GOOD.words(cells, seeds) >> 16)

    def test_without_dieharder(self):
        with mock.patch.object(streams, "PROGRAM", "no-such-program"), \
                self.assertRaisesRegex(NotBuilt, "no no-such-program: apt-get install"):
            streams.p_values(100, 1, iter(()))
        with mock.patch.object(streams, "PROGRAM", "false"), self.assertRaisesRegex(NotBuilt, "ended with 1"):
            streams.p_values(100, 1, iter(()))


class Command(Case):
    def call(self, *arguments):
        status, self.shown = called(command.main, *arguments)
        return status

    def test_bad_usage(self):
        for arguments in (["--hash", "MD5"], ["--nothing"], ["--quick", "--out", "o"]):
            self.assertEqual(self.call(*arguments), 2, arguments)

    def test_a_verdict_on_one_hash(self):
        for wrong, status in ((False, 0), (True, 1)):
            found = {"windows": [judgement.Finding("lines", 9.0, 6.0, 0.0 if wrong else 0.5, "bit 31")]}
            with mock.patch.object(command, "measured", lambda tasks: [(task, found) for task in tasks]), \
                    mock.patch.object(library, "build", return_value=TWIN):
                self.assertEqual(self.call("--hash", "LATTICE", "--quick"), status)
        self.assertEqual(command.verdict("X 2D", found["windows"]), "X 2D: FAILS lines: 9 (allowed 6, p = 0; bit 31)")

    def test_the_records(self):
        found = {"windows": [judgement.Finding("lines", 9.0, 6.0, 0.0)]}
        shown = [fields.Measure("hn_perlin", 2, "structures, 4", [0.2, 0.3], 0.1)]
        with mock.patch.object(command, "measured", lambda tasks: [(task, found) for task in tasks]), \
                mock.patch.object(library, "build", return_value=TWIN), \
                mock.patch.object(command, "noises", return_value=shown), \
                mock.patch.object(library, "hash_names", return_value={"LATTICE": 8}):
            self.assertEqual(self.call("--out", self.folder), 1)
        self.assertIn("hn_perlin 2D FAILS structures, 4: 0.2500 (allowed 0.1)", self.shown)
        rows = stamps.read(self.folder / "quality.csv").rows
        self.assertEqual([row["hash"] for row in rows[:2]], ["LATTICE", "LATTICE"])
        self.assertEqual({row["text"] == stamps.NONE for row in rows[:2]}, {False})
        self.assertEqual({row["text"] for row in rows[2:]}, {stamps.NONE})
        self.assertEqual(len(rows), 2 + 1 + len(CONTROLS))
        row, = stamps.read(self.folder / "directions.csv").rows
        self.assertEqual((row["mean"], row["error"], row["allowed"]), ("0.2500", "0.0500", "0.1"))

    def test_what_cannot_be_built(self):
        self.assertEqual(self.call("--quick", "--hash-fn", "k +"), 4)
        self.assertIn("does not compile", self.shown)


def changed(test: unittest.TestCase, name: str, pattern: str, replacement: str) -> Path:
    """include/ of a copy of the library with another text in a file."""
    folder = Path(test.enterContext(tempfile.TemporaryDirectory()))
    for part in ("include", "glsl"):
        shutil.copytree(ROOT / part, folder / part)
    path = folder / "glsl" / "hashnoise" / name
    text, count = re.subn(pattern, replacement, path.read_text(encoding="utf-8"))
    test.assertGreater(count, 0, f"{name} has no {pattern}")
    path.write_text(text, encoding="utf-8")
    return folder / "include"
