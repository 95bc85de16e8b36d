// The package is one that npm's registry would take, as npm checks before it sends anything: the command of
// docs/develop/publishing.md.
//
//   node registry.mjs PAGE
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import test from "node:test";

const page = readFileSync(process.argv[2], "utf8");
const [, command] = /^\| npm \| `(npm publish [^`]*)`/m.exec(page);
const packages = resolve(import.meta.dirname, "..");
const packed = readdirSync(packages).find((name) => /^hashnoise-[\d.]+\.tgz$/.test(name));

/** npm's messages on a package in a folder. */
function published(folder, name) {
  assert.ok(command.includes("--dry-run"), command);
  const words = command.replace(/hashnoise-1\.2\.3\.tgz/, name).split(" ");
  const { status, stderr } = spawnSync(words[0], [...words.slice(1), "--offline"], { cwd: folder, encoding: "utf8" });
  return { status, stderr };
}

test("npm would publish it", () => {
  const { status, stderr } = published(packages, `./${packed}`);
  assert.equal(status, 0, stderr);
  assert.match(stderr, /Publishing to .* with tag latest and default access \(dry-run\)/);
  assert.doesNotMatch(stderr, /npm (warn publish (?!This command requires you to be logged in)|error)/i);
});

test("npm would refuse others", () => {
  const manifest = join(import.meta.dirname, "node_modules", "hashnoise", "package.json");
  const right = JSON.parse(readFileSync(manifest, "utf8"));
  assert.ok(!right.private); // which it would report without --dry-run alone
  for (const change of [{ version: "one" }, { name: "hash noise" }]) {
    const folder = mkdtempSync(join(tmpdir(), "registry-"));
    writeFileSync(join(folder, "package.json"), JSON.stringify({ ...right, ...change }));
    assert.notEqual(published(folder, ".").status, 0, JSON.stringify(change));
    rmSync(folder, { recursive: true });
  }
});
