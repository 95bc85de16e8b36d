"""The gate accepts what is random and rejects what is not, by the test meant for it; thresholds are derived."""

import contextlib
import functools
import io
import json
import shutil
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

import numpy as np
from scipy import stats

from base.thorough import in_thorough_runs, some
from base.tree import ROOT
from measure.hashes import (
    avalanche,
    command,
    components,
    controls,
    copies,
    directions,
    fourier,
    gate,
    judgement,
    library,
    near_returns,
    report,
)

SMALL = {2: (64, 64), 3: (16, 16, 16)}
SHAPES = {2: (512, 512), 3: (32, 32, 256)}  # in space, long enough for a line to differ from chance
FOLDER = tempfile.TemporaryDirectory()
TWIN = library.build("LATTICE", [], ROOT / "include", Path(FOLDER.name))


def rejecting(findings):
    return {finding.test for finding in findings if not finding.passed}


def missing(meant, findings):
    """The tests that were meant to reject and do not; no more findings are made than it takes."""
    left = set(meant)
    for finding in findings:
        left -= rejecting([finding])
        if not left:
            break
    return left


TESTS = (*gate.WINDOW_TESTS, *gate.COSTLY_TESTS, avalanche.of_window)


@functools.cache
def makers(n):
    """By finding the test that makes it, of a small window."""
    window = gate.of_words(controls.random(SMALL[n]), TWIN)
    return {finding.test: test for test in TESTS for finding in test(window)}


def of_window(words, first=()):
    """As judge_words has it, one by one; what makes these findings comes first."""
    window = gate.of_words(words, TWIN)
    wanted = {makers(words.ndim).get(name) for name in first}
    tests = sorted(TESTS, key=lambda test: test not in wanted)
    return (finding for test in tests for finding in test(window))


class Windows(unittest.TestCase):
    def test_random_words_are_accepted(self):
        for n, shape in SHAPES.items():
            for seed in some(range(3), n):
                self.assertEqual(rejecting(gate.judge_words(controls.random(shape, seed), TWIN)), set(), (n, seed))

    def test_each_control_is_rejected_by_the_tests_meant_for_it(self):
        for turn, (name, (make, tests)) in enumerate(controls.WINDOWS.items()):
            for n in some([2] if name in controls.ONLY_2D else [2, 3], turn):
                size = (gate.SIDES[n],) * n if name in controls.FULL_SIZE else SHAPES[n]
                self.assertEqual(missing(tests, of_window(make(size), tests)), set(), f"{name} in {n}D")

    def test_what_is_not_rejected_is_missing(self):
        self.assertEqual(missing({"lines"}, of_window(controls.random(SHAPES[2]))), {"lines"})

    def test_every_test_of_a_window_has_a_control(self):
        meant = {test for _, tests in controls.WINDOWS.values() for test in tests}
        made = {finding.test for finding in gate.judge_words(controls.random(SHAPES[2]), TWIN)}
        # 2D's fewer bits have "equal words"; the next test is its control.
        self.assertEqual(made - meant, {"equal values"})

    def test_values_that_are_too_few(self):
        self.assertIn("equal values", rejecting(copies.duplicates(gate.of_words(controls.stuck_bit(SHAPES[2]), TWIN))))


