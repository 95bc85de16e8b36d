"""Tests of tools/measure clock: its page and its comparison, of a record that a stand-in for hn-conform leaves."""

from __future__ import annotations

from pathlib import Path
from unittest import mock

from base.testing import Case, called
from measure import clock

HEAD = "id,dimensions,call,ratio,spread,evaluations_per_second,compile_ms,spirv,problem"
FACTS = "# date: 2026-01-02T03:04:05Z\n# renderer: Voodoo <2>\n"


def costing(id: str, axes: int, cost: float, call: str = "") -> str:
    """Of 10^9 evaluations in a second a frame has 2.07 milliseconds' worth."""
    return f"{id},{axes},{call or 'call_of_' + id},{cost / 4:g},{cost / 64:g},{1e9 / cost:.3g},1.0,{int(100 * cost)},"


FAILED = 'broken<2>,2,x,failed,failed,failed,failed,failed,"a.glsl:1: <no>\nmore"'


class Clock(Case):
    def setUp(self) -> None:
        self.out = self.folder / "out"
        self.passed: list[str] = []

    def measure(self, *arguments: str, rows: tuple[str, ...] = (), status: int = 0) -> tuple[int, str]:
        def run(command: list[str]) -> int:
            self.passed = command[1:]
            if status in (0, 1):
                self.out.mkdir(exist_ok=True)
                self.write(self.out / "bench.csv", *rows)
            return status

        with mock.patch.object(clock.conform, "run", run):
            return called(clock.main, "--out", self.out, *arguments)

    def write(self, path: Path, *rows: str) -> Path:
        path.write_text(FACTS + "\n".join([HEAD, *rows]) + "\n", encoding="utf-8")
        return path

    def page(self, *rows: str) -> str:
        self.assertEqual(self.measure(rows=rows)[0], 0)
        return (self.out / "index.html").read_text(encoding="utf-8")


class Page(Clock):
    def test_begins_with_what_people_use_the_cheapest_first(self) -> None:
        unknown = "noise2d.value.lattice,2,call_of_value,cannot be told,cannot be told,too fast to tell,1.0,9,"
        page = self.page(costing("empty2", 2, 0.5), costing("table.float2", 2, 4), costing("fbm.fbm2.lattice", 2, 8),
                         costing("noise2d.perlin.lattice", 2, 2), costing("noise2d.perlin.fnv1", 2, 3),
                         costing("simplex2", 2, 5), costing("noise2d.perlin_cell.lattice", 2, 1), unknown,
                         costing("noise2d.perlin_cell_period.lattice", 2, 1), costing("hash.word.lattice", 2, 0.25),
                         costing("noise3d.perlin.lattice", 3, 6), FAILED)
        frames, all_rows = page[page.index("<h2>"):].split("<h2>By settings")
        at = 0
        for row in ('call_of_value</th><td class="number">too fast to tell</td><td class="number">cannot be told</td>',
                    'call_of_noise2d.perlin.lattice</th><td class="number">4.15</td><td class="number">0.50 ± 0.03</td>',
                    'table.float2</th><td class="number">8.29</td><td class="number">1.00 ± 0.06</td>',
                    'simplex2</th><td class="number">10.4</td>', 'call_of_fbm.fbm2.lattice</th><td class="number">16.6</td>',
                    "3D: p is a vec3", 'call_of_noise3d.perlin.lattice</th><td class="number">12.4</td>'):
            self.assertIn(row, frames[at:])
            at = frames.index(row)
        for absent in ("empty2", "fnv1", "cell", "hash.word", "broken"):
            self.assertNotIn(absent, frames)
        places = [all_rows.index(part) for part in ("perlin.lattice</th>", "perlin.fnv1</th>", "broken&lt;2&gt;</th>")]
        self.assertEqual(places, sorted(places))
        for part in ("Voodoo &lt;2&gt;", "2026-01-02T03:04:05Z", "a.glsl:1: &lt;no&gt;"):
            self.assertIn(part, page)
        self.assertNotIn("<2>", page)
        self.assertNotIn("A frame of", self.page(costing("hash.word.fnv1", 2, 2)))


class Baseline(Clock):
    def test_slower_is_status_1_and_no_slower_is_0(self) -> None:
        earlier = self.write(self.out.parent / "earlier.csv", costing("a", 2, 2), costing("b", 2, 2),
                             costing("gone", 2, 1), FAILED)
        earlier.write_text(earlier.read_text().replace("renderer: Voodoo", "by: Rage"))
        status, out = self.measure("--baseline", str(earlier), "--driver", "x",
                                      rows=(costing("a", 2, 2), costing("b", 2, 8), costing("new", 2, 1), FAILED))
        self.assertEqual(status, 1)
        self.assertEqual(self.passed, ["bench", "--out", str(self.out), "--driver", "x"])
        self.assertIn("another renderer: Rage <2>, not Voodoo <2>\n", out)
        self.assertIn("2 subjects compared; 1 of the baseline were not measured now", out)
        self.assertEqual([line for line in out.splitlines() if line.startswith("SLOWER")],
                         ["SLOWER b: 2.000 +- 0.125, was 0.500 +- 0.031"])
        self.assertEqual((self.out / "index.html").read_text().count('<td class="number">slower</td>'), 1)
        # The record of a run may be the baseline of the one that replaces it.
        status, out = self.measure("--baseline", str(self.out / "bench.csv"), rows=(costing("b", 2, 8),))
        self.assertEqual((status, "SLOWER" in out), (0, False))

    def test_that_is_none_is_refused_before_anything_is_measured(self) -> None:
        folder = self.out.parent
        (folder / "text.csv").write_text("no record")
        (folder / "bytes.csv").write_bytes(b"id,ratio,spread\n\xff\n")
        for name, part in (("none.csv", "cannot read .*none.csv: No such file or directory; --baseline wants a bench.csv"),
                           (".", "cannot read .*: Is a directory; --baseline wants a bench.csv"),
                           ("text.csv", "text.csv is not a bench.csv of this program: "),
                           ("bytes.csv", "bytes.csv is not a bench.csv of this program: ")):
            with self.subTest(name):
                status, err = self.measure("--baseline", str(folder / name))
                self.assertEqual((status, self.passed), (2, []))
                self.assertRegex(err, part)

    def test_a_status_of_the_program_stays(self) -> None:
        for given in (1, 2, 3, 130):
            status, out = self.measure(rows=(FAILED,), status=given)
            self.assertEqual((status, "index.html" in out), (given, given == 1))
