/// Which pages the book has, in the order of the course, and where each of them goes.
import fs from "node:fs";
import path from "node:path";

/// The pages of docs/ in the order of the course; one that is not named here comes last.
const further = [
  "symptoms",
  "challenges",
  "which_solver",
  "your_own_scene",
  "bodies_and_queries",
  "notation",
  "hard_cases",
  "accuracy_and_time",
  "benchmark",
  "methods",
  "speed",
  "soak_and_fuzz",
  "engine",
  "architecture",
  "machinery",
  "teaching",
  "a_solver_of_your_own",
  "commands",
  "other_systems",
];

/// A page of Markdown becomes a page of the same folder, so that what it names beside itself is beside it in the book, too.
export function addressOf(file) {
  if (path.posix.basename(file) === "README.md") return path.posix.join(path.posix.dirname(file), "index.html");
  return file.replace(/\.md$/, ".html");
}

/// From one page of the book to another file of it.
export function relative(from, to) {
  return path.posix.relative(path.posix.dirname(from), to);
}

/// [{file, part, chapter, parent, experiment}]: the pages that are read one after the other, and behind each chapter's its exercises
/// (`parent`). A chapter's README.md comes before its other pages. `experiment`: what can be run on the page, where it is compiled for the browser.
export function outline(root) {
  const has = (file) => fs.existsSync(path.join(root, file));
  const names = (folder) => (has(folder) ? fs.readdirSync(path.join(root, folder)).sort() : []);
  const place = (name) => (further.includes(name) ? further.indexOf(name) : further.length);
  const pages = [];
  const add = (part, file, more) => has(file) && pages.push({ file, part, ...more });

  add("Start", "README.md", { experiment: "07_warm_start" }); // what its film shows
  add("Start", "docs/before_you_start.md");
  for (const page of names("docs/from_an_empty_file").filter((name) => name.endsWith(".md")))
    add("Start", `docs/from_an_empty_file/${page}`);
  for (const chapter of names("chapters").filter((name) => /^\d\d_/.test(name))) {
    const parent = `chapters/${chapter}/README.md`;
    add("Chapters", parent, { chapter, experiment: chapter });
    for (const page of names(`chapters/${chapter}`).filter((name) => name.endsWith(".md") && name !== "README.md"))
      add("Chapters", `chapters/${chapter}/${page}`, { chapter, experiment: chapter });
    add("Exercises", `chapters/${chapter}/exercise/task.md`, { parent });
    add("Exercises", `chapters/${chapter}/exercise/transfer/task.md`, { parent });
  }
  const docs = names("docs")
    .filter((name) => name.endsWith(".md") && name !== "before_you_start.md")
    .map((name) => name.slice(0, -3));
  for (const name of docs.sort((a, b) => place(a) - place(b))) add("Further", `docs/${name}.md`, { experiment: name });
  add("Further", "CONTRIBUTING.md");
  add("Further", "CHANGELOG.md");
  for (const page of names("docs/results").filter((name) => name.endsWith(".md"))) {
    const file = `docs/results/${page}`;
    const above = /\]\(\.\.\/(\w+\.md)/.exec(fs.readFileSync(path.join(root, file), "utf8"))[1]; // its first link
    add("Tables", file, { parent: `docs/${above}` });
  }
  add("Tables", "renders/hard_cases/table.md", { parent: "docs/hard_cases.md", title: "All cases under all stages" });
  add("Tables", "renders/hard_cases/peers.md", {
    parent: "docs/hard_cases.md",
    title: "All cases under other engines",
  });
  add("Tables", "renders/19_accuracy_and_time/frozen.md", {
    parent: "docs/accuracy_and_time.md",
    title: "Contact problems, solved to a residual",
  });
  return pages;
}

/// From a page of the book to its folder.
export const toRoot = (address) => relative(address, ".") || ".";
