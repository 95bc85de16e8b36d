// The meaning of failures for writers of shaders, in sentences.
import { kBadStatuses } from "./checks.js";
import { functionOf } from "./failures.js";

const kMostNamed = 6;

function listed(names) {
  const shown = names.slice(0, kMostNamed).join(", ");
  return names.length > kMostNamed ? `${shown} and ${names.length - kMostNamed} more` : shown;
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
export function meaningsOf(results) {
  const wrong = results.filter(({ status }) => kBadStatuses.includes(status));
  if (!wrong.length) {
    return ["Hashes, and noise with HN_FIXED, have the same bits here as everywhere, and floats keep to their bounds. " +
            "Shaders need nothing special on this device."];
  }
  return Object.entries(kSentences).flatMap(([kind, sentence]) => {
    const names = [...new Set(wrong.filter(({ id }) => kindOf(id) === kind).map(({ id }) => functionOf(id)))];
    return names.length ? [sentence(listed(names))] : [];
  });
}
