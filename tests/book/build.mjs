/// What the book makes of a page, and what it refuses, with the file and the line.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { readBook, stillOf } from "../../tools/book/book.js";
import { home as root } from "../../tools/book/experiments.js";
import { addressOf } from "../../tools/book/outline.js";
import { pagesOf } from "../../tools/book/pages.js";

const header = "#pragma once\n\nstruct Clamping {\n  int least = 0;\n};\n";
const picture = '<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10"></svg>';

/// A project of a front page and one chapter with this text below its title.
function project(text) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "book-"));
  const write = (file, content) => {
    fs.mkdirSync(path.dirname(path.join(folder, file)), { recursive: true });
    fs.writeFileSync(path.join(folder, file), content);
  };
  write("README.md", "# Front\n\n## A part\n\n[one](chapters/01_one/README.md)\n");
  write("chapters/01_one/README.md", `# 01 One\n\n${text}\n`);
  write("chapters/01_one/one.h", header);
  write("chapters/01_one/more/two.cpp", '#include "pushback/chapters/01_one/one.h"\n');
  write("docs/figures/one.svg", picture);
  write("tests/one.cpp", "int tested() {\n  return 1;\n}\n");
  write("renders/one.csv", "1\n");
  return folder;
}

const chapterOf = (text) => readBook(project(text)).pages.find(({ chapter }) => chapter);
const htmlOf = (text) => chapterOf(text).html.replace(/^.*<\/h1>\s*/s, "");

function refused(text, line, message) {
  assert.throws(
    () => readBook(project(text)),
    (error) => {
      assert.ok(error.message.includes(`chapters/01_one/README.md:${line}: ${message}`), error.message);
      return true;
    },
  );
}

test("broken links, anchors, pictures, formulas and quoted code are refused with file and line, all of them at once", () => {
  refused("[a](nowhere.md)", 3, "the link to nowhere.md: there is no such file");
  refused("one\ntwo [a](../../README.md#no-part)", 4, "the link to README.md#no-part: there is no such heading");
  refused("[a](#no-part)", 3, "the link to chapters/01_one/README.md#no-part: there is no such heading");
  refused("[a](one.h#L3)", 3, "the link to one.h#L3: an anchor in what is no page");
  refused("[a](../../../etc/passwd)", 3, "the link to ../../../etc/passwd: there is no such file");
  refused("[a](https:/x)", 3, "no address has the form https:/x");
  refused(
    '<details><summary>\n<a href="nowhere.h">a</a></summary>\n\n</details>',
    4,
    "the link to nowhere.h: there is no such file",
  );
  refused("![seen](../../docs/figures/two.svg)", 3, "the link to ../../docs/figures/two.svg: there is no such file");
  refused("![](../../docs/figures/one.svg)", 3, "the picture ../../docs/figures/one.svg has no alternative text");
  refused("one\n\n$$\\frac{a}$$", 5, "the formula $\\frac{a}$ is none: ");
  refused("one $\\nosuch$", 3, "the formula $\\nosuch$ is none: ");
  for (const text of [
    'one <!-- set: scene="x" -->two',
    "one <!-- /set -->two",
    'one\n\n<!-- set: scene="x" -->two<!-- /set -->',
  ])
    refused(
      text,
      text.includes("\n") ? 5 : 3,
      'a mark "set" stands within a line, has its words, and then <!-- /set -->',
    );
  refused("it costs $5", 3, "a dollar sign that belongs to no formula: it costs $5");
  assert.throws(() => readBook(project("[a](b.md) [c](d.md)")), /b\.md.*\n.*d\.md/);
});

test("the command names what is wrong, ends with 1, and writes nothing", () => {
  const folder = project("[a](nowhere.md)");
  const run = spawnSync(process.execPath, [path.join(root, "tools/book/build.js"), "--root", folder], {
    encoding: "utf8",
  });
  assert.equal(run.status, 1);
  assert.equal(
    run.stderr,
    "the book was not built:\n  chapters/01_one/README.md:3: the link to nowhere.md: there is no such file\n",
  );
  assert.equal(fs.existsSync(path.join(folder, "build")), false);
});

