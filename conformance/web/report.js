// The results: results.json, and the page.
import { kBadStatuses, kStatuses, measureOf } from "./checks.js";

// All of them are in results.json.
const kMostCasesShown = 3;
const kMostOpen = 6;

export function count(results, status) {
  return results.filter((result) => result.status === status).length;
}

export function functionOf(id) {
  return id.split(".").slice(0, 2).join(".");
}

export function bad(results) {
  return results.filter((result) => kBadStatuses.includes(result.status));
}

// Something passed, and nothing was wrong.
export function asExpected(results) {
  return count(results, "pass") > 0 && bad(results).length === 0;
}

// It has the schema that hn-conform writes (docs/reference/formats.md). The page has the random points of seed 1.
export function resultsJson({ version, library, api, cases, golden }, info, results) {
  const notRun = cases.length - results.length; // since somebody has stopped the page
  const totals = Object.fromEntries(kStatuses.map((status) => [status, count(results, status)]));
  const date = new Date().toISOString().replace(/\.\d+Z$/, "Z");
  const tested = library === null ? {} : { library };
  const whole = golden === null ? {} : { golden };
  const run = { driver: api, ...info, seed: 1, ...tested, date, ...whole, totals, ...(notRun ? { not_run: notRun } : {}),
                as_expected: notRun === 0 && asExpected(results), cases: results };
  return JSON.stringify({ schema: 2, version, runs: [run] }, null, 1) + "\n";
}

// An element with attributes and children; what is text stays text.
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// On a phone each row becomes a block, each cell a line with its head, if it is to fold.
function table(heads, rows, kind = "table") {
  const head = element("tr", {}, ...heads.map((text) => element("th", {}, text)));
  const lines = rows.map((row) => element("tr", {}, ...row.map(
    (cell, i) => element("td", { "data-label": heads[i] }, String(cell)))));
  return element("div", { class: kind },
                 element("table", {}, element("thead", {}, head), element("tbody", {}, ...lines)));
}

function exampleTable(examples) {
  return table(["point", "inputs", "got", "expected"],
               examples.map(({ point, inputs, got, expected }) => [point, inputs, got, expected]), "table fold");
}

function wrongCase(result) {
  const parts = [element("h4", {}, element("code", {}, result.id))];
  if (result.samples) parts.push(element("p", {}, `${measureOf(result)}.`));
  // The message, unless the examples repeat it.
  if (result.examples.length && !result.message.startsWith("first at")) parts.push(element("p", {}, result.message));
  parts.push(result.examples.length ? exampleTable(result.examples) : element("pre", {}, result.message));
  return element("article", {}, ...parts);
}

const hasValues = ({ status, mismatches }) => status === "fail" && mismatches !== 0;

// The wrong cases in groups: wrong values of a function, or cases with one message.
function groupsOf(results) {
  const groups = new Map();
  for (const result of bad(results)) {
    const key = hasValues(result) ? functionOf(result.id) : `${result.status}\n${result.message}`;
    groups.set(key, [...(groups.get(key) ?? []), result]);
  }
  return [...groups.values()];
}

// A group in the words of FailureGroup (run/failures.hpp). Equal texts are shown once.
function wrongGroup(group, ran, open) {
  const [{ id, status, message }] = group;
  const ofFunction = hasValues(group[0]);
  const all = ofFunction ? ran.filter((result) => functionOf(result.id) === functionOf(id)).length : group.length;
  const cases = `${all} ${all === 1 ? "case" : "cases"}`;
  const text = ofFunction ? `${group.length} of ${cases} of ${functionOf(id)}` : `${cases}: ${message.split("\n")[0]}`;
  const shown = group.slice(0, ofFunction ? kMostCasesShown : 1);
  const left = group.length - shown.length;
  const parts = [element("summary", {}, element("span", { class: "bad" }, status), ` ${text}`), ...shown.map(wrongCase)];
  if (left) parts.push(element("p", { class: "faint" }, `${left} more, in results.json.`));
  return element("details", { class: "group", ...(open ? { open: "" } : {}) }, ...parts);
}

function wrongParts(results) {
  const ran = results.filter(({ status }) => status !== "unsupported");
  return [element("h2", {}, "Failures, and their places"),
          element("p", {}, `${bad(results).length} of ${ran.length} cases are wrong.`),
          ...groupsOf(results).map((group, place) => wrongGroup(group, ran, place < kMostOpen))];
}

// The largest difference from a golden value, by function.
function largestDifferences(results) {
  const largest = new Map();
  for (const { id, max_abs } of results) {
    if (!id.endsWith(".golden") || max_abs === 0) continue;
    const name = functionOf(id);
    largest.set(name, Math.max(largest.get(name) ?? 0, max_abs));
  }
  return [...largest].map(([name, value]) => [name, value.toExponential(1)]);
}

function byReason(results, status) {
  const reasons = new Map();
  for (const result of results) {
    if (result.status === status) reasons.set(result.message, [...(reasons.get(result.message) ?? []), result.id]);
  }
  return [...reasons].map(([reason, ids]) => [ids.length > 1 ? `${ids[0]} and ${ids.length - 1} more` : ids[0], reason]);
}

