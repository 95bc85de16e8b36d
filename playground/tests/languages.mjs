// Programs that print what copied code of the languages of the CPU computes, as the words of floats.
import { mkdir, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { readFileSync } from "node:fs";
import { hasDrift } from "../model.js";
import { inFolder, kRoot, run } from "./support.mjs";


// How each is compiled and run: the files, by the call of pattern at "column" and "row", and the commands.
const kPrograms = {
  c: {
    needs: ["gcc"],
    files: (code, call, width, height) => ({
      "pattern.h": code,
      "main.c": `#include "pattern.h"
#include <stdio.h>
#include <string.h>
int main(void) {
  for (int row = 0; row < ${height}; ++row) for (int column = 0; column < ${width}; ++column) {
    float value = ${call("pattern", "(float)column * 0.125f", "(float)row * 0.125f", "f")};
    uint32_t word; memcpy(&word, &value, 4); printf("%u\\n", (unsigned)word);
  }
}
`,
    }),
    commands: [["gcc", "-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wno-unused-function", "-Werror", "main.c", "-o", "main", "-lm"], ["./main"]],
  },
  // Compiled as C++, with the stand-in of the suite for Metal's library, which has no functions for colours.
  metal: {
    needs: ["clang++"],
    files: (code, call, width, height) => ({
      metal_stdlib: readFileSync(join(kRoot, "conformance", "gpu", "metal", "metal_stdlib.hpp"), "utf8"),
      "main.cpp": `${code.slice(0, code.indexOf("// From "))}
#include <cstdio>
#include <cstring>
int main() {
  for (int row = 0; row < ${height}; ++row) for (int column = 0; column < ${width}; ++column) {
    float value = ${call("pattern", "(float)column * 0.125f", "(float)row * 0.125f", "f", "float")};
    unsigned word; std::memcpy(&word, &value, 4); std::printf("%u\\n", word);
  }
}
`,
    }),
    commands: [["clang++", "-std=c++14", "-O1", "-ffp-contract=off", "-I.", "main.cpp", "-o", "main"], ["./main"]],
  },
  rust: {
    needs: ["rustc"],
    files: (code, call, width, height) => ({
      "pattern.rs": code,
      "main.rs": `#[allow(dead_code)] mod pattern;
fn main() {
    for row in 0..${height} { for column in 0..${width} {
        println!("{}", ${call("pattern::pattern", "column as f32 * 0.125", "row as f32 * 0.125", "")}.to_bits());
    } }
}
`,
    }),
    commands: [["rustc", "--edition", "2021", "-O", "main.rs"], ["./main"]],
  },
  go: {
    needs: ["go"],
    files: (code, call, width, height) => ({
      "go.mod": "module pattern\n\ngo 1.18\n",
      "noise/pattern.go": code,
      "main.go": `package main
import ("fmt"; "math"; hashnoise "pattern/noise")
func main() {
	for row := 0; row < ${height}; row++ { for column := 0; column < ${width}; column++ {
		fmt.Println(math.Float32bits(${call("hashnoise.Pattern", "float32(column) * 0.125", "float32(row) * 0.125", "")}))
	} }
}
`,
    }),
    commands: [["go", "build", "-o", "main", "."], ["./main"]],
  },
  java: {
    needs: ["javac", "java"],
    files: (code, call, width, height) => ({
      "HashNoise.java": code,
      "Main.java": `final class Main {
  public static void main(String[] arguments) {
    for (int row = 0; row < ${height}; ++row) for (int column = 0; column < ${width}; ++column)
      System.out.println(Float.floatToRawIntBits(${call("HashNoise.pattern", "column * 0.125f", "row * 0.125f", "f")}) & 0xFFFFFFFFL);
  }
}
`,
    }),
    commands: [["javac", "-proc:none", "HashNoise.java", "Main.java"], ["java", "-Xshare:auto", "-XX:TieredStopAtLevel=1", "Main"]],
  },
  csharp: {
    needs: ["mcs", "mono"],
    files: (code, call, width, height) => ({
      "HashNoise.cs": code,
      "Main.cs": `static class Program {
  static void Main() {
    for (int row = 0; row < ${height}; ++row) for (int column = 0; column < ${width}; ++column)
      System.Console.WriteLine(System.BitConverter.ToUInt32(System.BitConverter.GetBytes(${call("HashNoise.Pattern", "column * 0.125f", "row * 0.125f", "f")}), 0));
  }
}
`,
    }),
    commands: [["mcs", "-langversion:7.2", "-out:main.exe", "HashNoise.cs", "Main.cs"], ["mono", "main.exe"]],
  },
};
export const kCompiled = Object.keys(kPrograms);

const isHere = (program) => run("sh", ["-c", `command -v ${program}`]).then(() => true, () => false);
export const hasCompiler = async (language) => (await Promise.all(kPrograms[language].needs.map(isHere))).every(Boolean);

// The words of pattern() at eighths of a cell, the lower row first.
export const wordsOf = (language, code, state, width, height) =>
  inFolder(async (folder) => {
    const { files, commands } = kPrograms[language];
    const call = (name, x, y, suffix, vector) => {
      const parts = [x, y, ...[state.z, state.w].map((part) => `${part.toFixed(4)}${suffix}`)].slice(0, state.dimensions);
      const place = vector && parts.length > 1 ? `${vector}${parts.length}(${parts.join(", ")})` : parts.join(", ");
      return `${name}(${place}${hasDrift(state) ? `, ${state.time.toFixed(4)}${suffix}` : ""})`;
    };
    for (const [name, text] of Object.entries(files(code, call, width, height))) {
      await mkdir(join(folder, name, ".."), { recursive: true });
      await writeFile(join(folder, name), text);
    }
    let printed = "";
    for (const [program, ...options] of commands)
      printed = (await run(program, options, { cwd: folder, env: { ...process.env, GOFLAGS: "-mod=mod" }, maxBuffer: 1 << 26 })).stdout;
    return printed.trim().split("\n").map(Number);
  });

// Computes the words by JavaScript, here.
export async function wordsOfJavaScript(code, state, width, height) {
  const { pattern } = await import(`data:text/javascript,${encodeURIComponent(code)}`);
  const values = Array.from({ length: width * height }, (_, at) =>
    pattern(...[(at % width) / 8, Math.floor(at / width) / 8, state.z, state.w].slice(0, state.dimensions), state.time),
  );
  return Array.from(new Uint32Array(new Float32Array(values).buffer));
}
