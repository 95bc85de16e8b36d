// Prints the text of a link, as the page copies it, or as JSON what tools/bake is called with (tools/lib/ship/playground/linked.py):
//
//   node text.mjs PIECES VERSION LANGUAGE KIND LINK      PIECES is what tools/lib/ship/playground/picks.py keeps
import { readFileSync } from "node:fs";
import { kLanguages } from "./code.js";
import { exportedText, kKinds } from "./export.js";
import { bakeParts } from "./lines.js";
import { ignoredIn, stateOf } from "./links.js";
import { Library, unpacked } from "./pieces.js";

const [pieces, version, language, kind, link] = process.argv.slice(2);

function refuse(reason) {
  console.error(reason);
  process.exit(2);
}

const ignored = ignoredIn(link);
if (ignored) refuse(ignored);
const state = stateOf(link);
if (language === "arguments") {
  const made = state.hash === "lattice" ? bakeParts(state) : refuse("tools/bake has the default hash alone.");
  console.log(JSON.stringify(made ?? refuse("tools/bake has no sums of distances, and no cells of their own numbers; tools/pick has all pictures.")));
} else {
  if (!Object.hasOwn(kLanguages, language)) refuse(`--language ${language} is none of the page: ${Object.keys(kLanguages).join(", ")}.`);
  if (!Object.hasOwn(kKinds[language], kind)) refuse(`--as ${kind}: of ${language} there is ${Object.keys(kKinds[language]).join(", ")}.`);
  const library = new Library(version, await unpacked(readFileSync(pieces, "ascii")));
  process.stdout.write(exportedText(library, language, state, kind, true));
}
