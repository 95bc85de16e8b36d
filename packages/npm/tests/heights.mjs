// Heights at points, for tools/lib/ship/heights: of Field, and of texts in GLSL, which Chromium runs by WebGL2.
//
//   node heights.mjs JOB    {"rows": [[x, y, seed], ...], "texts": {NAME: GLSL}}, all words
//
// It prints the results as JSON, by names: a word for each row. The package's own text is "page", and Field "npm".
import { readFile } from "node:fs/promises";
import { Field } from "hashnoise";
import fbm2d from "hashnoise/glsl/fbm2d";
import { launch, open } from "../chromium.mjs";
import { bitsOf, meaning } from "./golden_values.mjs";
import { evaluate } from "./vertices.mjs";

const { rows, texts } = JSON.parse(await readFile(process.argv[2], "utf8"));
const found = {
  npm: rows.map(([x, y, seed]) =>
    bitsOf(new Field(2, { fractal: "fbm", octaves: 6, seed }).at(meaning("f32", x), meaning("f32", y)))),
};

const browser = await launch();
try {
  const page = await open(browser, "about:blank");
  for (const [name, text] of Object.entries({ page: fbm2d, ...texts })) {
    found[name] = await page.evaluate(evaluate, `#define HN_ARITHMETIC HN_FIXED\n${text}`, "hn_fbm(p, 6, 2.0, 0.5, row.z)", rows);
  }
} finally {
  await browser.close();
}
console.log(JSON.stringify(found));
