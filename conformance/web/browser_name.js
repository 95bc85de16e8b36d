// A browser's own name, without the numbers of builds.

// The first name in the user agent. Browsers made of Chromium name it, too, and Chrome names Safari.
const kBrowsers = [["Edge", /\bEdgA?\/(\d+)/], ["Opera", /\bOPR\/(\d+)/],
                   ["Samsung Internet", /\bSamsungBrowser\/(\d+)/], ["Firefox", /\b(?:Firefox|FxiOS)\/(\d+)/], ["Chrome", /(?:Chrome|CriOS)\/(\d+)/],
                   ["Safari", /\bVersion\/(\d+).*\bSafari\//]];
const kSystems = [["Android", /Android/], ["iOS", /iPhone|iPad|iPod/], ["ChromeOS", /CrOS/], ["Windows", /Windows/],
                  ["macOS", /Mac OS X|Macintosh/], ["Linux", /Linux/]];

export function browserName(userAgent) {
  const [system] = kSystems.find(([, pattern]) => pattern.test(userAgent)) ?? ["unknown"];
  for (const [name, pattern] of kBrowsers) {
    const found = pattern.exec(userAgent);
    if (found) return { system, browser: `${name} ${found[1]}` };
  }
  return { system, browser: "unknown" };
}
