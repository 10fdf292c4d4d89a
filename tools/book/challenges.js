/// Challenges: docs/challenges.md says each in words, and below them, in a comment, what the experiment has to know of it:
///
///   <!-- challenge: key="fewest-sweeps" chapter="07_warm_start" scene="a-stack" variant="warm" values="boxes=20" set="sweeps dt"
///        asks="drift after 60 s <= 10 mm" score="sweeps / dt" unit="sweeps a second" ours="sweeps=4 dt=1/120" -->
///
/// GitHub shows nothing of it. In the book it is a link to the chapter's experiment, which judges.
///
///   scene, variant, values   as for a live picture (tools/book/small.js); one variant, the first where there is none
///   set       the parameters that may be set
///   asks      what the scene's numbers have to be at its end, with | between them: <=, >= or = with a value (± another) and its unit
///   score     a parameter, or it "/ dt", per second, or "1 / dt"; or one of the numbers, or by how much it differs: "highest jump - 500"
///   best      "most", where the greater score is the better one
///   unit      of the score
///   ours      the best that we know, by the parameters that are set; `scored`: its score, which a test plays
import fs from "node:fs";
import path from "node:path";
import { chosenBy, markIn, valueOf } from "./small.js";
import { escaped } from "./sources.js";

const known = "key chapter scene variant values set asks score best unit ours scored".split(" ");
export const file = "docs/challenges.md";

/// Each mark of the page with what stands above it: {line, mark, title, rule}, `rule` being the first paragraph below the heading.
export function challengesIn(text) {
  const parts = text.split(/^(?=### )/m);
  let line = 1;
  return parts.flatMap((part) => {
    const at = line;
    line += (part.match(/\n/g) ?? []).length;
    const [html] = /<!-- challenge: .*?-->/s.exec(part) ?? [];
    if (!html) return [];
    const [heading, rule] = part.split(/\n\n+/);
    return [
      {
        line: at,
        html,
        mark: markIn(html, "challenge"),
        title: heading.replace(/^### /, ""),
        rule: rule
          .replace(/\s+\[Chapter\s\d\d\]\(\S*\)\.\s*$/, "")
          .replace(/\[([^\]]*)\]\([^)]*\)/g, "$1")
          .replace(/[*`$]/g, "")
          .replace(/\s+/g, " "),
      },
    ];
  });
}

/// Of each chapter its challenges, as its figure is told them; `problem(line, text)` of what cannot be.
export function challengesOf(root, engines, problem) {
  const found = new Map();
  const page = path.join(root, file);
  if (!fs.existsSync(page)) return found;
  for (const one of challengesIn(fs.readFileSync(page, "utf8"))) {
    const engine = engines.get(one.mark.asked.chapter);
    if (!engine) continue;
    try {
      const challenge = challengeOf(one, engine);
      found.set(one.mark.asked.chapter, [...(found.get(one.mark.asked.chapter) ?? []), challenge]);
    } catch (refused) {
      problem(one.line, `the challenge: ${refused.message}`);
    }
    engine.set("");
  }
  return found;
}

/// All that a figure has to be told. Throws with what does not exist.
export function challengeOf({ mark, title, rule }, engine) {
  const { asked } = mark;
  const refuse = (text) => {
    throw new Error(text);
  };
  for (const name of known)
    if (asked[name] === undefined && !/^(variant|values|best)$/.test(name)) refuse(`without ${name}`);
  const { index, scene, places, own } = chosenBy(
    { asked: { ...asked, variants: asked.variant }, rest: mark.rest, known: [...known, "variants"], most: 1 },
    engine,
  );
  const parameter = (name) =>
    engine.parameters.find(({ flag }) => flag === `--${name}`)?.flag ?? refuse(`there is no parameter ${name}`);
  const number = (name) => {
    const which = scene.numbers.findIndex((one) => one.name === name);
    return which < 0
      ? refuse(`there is no number ${name}; there are ${scene.numbers.map((one) => one.name).join(", ")}`)
      : which;
  };
  const asks = asked.asks.split(" | ").map((words) => {
    const [, name, relation, value, within = 0, unit] =
      /^(.*) (<=|>=|=) (-?[\d.]+)(?: ± ([\d.]+))? ?(.*)$/.exec(words) ?? refuse(`it asks for ${words}`);
    return {
      which: number(name),
      relation,
      value: Number(value),
      within: Number(within),
      unit,
      words: words.replace("<=", "≤").replace(">=", "≥"),
    };
  });
  const [, per] = /^(\S+) \/ dt$/.exec(asked.score) ?? [];
  const [, name, less] = /^(.*) - ([\d.]+)$/.exec(asked.score) ?? [];
  const isParameter = engine.parameters.some(({ flag }) => flag === `--${asked.score}`);
  const score = per
    ? { flag: per === "1" ? null : parameter(per), perSecond: true }
    : isParameter
      ? { flag: parameter(asked.score) }
      : { which: number(name ?? asked.score), less: less === undefined ? undefined : Number(less) };
  const assignments = (text) =>
    text.split(/\s+/).map((one) => {
      const [flag, value] = one.split("=");
      return [parameter(flag), valueOf(value) ?? refuse(`${one} is no number`)];
    });
  return {
    key: asked.key,
    title,
    rule,
    scene: index,
    place: places[0],
    fixed: [...own],
    free: asked.set.split(/\s+/).map(parameter),
    asks,
    score,
    most: asked.best === "most",
    unit: asked.unit,
    ours: valueOf(asked.scored) ?? refuse("scored is no number"),
    best: assignments(asked.ours),
  };
}

/// On the page: in the place of each mark a link to the experiment.
export function linkChallenges(tokens, page) {
  for (const token of tokens) {
    const mark = token.type === "html_block" && markIn(token.content, "challenge");
    if (!mark) continue;
    const { chapter, key } = mark.asked;
    const there = page.challenged?.get(chapter)?.find((one) => one.key === key);
    token.content = there
      ? `<p class="challenge"><a href="${page.root}/chapters/${chapter}/index.html#live=${chapter}&amp;challenge=${escaped(key)}">Take it up</a> ` +
        `<small>Ours: ${Number(there.ours.toPrecision(4))} ${escaped(there.unit)}</small></p>\n`
      : "";
  }
}