class Functions(unittest.TestCase):
    """gate.each_of_choices."""

    def judge(self, function, n):
        return gate.judge_twin(controls.Function("control", TWIN.program, {}, function), n, gate.LEAST)

    @in_thorough_runs
    def test_a_strong_hash_is_accepted(self):
        for n in (2, 3):
            self.assertEqual(rejecting(self.judge(controls.strong, n)), set())

    def test_each_control_is_rejected_by_the_tests_meant_for_it(self):
        for name, (function, tests) in controls.FUNCTIONS.items():
            if tests != controls.NEAR_RETURNS:  # they have a class of their own, which judges without windows
                control = controls.Function("control", TWIN.program, {}, function)
                self.assertEqual(missing(tests, gate.each_of_choices(control, 2, gate.LEAST)), set(), name)

    def test_they_are_among_all_findings(self):
        small = replace(gate.LEAST, sides={2: 256}, samples=1 << 9, windows=1)
        control = controls.Function("control", TWIN.program, {}, controls.strong)
        of_choices, of_all = ({finding.test for finding in findings(control, 2, small)}
                              for findings in (gate.each_of_choices, gate.each_finding))
        self.assertLessEqual({name for _, tests in controls.FUNCTIONS.values() for name in tests}, of_all)
        self.assertLess(of_choices, of_all)

    def test_weakness_everywhere_shows_in_the_windows_together(self):
        rng = np.random.default_rng(5)

        def finding():
            return judgement.normal("t", rng.normal(4.0 * (np.arange(100) == 7), 1), 1000, lambda i: f"at {i}")

        findings = [finding() for _ in range(12)]
        joined, = gate.pooled(findings)
        self.assertFalse(joined.passed)
        self.assertIn("at 7", joined.where)

    @in_thorough_runs
    def test_gradients_that_are_not_those_of_the_words(self):
        class Another(controls.Function):
            def gradients(self, cells, seeds):
                return 2 * super().gradients(cells + 1, seeds)

        another = Another("another", TWIN.program, {}, controls.strong)
        self.assertEqual(missing({"gradient of the word", "directions: others"},
                                 gate.each_finding(another, 2, gate.LEAST)), set())


class Components(unittest.TestCase):
    """Words and noises of vectors."""

    def judge(self, make, shape=(32, 32, 32)):
        words = controls.random(shape)
        return gate.judge_components([words, *make(words)], TWIN)

    def test_independent_components_are_accepted(self):
        self.assertEqual(rejecting(self.judge(controls.independent)), set())

    def test_the_library_is_accepted(self):
        cells = gate.cells_of((0, 0, 0), controls.COMPONENT_SHAPE)
        tables = components.Tables(3)
        words = TWIN.words(cells, 7)
        tables.add([words, *TWIN.further(words, 3)])
        self.assertEqual(rejecting(tables.judge()), set())

    @in_thorough_runs
    def test_the_library_is_accepted_by_all_tests(self):
        for n in (2, 3):
            self.assertEqual(rejecting(gate.each_of_components(TWIN, n, gate.LEAST)), set())

    def test_each_control_is_rejected_by_the_tests_meant_for_it(self):
        for name, (make, tests) in controls.COMPONENTS.items():
            shape = controls.COMPONENT_SHAPE if name == "first_factors" else (32, 32, 32)
            self.assertEqual(missing(tests, self.judge(make, shape)), set(), name)

    def test_every_test_has_a_control(self):
        meant = {test for _, tests in (*controls.COMPONENTS.values(), *controls.VECTORS.values()) for test in tests}
        small = replace(gate.LEAST, sides={3: 16}, samples=1 << 9)
        made = {finding.test for finding in gate.each_of_components(TWIN, 3, small)}
        of_windows = {f"one component: {test}" for _, tests in controls.WINDOWS.values() for test in tests}
        # As of windows: what fewer bits have of "equal words".
        self.assertEqual(made - meant - of_windows, {"one component: equal values"})

    def test_vectors_of_one_noise_are_rejected(self):
        (make, tests), = controls.VECTORS.values()
        for n in some([2, 3], 1):
            twin = controls.Vectors("alike", TWIN.program, TWIN.bits, others=make)
            self.assertEqual(rejecting(components.of_noise(twin, n, 7, gate.LEAST.samples >> 5)), set(tests), n)

    def test_the_bits_that_are_compared_are_consumed(self):
        for n, chosen in components.GRADIENT.items():
            self.assertLessEqual(set(chosen), set(TWIN.consumed(n).tolist()))

    def test_the_words_are_those_of_the_noise(self):
        # At a lattice point value noise is the number of its word, and Perlin noise beside it is a part of its ramp.
        for n in (2, 3):
            cells = np.random.default_rng(n).integers(-1000, 1000, (500, n))
            words = TWIN.words(cells, 5)
            all_words = [words, *TWIN.further(words, n)]
            values = TWIN.vectors("value", cells, 5)
            near = TWIN.vectors("perlin", cells + 2.0 ** -10 * np.eye(n)[0], 5)
            for k, component in enumerate(all_words):
                numbers = (component & np.uint32(0x7FFFFF)) * 2.0 ** -22 - 1
                self.assertLess(np.abs(values[:, k] - numbers).max(), 1e-5)
                slope = TWIN.stage(component, n)[:, 0]
                self.assertGreater(np.corrcoef(near[:, k], slope)[0, 1], 0.999)


