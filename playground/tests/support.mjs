// Shared by the tests of the page. They run in the folder of tools/lib/base/javascript:
//
//   node TEST PAGE.html
import { execFile } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { promisify } from "node:util";

export const kRoot = resolve(dirname(fileURLToPath(import.meta.url)), "..", "..");
export const kPage = pathToFileURL(resolve(process.argv[2] ?? "playground.html")).href;
export const run = promisify(execFile);

const { launch, open } = await import(pathToFileURL(resolve("chromium.mjs")));

const kSkipped = 77;

// A canvas of WebGPU needs the compositor to be on the same Vulkan, where each frame of the page is expensive.
export const kForWebGpu = ["--enable-features=Vulkan", "--use-vulkan=swiftshader"];
export const kForWebGl = ["--disable-gpu-compositing"];

export async function launched(args = kForWebGpu) {
  try {
    return await launch({ args });
  } catch (error) {
    if (!/^there is no /.test(error.message)) throw error;
    console.log(`skipped: ${error.message}`);
    process.exit(kSkipped);
  }
}

export const kPhone = { width: 390, height: 844, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
export const kSmall = { width: 320, height: 200 };

// The page, ready, and without errors in its console so far.
export async function opened(browser, { link = "#", viewport = kSmall, before } = {}) {
  const page = await open(browser, "about:blank");
  await page.setViewport(viewport);
  if (before) await page.evaluateOnNewDocument(before);
  await page.goto(kPage + link);
  await ready(page);
  return page;
}

export const ready = (page) =>
  page.waitForFunction(() => document.documentElement.dataset.ready === "yes", { timeout: 30000 });

// BigInts do not pass from the page to here or back, so they pass as text.
export const sent = (value) =>
  JSON.parse(JSON.stringify(value, (_, part) => (typeof part === "bigint" ? { parts: String(part) } : part)));
export const received = (value) =>
  JSON.parse(JSON.stringify(value), (_, part) =>
    part && typeof part === "object" && part.parts ? BigInt(part.parts) : part,
  );

// Sets the state of the page as it is, or settings of it, without the limits of what can be chosen.
export const setState = (page, state) =>
  page.evaluate((given) => {
    const state = JSON.parse(JSON.stringify(given), (_, part) => (part?.parts ? BigInt(part.parts) : part));
    window.hashnoise.state = window.hashnoise.with(state);
  }, sent(state));

// The state, with the settings of the first layer by their names.
export const stateOfPage = async (page) =>
  received(
    await page.evaluate(() =>
      JSON.parse(
        JSON.stringify({ ...window.hashnoise.state, ...window.hashnoise.state.layers[0] }, (_, part) =>
          typeof part === "bigint" ? { parts: String(part) } : part,
        ),
      ),
    ),
  );

// The bytes of a picture of this size, or the bits of its values, as words.
export async function pixels(page, width, height, bits = false) {
  const bytes = await page.evaluate(
    async (...size) => Array.from(await window.hashnoise.pixels(...size)),
    width,
    height,
    bits ? 1 : 0,
  );
  return bits ? Array.from(new Uint32Array(new Uint8Array(bytes).buffer)) : bytes;
}

export const copiedCode = (page, language, whole, kind = "function") =>
  page.evaluate(
    (tab, chosen, as) => {
      const { controls, state } = window.hashnoise;
      controls.chooseLanguage(tab);
      controls.chooseKind(as);
      document.getElementById("whole").checked = chosen;
      controls.show(state);
      return controls.code;
    },
    language,
    whole,
    kind,
  );

export const floatOf = (word) => new Float32Array(new Uint32Array([word]).buffer)[0];

// A folder that goes when the work in it is done.
export async function inFolder(work) {
  const folder = await mkdtemp(join(tmpdir(), "playground-"));
  try {
    return await work(folder);
  } finally {
    await rm(folder, { recursive: true });
  }
}

// The output of a program of C++ that ends in `main`, behind the copied code.
export const compiled = (code, main) =>
  inFolder(async (folder) => {
    await writeFile(join(folder, "main.cpp"), `${code}\n${main}`);
    const flags = ["-std=c++20", "-O0", "-Dalways_inline=unused", "-ffp-contract=off", "-I", join(kRoot, "include")];
    await run("g++", [...flags, join(folder, "main.cpp"), "-o", join(folder, "main")]);
    return (await run(join(folder, "main"), { maxBuffer: 1 << 26 })).stdout;
  });
