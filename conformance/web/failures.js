// The cases that are wrong, put together, and what they have in common: as in run/failures.hpp, in the same words.
import { kBadStatuses } from "./checks.js";

// As in failures.cpp.
const kMostCommon = 2;
const kMostNamed = 3;
const kSeparatedOfAll = 20;
const kToldOfGroup = 4;

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

function groupOf(rows, ran, traits) {
  const [first] = rows.map(({ result }) => result);
  const ofFunction = hasValues(first);
  const name = functionOf(first.id);
  const related = ofFunction ? ran.filter(({ result }) => functionOf(result.id) === name) : ran;
  const others = related.filter((row) => !isBad(row.result) && traits.every((trait) => has(trait, row)));
  const only = traitsOf(rows, others, kToldOfGroup)
                 .map(({ byAbsence, values }) => `${byAbsence ? "never" : "only"} ${listed(values)}`);
  const cases = (count) => (count === 1 ? "case" : "cases");
  const what = ofFunction ? `${rows.length} of ${related.length} ${cases(related.length)} of ${name}`
                          : `${rows.length} ${cases(rows.length)}: ${first.message.split("\n")[0]}`;
  return { status: first.status, ofFunction, text: only.length ? `${what} (${only.join(", ")})` : what,
           results: rows.map(({ result }) => result) };
}

// {failed, ran, common, groups}, of results and the texts that facets (Suite) has for their ids.
export function failuresOf(results, facets) {
  const ran = results.filter(({ status }) => status !== "unsupported")
                .map((result) => ({ result, facets: facets.get(result.id) }));
  const failed = ran.filter(({ result }) => isBad(result));
  const others = ran.filter(({ result }) => !isBad(result));
  const traits = traitsOf(failed, others, kSeparatedOfAll);
  const common = traits.map((trait) => sentenceOf(trait, others));
  const groups = grouped(failed).map((rows) => groupOf(rows, ran, traits));
  // A single group shows the common trait of its cases itself.
  if (failed.length > 1 && traits.length === 0 && (!others.length || groups.length > 1)) {
    common.push(others.length ? "The names of the failing cases have nothing in common." : "Every case that ran fails.");
  }
  return { failed: failed.length, ran: ran.length, common, groups };
}