function totalsText(results) {
  const parts = kStatuses.map((status) => [status, count(results, status)]).filter(([, number]) => number > 0);
  return parts.map(([status, number]) => `${number} ${status}`).join(", ");
}

// --- The meaning of failures for writers of shaders, in sentences ---

const kMostNamedInMeaning = 6;

function someOf(names) {
  const shown = names.slice(0, kMostNamedInMeaning).join(", ");
  return names.length > kMostNamedInMeaning ? `${shown} and ${names.length - kMostNamedInMeaning} more` : shown;
}

// The subject of a case, for the sentence on its failure.
function kindOf(id) {
  const [file, name, , arithmetic] = id.split(".");
  if (file === "bugs") return "driver";
  if (name === "all" || file === "config") return "text";
  return arithmetic === "precise" ? "fast" : arithmetic;
}

const kSentences = {
  exact: (names) => `Hashes or random numbers are wrong here, in ${names}. ` +
                    "Worlds made of them differ from those on other devices.",
  fixed: (names) => `With HN_FIXED these have other bits here than on other devices: ${names}. ` +
                    "Do not compare them between devices.",
  fast: (names) => `With floats these are off by more than their bounds allow: ${names}. They may look wrong here.`,
  text: (names) => `This browser does not take the text of the library as it should, in ${names}.`,
  driver: (names) => `The driver has faults that other shaders may meet as well: ${names}.`,
};

// Something passed, or there is nothing to report.
function meaningsOf(results) {
  const wrong = bad(results);
  if (!wrong.length) {
    return ["Hashes, and noise with HN_FIXED, have the same bits here as everywhere, and floats keep to their bounds. " +
            "Shaders need nothing special on this device."];
  }
  return Object.entries(kSentences).flatMap(([kind, sentence]) => {
    const names = [...new Set(wrong.filter(({ id }) => kindOf(id) === kind).map(({ id }) => functionOf(id)))];
    return names.length ? [sentence(someOf(names))] : [];
  });
}

// --- The page ---

const place = (id) => document.getElementById(id);

function setVerdict(text, kind) {
  place("verdict").textContent = text;
  place("verdict").className = kind;
}

export function showContext(info) {
  place("renderer").textContent = `${info.renderer} (${info.vendor})`;
  place("versions").textContent = `${info.gl_version}; ${info.glsl_version}`;
}

// Below this the mean of the cases so far does not predict the others.
const kEnoughToEstimate = 20;

// As "2:05 left": what the cases that are left take if they take as long as those before.
function timeLeft(done, total, milliseconds) {
  if (done < kEnoughToEstimate) return "";
  const seconds = Math.ceil((milliseconds / done) * (total - done) / 1000);
  return `, about ${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")} left`;
}

export function showProgress(results, total, current, milliseconds) {
  const wrong = bad(results).length;
  const left = timeLeft(results.length, total, milliseconds);
  setVerdict(`Checking ${results.length + 1} of ${total}${wrong ? `, ${wrong} failed` : ""}${left} …`, wrong ? "bad" : "");
  place("progress").max = total;
  place("progress").value = results.length;
  place("current").textContent = current;
}

// Nothing can be checked, or no further.
export function showStopped(title, message) {
  setVerdict(title, "bad");
  place("stop").hidden = true;
  place("progress").remove();
  place("current").textContent = message;
}

export function showResults(suite, info, results) {
  const good = asExpected(results);
  const total = suite.cases.length;
  const stopped = results.length === total ? "" : `, stopped after ${results.length} of ${total}`;
  setVerdict((good ? "All as expected" : "NOT AS EXPECTED") + stopped, !good ? "bad" : stopped ? "" : "good");
  const samples = results.reduce((sum, result) => sum + result.samples, 0);
  place("stop").hidden = true;
  place("progress").remove();
  place("current").textContent = `${totalsText(results)}; ${samples.toLocaleString("en")} values compared`;
  offer(resultsJson(suite, info, results));
  if (count(results, "pass")) place("meaning").append(...meaningsOf(results).map((text) => element("p", {}, text)));
  const found = place("found");
  if (bad(results).length) found.append(...wrongParts(results));
  for (const [status, title] of [["warning", "Warnings"], ["unsupported", "Not supported here"]]) {
    const reasons = byReason(results, status).map(
      ([ids, reason]) => element("section", {}, element("h3", {}, ids), element("p", {}, reason)));
    if (reasons.length) found.append(element("h2", {}, title), ...reasons);
  }
  const differences = largestDifferences(results);
  if (differences.length) {
    found.append(element("h2", {}, "Largest difference from the exact values"),
                 table(["function", "difference"], differences));
  }
  found.append(element("details", {}, element("summary", {}, "Every case"),
                       table(["case", "status", "values"], results.map((r) => [r.id, r.status, r.samples]))));
}

function offer(json) {
  const link = place("download");
  link.href = URL.createObjectURL(new Blob([json], { type: "application/json" }));
  place("offer").hidden = false;
}
