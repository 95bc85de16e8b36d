"""tools/pack unreal: the content of the plugin, and its command line.

    python3 -m unittest ship.unreal.unreal_test  names and texts of a few
    python3 -m ship.unreal.unreal_test           the whole plugin: glslang, DXC and FXC compile what its nodes include,
                                                 DXC and FXC the nodes to paste, Clang and Mono its module

Exit status: as of the tests; 77 glslang, Clang or Mono is not here, or nothing failed without Microsoft's compilers.
"""

from __future__ import annotations

import json
import re
import subprocess
import unittest
from pathlib import Path
from unittest import mock

from base.tree import TOOLS, version
from ship.hlsl_nodes import ARITHMETICS, NODES, PORTS, forms, ports, title
from ship.packing import Refused
from ship.packing_support import DEFAULTS, made, run_with_compilers
from ship.unreal import files
from translate.hlsl.compilers import compiled, refusals
from translate.hlsl.compilers import missing as missing_compilers
from translate.tools import DXC, FXC

NEEDED = {"glslangValidator": "glslang-tools", "clang++": "clang", "mcs": "mono-mcs"}
# As much of Unreal as the module needs, to compile it: a header each, and what builds it.
ENGINE = {
    "CoreMinimal.h": """#pragma once
#define TEXT(x) L##x
struct FString { FString(const wchar_t*) {} FString() {} };
template <typename T> struct TSharedPtr { T* at = nullptr; T* operator->() const { return at; } };
""",
    "Interfaces/IPluginManager.h": """#include "CoreMinimal.h"
struct IPlugin { virtual FString GetBaseDir() const = 0; };
struct IPluginManager {
  static IPluginManager& Get();
  virtual TSharedPtr<IPlugin> FindPlugin(const FString& Name) = 0;
};
""",
    "Misc/Paths.h": """#include "CoreMinimal.h"
struct FPaths { template <typename... Parts> static FString Combine(Parts&&...); };
""",
    "Modules/ModuleManager.h": """#pragma once
struct IModuleInterface { virtual ~IModuleInterface() = default; virtual void StartupModule() {} };
#define IMPLEMENT_MODULE(Class, Name) static Class Made##Name;
""",
    "ShaderCore.h": """#include "CoreMinimal.h"
void AddShaderSourceDirectoryMapping(const FString& Virtual, const FString& Real);
"""}
BUILD = """
namespace UnrealBuildTool {
    public enum PCHUsageMode { UseExplicitOrSharedPCHs }
    public class ReadOnlyTargetRules {}
    public class ModuleRules {
        public PCHUsageMode PCHUsage;
        public System.Collections.Generic.List<string> PrivateDependencyModuleNames;
        public ModuleRules(ReadOnlyTargetRules Target) {}
    }
}
"""

COMPILERS = ((DXC, "ps_6_0"), (FXC, "ps_5_0"))
BLOCK = re.compile(r"^Begin Object Class=/Script/UnrealEd.MaterialGraphNode Name=\"(\w+)\"\n(.*?)^End Object\n", re.M | re.S)
PIN = re.compile(r'^   CustomProperties Pin \(PinId=(\w{32}),PinName="(\w+)",(.*)\)$', re.MULTILINE)


