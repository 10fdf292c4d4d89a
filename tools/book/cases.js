/// The hard cases: in their table `#stack-10` is the row of a case, its name leads to what is asked of it, and each cell plays the case
/// under its stage and under the three stages before it. On docs/hard_cases.md `#stack-10` is its name in the first cell of a row.
import { relative } from "./outline.js";

const table = "renders/hard_cases/table.md";
const told = "docs/hard_cases.md";
const tooLong = "19 direct contacts"; // the stage that no page plays: one step may take seconds

export function linkCases(tokens, page) {
  if (page.file === table) linkTable(tokens, page);
  else if (page.file === told) linkNames(tokens);
}

const textOf = (cell) => cell.children.map(({ content }) => content).join("");

function linkTable(tokens, page) {
  const names = new Map(); // of the list below the table: what a case is called, and its name
  tokens.forEach((token, i) => {
    const children = token.type === "inline" ? token.children : [];
    const bold = children.findIndex(({ type }) => type === "strong_open");
    const name = children.find(({ type }) => type === "code_inline")?.content;
    if (bold < 0 || !name || tokens[i - 2].type !== "list_item_open") return;
    names.set(children[bold + 1].content, name);
    tokens[i - 2].attrSet("id", `${name}-asked`);
  });
  const stages = []; // of all tables, one after the other
  let row, column, before, name;
  tokens.forEach((token, i) => {
    if (token.type === "table_open") before = stages.length;
    if (token.type === "tr_open") ((row = token), (column = -1), (name = undefined));
    if (!["th_open", "td_open"].includes(token.type)) return;
    const cell = tokens[i + 1];
    const stage = before + column++;
    if (token.type === "th_open") {
      if (column > 0) stages.push(textOf(cell));
    } else if (column > 0) {
      if (!name || !page.played || stages[stage] === tooLong) return;
      const [, rate] = /^dt-(\d+)$/.exec(name) ?? []; // those that are of a step have it in their names
      const shown = [stage, ...[0, 1, 2, 3].map((i) => Math.max(0, stage - 3) + i).filter((one) => one !== stage)];
      const state = `live=hard_cases&scene=${name}&show=${shown}${rate ? `&dt=${1 / rate}` : ""}&play=1`;
      link(cell, `${relative(page.address, page.played.address)}#${state}`, stages[stage]);
    } else if ((name = names.get(textOf(cell)))) {
      row.attrSet("id", before === 0 ? name : `${name}-after`);
      link(cell, `#${name}-asked`);
    }
  });
}

function link(cell, href, title) {
  const open = new cell.constructor("link_open", "a", 1);
  open.attrSet("href", href);
  if (title) open.attrSet("title", title);
  cell.children = [open, ...cell.children, new cell.constructor("link_close", "a", -1)];
}

function linkNames(tokens) {
  tokens.forEach((token, i) => {
    if (token.type !== "inline" || tokens[i - 1]?.type !== "td_open" || tokens[i - 2].type !== "tr_open") return;
    for (const child of token.children) if (child.type === "code_inline") child.attrSet("id", child.content);
  });
}
