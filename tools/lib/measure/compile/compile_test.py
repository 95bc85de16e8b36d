"""Tests of tools/measure compile: its times, and how it treats compilers' messages and compilers that are missing."""

from __future__ import annotations

import shutil
from unittest import mock

from base.testing import Case, called
from base.thorough import THOROUGH
from measure.compile import command, compilers, texts
from measure.compile.compilers import COMPILERS, DESKTOP, ES, Place
from measure.compile.texts import EMPTY, FIXED, SUBJECTS, WAYS, jobs
from measure.gpu.command import DRIVERS

ALL_WAYS = [way + suffix for suffix in ("", FIXED) for way in WAYS]


class CompileTimes(Case):
    def setUp(self):
        self.place = Place(self.folder, {}, DRIVERS)
        for module in (texts, command):  # fewer shaders are faster
            self.enterContext(mock.patch.object(module, "SUBJECTS", SUBJECTS[:1]))

    def measured(self, *arguments: str) -> tuple[int, str]:
        return called(command.main, "--rounds", "1", "--out", self.folder / "compile.csv", *arguments)

    def program(self, text: str) -> str:
        return str(self.script("program", text))

    def test_what_is_timed_compiles(self):
        for number, job in enumerate(jobs("glsl", {})):
            if job.way.startswith("whole"):  # another test compiles these
                continue
            versions = ((DESKTOP, compilers.glslang()), (ES, ["glslangValidator"]))
            for version, options in versions if THOROUGH else versions[number % 2:][:1]:
                file = self.folder / f"{number}.frag"
                file.write_text(job.shader("glsl", version))
                compilers.run(self.folder, *options, file)

    def test_a_record_of_a_compiler(self):
        peers = self.folder / "peers"
        peers.mkdir()
        (peers / "Perlin2D.glsl").write_text("float Perlin2D(vec2 p) { return p.x; }")
        glslang = shutil.which("glslangValidator") if THOROUGH else self.program("true")
        with mock.patch.object(shutil, "which", return_value=glslang):
            status, said = self.measured("--compiler", "glslang", "--wombat", str(peers))
        self.assertEqual((status, said), (0, f"glslang: 1 rounds\n{self.folder}/compile.csv\n"))
        with mock.patch.object(command, "RECORD", self.folder / "compile.csv"):
            rows = command.record()
        self.assertEqual([row["way"] for row in rows], [*ALL_WAYS, "W"])
        sizes = {row["way"]: int(row["bytes"]) for row in rows}
        self.assertGreater(sizes["whole"], 3 * sizes["file"])
        self.assertGreater(sizes["file"], 10 * sizes["pick"])

    def test_each_language_has_each_shader(self):
        library = self.folder / "GLSL" / "FastNoiseLite.glsl"
        for file in (library, self.folder / "HLSL" / "FastNoiseLite.hlsl"):
            file.parent.mkdir()
            file.write_text("// a library\n")
        for language, theirs in (("glsl", "F"), ("hlsl", "F"), ("wgsl", None)):
            with mock.patch.object(texts, "library"):
                found = [job.way for job in jobs(language, {"fastnoiselite": library})]
            self.assertEqual(found, [EMPTY, *ALL_WAYS, *filter(None, [theirs])])

    def test_the_table(self):
        rows = [{"noise": "Perlin 2D", "way": way, "compiler": compiler, "ms": f"{number}.4"}
                for compiler in [*COMPILERS][:-1]
                for number, way in enumerate([*ALL_WAYS, "F"], 0 if compiler == "glslang" else 7996)]
        found = command.page_table([*rows, *({**row, "noise": "fBm 3D, 6 octaves"} for row in rows)])
        self.assertIn("six octaves in 3D takes 7996 ms, as one function 7998 ms, and of FastNoiseLite's file 8.0 s.", found)
        self.assertIn("| glslang, to SPIR-V | < 1 / 1 / 2; 3 / 4 / 5; F 6 |", found)
        self.assertIn("| RADV, AMD Navi 31 | 7,996 / 7,997 / 7,998; 7,999 / 8,000 / 8,001; F 8,002 |", found)
        with self.assertRaises(LookupError):
            command.page_table(rows[1:])
        self.assertIn(f"| {COMPILERS[[*COMPILERS][-1]].title} | missing |", found)

    def test_a_refused_shader_is_named(self):
        refusing = self.program("case $5 in 2.frag) echo 'ERROR: 0:7: no such thing'; exit 2;; esac")
        with mock.patch.object(shutil, "which", return_value=refusing):
            status, said = self.measured("--compiler", "glslang")
        self.assertEqual(status, 1)
        self.assertRegex(said, r"Perlin 2D, file, is refused: program ended with status 2: ERROR: 0:7: no such thing\n")

    def test_a_page_that_fails_is_named(self):
        for text, why in (("echo '<pre id=\"times\">failed: there is no WebGL2</pre>'", "failed: there is no WebGL2"),
                          ("true", "left no report")):
            with mock.patch.object(shutil, "which", return_value=self.program(text)), \
                    self.assertRaisesRegex(compilers.Failed, why):
                command.measured(COMPILERS["angle"], self.place, 1)

    def test_a_missing_compiler_is_named(self):
        with mock.patch.object(shutil, "which", return_value=None):
            status, said = self.measured("--compiler", "naga", "--compiler", "angle")
        self.assertEqual(status, 3)
        self.assertIn("angle is missing: there is no chromium", said)
        status, said = self.measured("--compiler", "radv", "--drivers", str(self.folder))
        self.assertEqual(status, 3)
        self.assertIn("radv is missing: there are no drivers in", said)

    def test_bad_usage(self):
        for arguments, message in ((["--compiler", "fxd"], "invalid choice: 'fxd'"), (["--rounds", "0"], "not a whole number from 1 on"),
                                   (["--wombat", "nowhere"], "--wombat: there is no nowhere")):
            status, said = called(command.main, *arguments)
            self.assertEqual(status, 2)
            self.assertIn(message, said)
