/// Which pages the book has, in the order of the course, and where each of them goes.
import fs from "node:fs";
import path from "node:path";

/// The pages of docs/ by what a reader does with them, in the order of the course; one that is not named here comes last.
const further = {
  "Use it": ["symptoms", "sandbox", "which_solver", "your_own_scene", "bodies_and_queries", "commands", "challenges"],
  Measure: ["hard_cases", "accuracy_and_time", "speed", "benchmark", "engines", "soak_and_fuzz"],
  Understand: ["notation", "engine", "methods"],
  Teach: ["teaching", "a_solver_of_your_own"],
  "Change it": ["architecture", "machinery"],
};
const start = ["before_you_start", "other_systems"];

/// A page of Markdown becomes a page of the same folder, so that what it names beside itself is beside it in the book, too.
export function addressOf(file) {
  if (path.posix.basename(file) === "README.md") return path.posix.join(path.posix.dirname(file), "index.html");
  return file.replace(/\.md$/, ".html");
}

/// From one page of the book to another file of it.
export function relative(from, to) {
  return path.posix.relative(path.posix.dirname(from), to);
}

/// The trunk of the course, which README.md lists: of each of its pages {file, name, branches}, the branches as files.
function trunkOf(text) {
  const rows = [...text.matchAll(/^\| \d+ \| \[(\d\d)[^\]]*\]\(([^)]+)\) \| \d+ \|(.*)\|$/gm)];
  return rows.map(([, name, file, rest]) => ({
    ...{ file, name },
    branches: [...rest.matchAll(/\]\(([^)]+)\)/g)].map(([, branch]) => branch),
  }));
}

/// [{file, part, chapter, parent, experiment}]: the pages that are read one after the other, and behind each chapter's its exercises
/// (`parent`). A chapter's README.md comes before its other pages. `part`: under which heading the contents have it; `experiment`:
/// what can be run on the page, where it is compiled for the browser.
export function outline(root) {
  const has = (file) => fs.existsSync(path.join(root, file));
  const names = (folder) => (has(folder) ? fs.readdirSync(path.join(root, folder)).sort() : []);
  const pagesIn = (folder) => names(folder).filter((name) => name.endsWith(".md"));
  const pages = [];
  const add = (part, file, more) => has(file) && pages.push({ file, part, ...more });
  const trunk = trunkOf(has("README.md") ? fs.readFileSync(path.join(root, "README.md"), "utf8") : "");
  const addOfChapter = (chapter, page) => {
    const file = `chapters/${chapter}/${page}`;
    const from = trunk.find(({ branches }) => branches.includes(file));
    const alone = trunk.some((page) => page.file === file) ? "The trunk" : "Chapters";
    add(from ? `Branches of ${from.name}` : alone, file, { chapter, experiment: chapter });
  };

  add("Start", "README.md", { experiment: "07_warm_start" }); // what its film shows
  for (const name of start) add("Start", `docs/${name}.md`);
  for (const page of pagesIn("docs/from_an_empty_file")) add("Start", `docs/from_an_empty_file/${page}`);
  for (const chapter of names("chapters").filter((name) => /^\d\d_/.test(name))) {
    const parent = `chapters/${chapter}/README.md`;
    addOfChapter(chapter, "README.md");
    for (const page of pagesIn(`chapters/${chapter}`).filter((name) => name !== "README.md"))
      addOfChapter(chapter, page);
    add("Exercises", `chapters/${chapter}/exercise/task.md`, { parent });
    add("Exercises", `chapters/${chapter}/exercise/transfer/task.md`, { parent });
  }
  for (const [part, docs] of Object.entries(further))
    for (const name of docs) add(part, `docs/${name}.md`, { experiment: name });
  for (const page of pagesIn("docs"))
    if (!pages.some(({ file }) => file === `docs/${page}`)) add("Change it", `docs/${page}`);
  add("Change it", "CONTRIBUTING.md");
  add("Change it", "CHANGELOG.md");
  for (const page of pagesIn("docs/results")) {
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
