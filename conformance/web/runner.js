// Runs the cases one after the other, over lost contexts.
import { kBadStatuses, outcomeWith, runCase } from "./checks.js";
import { NoContext, Renderer, openContext } from "./renderer.js";
import { openDevice } from "./webgpu.js";

// A context that is gone may come back when the browser has started its GPU process again.
const kNewContextTries = 50;
const kMillisecondsBetweenTries = 200;
// A browser reports a lost context in a task of its own, after the call that could not be answered.
const kMillisecondsUntilLossIsReported = 100;

const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

// Lets the browser draw and answer. Timers would be held back to one per second in a tab that nobody sees.
function breathe() {
  return new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage(null);
  });
}

// The first name in the user agent. Browsers made of Chromium name it, too, and Chrome names Safari.
const kBrowsers = [["Edge", /\bEdgA?\/(\d+)/], ["Opera", /\bOPR\/(\d+)/],
                   ["Samsung Internet", /\bSamsungBrowser\/(\d+)/], ["Firefox", /\b(?:Firefox|FxiOS)\/(\d+)/], ["Chrome", /(?:Chrome|CriOS)\/(\d+)/],
                   ["Safari", /\bVersion\/(\d+).*\bSafari\//]];
const kSystems = [["Android", /Android/], ["iOS", /iPhone|iPad|iPod/], ["ChromeOS", /CrOS/], ["Windows", /Windows/],
                  ["macOS", /Mac OS X|Macintosh/], ["Linux", /Linux/]];

// Its own name, without the numbers of builds.
function browserName(userAgent) {
  const [system] = kSystems.find(([, pattern]) => pattern.test(userAgent)) ?? ["unknown"];
  for (const [name, pattern] of kBrowsers) {
    const found = pattern.exec(userAgent);
    if (found) return { system, browser: `${name} ${found[1]}` };
  }
  return { system, browser: "unknown" };
}

// Opens another one, until there is one that is not lost at once.
async function reopened(open) {
  for (let tries = 1; ; ++tries) {
    try {
      const found = await open();
      if (!found.isLost()) return found;
    } catch (error) {
      if (!(error instanceof NoContext) || tries >= kNewContextTries) throw error;
    }
    if (tries >= kNewContextTries) throw new NoContext("every new context is lost at once");
    await wait(kMillisecondsBetweenTries);
  }
}

const kOpen = { webgl2: () => new Renderer(openContext()), webgpu: openDevice };

// listener: async ready(info), started(id) and finished(result); wantsMore(), which is called before each case. Throws
// NoContext if there is none.
export async function runSuite(suite, listener) {
  // The renderers of the APIs; null where one was lost. The page cannot do without its own.
  const renderers = { [suite.api]: await kOpen[suite.api]() };
  await listener.ready({ ...renderers[suite.api].describe(), ...browserName(navigator.userAgent) });
  for (const test of suite.cases) {
    if (!listener.wantsMore()) return;
    const api = suite.apiOf(test);
    await listener.started(test.id);
    let outcome;
    try {
      if (!(api in renderers)) renderers[api] = await kOpen[api]();
      else renderers[api] ??= await reopened(kOpen[api]);
    } catch (error) {
      if (!(error instanceof NoContext) || api === suite.api) throw error;
      outcome = outcomeWith("unsupported", error.message);
    }
    const start = performance.now();
    outcome ??= await runCase(renderers[api], suite, test);
    const seconds = (performance.now() - start) / 1000;
    if (kBadStatuses.includes(outcome.status)) await wait(kMillisecondsUntilLossIsReported);
    if (renderers[api]?.isLost()) {
      outcome = outcomeWith("crash", "the context was lost");
      renderers[api] = null;
    }
    await listener.finished({ id: test.id, ...outcome, seconds });
    await breathe();
  }
}