class NearReturns(unittest.TestCase):
    """Lags after which spread coordinates are nearly what they were."""

    CONTROLS = [name for name, (_, tests) in controls.FUNCTIONS.items() if tests == controls.NEAR_RETURNS]

    def control(self, function):
        return controls.Function("control", TWIN.program, {}, function)

    def findings(self, twin, n):
        return near_returns.near_returns(twin, n, 7, gate.LEAST.samples >> 3)

    def test_each_control_is_rejected_by_all_findings(self):
        for turn, name in enumerate(self.CONTROLS):
            for n in some([2, 3], turn):
                found = self.findings(self.control(controls.FUNCTIONS[name][0]), n)
                self.assertEqual(rejecting(found), set(controls.NEAR_RETURNS), f"{name} in {n}D")

    def test_a_strong_hash_is_accepted(self):
        for n in (2, 3):
            self.assertEqual(rejecting(self.findings(self.control(controls.strong), n)), set())

    @in_thorough_runs
    def test_no_other_test_rejects_the_controls(self):
        for name in self.CONTROLS:
            for n in (2, 3):
                found = gate.judge_twin(self.control(controls.FUNCTIONS[name][0]), n, gate.LEAST)
                self.assertEqual(rejecting(found), set(controls.NEAR_RETURNS), f"{name} in {n}D")

    def test_the_copies_show_in_number(self):
        agreeing, alike, equal = self.findings(self.control(controls.near_copies), 2)
        self.assertAlmostEqual(agreeing.statistic, 1 / 5, 1)
        self.assertAlmostEqual(alike.statistic, 1 / 5, 1)
        pairs = gate.LEAST.samples >> 3 << 1  # at the one lag, in both places
        self.assertAlmostEqual(equal.statistic / pairs, 1 / 5, 1)

    def test_lags_that_come_near(self):
        for step, in library.USUAL_STEPS:
            lags = np.arange(1, 1 << 16)
            away = (lags * step + (1 << 31)) % (1 << 32) - (1 << 31)
            nearest = np.minimum.accumulate(np.abs(away))
            records = [1, *(lags[1:][nearest[1:] < nearest[:-1]])]
            self.assertEqual([lag for lag in near_returns.denominators(step) if lag < 1 << 16], records)
            self.assertEqual([lag * step % (1 << 32) for lag in near_returns.powers(step)],
                             [1 << k for k in range(near_returns.NEAR + 1)])
        self.assertIn(controls.NEAR_RETURN, near_returns.denominators(int(controls.PRIMES[0])))

    def test_lags_of_two_axes(self):
        lags, names = near_returns.lags_of(library.USUAL_STEPS, 2)
        self.assertEqual(len(set(map(tuple, lags))), len(names))
        both = lags[(lags != 0).all(axis=1)] * [step for step, in library.USUAL_STEPS[:2]] % (1 << 32)
        powers = {1 << k for k in range(near_returns.NEAR + 1)}
        self.assertEqual({tuple(row) for row in both},
                         {(power, way % (1 << 32)) for power in powers for way in (power, -power)})

    def test_the_pairs_are_in_both_places(self):
        for n, count in ((2, 1 << 12), (3, 1 << 12), (3, 1 << 13)):
            shown = near_returns.places(n, count)
            self.assertEqual({cells.shape for cells in shown.values()}, {(count, n)})
            self.assertLessEqual(np.abs(shown["as positions"]).max(), 1 << near_returns.REACH)


