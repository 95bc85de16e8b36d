#!/usr/bin/env python3
"""The page that hn-conform web writes, as its user meets it.

Chromium opens the page, which reports here its text and its downloads."""

import base64
import json
import re
import shutil
import subprocess
import sys
import unittest

from program import ROOT, ProgramTest

sys.path[:0] = [str(ROOT / "tools" / "lib"), str(ROOT / "conformance" / "web")]
import browse  # noqa: E402

from base import chromium  # noqa: E402

PHONE = "--window-size=360,800"
SECONDS = 120


# Sends the text of the page at the end, too.
LOOK = """<script>{
  const send = window.fetch;
  const place = (id) => document.getElementById(id);
  window.fetch = (to, options) => {
    const event = options?.body ? JSON.parse(options.body) : {};
    if (event.type !== "done") return send(to, options);
    const sent = { hidden: place("offer").hidden, address: place("send").href,
                   width: document.documentElement.scrollWidth, window: innerWidth };
    return send(to, { ...options, body: JSON.stringify({ ...event, sent, meaning: place("meaning").innerText }) });
  };
}</script>"""


# A few of each kind of case that a page may have. Every case of a page is run in Chromium by the test
# conform.all. (Chromium's Tint has one bug of WGSL: run/expect/webgpu.csv.)
GLOBS = ("bugs.*.es300.*", "bugs.[a-y]*.wgsl.*", "hash.lattice2.lattice.*", "noise2d.perlin.lattice.*", "fbm.fbm2.lattice.fixed.*", "fbm.all.lattice.*",
         "config.hash*")
FEW = ["--thorough", *(argument for glob in GLOBS for argument in ("--filter", glob))]
SMALL = ("--thorough", "--filter", "hash.lattice2.lattice.*", "--filter", "bugs.abs_of_int.*")
WEBGPU = ("--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader")


