// The cases that are wrong, put together, and what they have in common: as in run/failures.hpp, in the same words.
import { kBadStatuses } from "./checks.js";

// As in failures.cpp.
const kMostCommon = 2;
const kMostNamed = 3;
const kSeparatedOfAll = 20;
const kToldOfGroup = 4;
// The places of facets.
const [kKind, kDimension, kCheck] = [0, 1, 10];

export function functionOf(id) {
  return id.split(".").slice(0, 2).join(".");
}

function isBad(result) {
  return kBadStatuses.includes(result.status);
}

function listed(values) {
  const list = [...values].sort();
  const last = list.pop();
  return list.length ? `${list.join(", ")} or ${last}` : last;
}

function valuesIn(rows, facet) {
  return new Set(rows.map((row) => row.facets[facet]));
}

function has(trait, row) {
  return trait.values.has(row.facets[trait.facet]) !== trait.byAbsence;
}

// A common trait of the failed cases in a facet: they have one of few values, or all but one.
function traitOf(facet, failed, others) {
  const wrong = valuesIn(failed, facet);
  if (wrong.has("")) return null;
  const good = valuesIn(others, facet);
  for (const value of ["", ...wrong]) good.delete(value);
  if (good.size === 0) return null;
  if (wrong.size <= kMostCommon) return { facet, byAbsence: false, values: wrong };
  return good.size === 1 ? { facet, byAbsence: true, values: good } : null;
}

// The traits that together separate the failed cases from most of the others. One value is simpler than two.
function traitsOf(failed, others, share) {
  const chosen = [];
  while (failed.length > 1 && others.length > 0) {
    let best = null;
    let bestScore = 0;
    for (let facet = 0; facet < failed[0].facets.length; ++facet) {
      const trait = traitOf(facet, failed, others);
      const separated = trait ? others.filter((row) => !has(trait, row)).length : 0;
      if (separated <= Math.floor(others.length / share)) continue;
      const score = separated / trait.values.size;
      if (score <= bestScore) continue;
      bestScore = score;
      best = trait;
    }
    if (best === null) break;
    others = others.filter((row) => has(best, row));
    chosen.push(best);
  }
  return chosen;
}

function successOf(rows, which, one) {
  if (rows.some(({ result }) => result.status === "warning")) return `none of the ${rows.length} ${which} fails`;
  return rows.length === 1 ? `the ${one} passes` : `all ${rows.length} ${which} pass`;
}

function sentenceOf(trait, others) {
  let apart = others.filter((row) => !has(trait, row));
  if (trait.byAbsence) {
    return `No failing case is ${listed(trait.values)}; ${successOf(apart, "such cases", "one such case")}.`;
  }
  const good = valuesIn(apart, trait.facet);
  good.delete("");
  let [which, one] = ["others", "other one"];
  if (good.size <= kMostNamed) {
    apart = apart.filter((row) => row.facets[trait.facet] !== "");
    which = listed(good);
    one = `one ${which}`;
  }
  return `Every failing case is ${listed(trait.values)}; ${successOf(apart, which, one)}.`;
}

// The number of the layer, from below, or -1 for files as a whole and for settings.
function layerOf({ facets }) {
  const layers = [["of what drivers are known to get wrong"], ["of hashes"], ["of gradients", "of positions"], [],
                  ["of octave sums"]];
  return facets[kKind].endsWith(" noise") ? 3 : layers.findIndex((kinds) => kinds.includes(facets[kKind]));
}

// The cases with wrong values in the lowest layer that has any.
function lowestLayer(failed) {
  const held = failed.filter((row) => hasValues(row.result) && layerOf(row) >= 0 &&
                                      (layerOf(row) === 0 || row.facets[kCheck] === ""));
  const lowest = Math.min(...held.map(layerOf));
  return held.filter((row) => layerOf(row) === lowest);
}

