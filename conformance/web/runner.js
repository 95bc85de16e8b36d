// Runs the cases one after the other, over lost contexts.
import { kBadStatuses, outcomeWith, runCase } from "./checks.js";
import { NoContext, Renderer, describe, openContext } from "./renderer.js";

// A context that is gone may come back when the browser has started its GPU process again.
const kNewContextTries = 50;
const kMillisecondsBetweenTries = 200;
// A browser tells of a lost context in a task of its own, after the call that could not be answered.
const kMillisecondsUntilLossIsTold = 100;

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

async function newContext() {
  for (let tries = 1; ; ++tries) {
    try {
      const gl = openContext();
      if (!gl.isContextLost()) return gl;
    } catch (error) {
      if (!(error instanceof NoContext) || tries >= kNewContextTries) throw error;
    }
    if (tries >= kNewContextTries) throw new NoContext("every new context is lost at once");
    await wait(kMillisecondsBetweenTries);
  }
}

// listener: async ready(info), started(id), finished(result). Throws NoContext if there is none.
export async function runSuite(suite, listener) {
  let gl = openContext();
  let renderer = new Renderer(gl);
  await listener.ready(describe(gl));
  for (const test of suite.cases) {
    await listener.started(test.id);
    if (gl === null) {
      gl = await newContext();
      renderer = new Renderer(gl);
    }
    const start = performance.now();
    let outcome = runCase(renderer, suite, test);
    const seconds = (performance.now() - start) / 1000;
    if (kBadStatuses.includes(outcome.status)) await wait(kMillisecondsUntilLossIsTold);
    if (gl.isContextLost()) {
      outcome = outcomeWith("crash", "the context was lost");
      gl = null;
    }
    await listener.finished({ id: test.id, ...outcome, seconds });
    await breathe();
  }
}
