// The page: runs the suite that it came with, and shows how it goes. If the suite names somebody to report to,
// hn-conform drives this browser and hears of every event before the next one happens.
import { kAddress } from "./address.js";
import { bad } from "./report.js";
import { resultsJson, showContext, showProgress, showResults, showStopped } from "./report.js";
import { NoContext } from "./renderer.js";
import { runSuite } from "./runner.js";
import { Suite, bytesOf } from "./suite.js";

// More often than this nobody can read.
const kMillisecondsBetweenProgress = 100;

async function tell(suite, event) {
  if (suite.reportTo === null) return;
  const answer = await fetch(suite.reportTo, { method: "POST", body: JSON.stringify(event) });
  if (!answer.ok) throw new Error(`hn-conform answers ${answer.status}`);
}

// A request that lasts as long as this page does: hn-conform sees from its end that the page is gone.
async function stayInTouch(suite) {
  if (suite.reportTo === null) return;
  const answer = await fetch("alive");
  const reader = answer.body.getReader();
  while (!(await reader.read()).done) ;
}

function shownVerdict() {
  return document.getElementById("verdict").textContent;
}

async function run(suite) {
  const results = [];
  let info = null;
  let shown = -Infinity;
  const start = performance.now();
  const stop = document.getElementById("stop");
  stop.hidden = false;
  stop.addEventListener("click", () => (stop.disabled = true));
  await runSuite(suite, {
    wantsMore: () => !stop.disabled,
    async ready(context) {
      info = context;
      showContext(info);
      await tell(suite, { type: "ready", ...info });
    },
    async started(id) {
      if (performance.now() - shown > kMillisecondsBetweenProgress) {
        shown = performance.now();
        showProgress(results, suite.cases.length, id, performance.now() - start);
      }
      await tell(suite, { type: "started", id });
    },
    async finished(result) {
      results.push(result);
      await tell(suite, { type: "finished", ...result });
    },
  });
  showResults(suite, info, results);
  if (kAddress) document.getElementById("send").href = `${kAddress}/issues/new?template=result.yml`;
  document.title = `${bad(results).length ? "✗" : "✓"} ${document.title}`;
  const found = document.getElementById("found").innerText;
  await tell(suite, { type: "done", verdict: shownVerdict(), found,
                      results: resultsJson(suite, info, results) });
}

// The suite is gzipped, and the bytes are written as base64: it is several megabytes of shaders and values.
async function suiteOfPage() {
  if (!("DecompressionStream" in window)) {
    throw new Error("the browser cannot unpack the suite (it has no DecompressionStream); any of 2023 or later can");
  }
  const packed = bytesOf(document.getElementById("suite").textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Suite(await new Response(stream).json());
}

async function main() {
  let suite;
  try {
    suite = await suiteOfPage();
  } catch (error) {
    showStopped("The page could not begin", error.message);
    return;
  }
  try {
    stayInTouch(suite).catch(() => {});
    await run(suite);
  } catch (error) {
    const without = error instanceof NoContext;
    showStopped(without ? `No ${suite.api === "webgpu" ? "WebGPU" : "WebGL2"} here` : "The page could not go on", error.message);
    await tell(suite, { type: "stopped", verdict: shownVerdict(), message: error.message });
  }
}

main();
