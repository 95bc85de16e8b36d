"""Translators that people have take each text of tools/pick, and the whole library: the oldest and the newest of each.

    python3 -m translate.pick.translators_test [TOOL]...     such as glslang or "glslang 12.0"; by default all

A row of TRANSLATORS is a tool in a version, with how it is had and the languages it takes. By default the tools of
Debian 12 take some functions; in a thorough run all tools take all functions in all arithmetics, in half an hour of
processor time. Each tool must refuse a text with a fault, too.

Exit status: 0 they do, 1 they do not, 77 what could be tried is right, but a tool cannot be had here.
"""

from __future__ import annotations

import functools
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from base.debian import SKIPPED, Missing, program
from base.javascript.environment import NODE
from base.thorough import THOROUGH
from base.tree import GLSL, ROOT
from translate.hlsl.compilers import compiled, refusal
from translate.pick import command
from translate.pick.program import Program, chosen, read
from translate.pick.shading import LANGUAGES
from translate.pick.shading_runners import Case, GlslRunner, HlslRunner, WgslRunner
from translate.tools import BY_NAME, DXC, FXC, SLANG, Tool, own
from translate.wgsl import wgpu_program
from translate.wgsl.device import WGPU
from translate.whole import library

# Before a text, the runner that calls it, and how a file with it is called.
FORMS = {"glsl": ("#version 310 es\n", GlslRunner, "comp"), "glsl-desktop": ("#version 450\n", GlslRunner, "comp"),
         "hlsl": ("", HlslRunner, "hlsl"), "slang": ("", HlslRunner, "slang"), "wgsl": ("", WgslRunner, "wgsl")}
PRECISE = ("glsl-desktop", "hlsl")
# Texts that these refuse; older and newer ones take them.
KNOWN = dict.fromkeys(("naga 22.0.0", "wgpu 0.22.2"), "fn f() -> i32 { return i32(1048576.0); }")

Refused = dict[Path, str]  # messages, by the file
Take = Callable[[Sequence[Path]], Refused]


class Translator(NamedTuple):
    tool: str
    version: str
    languages: Sequence[str]
    get: Callable[[], Take]  # raises Missing
    by_default: bool = False  # what setup installs


def each(commands: Callable[[Path], Sequence[Sequence[str | Path]]]) -> Take:
    """By commands that succeed, one after the other, in silence but for standard output."""
    def refused(file: Path) -> str:
        for words in commands(file):
            done = subprocess.run([str(word) for word in words], cwd=file.parent, capture_output=True, text=True,
                                  errors="replace", check=False)
            if done.returncode != 0 or "WARNING" in done.stdout:
                return f"{done.stdout}{done.stderr}" or f"{words[0]} ended with {done.returncode}"
        return ""

    return lambda files: {file: said for file in files if (said := refused(file))}


def asked(*command: str | Path, **variables: Tool) -> Take:
    """By a program of the suite's drivers, which has an answer for each line."""
    environment = {**os.environ, **{name: str(tool.path()) for name, tool in variables.items()}}

    def take(files: Sequence[Path]) -> Refused:
        lines = (json.dumps({"shader": str(file), "form": "wgsl" if file.suffix == ".wgsl" else "glsl"}) for file in files)
        done = subprocess.run([*command, "1"], input="\n".join(lines), env=environment, capture_output=True, text=True,
                              cwd=ROOT / "conformance" / "web", check=False)
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        if len(answers) != len(files) + 1:
            raise RuntimeError(f"{done.stdout}{done.stderr}"[-2000:])
        return {file: answer["error"] for file, answer in zip(files, answers[1:]) if "error" in answer}
    return take


def to_spirv(validator: Path, file: Path) -> list[str | Path]:
    return [validator, *(("-D",) if file.suffix == ".hlsl" else ()), "-V", "-S", "comp", "-e", "main", "-o",
            file.with_suffix(".spv"), file]


def glslang(find: Callable[[str], Path]) -> Take:
    validator = find("glslangValidator")
    return each(lambda file: [to_spirv(validator, file)])


@functools.cache
def spirv(text: str) -> bytes:
    """By Debian's glslang, which starts for longer than the others work on a text; nothing if it is refused."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "text.comp"
        file.write_text(text, encoding="ascii")
        done = subprocess.run(to_spirv(own("glslangValidator"), file), capture_output=True, check=False)
        return b"" if done.returncode else file.with_suffix(".spv").read_bytes()


def through_spirv(find: Callable[[str], Path]) -> Take:
    """SPIR-V of Debian's glslang is optimized, and becomes GLSL ES, HLSL and Metal."""
    validator, optimizer, cross = own("spirv-val"), find("spirv-opt"), find("spirv-cross")

    def commands(file: Path) -> list[list[str | Path]]:
        made, less = file.with_suffix(".spv"), file.with_suffix(".less")
        made.write_bytes(spirv(file.read_text(encoding="ascii")))
        return [[optimizer, "-O", made, "-o", less], [validator, less],
                *([cross, less, *options, "--output", file.with_suffix(".out")] for options in (
                    ("--es", "--version", "310"), ("--hlsl", "--shader-model", "50"), ("--msl",)))]
    return each(commands)


