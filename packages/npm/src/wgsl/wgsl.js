/** A function, a struct or a constant of WGSL, and those that it needs. */
export const definition = (code, ...needs) => ({ code, needs });

function collect(one, done) {
  if (done.has(one)) return;
  for (const need of one.needs) collect(need, done);
  done.add(one);
}

/** The text of these definitions and of all that they need, each once. */
export function wgsl(...definitions) {
  for (const one of definitions) {
    if (!Array.isArray(one?.needs)) throw new TypeError(`wgsl takes what you import from hashnoise/wgsl, such as hn_fbm2, not ${one}`);
  }
  const done = new Set();
  for (const one of definitions) collect(one, done);
  return [...done].map(({ code }) => code).join("");
}