class Web(ProgramTest):
    def page(self, *arguments):
        done = self.call("web", "--out", self.folder / "page", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([path.name for path in (self.folder / "page").iterdir()], ["index.html"])
        return (self.folder / "page" / "index.html").read_text()

    def chromium(self, *switches):
        return chromium.command(chromium.found(), self.folder / "profile", PHONE, *switches)

    def open(self, page, *switches, address=""):
        """The text of the page of a project at this address, at its end."""
        module = (ROOT / "conformance" / "web" / "address.js").read_bytes()
        other = re.sub(rb'(?m)"[^"]*";$', f'"{address}";'.encode(), module)
        page = page.replace(base64.b64encode(module).decode(), base64.b64encode(other).decode())
        full = browse.reporting(page, golden="89abcdef")  # as if it had all default cases
        return browse.last_event(full.replace("<body>", f"<body>{LOOK}"), self.chromium(*switches), SECONDS)

    def merged(self, end):
        """hn-conform takes the results of the page for its own."""
        (self.folder / "results.json").write_text(end["results"])
        return self.call("merge", self.folder / "results.json", "--out", self.folder / "merged")

    def test_all_is_as_expected_and_results_have_the_schema(self):
        end = self.open(self.page(*FEW), *WEBGPU, address="https://example.org/another")
        self.assertEqual(end["verdict"], "All as expected")
        results = json.loads(end["results"])
        self.assertEqual(results["schema"], 2)
        run, = results["runs"]
        self.assertEqual(run["driver"], "webgl2")
        self.assertIn("SwiftShader", run["renderer"])
        self.assertEqual(run["totals"]["fail"], 0)
        self.assertEqual(run["totals"]["pass"] + run["totals"]["warning"], len(run["cases"]))
        self.assertLessEqual({case["id"] for case in run["cases"]}, set(self.listed("--thorough")))
        self.assertGreater(len(run["cases"]), 60)
        self.assertIn("noise2d.perlin.lattice.fixed.compute.wgsl.golden", {case["id"] for case in run["cases"]})
        # hn-conform takes them for its own.
        merged = self.merged(end)
        self.assertEqual(merged.returncode, 0, merged.stderr + merged.stdout)
        self.assertRegex(run["browser"], r"^Chrome \d+$")
        self.assertEqual((run["system"], run["golden"]), ("Linux", "89abcdef"))
        self.assertFalse(end["sent"]["hidden"])
        self.assertEqual(end["sent"]["address"], "https://example.org/another/issues/new?template=result.yml")
        self.assertTrue((ROOT / ".github" / "ISSUE_TEMPLATE" / "result.yml").is_file())
        self.assertIn("have the same bits here as everywhere", end["meaning"])
        self.assertLessEqual(end["sent"]["width"], end["sent"]["window"])
        for key in ("id", "status", "samples", "mismatches", "max_abs", "max_ulp", "seconds", "message"):
            self.assertTrue(all(key in case for case in run["cases"]), key)

    def edited_golden(self):
        """The folder of golden files with one value of a hash that is wrong."""
        golden = self.folder / "golden"
        shutil.copytree(ROOT / "conformance" / "expected" / "golden", golden)
        file = golden / "hash.lattice2.golden"
        lines = file.read_text().split("\n")
        groups = lines[10].split(" = ")
        lattice = next(i for i, setting in enumerate(lines[5].split()) if setting.startswith("lattice:"))
        groups[lattice] = groups[lattice][:-1] + ("0" if groups[lattice][-1] != "0" else "1")
        lines[10] = " = ".join(groups)
        file.write_text("\n".join(lines))
        return golden

    def test_an_edited_library_is_named_and_failures_are_told_in_the_words_of_the_report(self):
        copy = self.folder / "copy"
        shutil.copytree(ROOT / "glsl" / "hashnoise", copy)
        file = copy / "perlin2d.glsl"
        before = file.read_text()
        file.write_text(before.replace("t = hn_i_fade(f)", "t = f"))
        self.assertNotEqual(file.read_text(), before)
        globs = ("noise?d.perlin.lattice.*.golden", "noise2d.perlin.lattice.*", "fbm.fbm2.lattice.fixed.*", "hash.lattice2.lattice.*")
        page = self.page("--glsl", copy, "--golden", self.edited_golden(), "--thorough",
                         *(argument for glob in globs for argument in ("--filter", glob)))
        self.assertIn(f"the library in {copy} (perlin2d.glsl differs from hashnoise ", page)
        end = self.open(page)
        self.assertEqual((end["verdict"], end["sent"]["address"]), ("NOT AS EXPECTED", ""))
        for meaning in ("Worlds made of them differ from those on other devices.", "With HN_FIXED these have other bits here",
                        "With floats these are off by more than their bounds allow"):
            self.assertIn(meaning, end["meaning"])
        run, = json.loads(end["results"])["runs"]
        self.assertEqual((run["library"]["folder"], run["library"]["changed"]), (str(copy), ["perlin2d.glsl"]))
        wrong = [case for case in run["cases"] if case["status"] == "fail" and case["id"].startswith("hash.")]
        self.assertGreater(len(wrong), 0)
        for case in wrong:
            self.assertEqual((case["mismatches"], len(case["examples"])), (1, 1))
        merged = self.merged(end)
        self.assertEqual(merged.returncode, 1, merged.stderr + merged.stdout)
        self.assertIn(f"The tested library is the library in {copy} (", merged.stdout)
        groups = re.findall(r"^FAIL +(\d+ of \d+ cases of [\w.]+\w)", merged.stdout, re.MULTILINE)
        self.assertGreater(len(groups), 1)
        measures = [line.strip() for line in merged.stdout.splitlines() if " values are wrong" in line]
        for words in (*groups, f"{measures[0]}."):
            self.assertIn(words, end["found"])

    def test_it_can_be_stopped_and_says_what_was_not_run(self):
        press = """<script>addEventListener("DOMContentLoaded", () => {
          const verdict = document.getElementById("verdict");
          const left = () => verdict.textContent.includes(" left ") && document.getElementById("stop").click();
          new MutationObserver(left).observe(verdict, {childList: true});
        });</script>"""
        page = self.page("--thorough", "--filter", "bugs.*")
        end = self.open(page.replace("<body>", f"<body>{press}"))
        self.assertRegex(end["verdict"], r"^All as expected, stopped after \d+ of \d+$")
        run, = json.loads(end["results"])["runs"]
        ran, total = map(int, re.findall(r"\d+", end["verdict"]))
        self.assertEqual((len(run["cases"]), run["not_run"], run["as_expected"]), (ran, total - ran, False))
        merged = self.merged(end)
        self.assertNotEqual(merged.returncode, 0)
        self.assertIn(f"{total - ran} not run", merged.stdout)

    def test_without_webgpu_its_cases_are_unsupported_and_the_others_run(self):
        end = self.open(self.page("--thorough", "--filter", "noise2d.perlin.lattice.fixed.*"), "--disable-features=WebGPU")
        self.assertEqual(end["verdict"], "All as expected")
        run, = json.loads(end["results"])["runs"]
        statuses = {case["id"].split(".")[5]: case["status"] for case in run["cases"]}
        self.assertEqual((statuses["wgsl"], statuses["es300"]), ("unsupported", "pass"))

    def test_a_page_of_some_cases_names_no_golden_files(self):
        self.assertNotIn("golden", browse.suite_of(self.page(*SMALL)))

    def test_a_page_that_is_damaged_says_so(self):
        page = self.page(*SMALL)
        for damaged in (browse.SUITE.sub(lambda packed: packed[0][:len(packed[0]) // 8 * 4], page), browse.SUITE.sub("?", page)):
            (self.folder / "damaged.html").write_text(damaged)
            command = self.chromium("--dump-dom", "--virtual-time-budget=10000")
            done = subprocess.run([*command, f"file://{self.folder / 'damaged.html'}"], capture_output=True, text=True,
                                  check=True, timeout=SECONDS)
            self.assertIn("The page could not begin", done.stdout)

    def test_without_webgl_it_says_so(self):
        end = self.open(self.page(*SMALL), "--disable-3d-apis")
        self.assertEqual(end["type"], "stopped")
        self.assertEqual(end["verdict"], "No WebGL2 here")

    def test_browse_keeps_the_results_and_has_a_status(self):
        page, results = self.folder / "page" / "index.html", self.folder / "results.json"

        def browsed(*options):
            return subprocess.run([sys.executable, "-B", browse.__file__, page, results, *self.chromium(*options)],
                                  capture_output=True, text=True, check=False, timeout=SECONDS)

        self.page(*SMALL)
        done = browsed()
        self.assertEqual((done.returncode, done.stdout.split("\n")[0]), (0, "All as expected"), done.stderr)
        self.assertEqual(json.loads(results.read_text())["runs"][0]["totals"]["fail"], 0)
        self.page(*SMALL, "--golden", self.edited_golden())
        done = browsed()
        self.assertEqual((done.returncode, done.stdout.split("\n")[0]), (1, "NOT AS EXPECTED"), done.stderr)
        self.assertIn("hash.lattice2", done.stdout)
        done = browsed("--disable-3d-apis")
        self.assertEqual((done.returncode, done.stdout.split("\n")[0]), (2, "No WebGL2 here"), done.stderr)


if __name__ == "__main__":
    unittest.main()
