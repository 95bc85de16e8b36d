// A package is one that npm's registry would take, as npm checks before it sends anything, by the command of
// docs/develop/publishing.md; and publint and arethetypeswrong find no fault with it.
//
//   node registry.mjs PAGE PACKAGE     a .tgz file or a folder
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import test from "node:test";

const [, command] = /^\| npm \| `(npm publish [^`]*)`/m.exec(readFileSync(process.argv[2], "utf8"));
const given = resolve(process.argv[3]);
const scratch = mkdtempSync(join(tmpdir(), "registry-"));
process.on("exit", () => rmSync(scratch, { recursive: true }));
const right = join(scratch, "package"); // the folder as it is, and others with a fault
if (statSync(given).isDirectory()) cpSync(given, right, { recursive: true });
else spawnSync("tar", ["-xzf", given, "-C", scratch]);
const manifest = JSON.parse(readFileSync(join(right, "package.json"), "utf8"));
const entries = Object.entries(manifest.exports);
const [untyped] = entries.find(([, target]) => target.types);
// Files that are no modules have no types.
const others = entries.filter(([name]) => /\.(wasm|glsl)$/.test(name) && !name.includes("*")).map(([name]) => name);

function ran(program, ...words) {
  const { status, stdout, stderr } = spawnSync(program, words, { cwd: scratch, encoding: "utf8" });
  return { status, printed: stdout + stderr };
}

function published(what) {
  assert.ok(command.includes("--dry-run"), command);
  const [program, ...words] = command.replace(/hashnoise-1\.2\.3\.tgz/, what).split(" ");
  return ran(program, ...words, "--offline");
}

/** A copy of the package with a change of its manifest. */
function changed(change) {
  const folder = mkdtempSync(join(scratch, "faulty-"));
  cpSync(right, folder, { recursive: true });
  writeFileSync(join(folder, "package.json"), JSON.stringify({ ...manifest, ...change }));
  return folder;
}

test("npm would publish it", () => {
  const { status, printed } = published(given);
  assert.equal(status, 0, printed);
  assert.match(printed, /Publishing to .* with tag latest and default access \(dry-run\)/);
  assert.doesNotMatch(printed, /npm (warn publish (?!This command requires you to be logged in)|error)/i);
  const [, stated] = /download of (\d+) kB/.exec(readFileSync(join(right, "README.md"), "utf8"));
  const [, size] = /package size: +([\d.]+) kB/.exec(printed);
  assert.ok(Math.abs(size / stated - 1) < 0.05, `README.md has ${stated} kB, and npm ${size} kB`);
});

test("npm would refuse others", () => {
  assert.ok(!manifest.private); // which it would report without --dry-run alone
  for (const change of [{ version: "one" }, { name: "hash noise" }]) {
    assert.notEqual(published(changed(change)).status, 0, JSON.stringify(change));
  }
});

const lint = ["publint@0.3.25", "publint", "--strict", "--pack", "false"];
const types = ["@arethetypeswrong/cli@0.18.5", "attw", "--profile", "esm-only", "--format", "ascii",
  ...others.flatMap((name) => ["--exclude-entrypoints", name]), "--pack"];
for (const [subject, [source, ...words], fault, message] of [
  ["publint", lint, { exports: { ...manifest.exports, "./no": "./no.js" } }, /no\.js but the file does not exist/],
  ["arethetypeswrong", types, { exports: { ...manifest.exports, [untyped]: { ...manifest.exports[untyped], types: "./no.d.ts" } } },
    /No types|Resolution failed/],
]) {
  test(`${subject} finds faults of others alone`, (context) => {
    const checked = (folder) => ran("npm", "exec", "--yes", `--package=${source}`, "--", ...words, folder);
    const { status, printed } = checked(right);
    if (/ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH/.test(printed)) {
      context.skip("npm's registry cannot be reached");
      return;
    }
    assert.equal(status, 0, printed);
    const wrong = checked(changed(fault));
    assert.notEqual(wrong.status, 0, wrong.printed);
    assert.match(wrong.printed, message);
  });
}
