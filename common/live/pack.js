// pack.js NAME LOADER WASM OUT: what a page loads to play a chapter, as one script, which also works from a folder: the
// loader and, in base64, the program.
const fs = require("fs");

const [name, loader, wasm, out] = process.argv.slice(2);
const program = fs.readFileSync(wasm).toString("base64");
const text = `"use strict";
(function () {
${fs.readFileSync(loader, "utf8")}
(self.PUSHBACK_LIVE_CHAPTERS = self.PUSHBACK_LIVE_CHAPTERS || {})[${JSON.stringify(name)}] = {
  create: createPushbackLive,
  program: "${program}",
};
})();
`;
fs.writeFileSync(out, text);
