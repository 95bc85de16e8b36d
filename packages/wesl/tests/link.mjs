// Links shaders by npm's wesl: node link.mjs BUNDLE FOLDER writes FOLDER/NAME.wgsl of each FOLDER/NAME.wesl.
// Exit status: 0 done, 1 wesl reports an error.

import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { link } from "wesl/core";

const [bundle, folder] = process.argv.slice(2);
const { weslBundle } = await import(bundle);
for (const file of readdirSync(folder).filter((name) => name.endsWith(".wesl"))) {
  const name = file.slice(0, -".wesl".length);
  const weslSrc = { [file]: readFileSync(`${folder}/${file}`, "utf8") };
  try {
    const linked = await link({ weslSrc, libs: [weslBundle], rootModuleName: name });
    writeFileSync(`${folder}/${name}.wgsl`, linked.dest);
  } catch (error) {
    console.error(`${error.message}`);
    process.exit(1);
  }
}