test("an address of a host or of a repository that is none is refused", () => {
  for (const option of ["--address", "--repository"])
    for (const value of ["book.org", 'https://a.org/"x', "file:///tmp"]) {
      const run = spawnSync(process.execPath, [path.join(root, "tools/book/build.js"), option, value], {
        encoding: "utf8",
      });
      assert.equal(run.status, 2);
      assert.equal(
        run.stderr,
        `${option}: '${value}' is not allowed: an address that begins with https:// or http:// is\n`,
      );
    }
});

test("links lead to pages, to sources and to folders of sources", () => {
  const html = htmlOf("See [a](../../README.md#a-part) [b](one.h) [c](more) [d](#01-one)");
  const targets = [...html.matchAll(/href="([^"]*)"/g)].map(([, target]) => target);
  assert.deepEqual(targets, ["../../index.html#a-part", "one.h.html", "more/index.html", "#01-one"]);
  const book = readBook(project("[c](more)"));
  assert.deepEqual(
    book.sources.map(({ file }) => file),
    ["chapters/01_one/more/two.cpp"],
  );
});

test("tests, tools and data are in the repository and not in the book; where no address is given, they are named", () => {
  const text =
    "[a](../../tests/one.cpp) [b](../../tests) [c](../../renders/one.csv)\n\n```cpp\nint tested() {\n  return 1;\n}\n```";
  const linked = readBook(project(text), new Map(), {}, "https://a.org/b");
  const { html } = linked.pages.find(({ chapter }) => chapter);
  assert.deepEqual(
    [...html.matchAll(/href="([^"]*)"/g)].map(([, target]) => target),
    ["blob/HEAD/tests/one.cpp", "tree/HEAD/tests", "blob/HEAD/renders/one.csv", "blob/HEAD/tests/one.cpp#L1"].map(
      (file) => `https://a.org/b/${file}`,
    ),
  );
  const alone = readBook(project(text));
  const named = alone.pages.find(({ chapter }) => chapter).html;
  assert.doesNotMatch(named, /href=/);
  assert.match(named, /<a title="tests\/one\.cpp">a<\/a> <a title="tests">b<\/a> <a title="renders\/one\.csv">c<\/a>/);
  assert.match(named, /<a title="tests\/one\.cpp, line 1">one\.cpp<\/a>/);
  for (const book of [linked, alone]) assert.deepEqual([book.sources, book.folders, book.files], [[], [], []]);
  refused("[a](../../tests/nowhere.cpp)", 3, "the link to ../../tests/nowhere.cpp: there is no such file");
});

test("what is for GitHub only is not in the book, what is for the book only is, and lines keep their numbers", () => {
  const text = "*one.<!-- github --> two\n[x](nowhere.md).<!-- /github -->*\n\n<!-- book: three [a](one.h) -->";
  assert.equal(htmlOf(text), '<p><em>one.</em></p>\n<p>three <a href="one.h.html">a</a></p>\n');
  refused(`${text}\n\n[a](gone.md)`, 8, "the link to gone.md: there is no such file");
});

test("words for the search only are found and not shown", () => {
  const page = chapterOf("<!-- search: jitter, flicker -->\n\nfirst");
  assert.deepEqual(page.sections, [{ id: "", title: "01 One", text: "first ", keywords: "jitter, flicker" }]);
  assert.doesNotMatch(page.html, /jitter|search/);
});

test("formulas of each of GitHub's forms are rendered, in tables and lists, too; what is code is none", () => {
  for (const form of [
    "a $x^2$ b",
    "$$x^2$$",
    "$$\nx^2\n$$",
    "```math\nx^2\n```",
    "| a |\n| --- |\n| $x^2$ |",
    "- $x^2$",
  ])
    assert.match(htmlOf(form), /class="katex"/, form);
  assert.match(htmlOf("`$x^2$`"), /<code[^>]*>\$x\^2\$<\/code>/);
});

