/// The hard cases: each row of their table, what is asked of each, and what is told of it can be linked to, and link to each other.
import { relative } from "./outline.js";

const table = "renders/hard_cases/table.md";
const told = "docs/hard_cases.md";

/// In the table `#stack-10` is the row of a case, `#stack-10-after` that of the stages that came after, `#stack-10-asked` what is
/// asked of it; each cell knows its case and its stage. On the page `#stack-10` is what is told of it.
export function linkCases(tokens, page) {
  if (page.file === table) linkTable(tokens);
  else if (page.file === told) linkNames(tokens, page);
}

function linkTable(tokens) {
  const names = new Map();
  tokens.forEach((token, i) => {
    const children = token.type === "inline" ? token.children : [];
    const bold = children.findIndex(({ type }) => type === "strong_open");
    const name = children.find(({ type }) => type === "code_inline")?.content;
    if (bold < 0 || !name || tokens[i - 2].type !== "list_item_open") return;
    names.set(children[bold + 1].content, name);
    tokens[i - 2].attrSet("id", `${name}-asked`);
  });
  let stages = [];
  let tables = 0;
  let row, column, name;
  tokens.forEach((token, i) => {
    if (token.type === "table_open") ((stages = []), ++tables);
    if (token.type === "th_open") stages.push(tokens[i + 1].children.map(({ content }) => content).join(""));
    if (token.type === "tr_open") ((row = token), (column = -1), (name = undefined));
    if (token.type !== "td_open") return;
    if (++column > 0) return name && (token.attrSet("data-case", name), token.attrSet("data-stage", stages[column]));
    const cell = tokens[i + 1];
    name = names.get(cell.children.map(({ content }) => content).join(""));
    if (!name) return;
    row.attrSet("id", tables === 1 ? name : `${name}-after`);
    cell.children = linked(cell, cell.children, `#${name}-asked`);
  });
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

function linked(token, children, href) {
  const open = new token.constructor("link_open", "a", 1);
  open.attrSet("href", href);
  return [open, ...children, new token.constructor("link_close", "a", -1)];
}