def naga(version: str, *options: str) -> Take:
    """naga of crates.io, to MSL, HLSL and SPIR-V."""
    program = BY_NAME[f"naga-{version}"].path()
    kinds = ("spv", "metal", "hlsl")
    return each(lambda file: [[program, *(options if file.suffix == ".comp" else ()), file,
                               *(file.with_suffix(f".{kind}") for kind in kinds)]])


def wgpu(version: str) -> Take:
    """naga, as wgpu has it, with a driver of Vulkan."""
    return asked(sys.executable, wgpu_program.__file__, HN_WGPU=BY_NAME[f"wgpu-{version}"])


def tint(version: str) -> Take:
    """As Dawn has it."""
    return asked(NODE, "node", "dawn.mjs", HN_DAWN=BY_NAME[f"dawn-{version}"], VK_DRIVER_FILES=BY_NAME["swiftshader-"])


def by_slang(tool: Tool, *targets: str) -> Take:
    program = tool.path()
    return each(lambda file: [[program, file, "-target", target, "-entry", "main", "-stage", "compute", "-o",
                               file.with_suffix(".out")] for target in targets])


def unbound(file: Path) -> Path:
    """The file without attributes of Vulkan, at which the compilers warn in other code."""
    text = file.read_text(encoding="ascii")
    file.write_text(re.sub(r"\[\[vk::binding\(\d\)\]\] ", "", text), encoding="ascii")
    return file


def by_dxc() -> Take:
    """To SPIR-V, which is valid, and to what Direct3D 12 takes."""
    def take(files: Sequence[Path]) -> Refused:
        made = compiled(DXC, files, "cs_6_0", "main", "-spirv", "-fspv-target-env=vulkan1.1")
        wrong = validate([Path(f"{file}.code") for file in files])
        direct = compiled(DXC, [*map(unbound, files)], "cs_6_0")
        return {file: said for file, *ways in zip(files, made, direct)
                if (said := refusal(ways[0]) or wrong.get(Path(f"{file}.code"), "") or refusal(ways[1]))}

    DXC.path()
    validate = each(lambda file: [[own("spirv-val"), "--target-env", "vulkan1.1", file]])
    return take


def by_wine(tool: Tool, profile: str) -> Take:
    """To what Direct3D takes, of texts without attributes of Vulkan. It takes a second to start."""
    def take(files: Sequence[Path]) -> Refused:
        made = compiled(tool, [*map(unbound, files)], profile)
        return {file: said for file, one in zip(files, made) if (said := refusal(one))}
    tool.path()
    return take


OF_GLSLANG = ("glsl", "glsl-desktop")
OF_NAGA = ("wgsl", "glsl-desktop")
STAGE = ("--input-kind", "glsl", "--shader-stage", "compute")
TRANSLATORS = (
    Translator("glslang", "12.0", OF_GLSLANG, lambda: glslang(own), by_default=True),
    Translator("glslang", "Debian unstable", (*OF_GLSLANG, "hlsl"), lambda: glslang(program)),
    Translator("SPIRV-Tools and SPIRV-Cross", "Debian 12", OF_GLSLANG, lambda: through_spirv(own), by_default=True),
    Translator("SPIRV-Tools and SPIRV-Cross", "Debian unstable", OF_GLSLANG, lambda: through_spirv(program)),
    Translator("naga", "0.14.0", OF_NAGA, lambda: naga("0.14.0")),
    Translator("naga", "22.0.0", OF_NAGA, lambda: naga("22.0.0", *STAGE)),
    Translator("naga", "30.0.1", OF_NAGA, lambda: naga("30.0.1", *STAGE)),
    Translator("wgpu", "0.13.2", OF_NAGA, lambda: wgpu("0.13.2")),
    Translator("wgpu", "0.22.2", OF_NAGA, lambda: wgpu("0.22.2")),
    Translator(*WGPU.split("=="), OF_NAGA, lambda: wgpu(WGPU.partition("==")[2])),
    Translator("Tint", "webgpu 0.4.0", ("wgsl",), lambda: tint("0.4.0")),
    Translator("Tint", "webgpu 0.6.2", ("wgsl",), lambda: tint("0.6.2")),
    Translator("Slang", "2024.1.6", ("slang",), lambda: by_slang(BY_NAME["slang-2024.1.6"], "hlsl")),
    Translator("Slang", SLANG.version, ("slang",), lambda: by_slang(SLANG, "hlsl", "metal", "wgsl")),
    Translator("DXC", DXC.version, ("hlsl",), by_dxc),
    Translator("DXC", "1.10", ("hlsl",), lambda: by_wine(BY_NAME["dxc-1.10"], "cs_6_0")),  # it has no SPIR-V
    Translator("FXC", FXC.version, ("hlsl",), lambda: by_wine(FXC, "cs_5_0")),
)
SMALL = ("hn_cellular2", "hn_place_at_cell2")