// Where to begin; nothing unless most of the other failures are of what is made of this layer.
function beginning(lowest, failed) {
  if (!lowest.length) return [];
  const layer = layerOf(lowest[0]);
  const others = failed.filter((row) => layerOf(row) !== layer);
  const dimensions = valuesIn(lowest, kDimension);
  const ofAny = layer === 0 || dimensions.has("");
  const above = others.filter((row) => layerOf(row) >= 0 && (ofAny || dimensions.has(row.facets[kDimension]))).length;
  if (2 * above <= others.length) return [];
  const names = [...new Set(lowest.map(({ result }) => functionOf(result.id)))];
  const more = names.length > kMostNamed ? ` and ${names.length - kMostNamed} more` : "";
  const why = layer === 0 ? "a few lines without the library" : "the lowest layer that fails";
  return [`Begin with ${names.slice(0, kMostNamed).join(", ")}${more}, ${why}: ` +
          `${above} of ${others.length} other failures may follow.`];
}

function nothingInCommon(passed, others) {
  if (others.length) return "The names of the failing cases have nothing in common.";
  if (!passed) return "Every case that ran fails.";
  return "Every case that compares with right values fails; " +
         `the ${passed === 1 ? "one that passes compares" : `${passed} that pass compare`} the driver with itself.`;
}

function hasValues(result) {
  return result.status === "fail" && result.mismatches !== 0;
}

function grouped(failed) {
  const groups = new Map();
  for (const row of failed) {
    const { result } = row;
    const key = hasValues(result) ? functionOf(result.id) : `${result.status}\n${result.message}`;
    groups.set(key, [...(groups.get(key) ?? []), row]);
  }
  return [...groups.values()];
}

function groupOf(rows, ran, held, traits) {
  const [first] = rows.map(({ result }) => result);
  const ofFunction = hasValues(first);
  const name = functionOf(first.id);
  const related = (all) => (ofFunction ? all.filter(({ result }) => functionOf(result.id) === name) : all);
  const others = related(held).filter((row) => traits.every((trait) => has(trait, row)));
  const only = traitsOf(rows, others, kToldOfGroup)
                 .map(({ byAbsence, values }) => `${byAbsence ? "never" : "only"} ${listed(values)}`);
  const cases = (count) => (count === 1 ? "case" : "cases");
  const all = related(ran).length;
  const what = ofFunction ? `${rows.length} of ${all} ${cases(all)} of ${name}`
                          : `${rows.length} ${cases(rows.length)}: ${first.message.split("\n")[0]}`;
  return { status: first.status, ofFunction, text: only.length ? `${what} (${only.join(", ")})` : what,
           results: rows.map(({ result }) => result) };
}

// {failed, ran, common, groups}, of results and the texts that facets (Suite) has for their ids.
export function failuresOf(results, facets) {
  const ran = results.filter(({ status }) => status !== "unsupported")
                .map((result) => ({ result, facets: facets.get(result.id) }));
  const failed = ran.filter(({ result }) => isBad(result));
  const failingChecks = valuesIn(failed, kCheck).add("");
  const others = ran.filter((row) => !isBad(row.result) && failingChecks.has(row.facets[kCheck]));
  const traits = traitsOf(failed, others, kSeparatedOfAll);
  const lowest = lowestLayer(failed);
  const common = [...beginning(lowest, failed), ...traits.map((trait) => sentenceOf(trait, others))];
  const isLow = (rows) => rows.some((row) => lowest.includes(row));
  const all = grouped(failed);
  const groups = [...all.filter(isLow), ...all.filter((rows) => !isLow(rows))]
                   .map((rows) => groupOf(rows, ran, others, traits));
  // A single group shows the common trait of its cases itself.
  if (failed.length > 1 && !common.length && (!others.length || groups.length > 1)) {
    common.push(nothingInCommon(ran.length - failed.length, others));
  }
  return { failed: failed.length, ran: ran.length, common, groups };
}
