/// Shows a folder on this machine alone: node tools/book/serve.js [FOLDER] [PORT].
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";

const types = { ".css": "text/css", ".html": "text/html", ".js": "text/javascript", ".svg": "image/svg+xml" };

/// The server of a folder, listening on the loopback address; port 0: any that is free.
export async function serve(folder, port = 0) {
  const server = http.createServer((request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    const wanted = path.join(folder, path.posix.normalize(decodeURIComponent(pathname)));
    const file = pathname.endsWith("/") ? path.join(wanted, "index.html") : wanted;
    const isFile = (name) => fs.statSync(name, { throwIfNoEntry: false })?.isFile();
    const shown = [file, path.join(folder, "404.html")].find(isFile);
    const type = types[path.extname(shown ?? "")];
    response.writeHead(isFile(file) ? 200 : 404, type && { "Content-Type": `${type}; charset=utf-8` });
    response.end(shown && fs.readFileSync(shown));
  });
  await new Promise((resolve, reject) => server.once("error", reject).listen(port, "127.0.0.1", resolve));
  return server;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const folder = process.argv[2] ?? "build/book";
  const wanted = Number(process.argv[3] ?? 8000);
  const server = await serve(folder, wanted).catch(() => serve(folder)); // taken: any that is free
  console.log(`the book: http://127.0.0.1:${server.address().port}/   (Ctrl-C ends it)`);
}
