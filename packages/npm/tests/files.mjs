// Files as they are, without Vite, for pages.
import { createServer } from "node:http";
import { extname } from "node:path";

/** A server at a port of 127.0.0.1 of its own. `text` returns a path's file, or throws if there is no such file. */
export async function serve(text) {
  const server = createServer(async ({ url }, answer) => {
    const path = new URL(url, "http://localhost").pathname;
    const type = { ".html": "text/html", ".js": "text/javascript" }[extname(path)];
    const found = type && (await Promise.resolve(path).then(text).catch(() => null));
    answer.writeHead(found ? 200 : 404, { "Content-Type": type ?? "text/plain" }).end(found);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return server;
}