class Thresholds(unittest.TestCase):
    """They follow from the distribution and the size, as scipy has them."""

    def test_a_peak(self):
        for n, m in ((1000, 10), (1 << 20, 1 << 20)):
            found = judgement.normal("t", np.zeros(m), n, None, 1 / np.sqrt(n))
            self.assertAlmostEqual(found.threshold, stats.norm.isf(2.0 ** -20 / m / 2) / n ** 0.5, 12)
            self.assertAlmostEqual(2 * stats.norm.sf(found.floor * n ** 0.5), 1 - 0.5 ** (1 / m), 9)

    def test_the_verdict_is_that_of_the_threshold(self):
        for null, two_sided in ((stats.norm(), True), (stats.expon(), False)):
            limit = judgement.peak("t", 0, null, 1, 100, "", two_sided).threshold
            self.assertTrue(judgement.peak("t", limit * 0.999, null, 1, 100, "", two_sided).passed)
            self.assertFalse(judgement.peak("t", limit * 1.001, null, 1, 100, "", two_sided).passed)
        self.assertFalse(judgement.peak("t", np.nan, stats.norm(), 1, 100).passed)

    def test_counts_may_be_neither_too_many_nor_too_few(self):
        for expected in (0.001, 8, 128, 4000):
            found = judgement.poisson("t", int(expected), expected, 1)
            self.assertTrue(found.passed)
            self.assertTrue(judgement.poisson("t", int(found.threshold), expected, 1).passed)
            self.assertFalse(judgement.poisson("t", int(found.threshold) + 2, expected, 1).passed)
            if expected > 100:
                self.assertFalse(judgement.poisson("t", int(found.lower) - 1, expected, 1).passed)

    def test_too_even_tables_are_rejected(self):
        rng = np.random.default_rng(3)
        self.assertTrue(judgement.chi_square("t", rng.multinomial(100000, [1 / 256] * 256)).passed)
        self.assertFalse(judgement.chi_square("t", np.full(256, 400)).passed)
        self.assertFalse(judgement.chi_square("t", np.arange(256) + 200).passed)

    def test_random_lattices_come_above_the_floor_every_second_time(self):
        above = {"autocorrelation": 0, "spectral peak": 0}
        for seed in range(40):
            window = gate.of_words(controls.random((64, 64), seed), TWIN)
            for finding in fourier.autocorrelation(window):
                above[finding.test] += finding.statistic > finding.floor
        # Opposite lags are the same, which halves the comparisons: a little less than half of the time.
        for count in above.values():
            self.assertGreater(stats.binom.cdf(count, 40, 0.5), 1e-4)
            self.assertLess(stats.binom.cdf(count, 40, 0.5), 1 - 1e-4)