def faults(text: str, form: str) -> list[str]:
    """Why a text is not a custom node with the inputs of a form, and a constant at each that has a default."""
    nodes = dict(BLOCK.findall(text))
    if BLOCK.sub("", text) or not all(len(re.findall("(?m)^   Begin", one)) == len(re.findall("(?m)^   End", one)) == 2
                                      for one in nodes.values()):
        return ["it is no list of nodes"]
    pins = {(node, id_): (name, "EGPD_Output" in more, set(re.findall(r"(\w+) (\w{32}),", more)))
            for node, one in nodes.items() for id_, name, more in PIN.findall(one)}
    expressions = {}
    for node, one in nodes.items():
        (kind, name), = re.findall(r'^   Begin Object Class=/Script/Engine.(\w+) Name="(\w+)"$', one, re.MULTILINE)
        if f'   Begin Object Name="{name}"\n' not in one or f"   MaterialExpression=\"/Script/Engine.{kind}'{name}'\"\n" not in one:
            return [f"{node} has no expression {name}"]
        expressions[f"/Script/Engine.{kind}'{node}.{name}'"] = one
    found = [f"{name} is linked in one direction" for at, (name, is_output, linked) in pins.items() for other in linked
             if other not in pins or pins[other][1] == is_output or at not in pins[other][2]]
    custom = nodes["MaterialGraphNode_0"]
    given = [(name, source) for name, source in re.findall(
        r'^      Inputs\(\d+\)=\(InputName="(\w+)"(?:,Input=\(Expression="(.*)"\))?\)$', custom, re.MULTILINE)]
    names = [name for _, name in ports(form)]
    if [name for name, _ in given] != names or [name for _, name, _ in PIN.findall(custom)] != [*names, "Output"]:
        return [*found, f"the inputs are {given}"]
    linked = {name: {nodes.get(node) for node, _ in of} for name, is_output, of in pins.values() if not is_output}
    for (type_, name), (_, source) in zip(ports(form), given):
        if (linked[name] or {""}) != {expressions.get(source, "")}:
            found.append(f"the pin of {name} and its input differ")
        numbers = [float(one) for one in re.findall(r"\b[RGB]=([\d.]+)", expressions.get(source, ""))]
        if numbers != list(DEFAULTS[name][:int(type_[5:] or 1)]):
            found.append(f"{name} is {numbers}")
    if f"      OutputType=CMOT_Float{PORTS[forms()[form].type][5:] or 1}\n" not in custom:
        found.append("the type of the output is another one")
    return found


class Text(unittest.TestCase):
    def test_it_names_the_engine_that_fab_asks_for(self) -> None:
        with mock.patch.object(files, "shader", return_value=""), mock.patch.object(files, "alone", return_value=""):
            described = [json.loads(files.package.__wrapped__(engine)[files.DESCRIPTION]) for engine in (None, "5.6")]
            self.assertEqual([one.get("EngineVersion") for one in described], [None, "5.6.0"])
            self.assertIn("Win64", described[0]["Modules"][0]["PlatformAllowList"])
            with self.assertRaisesRegex(Refused, "--engine 5.6.1: write a version of Unreal such as 5.6"):
                files.package.__wrapped__("5.6.1")

    def test_what_is_pasted_has_each_input_with_its_default(self) -> None:
        with mock.patch.object(files, "alone", return_value=""):
            for form in NODES:
                with self.subTest(form):
                    self.assertEqual(faults(files.pasted(form, "fast"), form), [])

    def test_a_fault_of_what_is_pasted_is_found(self) -> None:
        with mock.patch.object(files, "alone", return_value=""):
            whole = files.pasted("hn_fbm2", "fast")
        gain, lacunarity = (re.search(rf'PinId=\w+,PinName="{name}"', whole)[0] for name in ("Gain", "Lacunarity"))
        for number, plant in enumerate((
                lambda text: text.replace(gain, "other").replace(lacunarity, gain).replace("other", lacunarity),
                lambda text: text.replace(gain[:38], "other").replace(lacunarity[:38], gain[:38]).replace("other", lacunarity[:38]),
                lambda text: re.sub(r'(\(InputName=)"Gain"(.*?)"Seed"', r'\1"Seed"\2"Gain"', text, flags=re.DOTALL),
                lambda text: text.replace("R=6.0", "R=5.0"), lambda text: text.replace("CMOT_Float1", "CMOT_Float2"),
                lambda text: text.replace("Expression=\"/Script/Engine.MaterialExpressionConstant'MaterialGraphNode_2", "Expression=\""
                                          "/Script/Engine.MaterialExpressionConstant'MaterialGraphNode_3"),
                lambda text: text[:text.rindex("Begin Object Class=/Script/UnrealEd")],
                lambda text: text.replace("   End Object", "", 1))):
            with self.subTest(number):
                self.assertNotEqual(whole, plant(whole))
                self.assertNotEqual(faults(plant(whole), "hn_fbm2"), [])