def texts(languages: Sequence[str], arithmetic: str, first: int, step: int) -> dict[tuple[str, str], str]:
    """Functions in shaders that call them, by their names and languages: by default some of them."""
    split = read(GLSL, command.settings(arithmetic, "lattice"), splits=True)
    names = list(split.forms)[first::step] if THOROUGH else SMALL
    found = {}
    for name in names:
        programs: dict[tuple[str, ...], Program] = {}  # by the macros
        for language in languages:
            head, runner, _ = FORMS[language]
            if arithmetic != "precise" or language in PRECISE:
                macros = LANGUAGES[language].library
                of = read(GLSL, {**command.settings(arithmetic, "lattice"), **macros})
                if (*macros,) not in programs:
                    programs[(*macros,)] = Program(of, chosen(of, [name]))
                text = programs[(*macros,)].text(LANGUAGES[language], arithmetic == "precise")
                behind = object.__new__(runner).entry_of(Case(split, split.forms[name], text, b"", 0), 1)
                found[f"{name}_{arithmetic}", language] = head + text + behind
                if name == "hn_perlin2" and language != "slang":  # it is a module there
                    whole = library(language.removesuffix("-desktop"), arithmetic)
                    found[f"whole_{arithmetic}", language] = head + whole + behind
    return found


@functools.cache
def all_texts(languages: Sequence[str]) -> dict[tuple[str, str], str]:
    arithmetics = command.ARITHMETICS if THOROUGH else ("fixed",)
    jobs = [(languages, arithmetic, first, 16) for arithmetic in arithmetics for first in range(16 if THOROUGH else 1)]
    with ProcessPoolExecutor() as pool:
        return {key: text for found in pool.map(texts, *zip(*jobs)) for key, text in found.items()}


class Taken(unittest.TestCase):
    translator: Translator
    take: Take
    languages: Sequence[str]  # of all translators

    def refused(self, language: str, shaders: Mapping[str, str]) -> dict[str, str]:
        """Messages by the names."""
        found = {}
        with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
            files = [Path(folder) / f"{name}.{FORMS[language][2]}" for name in shaders]
            for file, text in zip(files, shaders.values()):
                file.write_text(text, encoding="ascii")
            parts = [files[i:i + 32] for i in range(0, len(files), 32)]
            for refused in pool.map(type(self).take, parts):
                found |= {file.stem: said for file, said in refused.items()}
        return found

    def test_each_text(self) -> None:
        tool = f"{self.translator.tool} {self.translator.version}"
        for language in self.translator.languages:
            shaders = {name: text for (name, of), text in all_texts(self.languages).items() if of == language
                       and (self.translator.tool not in ("naga", "wgpu") or not name.endswith("precise"))}
            self.assertGreater(len(shaders), 600 if THOROUGH else 1)
            found = self.refused(language, shaders)
            print(f"{tool}: {len(shaders) - len(found)} of {len(shaders)} texts of {language}", flush=True)
            with self.subTest(language):
                self.assertEqual(found, {})

    def test_a_fault_is_refused(self) -> None:
        for language in self.translator.languages:
            name, right = next((name, text) for (name, of), text in all_texts(self.languages).items()
                               if of == language and name.startswith("hn_cellular2_"))
            with self.subTest(language):
                wrong = re.sub(r"\bhn_cellular\w*(?=\(v0)", "hn_absent", right)
                self.assertNotEqual(wrong, right)
                self.assertEqual([*self.refused(language, {name: right, "wrong": wrong})], ["wrong"])
            if language == "wgsl" and (known := KNOWN.get(f"{self.translator.tool} {self.translator.version}")):
                self.assertEqual([*self.refused("wgsl", {"known": right + known})], ["known"])


class Page(unittest.TestCase):
    def test_it_names_them(self) -> None:
        page = (ROOT / "docs" / "guide" / "languages.md").read_text(encoding="utf-8")
        rows = {one.tool: "" for one in TRANSLATORS}
        for one in TRANSLATORS:
            rows[one.tool] += f"{', ' if rows[one.tool] else ''}{one.version}"
        wanted = [f"| {tool} | {versions} |" for tool, versions in rows.items()]
        self.assertEqual([row for row in wanted if row not in page], [])


def main(tools: Sequence[str]) -> int:
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Page)
    asked = [one for one in TRANSLATORS if ({one.tool, f"{one.tool} {one.version}"} & {*tools} if tools
                                            else THOROUGH or one.by_default)]
    Taken.languages = tuple(language for language in FORMS if any(language in one.languages for one in asked))
    absent = []
    for one in asked:
        try:
            case = type(f"{one.tool} {one.version}", (Taken,), {"translator": one, "take": staticmethod(one.get())})
            suite.addTests(unittest.defaultTestLoader.loadTestsFromTestCase(case))
        except Missing as why:
            absent.append(f"skipped: {one.tool} {one.version}: {why}")
    right = unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful()
    print("\n".join(absent))
    return 1 if not right else SKIPPED if absent else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
