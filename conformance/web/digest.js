// The part of a page's results that is worth sending: report/digest.cpp makes the same text from the same results.
import { kBadStatuses } from "./checks.js";
import { crc32, hex } from "./suite.js";

const kFormat = "hashnoise-digest 1";
// As in digest.hpp and digest.cpp.
const kMostDigestBytes = 4096;
const kMostBytesRead = 400;
const kMostNameBytes = 96;
const kMostFailed = 12;

function withSafeCharacters(text, most) {
  return text.replace(/[^A-Za-z0-9()+,./:;@_-]+/g, " ").replace(/^ /, "").slice(0, most);
}

export function withoutBuilds(text) {
  const name = withSafeCharacters(text, kMostBytesRead)
                 .replace(/ ?\(git-[0-9a-f]+\)|\b[0-9a-f]{8,}\b/g, "")
                 .replace(/(\d+\.\d+)(\.\d+)+/g, "$1");
  return withSafeCharacters(name, kMostNameBytes).replace(/ $/, "") || "unknown";
}

// JSON with its keys in order.
function sorted(value) {
  if (Array.isArray(value) || typeof value !== "object") return value;
  return Object.fromEntries(Object.keys(value).sort().map((key) => [key, sorted(value[key])]));
}

// The part of the results of one API. sets: the numbers of the cases' sets, by id.
function partOf(results, sets, count) {
  const counts = {};
  const checksums = new Map();
  for (const { id, status, checksum } of results) {
    const [file, name, , arithmetic] = id.split(".");
    const bad = kBadStatuses.includes(status);
    // The cases of whole files are one group: there are many files.
    const group = `${name === "all" ? "files" : file}.${arithmetic}`;
    (counts[group] ??= [0, 0, 0])[bad ? 1 : status === "unsupported" ? 2 : 0] += 1;
    const set = sets.get(id);
    // Versions and stages have a case each. A wrong result counts.
    if (checksum === undefined || set === undefined) continue;
    if (bad || !checksums.has(set)) checksums.set(set, { file, checksum });
  }
  const digits = new Uint8Array(Math.ceil(count / 4));
  const words = {};
  for (const set of [...checksums.keys()].sort((a, b) => a - b)) {
    const { file, checksum } = checksums.get(set);
    (words[file] ??= []).push(parseInt(checksum, 16));
    digits[set >> 2] |= 8 >> (set & 3);
  }
  return {
    cases: counts,
    checksums: Object.fromEntries(Object.entries(words).map(([file, list]) => [file, hex(crc32(list))])),
    sets: [...digits].map((digit) => digit.toString(16)).join(""),
    verdict: Object.values(counts).some(([, failed]) => failed) ? "fail" : "pass",
  };
}

// The text, or null if the results are not those of all default cases.
export function digestText(suite, info, results, costs) {
  const whole = suite.golden !== null && suite.library === null && results.length === suite.cases.length;
  if (!whole || !results.some(({ status }) => status === "pass")) return null;
  const apiOf = ({ id }) => (id.split(".")[5] === "wgsl" ? "webgpu" : suite.api);
  const sets = new Map(suite.cases.map(({ id, set }) => [id, set]));
  const apis = {};
  for (const api of new Set(results.map(apiOf))) {
    apis[api] = partOf(results.filter((result) => apiOf(result) === api), sets, suite.sets);
  }
  const bad = results.filter(({ status }) => kBadStatuses.includes(status));
  const failed = bad.slice(0, kMostFailed).map(({ id }) => id);
  const device = { renderer: withoutBuilds(info.renderer), vendor: withoutBuilds(info.vendor) };
  for (;; failed.pop()) {
    const text = `${JSON.stringify(sorted({ apis, browser: withoutBuilds(info.browser), device, failed,
                                            format: kFormat, golden: suite.golden, ...(costs ? { costs } : {}), system: withoutBuilds(info.system),
                                            version: suite.version }))}\n`;
    if (text.length <= kMostDigestBytes) return text;
    if (!failed.length) return null;
  }
}

// "webgl2-linux-chrome-150-llvmpipe-89abcdef.json": what it is of, and a checksum, so that no two have the same.
export function digestName(text) {
  const { apis, browser, device, system } = JSON.parse(text);
  const words = [...Object.keys(apis), system, browser, device.renderer].join(" ").toLowerCase();
  const slug = words.replace(/[^a-z0-9]+/g, "-").slice(0, 80).replace(/^-|-$/g, "");
  const checksum = crc32([...text].map((character) => character.charCodeAt(0)), 1);
  return `${slug}-${hex(checksum)}.json`;
}
