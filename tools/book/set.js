/// Sentences that set the figure. Two comments within a line hold the words that do it:
///
///   the sum <!-- set: scene="strobe" variants="bounce + push-out" at="1.3" number="apex 1" says="1.4 m" -->sends it to 1.4 m<!-- /set -->
///
/// GitHub shows the words alone. In the book they are a link to the page's experiment in that state.
///
///   scene     its key, as in links: #live=…&scene=strobe
///   variants  their names, with | between them; the first four where there are none
///   values    of parameters, apart from their defaults: "beta=1 dt=1/240"
///   at        s: the instant that the figure shows; without it, the experiment plays from its start
///   number    one of the scene's numbers; `says`: what the words say it is, of the first variant, at that instant
import { chosenBy, markIn } from "./small.js";
import { escaped } from "./sources.js";

const known = "scene variants values at number says".split(" ");
const end = "<!-- /set -->";

/// In the inline content of a page: a link in the place of each pair of comments. Without an experiment they are nothing.
export function settingSentences(tokens, page) {
  let line = 1;
  for (const { type, map, content, children } of tokens) {
    if (type === "html_block" && markIn(content.split("\n")[0].replace(/-->.*$/, "-->"), "set"))
      page.problem(map[0] + 1, 'a mark "set" that begins a line ends the paragraph: a word has to stand before it');
    if (type !== "inline") continue;
    line = map ? map[0] + 1 : line;
    let open = null;
    for (const child of children) {
      if (child.type !== "html_inline") continue;
      const mark = markIn(child.content, "set");
      if (!mark && child.content !== end) continue;
      if (Boolean(mark) === Boolean(open)) page.problem(line, `a mark "set" has its words, and then ${end}`);
      child.content = mark ? linkTo(mark, page, line) : open?.content ? "</a>" : "";
      open = mark && child;
    }
    if (open) page.problem(line, `a mark "set" has its words, and then ${end}`);
  }
}

function linkTo(mark, page, line) {
  const { engine } = page;
  if (!engine) return "";
  try {
    return `<a class="sets" href="#${escaped(stateOf(mark, engine).link)}">`;
  } catch (problem) {
    page.problem(line, `the words that set the figure: ${problem.message}`);
    return "";
  } finally {
    engine.set("");
  }
}

/// The state that a mark asks for: as an address has it (`link`), and for who plays it. Throws with what does not exist.
export function stateOf({ asked, rest }, engine) {
  const { index, places, which, own, number, assignments } = chosenBy({ asked, rest, known, most: 4 }, engine);
  const { key, steps } = engine.scene;
  const step = Math.round(number("at", 0) / engine.dt);
  if (step < 0 || step > steps) throw new Error(`${asked.at} s is not within the scene's ${steps * engine.dt} s`);
  const link = new URLSearchParams({ live: engine.description.name, scene: key });
  if (asked.variants !== undefined) link.set("show", places.join(","));
  for (const [flag, value] of own) link.set(flag.slice(2), value);
  if (step) link.set("step", step);
  return { link: String(link), scene: index, places, assignments: assignments(), step, which, says: asked.says };
}
