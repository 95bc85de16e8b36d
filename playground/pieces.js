// The functions that pictures call, as tools/pick writes them in each language: as pieces, from which a picture takes those
// that it needs (tools/lib/ship/playground/picks.py).
import { unpackedLzma } from "./lzma.js";

const kShading = ["glsl", "hlsl", "metal", "godot", "wgsl"];
// The languages that have their functions by other names than C.
const kNamed = {
  rust: (name) => name.replace(/^hn_/, ""),
  java: (name) => camel(name.replace(/^hn_/, "")),
  javascript: (name) => camel(name.replace(/^hn_/, "")),
  csharp: (name) => pascal(name.replace(/^hn_/, "")),
  go: (name) => pascal(name.replace(/^hn_/, "")),
};
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const pascal = (name) => camel(`_${name}`);

const kDigitsOf85 = new Map(
  [..."0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%,()*+-;.=>?@^_:{|}~"].map((digit, at) => [digit, at]),
);
// Five digits are four bytes, and the last ones so many bytes fewer as there are digits fewer.
export function bytesOf(digits) {
  const count = Math.floor((digits.length * 4) / 5);
  const view = new DataView(new ArrayBuffer(count + 4));
  for (let from = 0, to = 0; from < digits.length; from += 5, to += 4) {
    let word = 0;
    for (let at = from; at < from + 5; ++at) word = word * 85 + (kDigitsOf85.get(digits[at]) ?? 84);
    view.setUint32(to, word);
  }
  return new Uint8Array(view.buffer, 0, count);
}

// The content of a text in the page: JSON, as the number of its bytes, a blank, and LZMA in digits to the base of 85.
export async function unpacked(text) {
  const [size, digits] = text.trim().split(" ");
  return JSON.parse(new TextDecoder().decode(await unpackedLzma(bytesOf(digits), Number(size))));
}

export class Pieces {
  // pieces: [name, text, name, text, ...]; shells: {language: [first lines, last lines]}; modules: {"glsl fast lattice 2":
  // [how much further a piece is than the one before]}.
  constructor({ pieces, shells, modules }) {
    this.pieces = pieces;
    this.shells = shells;
    this.modules = modules;
    this.words = new Map(); // of pieces, by their texts
  }

  wordsOf(text) {
    if (!this.words.has(text)) this.words.set(text, new Set(text.match(/[A-Za-z_]\w*/g)));
    return this.words.get(text);
  }

  module(setting) {
    let number = 0;
    return this.modules[setting.join(" ")].map((step) => {
      number += step;
      return { name: this.pieces[2 * number], text: this.pieces[2 * number + 1] };
    });
  }

  // The texts of these functions and of all that they need. Calls within shading languages are read from the text in WGSL,
  // which has no overloads; the modules of one setting have the same pieces in the same order.
  texts(names, language, ...rest) {
    const own = this.module([language, ...rest]);
    const read = kShading.includes(language) ? this.module(["wgsl", ...rest]) : own;
    const called = kShading.includes(language) ? read.map(({ text, name }) => nameInWgsl(text) ?? name) : own.map(({ name }) => name);
    const numbers = new Map(called.map((name, at) => [name, at]));
    const needed = new Set();
    const need = (at) => {
      if (at === undefined || needed.has(at)) return;
      needed.add(at);
      for (const word of this.wordsOf(read[at].text)) need(numbers.get(word));
    };
    for (const name of names) {
      const at = numbers.get((kNamed[language] ?? String)(name));
      if (at === undefined) throw new Error(`There is no ${name} in ${language}.`);
      need(at);
    }
    return own.filter((_, at) => needed.has(at)).map(({ text }) => text);
  }
}

const nameInWgsl = (text) => /^(?:fn|struct) (\w+)/.exec(text)?.[1];

export const named = (language, name) => (kNamed[language] ?? String)(name);
