// The part of the page that offers a digest: it shows what will be sent, and sends nothing by itself.
import { kAddress } from "./address.js";
import { digestName } from "./digest.js";

// GitHub refuses longer addresses.
const kLongestAddress = 8000;

const place = (id) => document.getElementById(id);

// Where GitHub shows a new file of the project with this text, for its visitor to propose.
export function proposalAddress(text) {
  const parts = new URLSearchParams({ filename: digestName(text), value: text });
  return `${kAddress}/new/main/docs/measured/results/devices?${parts}`;
}

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    place("sent").textContent = "Copied.";
  } catch {
    // A page that is opened from a disk may not write there. Selected text can be copied by hand.
    getSelection().selectAllChildren(place("digest"));
    place("sent").textContent = "The browser does not let this page copy. The text is selected: copy it yourself.";
  }
}

// Nothing is offered without a text.
export function offerToSend(text) {
  if (text === null) return;
  place("digest").textContent = text;
  place("size").textContent = `${text.length.toLocaleString("en")} bytes`;
  place("copy").addEventListener("click", () => copy(text));
  place("save").href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  place("save").download = digestName(text);
  const address = proposalAddress(text);
  place("propose").href = address;
  place("propose").hidden = address.length > kLongestAddress;
  place("send").hidden = false;
}
