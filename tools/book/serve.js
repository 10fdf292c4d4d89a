/// Shows a folder on this machine alone: node tools/book/serve.js [FOLDER] [PORT].
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";

const types = {
  ".css": "text/css",
  ".csv": "text/csv",
  ".html": "text/html",
  ".js": "text/javascript",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".webp": "image/webp",
  ".woff2": "font/woff2",
};

/// The server of a folder, listening on the loopback address; port 0: any that is free.
export async function serve(folder, port = 0) {
  const server = http.createServer((request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    let file = path.join(folder, path.posix.normalize(decodeURIComponent(pathname)));
    if (pathname.endsWith("/")) file = path.join(file, "index.html");
    fs.readFile(file, (error, content) => {
      const type = (!error && types[path.extname(file)]) || (error ? types[".html"] : "application/octet-stream");
      response.writeHead(error ? 404 : 200, { "Content-Type": `${type}; charset=utf-8`, "Cache-Control": "no-store" });
      if (!error) return response.end(content);
      fs.readFile(path.join(folder, "404.html"), (none, page) =>
        response.end(none ? "There is no such page.\n" : page),
      );
    });
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
