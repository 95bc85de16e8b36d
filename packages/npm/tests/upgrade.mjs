// A page that has this version and one before: a world that was built with the old one stays as it is, beside what is
// new. Each has its own bits, in JavaScript and in shaders, also in one shader. From 1.0 on they are the same bits.
//
//   node upgrade.mjs ROOT [COMMIT]    of the repository, and a commit of an earlier version (default: the last release)
//
// Exit status: as of the tests; 77 the commit is not here, as in a clone without history or tags.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { build, preview } from "vite";
import { launch, open } from "../chromium.mjs";
import { bitsOf } from "./golden_values.mjs";
import { evaluate } from "./vertices.mjs";

const packages = join(import.meta.dirname, "node_modules");
const versionOf = (name) => JSON.parse(readFileSync(join(packages, name, "package.json"))).version;
const [repository, given] = process.argv.slice(2);
const root = join(import.meta.dirname, "upgrade");
const git = (...words) => spawnSync("git", ["-C", repository, ...words], { encoding: "utf8" });
const tags = git("tag", "--merged", "HEAD", "--sort", "-version:refname", "v[0-9]*").stdout.split("\n");
const commit = given ?? tags.find((tag) => tag !== `v${versionOf("hashnoise")}`);
if (!commit || git("cat-file", "-e", `${commit}^{commit}`).status !== 0) {
  console.log(`skipped: ${repository} has no ${commit ? `commit ${commit}` : "tag of an earlier version"}`);
  process.exit(77);
}

const points = Array.from({ length: 64 }, (_, i) => [i * 0.37 - 11, 5 - i * 0.61]);
const hasTheSameBits = () => !versionOf("hashnoise-before").startsWith("0.");
let page, server, browser;

before(async () => {
  const old = mkdtempSync(join(tmpdir(), "before-"));
  const archive = execFileSync("git", ["-C", repository, "archive", commit], { maxBuffer: 2 ** 30 });
  execFileSync("tar", ["-x", "-C", old], { input: archive });
  const own = join(old, "tools", "npm"); // of versions that have no tools/pack
  const command = existsSync(own) ? [own] : [join(old, "tools", "pack"), "npm"];
  const packed = execFileSync(command[0], [...command.slice(1), join(old, "made")], { encoding: "utf8" }).trim();
  execFileSync("npm", ["install", "--offline", "--no-save", "--no-audit", "--no-fund", `hashnoise-before@file:${packed}`],
    { cwd: import.meta.dirname });
  rmSync(old, { recursive: true });
  await build({ root, configFile: false, logLevel: "warn" });
  server = await preview({ root, configFile: false, preview: { port: 0, host: "127.0.0.1" } });
  browser = await launch();
  page = await open(browser, `http://127.0.0.1:${server.httpServer.address().port}/`);
  await page.waitForFunction("globalThis.hashnoise");
});
after(async () => {
  await browser?.close();
  await server?.close();
});

const computed = (name) => page.evaluate((...given) => hashnoise.computed(...given), name, points);
const calls = { now: "hn_fbm", before: "hn_fbm", renamed: "hnbefore_fbm" };

/** The heights by a shader that has these texts: a list for each. */
async function drawn(...names) {
  const texts = await page.evaluate(() => hashnoise.texts);
  const rows = points.map((p) => [...p.map(bitsOf), 7]);
  const text = names.map((name) => texts[name]).join("\n");
  return Promise.all(names.map((name) => page.evaluate(evaluate, text, `${calls[name]}(p, 6, 2.0, 0.5, row.z)`, rows)));
}

test("the two are of different versions, with the same values from 1.0 on", async () => {
  assert.notEqual(versionOf("hashnoise"), versionOf("hashnoise-before"));
  const [now, old] = [await computed("now"), await computed("before")];
  if (hasTheSameBits()) return assert.deepEqual(now, old);
  const differing = now.filter((word, i) => word !== old[i]).length;
  assert.ok(differing > points.length / 2, `${differing} of ${points.length} heights differ`);
});

test("each has its own bits in a shader of its own", async () => {
  assert.deepEqual(await drawn("now"), [await computed("now")]);
  assert.deepEqual(await drawn("before"), [await computed("before")]);
});

test("each has its own bits in one shader, where the names of one are others", async () => {
  assert.deepEqual(await drawn("now", "renamed"), [await computed("now"), await computed("before")]);
  assert.deepEqual(page.complaints, []);
});

test("without that one shader has one of them, or none", async (t) => {
  if (hasTheSameBits()) return t.skip("both have the same bits");
  const wrong = await drawn("now", "before").catch(() => [[], []]);
  assert.notDeepEqual(wrong[1], await computed("before"));
});
