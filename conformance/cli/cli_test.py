#!/usr/bin/env python3
"""hn-conform as its user meets it: exit statuses and messages."""

import fnmatch
import re
import shutil
import unicodedata
import unittest
import xml.etree.ElementTree

from program import CHEAP, ROOT, ProgramTest

BYTES = b"\xff\x1b[2J\x00\x9b1m\xc2\x9b\x07\r\x7f" * 300
ONE_CASE = "noise2d.perlin.lattice.fast.fragment.gl330.golden"


class Cli(ProgramTest):
    def run_case(self, *arguments, case=ONE_CASE, environment=None):
        return self.call("run", "--out", self.out, "--filter", case, *arguments, environment=environment)

    def cases(self):
        return {case["id"]: case for run in self.results()["runs"] for case in run["cases"]}

    def page(self):
        return (self.out / "index.html").read_text()

    def suites(self):
        """The suites of junit.xml, by name."""
        root = xml.etree.ElementTree.parse(self.out / "junit.xml").getroot()
        return {suite.get("name"): suite for suite in root.findall("testsuite")}

    def changed_glsl(self, *changes):
        """A copy of glsl/hashnoise/ with changes made: (file, old, new), each once."""
        copy = self.folder / "glsl"
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(ROOT / "glsl" / "hashnoise", copy)
        for name, old, new in changes:
            text = (copy / name).read_text()
            self.assertIn(old, text)
            (copy / name).write_text(text.replace(old, new, 1))
        return copy

    def assert_printable(self, text):
        """Nothing in it moves the cursor of a terminal, or changes its colours."""
        self.assertEqual([c for c in text if unicodedata.category(c) == "Cc" and c not in "\n\t"], [])

    def golden_copy(self):
        copy = self.folder / "golden"
        shutil.copytree(ROOT / "conformance" / "expected" / "golden", copy)
        return copy

    def test_a_healthy_case_passes_and_leaves_a_page_and_a_file_for_build_servers(self):
        done = self.run_case("--seed", "5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 pass; ", done.stdout)
        case, = self.results()["runs"][0]["cases"]
        self.assertEqual(case["id"], ONE_CASE)
        self.assertEqual(case["status"], "pass")
        self.assertGreater(case["samples"], 100)
        page = self.page()
        self.assertIn("All as expected: 1 case on 1 driver", page)
        self.assertIn(f"hn-conform run --out {self.out} --filter {ONE_CASE} --seed 5", page)
        self.assertIn("llvmpipe", page)
        for elsewhere in ("<link", "src=\"http", "href=\"http", "url("):
            self.assertNotIn(elsewhere, page)
        suite = self.suites()["osmesa"]
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("1", "0", "0"))
        properties = {entry.get("name"): entry.get("value") for entry in suite.find("properties")}
        self.assertEqual(properties["seed"], "5")
        self.assertIn("llvmpipe", properties["renderer"])
        test = suite.find("testcase")
        self.assertEqual((test.get("classname"), test.get("name")), ("noise2d.perlin", ONE_CASE))

    def test_what_failed_has_its_evidence(self):
        glsl = self.changed_glsl(("detail/word.glsl", "0x2C1B3C6Du", "0x2C1B3C6Fu"))
        self.run_case("--glsl", glsl, "--filter", "hash.lattice2.lattice.*.fragment.gl330.golden")
        case = self.cases()[ONE_CASE]
        evidence = case["evidence"]
        self.assertIn("The shader is red on this driver", evidence["note"])
        self.assertGreater(evidence["factor"], 0)
        first = case["examples"][0]
        page = self.page()
        for text in (ONE_CASE, first["inputs"], first["got"], first["expected"], evidence["got"], evidence["reference"],
                     evidence["difference"], "0x2C1B3C6Fu", f"{first['point']}, 0"):
            self.assertIn(text, page)
        self.assertIn("evidence", self.cases()["hash.lattice2.lattice.exact.fragment.gl330.golden"])
        suite = self.suites()["osmesa"]
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("2", "2"))
        self.assertIn(first["inputs"], suite.find(f"testcase[@name='{ONE_CASE}']/failure").text)

    def test_list_filters(self):
        done = self.call("list", "--thorough", "--filter", "noise2d.perlin.lattice.fast.fragment.*.golden")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(sorted(done.stdout.splitlines()), [
            f"noise2d.perlin.lattice.fast.fragment.{language}.golden" for language in ("es300", "gl140", "gl330")])

    def test_bad_usage_is_status_2_and_says_what_would_be_right(self):
        (self.folder / "file").write_text("")
        (self.folder / "bytes").write_bytes(BYTES)
        taken = self.folder / "taken"
        (taken / "results.json").mkdir(parents=True)
        damaged = self.folder / "damaged"
        damaged.mkdir()
        (damaged / "journal.jsonl").write_bytes(BYTES + b"\n")
        other = self.folder / "other"
        other.mkdir()
        (other / "other.golden").write_text("")
        for arguments, expected in (
            (["run", "--driver", "voodoo"], "osmesa, egl"),
            (["run", "--filter", "nothing*"], "hn-conform list shows the ids"),
            (["run", "--out", self.folder / "file" / "out"], "cannot make the folder"),
            (["run", "--out", self.folder / "file"], "file: Not a directory; --out wants a folder"),
            (["run", "--out", taken], "results.json: it is a folder; --out wants a folder"),
            (["run", "--glsl", self.folder], "a copy of every file of glsl/hashnoise/"),
            (["run", "--glsl", self.folder / "absent"], "/begin.hlsl: No such file or directory; --glsl wants"),
            (["run", "--glsl", self.folder / "file"], "file/begin.hlsl: Not a directory; --glsl wants"),
            (["run", "--golden", self.folder / "absent"], "absent: No such file or directory; --golden wants"),
            (["run", "--golden", self.folder / "file"], "file: Not a directory; --golden wants the folder"),
            (["run", "--golden", self.folder], f"there is no golden file in {self.folder}; --golden wants the folder"),
            (["web", "--golden", self.folder, "--out", self.out], f"there is no golden file in {self.folder};"),
            (["run", "--expect", self.folder / "absent"], "absent: No such file or directory; --expect wants"),
            (["run", "--resume", "--out", damaged], "journal.jsonl: its first line is not a plan"),
            (["merge", self.folder / "absent"], "absent: No such file or directory; merge wants files results.json"),
            (["merge", self.folder], "results.json: No such file or directory; merge wants files results.json"),
            (["merge", taken], "results.json: Is a directory; merge wants files results.json"),
            (["merge", self.folder / "bytes"], "bytes: the file is not a results.json: "),
            (["run", "--inject", "abs_imt"], "there are: modulo_sign"),
            (["web", "--filter", "nothing*"], "--filter"),
            (["web", "--golden", other, "--out", self.out], ".golden: No such file or directory; it is a golden file"),
            (["run", "--driver", "osmesa", "drivers"], "drivers"),
            ([], "drivers, list, run, check, merge, bench, spirv, paper or web"),
        ):
            with self.subTest(arguments=arguments):
                done = self.call(*arguments)
                self.assert_refused(done, expected)
                self.assert_printable(done.stderr + done.stdout)

    def test_an_injected_fault_turns_the_run_red_and_names_what_suffers(self):
        self.assertEqual(self.run_case(case=CHEAP).returncode, 0)
        done = self.run_case("--inject", "abs_int", case=CHEAP)
        self.assertEqual(done.returncode, 1)
        self.assertIn(CHEAP, done.stdout)
        self.assertIn("emulate_abs_int_function", done.stdout)
        self.assertEqual(self.run_case("--inject", "abs_int").returncode, 0)  # the noise takes abs of floats alone
        done = self.run_case("--inject", "integers_16_bits")
        self.assertEqual(done.returncode, 1)
        self.assertIn(ONE_CASE, done.stdout)
        self.assertLess(self.cases()[ONE_CASE]["evidence"]["shader"].count("\n"), 80)

    def test_inject_list_tells_the_faults(self):
        done = self.call("run", "--inject", "list")
        self.assertEqual(done.returncode, 0)
        self.assertIn("abs_int\n  fault: abs(int) wrong\n", done.stdout)

    def test_list_about_tells_where_a_bug_was_reported(self):
        done = self.call("list", "--about", "--filter", "bugs.abs_of_int.*gl330*")
        self.assertEqual(done.returncode, 0)
        self.assertIn("gl330.defined\n  reported in: ANGLE emulate_abs_int_function", done.stdout)

    def test_what_the_specification_leaves_open_is_a_warning(self):
        bug = "bugs.modulo_of_negative.any.exact.fragment.gl330.undefined"
        done = self.run_case("--filter", CHEAP, case=bug)
        self.assertEqual(done.returncode, 0, done.stdout)
        case = next(case for case in self.results()["runs"][0]["cases"] if case["id"] == bug)
        self.assertEqual(case["status"], "warning")
        self.assertIn("got 3 (00000003), expected -1", case["message"])  # llvmpipe's -1 % 7
        self.assertIn("gfx-rs/wgpu 9687", case["message"])

    def without_osmesa(self):
        for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
            (self.folder / name).write_text("no library")
        return {"LD_LIBRARY_PATH": str(self.folder)}

    def test_a_driver_that_is_not_here_is_status_3(self):
        self.assertEqual(self.run_case(case=CHEAP).returncode, 0)
        broken = self.without_osmesa()
        done = self.run_case(case=CHEAP, environment=broken)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("the driver osmesa is not here", done.stderr)
        run, = self.results()["runs"]  # those of the run before are gone
        self.assertIn("libOSMesa", run["absent"])
        self.assertNotIn("cases", run)
        self.assertIn("the driver osmesa is not here", self.page())
        self.assertIn("libOSMesa", self.suites()["osmesa"].find("testcase/skipped").text)

    def test_drivers_names_what_is_here_and_what_is_not(self):
        # Without programs, such as Chromium, whose start costs more than all else here.
        naga = self.folder / "naga"
        naga.write_text("#!/bin/sh\necho naga 1.2.3\n")
        naga.chmod(0o755)
        done = self.call("drivers", environment={**self.without_osmesa(), "PATH": str(self.folder)})
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line for line in done.stdout.splitlines() if line]
        below = {line.split()[0]: lines[i + 1] for i, line in enumerate(lines[:-1]) if not line.startswith(" ")}
        self.assertIn("naga 1.2.3", below["naga"])
        self.assertIn("not here:", below["spirv-opt"])
        self.assertIn("not here:", below["osmesa"])
        self.assertIn("llvmpipe", below["egl"])
        self.assertIn("not here:", below["webgl2"])

    def test_a_changed_constant_turns_the_run_red(self):
        glsl = self.changed_glsl(("detail/word.glsl", "0x85EBCA77u", "0x85EBCA79u"))
        perlin = "noise2d.perlin.lattice.fast.fragment.gl330"
        done = self.run_case("--glsl", glsl, "--filter", f"{perlin}.twin", case=f"{perlin}.golden")
        self.assertEqual(done.returncode, 1)
        self.assertIn("NOT AS EXPECTED", done.stdout)
        self.assertEqual(set(self.cases()), {f"{perlin}.golden", f"{perlin}.twin"})
        for name, case in self.cases().items():
            self.assertGreater(case["mismatches"], 100, name)
            self.assertLess(case["evidence"]["shader"].count("\n"), 60, name)  # as tools/pick writes it

    def test_every_other_check_can_fail(self):
        perlin = "noise2d.perlin.lattice.fast.fragment.gl330"
        # Changes that do not disturb each other are made at once: (cases, file, old, new). The cases of each change
        # fail, and no
        # others.
        for group in (
            (
                (f"{perlin}.range", "detail/direction.glsl", "n, 1831)", "n, 3173)"),
                (f"{perlin}.seeds", "perlin2d.glsl", "hn_perlin(hn_place(p), seed)", "hn_perlin(hn_place(p), 0u)"),
                ("fbm.fbm2.*.fast.*.other_noise", "detail/octave.glsl", "(s.value, n, weight)",
                 "(s.value, n, HN_I_WEIGHT_ONE)"),
                ("fbm.ridged2_cell_period.*.fixed.*.other_noise",),
                ("config.hash_beyond_the_last.*.gl330.refused_*", "config.glsl", "HN_HASH > 9", "HN_HASH > 99"),
                ("config.arithmetic_4.*.gl330.*", "config.glsl", "HN_ARITHMETIC > 3", "HN_ARITHMETIC > 99"),
                ("config.precise_too_early.*.gl330.*", "config.glsl", "HN_I_VERSION >= 400", "HN_I_VERSION >= 300"),
                ("config.version_120.*.refused_by_driver", "config.glsl", "needs GLSL 1.30", "needs more"),  # no reason
            ),
            (
                (f"{perlin}.range", "detail/direction.glsl", "n, 1831)", "n, 490)"),  # little of it is used
                (f"{perlin}.mirror", "perlin2d.glsl", "hn_perlin(hn_place(p), seed)",
                 "hn_perlin(hn_place(abs(p)), seed)"),
            ),
            (
                (f"{perlin}.zero", "perlin2d.glsl", "place.fraction", "place.fraction + 0.25f"),
                (f"{perlin}.finite",),
            ),
            (("hash.all.pcg.fast.fragment.vulkan.spirv", "detail/hashes.glsl", "2891336453u", "2891336453.5"),),
        ):
            with self.subTest(group=[cases for cases, *_ in group]):
                filters = [argument for cases, *_ in group for argument in ("--filter", cases)]
                glsl = self.changed_glsl(*(change for _, *change in group if change))
                done = self.call("run", "--out", self.out, "--thorough", "--glsl", glsl, *filters)
                self.assertEqual(done.returncode, 1, done.stdout)
                found = self.cases()
                for cases, *_ in group:
                    self.assertTrue(fnmatch.filter(found, cases), cases)
                self.assertEqual([name for name, case in found.items() if case["status"] == "pass"], [])
                for name, case in found.items():  # none because it does not compile, which the others would not show
                    self.assertEqual(case["mismatches"] > 0, not name.startswith(("config.", "hash.all.")), name)

    def test_unsupported_is_neither_passed_nor_failed(self):
        done = self.run_case(case="hash.all.lattice.fast.fragment.gl460.driver")
        self.assertEqual(done.returncode, 1)  # a run in which nothing passed shows nothing
        self.assertIn("no case passed: all that ran are excused or unsupported", done.stderr)
        self.assertEqual(self.suites()["hn-conform"].get("errors"), "1")
        totals = self.results()["runs"][0]["totals"]
        self.assertEqual({status: count for status, count in totals.items() if count}, {"unsupported": 1})
        self.assertIn("GLSL 4.60 is beyond this context's 4.50", done.stdout)

    def test_a_changed_default_seed_turns_the_run_red(self):
        glsl = self.changed_glsl(("perlin2d.glsl", "hn_perlin(p, 0u)", "hn_perlin(p, 1u)"))
        done = self.run_case("--glsl", glsl, case="noise2d.perlin.*unseeded")
        self.assertEqual(done.returncode, 1)

    def test_a_shader_that_does_not_compile_shows_file_and_line_and_the_run_goes_on(self):
        line = 1 + (ROOT / "glsl" / "hashnoise" / "noise2d.glsl").read_text().splitlines().index("#include \"perlin2d.glsl\"")
        glsl = self.changed_glsl(("noise2d.glsl", "#include \"perlin2d.glsl\"\n",
                                  "#include \"perlin2d.glsl\" \nint x = broken;\n"))
        profiles = ("gl140", "gl330", "es300")
        broken = [argument for profile in profiles
                  for argument in ("--filter", f"noise2d.all.lattice.fast.fragment.{profile}.*")]
        done = self.run_case("--glsl", glsl, "--thorough", *broken, case=CHEAP)
        self.assertEqual(done.returncode, 1)
        cases = self.cases()
        for profile in profiles:
            for check in ("glslang", "driver"):
                message = cases[f"noise2d.all.lattice.fast.fragment.{profile}.{check}"]["message"]
                self.assertIn(f"{glsl}/noise2d.glsl:{line + 1}", message)
        self.assertEqual(cases[CHEAP]["status"], "pass")

    def test_whatever_a_golden_file_is_its_case_is_an_error_that_can_be_printed(self):
        golden = self.golden_copy()
        damages = {  # one for each file, so that one run shows them all: (content, its message)
            "perlin": lambda path, text: (BYTES, f"{path}:1: \"\\xff\\x1b[2J"),
            "perlin_cell": lambda path, text: (bytes(100000), f"{path}:1: \"\\x00"),
            "value": lambda path, text:
                (text.replace("value", "perlin", 1).encode(),
                 f"{path}:2: \"function noise2d.perlin\" should be \"function noise2d.value\""),
            "value_cell": lambda path, text:
                (changed(text, lambda at: text[:at] + "\x9b1m\x07" + text[at:]), f"{path}:8: \"\\x9b1m\\x07"),
            "value_cell_period": lambda path, text:
                ("folder", f"cannot read {path}: Is a directory; it is a golden file, and tools/make golden writes it"),
        }

        def changed(text, change):
            return change(text.index(" = ", text.index("rows ")) + 3).encode("latin-1")  # at the first value

        expected = {}
        for name, damage in damages.items():
            path = golden / f"noise2d.{name}.golden"
            content, expected[f"noise2d.{name}.lattice.fast.fragment.gl330.golden"] = damage(path, path.read_text())
            path.unlink()
            path.mkdir() if content == "folder" else path.write_bytes(content)
        good = "noise3d.perlin.lattice.fast.fragment.gl330.golden"
        filters = [argument for case in expected for argument in ("--filter", case)]
        done = self.run_case("--golden", golden, *filters, case=good)
        self.assertEqual(done.returncode, 1)
        cases = self.cases()
        self.assertEqual({id: case["status"] for id, case in cases.items()},
                         {**dict.fromkeys(expected, "error"), good: "pass"})
        self.assert_printable(done.stdout + done.stderr)
        for id, said in expected.items():
            with self.subTest(id):
                message = cases[id]["message"]
                self.assertIn(said, message)
                self.assertIn("tools/make golden", message)
                self.assert_printable(message)
                self.assertLess(len(message), 500)
        self.assertIn(expected[ONE_CASE], done.stdout)

    def test_a_shader_of_any_bytes_leaves_the_terminal_alone(self):
        glsl = self.changed_glsl()
        (glsl / "perlin2d.glsl").write_bytes(BYTES)
        done = self.run_case("--glsl", glsl, case="noise2d.all.lattice.fast.fragment.gl330.*")  # by both compilers
        self.assertEqual(done.returncode, 1)
        self.assertEqual({case["status"] for case in self.cases().values()}, {"fail"})
        self.assert_printable(done.stdout + done.stderr)

    def test_a_wrong_golden_value_fails(self):
        golden = self.golden_copy()
        path = golden / "hash.word.golden"
        text = path.read_text()
        digest = text.index("fnv1a64=") + 8
        value = text.index(" = ", text.index("rows ")) + 3  # of fnv1, which is the first setting
        for at in (value, digest):
            with self.subTest(at=at):
                wrong = "0" if text[at] != "0" else "1"
                path.write_text(text[:at] + wrong + text[at + 1:])
                done = self.run_case("--golden", golden, "--thorough", case="hash.word.fnv1.*.fragment.*golden")
                self.assertEqual(done.returncode, 1)
                self.assertEqual(self.results()["runs"][0]["totals"]["fail"], 3)

    def test_fail_fast_stops(self):
        glsl = self.changed_glsl(("detail/direction.glsl", "n, 1831)", "n, 1832)"))
        self.run_case("--glsl", glsl, "--fail-fast", case="noise2d.perlin.*.golden")
        self.assertEqual(len(self.results()["runs"][0]["cases"]), 1)

    def test_the_page_of_checks_is_what_it_prints(self):
        page = (ROOT / "docs" / "reference" / "checks.md").read_text()
        self.assertEqual(self.call("list", "--checks").stdout, page, "run hn-conform list --checks > docs/reference/checks.md")

    def test_every_option_is_in_the_documents(self):
        for command, page in (("run", "guide/conformance.md"), ("check", "guide/conformance.md"),
                              ("bench", "measured/measuring.md")):
            if page.startswith("measured/") and not (ROOT / "tools" / "measure").exists():
                continue  # measuring was deleted, with its pages
            options = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", self.call(command, "--help").stdout, re.MULTILINE))
            text = (ROOT / "docs" / page).read_text()
            self.assertEqual({option for option in options - {"--help"} if f"`{option}" not in text}, set(),
                             f"docs/{page} does not document these options of {command}")

    def test_what_the_default_run_leaves_out_runs_where_it_is_named(self):
        case = "hash.word.pcg.exact.fragment.gl330.twin"
        listed = self.call("list").stdout.split()
        self.assertNotIn(case, listed)
        self.assertEqual(self.call("list", "--filter", case).stdout.split(), [case])
        self.assertEqual(self.run_case(case=case).returncode, 0)
        self.assertEqual(self.run_case(case="hash.nothing.*").returncode, 2)

    def test_a_case_is_dealt_to_one_driver_and_what_each_must_show_to_each_renderer(self):
        filters = "--filter", "bugs.abs_of_int.*gl330*", "--filter", "hash.word.murmur.*.gl*.golden"
        self.call("run", "--out", self.out, "--deal", "--driver", "osmesa", "--driver", "softpipe", *filters)
        runs = {run["driver"]: [case["id"] for case in run["cases"]] for run in self.results()["runs"]}
        both = set(runs["osmesa"]) & set(runs["softpipe"])
        self.assertEqual(both, {"bugs.abs_of_int.any.exact.fragment.gl330.defined"})
        listed = self.call("list", *filters).stdout.split()
        self.assertEqual(sorted({*runs["osmesa"], *runs["softpipe"]}), sorted(listed))

    def test_a_deal_without_a_driver_and_with_one_that_is_missing(self):
        self.assertEqual(self.call("run", "--out", self.out, "--deal", "--driver", "glslang", "--filter",
                                   "hash.all.lattice.fast.fragment.gl330.glslang").returncode, 0)
        missing = self.call("run", "--out", self.out, "--deal", "--driver", "osmesa", "--driver", "egl-device:77",
                            "--filter", "hash.lattice3.lattice.*.gl330.inlined")
        self.assertEqual(missing.returncode, 3)
        self.assertIn("egl-device:77", missing.stderr)
        both = self.call("run", "--out", self.out, "--deal", "--shard", "1/2", "--filter",
                         "hash.word.lattice.*.gl330.golden")
        self.assertEqual(both.returncode, 2)
        self.assertIn("--shard", both.stderr)

    def test_the_seed_chooses_the_points(self):
        case = "noise3d.perlin.lattice.fast.fragment.gl330.twin"
        seen = []
        for seed in (2, 2):
            self.assertEqual(self.run_case("--seed", seed, case=case).returncode, 0)
            run = self.results()["runs"][0]
            self.assertEqual(run["seed"], seed)
            self.assertEqual(run["cases"][0]["samples"], 1 << 16)
            seen.append(run["cases"][0]["max_ulp"])
        self.assertEqual(seen[0], seen[1])

    def test_points_are_evaluated_in_batches(self):
        case = "noise2d.perlin.lattice.*.fragment.gl330.twin"  # fast and fixed
        points = 2**20 + 5  # a grid has 2^20
        self.assertEqual(self.run_case("--thorough", "--points", points, case=case).returncode, 0)
        self.assertEqual([case["samples"] for case in self.results()["runs"][0]["cases"]], [points, points])


if __name__ == "__main__":
    unittest.main()