class Parts(unittest.TestCase):
    def test_the_bits_that_the_stage_uses(self):
        for n in (2, 3):
            used = sum(1 << int(bit) for bit in TWIN.consumed(n))
            words = controls.random((1000,))
            changed = (TWIN.stage(words, n) != TWIN.stage(words & np.uint32(used), n)).any(axis=-1).mean()
            # In space a third ends within two of the 32 parts that bits 31 to 27 distinguish.
            self.assertLessEqual(changed, {2: 0, 3: 2 / 32}[n])
        self.assertEqual(TWIN.consumed(2).tolist(), [31, 22, 21])
        self.assertEqual(TWIN.consumed(3).tolist(), [31, 30, 29, 28, 27, 22, 21])

    def test_equal_pairs(self):
        self.assertEqual(copies.equal_pairs(np.array([3, 1, 3, 3, 2, 1], np.uint32)), 4)
        self.assertEqual(copies.shared(np.array([1, 1, 2]), np.array([1, 2, 2, 5])), 4)

    def test_a_run_and_its_reverse_are_the_same(self):
        values = controls.random((3, 50))
        keys, mirrored = (np.sort(copies.run_keys(v, 3)) for v in (values, values[:, ::-1]))
        self.assertTrue(np.array_equal(keys, mirrored))

    def test_as_many_equal_runs_come_as_are_expected(self):
        side, length, bits = 16, 5, 3  # so few cells that a fourth of the pairs are those with cells in common
        counts = [copies.equal_pairs(copies.run_keys(controls.random((side, side), seed) >> np.uint32(32 - bits), length))
                  for seed in range(2000)]
        expected = copies.expected_runs(2 * side * (side - length + 1), 0, length, bits, 2)
        self.assertLess(np.mean(counts), expected)
        self.assertGreater(np.mean(counts), 0.85 * expected)  # at the edges there are fewer
        alone = 2.0 ** (-length * bits) * (2 * side * (side - length + 1)) ** 2
        self.assertGreater(np.mean(counts) / alone, 1.2)

    def test_the_gradients_are_all_that_words_make(self):
        for n, count in ((2, 8), (3, 12)):
            made = np.unique(TWIN.stage(controls.random((4096,)), n), axis=0)
            np.testing.assert_array_equal(made, np.unique(directions.GRADIENTS[n], axis=0))
            self.assertEqual(len(made), count)

    def test_how_likely_each_gradient_is(self):
        words = (np.arange(1 << 20, dtype=np.uint64) << np.uint64(12)).astype(np.uint32)  # evenly spread
        for n in (2, 3):
            made = TWIN.stage(words, n)
            counts = [np.count_nonzero((made == gradient).all(axis=-1)) for gradient in directions.GRADIENTS[n]]
            self.assertLessEqual(np.abs(counts - directions.likelihoods(n) * len(words)).max(), 1)

    def test_the_twin_takes_every_cell_and_seed(self):
        cells = np.array([[-1, 2 ** 31 - 1], [-2 ** 31, 0]])
        one = TWIN.words(cells, 5)
        self.assertTrue(np.array_equal(one, TWIN.words(cells, np.array([5, 5]))))
        self.assertFalse(np.array_equal(one, TWIN.words(cells, 6)))


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def call(self, *arguments):
        self.shown = io.StringIO()
        with contextlib.redirect_stdout(self.shown), contextlib.redirect_stderr(self.shown):
            try:
                return command.main([str(a) for a in arguments])
            except SystemExit as end:
                return end.code

    def test_bad_usage(self):
        np.save(self.folder / "wrong.npy", np.zeros((4, 4), np.uint32))
        for arguments in (["--hash", "MD5"], ["--words2", self.folder / "none.npy"],
                          ["--words2", self.folder / "wrong.npy"], ["--words3", self.folder / "wrong.npy"],
                          ["--quick", "--check"], ["--quick", "--least"], ["--dimensions", "4"], ["--jobs", "0"],
                          ["--steps", "2"], ["--steps", "0x100000001"], ["--seeds", "x"], ["--nothing"]):
            self.assertEqual(self.call(*arguments), 2, arguments)

    def test_options_that_would_not_be_heeded(self):
        for arguments, refused in ((["--check", "--seeds", "3"], "--check goes without --seeds"),
                                   (["--words3", "w.npy", "--hash-fn", "k"], "--words3 goes without --hash-fn"),
                                   (["--out", "o", "--dimensions", "2", "--least"],
                                    "--out goes without --dimensions and --least")):
            self.assertEqual(self.call(*arguments), 2)
            self.assertIn(refused, self.shown.getvalue())

    def test_what_is_chosen(self):
        def tasks(*arguments):
            with mock.patch.object(command, "measure_all", return_value=([], [])) as measured, \
                    mock.patch.object(library, "build", return_value=TWIN):
                self.assertEqual(self.call("--hash", "LATTICE", *arguments), 0, self.shown.getvalue())
            return measured.call_args[0][0]

        self.assertEqual([(task.dimensions, task.effort) for task in tasks()], [(3, gate.FULL), (2, gate.FULL)])
        one, = tasks("--dimensions", "2", "--least", "--seeds", "5,6", "--steps", "0x10001,0x9E3779B1")
        self.assertEqual((one.dimensions, one.effort), (2, replace(gate.LEAST, seeds=(5, 6))))
        self.assertEqual(one.twin.steps[0], (*dict.fromkeys((*TWIN.steps[0], 0x10001, 0x9E3779B1)),))
        self.assertEqual(one.twin.steps[1], (*TWIN.steps[1], 0x10001, 0x9E3779B1))

    def test_what_cannot_be_built(self):
        self.assertEqual(self.call("--quick", "--hash-fn", "k +"), 4)
        self.assertIn("does not compile", self.shown.getvalue())
        self.assertEqual(self.call("--include", self.folder), 4)

    @in_thorough_runs
    def test_words_from_a_file(self):
        np.save(self.folder / "good.npy", controls.random((128, 128)))
        np.save(self.folder / "bad.npy", controls.linear_sum((128, 128)))
        self.assertEqual(self.call("--words2", self.folder / "good.npy"), 0, self.shown.getvalue())
        with mock.patch.object(library, "build", return_value=TWIN):  # it takes longer than to judge
            self.assertEqual(self.call("--words2", self.folder / "bad.npy"), 1)
        self.assertIn("FAILS autocorrelation", self.shown.getvalue())

    def test_a_comment_behind_the_number_of_a_hash(self):
        shutil.copytree(ROOT / "glsl", self.folder / "glsl")
        config = self.folder / "glsl" / "hashnoise" / "config.glsl"
        text = config.read_text().replace("#define HN_HASH_PCG 6", "#define HN_HASH_PCG 6  // O'Neill's")
        config.write_text(text.replace("#define HN_HASH HN_HASH_LATTICE", "#define HN_HASH HN_HASH_LATTICE  // ours"))
        self.assertEqual(library.hash_names(self.folder / "include"), library.hash_names(ROOT / "include"))
        self.assertEqual(library.default_hash(self.folder / "include"), library.default_hash(ROOT / "include"))

    @in_thorough_runs
    def test_the_gradient_of_the_paper(self):
        sine = library.build("sine", ["HN_HASH=1", "HN_GRADIENT=2"], ROOT / "include", self.folder)
        self.assertTrue(np.all(np.abs(sine.gradients(np.arange(300).reshape(-1, 3), 7)) <= 1))

    def test_a_library_whose_product_was_taken_out(self):
        for part in ("include", "glsl"):
            shutil.copytree(ROOT / part, self.folder / part)
        text = (self.folder / "glsl" / "hashnoise" / "detail" / "word.glsl").read_text()
        self.assertIn("return join * (odd & 0x00FFFFFFu);", text)
        text = text.replace("return join * (odd & 0x00FFFFFFu);", "return join ^ (odd & 0u);")
        (self.folder / "glsl" / "hashnoise" / "detail" / "word.glsl").write_text(text)
        twin = library.build("no_product", [], self.folder / "include", self.folder)
        self.assertEqual(missing({"autocorrelation"}, gate.each_finding(twin, 2, gate.LEAST)), set())

    def test_the_constants_that_spread_coordinates(self):
        shutil.copytree(ROOT / "glsl", self.folder / "glsl")
        hashes = self.folder / "glsl" / "hashnoise" / "detail" / "word.glsl"
        text = hashes.read_text()
        self.assertIn("#define HN_I_STEP_Y 0x", text)

        def steps(changed):
            hashes.write_text(changed)
            return library.steps_of(self.folder / "include")

        self.assertEqual(steps(text.replace("#define HN_I_STEP", "#define HN_I_PACE")), library.USUAL_STEPS)
        own = steps(text)
        more = steps(text + "#define HN_I_STEP_SUM_Y 0x12345677u  // of another join\n")
        self.assertEqual(more, (own[0], (*own[1], 0x12345677), *own[2:]))
        with self.assertRaisesRegex(library.NotBuilt, "HN_I_STEP_SUM_Y is 0x12345678, which is even"):
            steps(text + "#define HN_I_STEP_SUM_Y 0x12345678u\n")

    @in_thorough_runs
    def test_the_dump_is_what_was_judged(self):
        library_default = library.default_hash(ROOT / "include")
        least = replace(gate.LEAST, windows=1, samples=1 << 13)
        # The worker is a fork, which has it, too.
        with mock.patch.object(gate, "QUICK", least), mock.patch.object(command, "DIMENSIONS", (2,)):
            self.call("--quick", "--hash", library_default, "--seeds", "3", "--dump", self.folder / "dump",
                      "--jobs", "1")
        entries = json.loads((self.folder / "dump" / "index.json").read_text())
        table = json.loads((self.folder / "dump" / "statistics.json").read_text())
        entry = next(e for e in entries if e["quantity"] == "gradient" and e["dimensions"] == 2 and e["seed"] == 3)
        said = next(row for row in table if row["test"] == "autocorrelation" and row["dimensions"] == 2)
        axis, lag = said["where"].split(";")[0].split(", lag ")
        g = np.load(self.folder / "dump" / entry["file"])[..., "xyz".index(axis)].astype(float)
        moved = np.roll(g, [-int(d) for d in lag.split(",")], (0, 1))
        self.assertAlmostEqual(abs((g * moved).sum() / (g * g).sum()), said["statistic"], 5)

    def test_an_old_page_is_noticed(self):
        page = self.folder / "measured" / "quality.md"
        page.parent.mkdir()
        page.write_text("a 0.12345 b 7")
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertTrue(report.same(page, "a 0.12346 b 7"))
            self.assertFalse(report.same(page, "a 0.125 b 7"))
            self.assertFalse(report.same(page, "c 0.12345 b 7"))
            self.assertFalse(report.same(self.folder / "none.md", ""))