test("quoted code is linked to its line; the page's own folder comes first", () => {
  const html = htmlOf("```cpp\nstruct Clamping {\n  int least = 0;\n};\n```");
  assert.match(html, /<a href="one\.h\.html#L3" title="chapters\/01_one\/one\.h, line 3">one\.h<\/a>/);
});

test("what is folded stays folded; a picture alone is a figure with the line in italics below it as its caption", () => {
  assert.match(
    htmlOf("<details><summary>Answer</summary>\n\n*42*\n\n</details>"),
    /<details><summary>Answer<\/summary>\s*<p><em>42<\/em><\/p>\s*<\/details>/,
  );
  const html = htmlOf("![seen](../../docs/figures/one.svg)\n\n*A caption.*");
  assert.match(
    html,
    /^<figure class="drawing"><a [^>]*><img src="..\/..\/docs\/figures\/one.svg" alt="seen" width="20" height="10" [^>]*><\/a><figcaption>A caption.<\/figcaption>\s*<\/figure>/,
  );
});

test("the words for the search are those of each section", () => {
  const { sections } = chapterOf("first $\\beta$\n\n## Part\n\n`code` and\nmore");
  assert.deepEqual(sections, [
    { id: "", title: "01 One", text: "first β " },
    { id: "part", title: "Part", text: "code and more " },
  ]);
});

test("the place of a page and its foot are links of the layout, not words of the page", () => {
  const up = "../../README.md#a-part";
  const page = chapterOf(`[Trunk, 1 of 1](${up})\n\nWhat?\n\n[Front](../../README.md) · **[The trunk](${up})**`);
  assert.match(page.html, /<\/h1>\s*<p>What\?<\/p>\s*$/);
  assert.deepEqual(page.place, { text: "Trunk, 1 of 1", href: "../../index.html#a-part" });
  assert.deepEqual(
    page.foot.map(({ href }) => href),
    ["../../index.html", "../../index.html#a-part"],
  );
  assert.equal(page.sections[0].text, "What? ");
});

test("the feet of the chapters lead to the pages before and behind them in the book", () => {
  const pages = pagesOf(readBook(root), root).filter(({ sort }) => sort === "chapter");
  const there = (page, { href }) => path.posix.join(path.posix.dirname(page.address), href);
  assert.ok(pages.length >= 30);
  pages.forEach((page, i) => {
    const links = [pages[i - 1], pages[i + 1]].filter(Boolean).map(({ address }) => address);
    const foot = page.foot.slice(0, 2).map((link) => there(page, link));
    for (const address of links) assert.ok(foot.includes(address), `${page.file}: ${address}`);
    assert.ok(page.place, page.file);
    assert.equal(page.onward.address, there(page, page.foot.at(-1)), page.file);
  });
});

test("the contents have the trunk and its branches as README.md lists them, and every page of docs/ under a heading", () => {
  const pages = pagesOf(readBook(root), root);
  const { course } = pages[0];
  const under = (name) => course.find((part) => part.name === name)?.pages.map(({ address }) => address);
  const readme = fs.readFileSync(path.join(root, "README.md"), "utf8");
  const rows = readme.match(/^\| \d+ \| \[.*$/gm).map((row) => [...row.matchAll(/\[(..).*?\]\((.*?)\)/g)]);
  assert.deepEqual(
    under("The trunk"),
    rows.map(([[, , file]]) => addressOf(file)),
  );
  for (const [[, name], ...branches] of rows.filter(({ length }) => length > 1))
    assert.deepEqual(
      under(`Branches of ${name}`),
      branches.map(([, , file]) => addressOf(file)),
    );
  assert.equal(under("Chapters"), undefined);
  const groups = readme.match(/^- \*\*.*\*\*:[^]*?(?=\n- |\n\n)/gm);
  assert.ok(groups.length > 3);
  for (const group of groups) {
    const [, name] = /\*\*(.*)\*\*/.exec(group);
    for (const [, file] of group.matchAll(/\]\((.*?)\)/g))
      assert.ok(under(name).includes(addressOf(file)), `${file} is not under ${name}`);
  }
  const listed = course.flatMap(({ pages: some }) => some);
  assert.deepEqual(
    listed.filter(({ parent }) => parent),
    [],
  );
  assert.equal(
    listed.length,
    pages.filter(({ parent, sort }) => !parent && !["source", "missing"].includes(sort)).length,
  );
});

