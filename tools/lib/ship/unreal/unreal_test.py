"""tools/pack unreal: the content of the plugin, and its command line.

    python3 -m unittest ship.unreal.unreal_test  names and texts of a few
    python3 -m ship.unreal.unreal_test           the whole plugin: glslang, DXC and FXC compile its nodes, Clang
                                                 and Mono its module

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
from ship.hlsl_nodes import NODES, PORTS, forms, ports
from ship.packing import Refused
from ship.packing_support import made, run_with_compilers
from ship.unreal import files
from translate.hlsl.compilers import missing as missing_compilers
from translate.hlsl.compilers import refusals

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


class Text(unittest.TestCase):
    def test_it_names_the_engine_that_fab_asks_for(self) -> None:
        with mock.patch.object(files, "shader", return_value=""):
            described = [json.loads(files.package.__wrapped__(engine)[files.DESCRIPTION]) for engine in (None, "5.6")]
            self.assertEqual([one.get("EngineVersion") for one in described], [None, "5.6.0"])
            self.assertIn("Win64", described[0]["Modules"][0]["PlatformAllowList"])
            with self.assertRaisesRegex(Refused, "--engine 5.6.1: write a version of Unreal such as 5.6"):
                files.package.__wrapped__("5.6.1")

    def test_the_page_has_each_node_once(self) -> None:
        rows = files.node_table().splitlines()[2:]
        self.assertEqual(len(rows), len({files.code(form) for form in NODES}))
        self.assertIn("| `return hn_value(Position, (uint)(int)Seed);` | `Position`, `Seed` | 2 or 3 | CMOT Float 1 |",
                      rows)


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
        page = (self.folder / "README.md").read_text()
        for form in NODES:
            self.assertIn(f"`{files.code(form)}`", page)

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

    def test_the_page_compiles(self) -> None:
        block, = re.findall(r"```hlsl\n(.*?)```", (self.folder / "README.md").read_text(), re.DOTALL)
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