@unittest.skipUnless(__name__ == "__main__", "the test unreal.plugin writes all functions")
class Plugin(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.root, cls.folder = made(cls, "unreal")
        # Where the module registers them.
        (cls.root / "HashNoise").symlink_to(cls.folder / "Shaders")

    def status_of(self, *words: str | Path) -> tuple[int, str]:
        done = subprocess.run([str(word) for word in words], cwd=self.root, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_it_says_what_it_is(self) -> None:
        described = json.loads((self.folder / files.DESCRIPTION).read_text())
        self.assertEqual((described["VersionName"], [one["Name"] for one in described["Modules"]]),
                         (version(), ["HashNoise"]))
        self.assertIn(f"`{files.code('hn_fbm2')}`", (self.folder / "README.md").read_text())

    def refusals(self, text: str) -> dict[str, str]:
        """The refusals of a shader of pixels, in which the paths of includes begin at the top."""
        file = self.root / "shader.hlsl"
        file.write_text(text.replace('#include "/', '#include "'))
        return refusals(file, "frag", "Main")

    def nodes(self, arithmetic: str, suffix: str) -> str:
        """Each node as Unreal writes it: a function around the code."""
        text, calls = f'#include "/HashNoise/HashNoise{suffix}.ush"\n', ""
        for i, form in enumerate(NODES):
            type_ = PORTS[forms()[form].type]
            taken = ", ".join(f"{of} {name}" for of, name in ports(form))
            text += f"{type_} CustomExpression{i}({taken})\n{{\n{files.code(form, arithmetic)}\n}}\n"
            calls += f"  sum += CustomExpression{i}({', '.join(f'({of})uv.x' for of, _ in ports(form))}).x;\n"
        return (f"{text}float4 Main(float2 uv : TEXCOORD0) : SV_Target {{\n  float sum = 0.0;\n{calls}"
                "  return sum;\n}\n")

    def test_each_node_compiles(self) -> None:
        texts = [self.nodes("fast", ""), self.nodes("fixed", "Fixed")]
        for text in texts:
            self.assertEqual(self.refusals(text), {})
            self.assertEqual(set(self.refusals(text.replace("(uint)(int)Seed", "(uint)(int)Sead", 1))),
                             {"glslang"} if missing_compilers() else {"glslang", "DXC", "FXC"})
        both = "\n".join(texts).replace("CustomExpression", "Other", texts[0].count("CustomExpression"))
        self.assertEqual(self.refusals(both.replace("float4 Main", "float4 First", 1)), {})

    @unittest.skipIf(missing_compilers(), "glslang takes no functions in a struct in a function")
    def test_each_node_to_paste_compiles(self) -> None:
        """Each as Unreal writes it: a function around the code."""
        shaders = []
        for path in sorted((self.folder / "Nodes").iterdir()):
            form = next(form for form in NODES if path.stem in (title(form, arithmetic) for arithmetic in ARITHMETICS))
            code = re.search(r'^      Code="(.*)"$', path.read_text(), re.MULTILINE)[1].replace("\\r\\n", "\n")
            shaders.append(self.root / f"{path.stem}.hlsl")
            shaders[-1].write_text(
                f"{PORTS[forms()[form].type]} Custom({', '.join(map(' '.join, ports(form)))})\n{{\n{code}\n}}\n"
                "float4 Main(float2 uv : TEXCOORD0) : SV_Target { return Custom("
                f"{', '.join(f'({of})uv.x' for of, _ in ports(form))}).x; }}\n")
        self.assertEqual(len(shaders), len(NODES) * len(ARITHMETICS))
        for tool, profile in COMPILERS:
            self.assertEqual([one.messages for one in compiled(tool, shaders, profile, "Main") if not one.code], [])
        shaders[0].write_text(shaders[0].read_text().replace("(uint)(int)Seed", "(uint)(int)Sead"))
        self.assertEqual([one.code for one in compiled(DXC, shaders[:1], "ps_6_0", "Main")], [b""])

    def test_the_page_compiles(self) -> None:
        block, _ = re.findall(r"```hlsl\n(.*?)```", (self.folder / "README.md").read_text(), re.DOTALL)
        include, _, code = block.partition("\n")
        self.assertEqual(self.refusals(f"{include}\nfloat4 Main(float2 uv : TEXCOORD0) : SV_Target {{\n{code}"
                                       "  return height + tiled;\n}\n"), {})

    def test_a_position_of_four_components_is_an_error_where_there_is_2d_and_3d(self) -> None:
        for type_ in ("float", "float4"):
            for code, refused in (("hn_perlin(Position, 7u)", True), ("hn_perlin(hn_tile(Position, 8), 7u)", False)):
                found = self.refusals('#include "/HashNoise/HashNoise.ush"\n'
                                      f"float Node({type_} Position) {{ return {code}; }}\n"
                                      "float4 Main(float2 uv : TEXCOORD0) : SV_Target { return Node(uv.x); }\n")
                with self.subTest(code, type=type_):
                    self.assertEqual(bool(found), refused)
                    for said in found.values():
                        self.assertIn("ambiguous", said)

    def test_the_text_of_another_function_stands_beside_it(self) -> None:
        page = (self.folder / "README.md").read_text()
        words = re.search(r"^    tools/pick (.*)$", page, re.MULTILINE)[1].split()
        subprocess.run([TOOLS / "pick", *words], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
        code = re.search(r"`(return my_.*?)`", page)[1]
        _, block = re.findall(r"```hlsl\n(.*?)```", page, re.DOTALL)
        text = re.sub("(?m)^#.*\n", "", (self.folder / "Shaders" / "Hybrid.ush").read_text())
        shader = self.root / "struct.hlsl"
        shader.write_text("float Node(float3 Position, float Octaves, float Lacunarity, float Gain, float Seed) {\n"
                          f"{block.replace('// the functions', text)}}}\n"
                          "float4 Main(float2 uv : TEXCOORD0) : SV_Target { return Node(float3(uv, 0.5), 6, 2, 0.5, 7); }\n")
        for tool, profile in () if missing_compilers() else COMPILERS:
            self.assertTrue(compiled(tool, [shader], profile, "Main")[0].code)
        self.assertEqual(self.refusals(
            '#include "/HashNoise/HashNoise.ush"\n#include "/HashNoise/Hybrid.ush"\n'
            f"float Node(float3 Position, float Octaves, float Lacunarity, float Gain, float Seed) {{\n{code}\n}}\n"
            "float4 Main(float2 uv : TEXCOORD0) : SV_Target {\n"
            "  return Node(float3(uv, 0.5), 6, 2, 0.5, 7) + hn_perlin(uv, 7u);\n}\n"), {})

    def test_the_module_compiles(self) -> None:
        for name, text in ENGINE.items():
            path = self.root / "engine" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        module, = self.folder.rglob("*.cpp")
        compiled = ("clang++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-Iengine")
        status, said = self.status_of(*compiled, module)
        self.assertEqual(status, 0, said)
        (self.root / "wrong.cpp").write_text(module.read_text().replace("Plugin->GetBaseDir", "Plugin->BaseDir"))
        self.assertNotEqual(self.status_of(*compiled, "wrong.cpp")[0], 0)
        rules, = self.folder.rglob("*.Build.cs")
        (self.root / "engine.cs").write_text(BUILD)
        status, said = self.status_of("mcs", "-target:library", "-warnaserror", "-out:rules.dll", "engine.cs", rules)
        self.assertEqual(status, 0, said)


if __name__ == "__main__":
    run_with_compilers("Plugin", NEEDED)
