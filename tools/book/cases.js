/// The hard cases: each row of their table, what is asked of each, and what is told of it can be linked to, and link to each other.
import { relative } from "./outline.js";

const table = "renders/hard_cases/table.md";
const told = "docs/hard_cases.md";
const tooLong = "19 direct contacts"; // the stage that no page plays: one step may take seconds

/// In the table `#stack-10` is the row of a case, `#stack-10-after` that of the stages that came after, `#stack-10-asked` what is
/// asked of it; each cell leads to where its case is played under its stage, if it is played anywhere: then `page.cases` is
/// given {title, address} of each, played under the last of the chapters and under the last stage. On the page `#stack-10` is
/// what is told of it.
export function linkCases(tokens, page) {
  if (page.file === table) linkTable(tokens, page);
  else if (page.file === told) linkNames(tokens, page);
}

function linkTable(tokens, page) {
  const names = new Map();
  tokens.forEach((token, i) => {
    const children = token.type === "inline" ? token.children : [];
    const bold = children.findIndex(({ type }) => type === "strong_open");
    const name = children.find(({ type }) => type === "code_inline")?.content;
    if (bold < 0 || !name || tokens[i - 2].type !== "list_item_open") return;
    names.set(children[bold + 1].content, name);
    tokens[i - 2].attrSet("id", `${name}-asked`);
  });
  const text = (cell) => cell.children.map(({ content }) => content).join("");
  const stages = []; // of all tables, one after the other
  const last = []; // of each table, the place of its last stage
  let row, column, before, name;
  tokens.forEach((token, i) => {
    if (token.type === "table_open") before = stages.length;
    if (token.type === "table_close") last.push(stages.findLastIndex((stage) => stage !== tooLong));
    if (token.type === "tr_open") ((row = token), (column = -1), (name = undefined));
    if (!["th_open", "td_open"].includes(token.type)) return;
    const cell = tokens[i + 1];
    const stage = before + column++;
    if (token.type === "th_open") return column > 0 && stages.push(text(cell));
    if (column > 0) {
      if (name && page.played && stages[stage] !== tooLong)
        cell.children = linked(cell, cell.children, played(page, name, [stage]), stages[stage]);
      return;
    }
    name = names.get(text(cell));
    if (!name) return;
    row.attrSet("id", before === 0 ? name : `${name}-after`);
    cell.children = linked(cell, cell.children, `#${name}-asked`);
  });
  if (!page.played) return;
  const note = new tokens[0].constructor("html_block", "", 0);
  note.content = `<p>Each cell is a link: it plays its case under its stage. Those of ${tooLong} take too long for that.</p>\n`;
  tokens.splice(tokens.findIndex(({ type }) => type === "paragraph_close") + 1, 0, note);
  page.cases = [...names].map(([title, name]) => ({ title, address: played({ ...page, address: "" }, name, last) }));
}

/// The address of a case that is played under the stages with these places. Those that are of a step have it in their names: dt-240.
function played(page, name, places) {
  const [, rate] = /^dt-(\d+)$/.exec(name) ?? [];
  const own = rate ? `&dt=${1 / rate}` : "";
  return `${relative(page.address, page.played.address)}#live=hard_cases&scene=${name}&show=${places}${own}`;
}

function linkNames(tokens, page) {
  tokens.forEach((token, i) => {
    if (token.type !== "inline" || tokens[i - 2]?.type !== "list_item_open") return;
    const end = token.children.findIndex(({ type, content }) => type !== "code_inline" && content !== ", ");
    if (end < 1 || !token.children[end].content.startsWith(":")) return;
    const names = token.children.slice(0, end).map((child) => {
      if (child.type !== "code_inline") return [child];
      child.attrSet("id", child.content);
      return linked(token, [child], `${relative(page.address, "renders/hard_cases/table.html")}#${child.content}`);
    });
    token.children.splice(0, end, ...names.flat());
  });
}

function linked(token, children, href, title) {
  const open = new token.constructor("link_open", "a", 1);
  open.attrSet("href", href);
  if (title) open.attrSet("title", title);
  return [open, ...children, new token.constructor("link_close", "a", -1)];
}