test("a paper has the same address wherever it is named", () => {
  const papers = new Map();
  for (const { html } of readBook(root).pages)
    for (const [, doi, title] of html.matchAll(
      /<a href="https:\/\/doi\.org\/([^"]*)">(?:<em>)?(.*?)(?:<\/em>)?<\/a>/gs,
    )) {
      assert.match(decodeURIComponent(doi), /^10\.\d{4,9}\/\S+$/);
      const [begin] = title.replace(/\s+/g, " ").split(":");
      papers.set(doi, (papers.get(doi) ?? new Set()).add(begin));
    }
  assert.ok(papers.size > 30);
  const named = [...papers.values()].map((titles) => [...titles].sort((a, b) => a.length - b.length));
  for (const [first, ...others] of named) for (const title of others) assert.ok(title.startsWith(first), title);
  assert.equal(new Set(named.map(([title]) => title)).size, papers.size);
});

test("a talk or an article that has an address has it under the Sources of every page, and contents say what is there", () => {
  const { pages } = readBook(root);
  const lists = pages.map(({ html }) => /<h2 id="sources">.*?<\/ul>/s.exec(html)?.[0] ?? "");
  const titles = (html, one) => [...html.matchAll(one)].map(([, title]) => title.replace(/\s+/g, " "));
  const linked = lists.flatMap((html) => titles(html, /<a href="http[^"]*"><em>(.*?)<\/em><\/a>/gs));
  const bare = lists.flatMap((html) => titles(html, /(?<!>)<em>(.*?)<\/em>/gs));
  assert.ok(new Set(linked).size > 25, `only ${new Set(linked).size}`);
  assert.deepEqual(
    bare.filter((title) => linked.includes(title)),
    [],
  );
  const names = pagesOf(readBook(root), root).map(({ name }) => name);
  for (const empty of ["The house", "Methods that are no chapter", "Machinery"])
    assert.ok(!names.includes(empty), empty);
});

test("the workflow that publishes the book builds it with options that the book has", () => {
  const workflow = fs.readFileSync(path.join(root, ".github/workflows/book.yml"), "utf8");
  const [, options] = /run: \.\/course book --yes -- (.*)/.exec(workflow);
  const [, folder] = /path: (.*)/.exec(workflow);
  const words = options.split(" ").map((word) => (word.startsWith('"$') ? "https://a.org/b" : word));
  const made = project("See [a](../../tests/one.cpp).");
  const run = spawnSync(process.execPath, [path.join(root, "tools/book/build.js"), "--root", made, ...words], {
    encoding: "utf8",
  });
  assert.equal(run.stderr, "");
  assert.match(
    fs.readFileSync(path.join(made, folder, "chapters/01_one/index.html"), "utf8"),
    /a\.org\/b\/blob\/HEAD\/tests/,
  );
});

test("the still of a film is its first picture", () => {
  const film = fs.readFileSync(path.join(root, "renders/front_page/film.webp"));
  const still = stillOf(film);
  assert.equal(still.toString("latin1", 0, 4) + still.toString("latin1", 8, 16), "RIFFWEBPVP8 ");
  assert.equal(still.readUInt32LE(4), still.length - 8);
  assert.throws(() => stillOf(Buffer.from("RIFF....WEBP")), /no film/);
});

test("the list of packages holds no address", () => {
  assert.doesNotMatch(fs.readFileSync(path.join(root, "tools/book/package-lock.json"), "utf8"), /"[a-z+]+:\/\//);
});

test("words that set a figure are words where no experiment is compiled", () => {
  assert.equal(htmlOf('one <!-- set: scene="x" -->two<!-- /set --> three'), "<p>one two three</p>\n");
});
