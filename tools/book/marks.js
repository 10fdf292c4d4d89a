/// Comments of a page that ask for what GitHub does not show. What they name is looked up in the page's compiled experiment; without
/// one they are nothing. Below a paragraph, a list or a formula, a small live picture beside it:
///
///   <!-- live: scene="gravity" values="beta=1" slider="beta" from="0" to="1.5" seconds="0.4" number="highest jump" says="631 mm" -->
///
/// a step of its experiment, which a reader solves row by row, by the names of its solvers:
///
///   <!-- rows: of="cold|warm" words="A stack at rest, one contact for each click" -->
///
/// around words, a link that sets the page's experiment; `at`: s, the instant that it shows, otherwise it is played from its start:
///
///   the sum <!-- set: scene="strobe" variants="bounce + push-out" at="1.3" number="apex 1" says="1.4 m" -->sends it to 1.4 m<!-- /set -->
///
/// in a table of pictures, behind a picture, a clip that plays in its place again and again, with a switch to the second variant:
///
///   <!-- clip: chapter="07_warm_start" scene="pyramid" variants="cold\|warm" values="sweeps=1" seconds="9" slow="1/3" -->
///
/// and in docs/challenges.md a challenge, which the chapter's experiment judges:
///
///   <!-- challenge: key="fewest-sweeps" chapter="07_warm_start" scene="a-stack" variant="warm" values="boxes=20" set="sweeps dt"
///        asks="drift after 60 s <= 10 mm" score="sweeps / dt" unit="sweeps a second" ours="sweeps=4 dt=1/120" scored="480" -->
///
///   scene     its key, as in links: #live=…&scene=gravity
///   variants  their names, with | between them; a picture has two at most, the first where there is none
///   values    of parameters, apart from their defaults: "beta=1 dt=1/240"
///   number    one of the scene's numbers; `says`: what the sentence says it is, which a test compares
///   guess     the direction, in world axes, in which a reader drags the first body that moves to the `number` at the clip's end,
///             between `from` and `to`, `zero` is the number where the body begins, and a guess `within` so much is right
///   draw      instead of that the series, in `unit`, that a reader draws as a curve, between `from` and `to`, before the clip plays
///   slider    the parameter that a reader sets, as `label` calls it; `from`, `to`, `step` where its own range is not meant
///   seconds   how long the clip is, of simulated time; `slow`: how many times slower it is shown; `words`: its caption
///   asks      what numbers have to be at the end, with | between them: <=, >= or = with a value (± another) and its unit
///   score     a parameter, or it "/ dt", per second, or "1 / dt"; or a number, or by how much it differs: "highest jump - 500";
///             `best="most"` where the greater one is better; `ours`: the best that we know, and its score, `scored`
import { withUnits } from "./markdown.js";
import { escaped } from "./sources.js";

const known = {
  live: "scene variants values slider label from to step seconds slow number says words aspect zoom guess draw unit zero within",
  clip: "chapter scene variants values seconds slow zoom words",
  set: "scene variants values at number says",
  challenge: "key chapter scene variant variants values set asks score best unit ours scored",
};
const end = "<!-- /set -->";

function refuse(text) {
  throw new Error(text);
}

/// What a mark asks for, as text by its names; null where the HTML is no mark.
export function markIn(html, kind) {
  const [, of, text] = /^<!-- (\w+): (.*?) *-->\s*$/s.exec(html) ?? [];
  if (of !== kind) return null;
  return Object.fromEntries([...text.matchAll(/(\w+)="([^"]*)"/g)].map(([, name, value]) => [name, value]));
}

/// "0.5" or "1/60".
function valueOf(text = "") {
  const [, above, below = 1] = /^(-?[\d.]+)(?:\/(\d+))?$/.exec(text) ?? [];
  const value = Number(above) / Number(below);
  return Number.isFinite(value) ? value : refuse(`${text} is no number`);
}

/// "beta=1 dt=1/240": {flag: value}.
const valuesIn = (text = "") =>
  Object.fromEntries(
    text
      .split(/\s+/)
      .filter(Boolean)
      .map((one) => one.split("="))
      .map(([name, value]) => [`--${name}`, valueOf(value)]),
  );

const find = (list, key, name, what) => {
  const place = list.findIndex((one) => one[key] === name);
  return place >= 0
    ? place
    : refuse(`there is no ${what} ${name}; there are ${list.map((one) => one[key]).join(", ")}`);
};

/// What all marks have in common, each as the engine knows it; the engine is set so.
function chosenBy(asked, kind, engine) {
  for (const name of Object.keys(asked))
    if (!known[kind].split(" ").includes(name)) refuse(`nothing is called ${name}`);
  const own = valuesIn(asked.values);
  const assignments = Object.entries(own)
    .map(([flag, value]) => `${flag}=${value}`)
    .join(";");
  const problem = engine.set(assignments);
  if (problem) refuse(problem);
  const index = find(engine.description.scenes, "key", asked.scene, "scene");
  engine.choose(index, [0]);
  const { scene } = engine;
  const names = (asked.variants ?? asked.variant ?? scene.variants[0].name).split("|");
  const places = names.map((name) => find(scene.variants, "name", name, "variant")).sort((a, b) => a - b);
  const which = asked.number === undefined ? -1 : find(scene.numbers, "name", asked.number, "number");
  const lanes = places.map((place) => scene.variants[place].name); // in the order in which an engine has them
  return { scene, index, names: lanes, places, which, own, assignments, says: asked.says };
}

const parameterOf = (engine, name) => engine.parameters[find(engine.parameters, "flag", `--${name}`, "parameter")];

// ---- live pictures

/// All that a page has to be told of a small picture. Throws with what does not exist.
export function clipOf(asked, engine, kind = "live") {
  const { scene, index, names, places, which, own, assignments, says } = chosenBy(asked, kind, engine);
  const number = (name, usual) => (asked[name] === undefined ? usual : valueOf(asked[name]));
  let slider = null;
  const zero = number("zero", 0);
  const guess = asked.guess && { axis: asked.guess.split(" ").map(valueOf), zero, within: valueOf(asked.within) };
  let curve = null;
  if (asked.draw !== undefined) {
    const series = find(scene.series, "name", asked.draw, "series"),
      { unit, name } = scene.series[series];
    curve = { which: series, name, unit: unit || (asked.unit ?? ""), colour: scene.variants[places[0]].colour };
    Object.assign(curve, { from: valueOf(asked.from), to: valueOf(asked.to), within: valueOf(asked.within) });
  }
  if (guess || asked.slider !== undefined) {
    const guessed = { what: "your guess", least: -Infinity, most: Infinity, default: [zero], ...scene.numbers[which] };
    const {
      flag,
      what,
      symbol,
      unit,
      whole,
      least,
      most,
      default: usual,
    } = guess ? guessed : parameterOf(engine, asked.slider);
    const value = own[flag] ?? usual[0];
    const [from, to] = [number("from", least), number("to", most)];
    const step = number("step", whole ? 1 : (to - from) / 100);
    if (from < least || to > most || from >= to) refuse(`${asked.slider} goes from ${least} to ${most}`);
    const [notches, at] = [to, value].map((end) => Math.round((end - from) / step));
    slider = { flag, label: asked.label ?? (symbol || what), unit, from, step, notches, at, value };
  }
  return {
    scene: index,
    guess,
    curve,
    places,
    assignments,
    slider,
    seconds: number("seconds", scene.steps * engine.dt),
    slow: number("slow", 1),
    number: which < 0 ? null : { which, name: scene.numbers[which].name },
    says,
    names,
    words: asked.words ?? scene.name,
    aspect: number("aspect", scene.strobe ? 1.6 : Math.min(2, Math.max(1, scene.aspect))),
    zoom: number("zoom", 1),
  };
}

/// In the place of each mark a step that is solved row by row.
export function rowFigures(tokens, page) {
  for (const token of tokens) {
    const asked = token.type === "html_block" && markIn(token.content, "rows");
    if (!asked) continue;
    const steps = lookedUp(page, token.map[0] + 1, ({ description }) => stepsOf(asked, description.rows));
    const data = steps && escaped(JSON.stringify(steps));
    token.content = steps
      ? `<figure class="small-live rows" data-chapter="${page.live}" data-root="${page.root}" data-rows="${data}">` +
        `<figcaption>${escaped(asked.words)}</figcaption></figure>\n`
      : "";
  }
}

/// Throws with what does not exist.
export function stepsOf(asked, all) {
  const named = all.map((name, step) => ({ name, step }));
  return asked.of.split("|").map((name) => named[find(named, "name", name, "step")]);
}

/// Puts the picture of each mark before what stands above it.
export function smallPictures(tokens, page) {
  for (let i = 0; i < tokens.length; ++i) {
    const asked = tokens[i].type === "html_block" && markIn(tokens[i].content, "live");
    if (!asked) continue;
    let from = i - 1;
    if (tokens[from]?.nesting === -1)
      while (tokens[from].nesting !== 1 || tokens[from].level !== tokens[i - 1].level) --from;
    tokens[i].content = "";
    const clip = lookedUp(page, tokens[i].map[0] + 1, (engine) => clipOf(asked, engine));
    if (!clip) continue;
    const open = new tokens[i].constructor("html_block", "", 0);
    open.content = `<div class="at-sentence">\n${figure(clip, page)}`;
    tokens[i].content = "</div>\n";
    tokens.splice(from, 0, open);
    ++i;
  }
}

/// Puts a clip in the place of the picture before each mark. Until it is drawn the picture shows.
export function wallOfClips(tokens, page) {
  for (const { map, children } of tokens.filter(({ type }) => type === "inline")) {
    const at = children.findIndex(({ content }) => markIn(content, "clip"));
    if (at < 0) continue;
    const asked = markIn(children[at].content, "clip");
    const { chapter } = asked;
    const engine = page.engines.get(chapter);
    const clip = lookedUp(page, map ? map[0] + 1 : 1, (own) => clipOf(asked, own, "clip"), engine);
    children[at].content = "";
    if (!clip) continue;
    const from = children.findLastIndex(({ type }, i) => i < at && type === "link_open");
    const open = new children[at].constructor("html_inline", "", 0);
    const [before, after] = figure(clip, { live: chapter, root: page.root }, true).split("<canvas");
    open.content = before;
    children[at].content = `<canvas${after}`;
    children.splice(from, 0, open);
  }
}

function lookedUp(page, line, look, engine = page.engine) {
  if (!engine) return null;
  try {
    return look(engine);
  } catch (problem) {
    page.problem(line, `the mark: ${problem.message}`);
    return null;
  } finally {
    engine.set("");
  }
}

const icon = (name, path) => `<svg class="${name}" viewBox="0 0 16 16" aria-hidden="true"><path d="${path}"/></svg>`;
const icons = icon("go", "M4 2v12l10-6z") + icon("rest", "M3 2h4v12H3zM9 2h4v12H9z");

/// `turns`: a clip that plays again and again, and shows one of its two variants.
function figure(clip, page, turns = false) {
  const { slider, words, names, aspect } = clip;
  const lanes = names.map((name) => `<span>${escaped(name)}</span>`).join("");
  const label = slider && escaped(slider.label);
  const value = slider && escaped(`${Number(slider.value.toPrecision(3))} ${slider.unit}`.trim());
  const set = slider
    ? `<label><span>${label}</span><output aria-live="off">${value}</output><input type="range" min="0" ` +
      `max="${slider.notches}" value="${slider.at}" aria-label="${label}" aria-valuetext="${value}" disabled></label>`
    : turns
      ? `<label class="mended"><input type="checkbox" aria-label="fixed: ${escaped(words)}" disabled> fixed</label>`
      : "";
  const guessed = clip.guess || clip.curve;
  const output = clip.number || guessed ? `<output aria-live="${guessed ? "polite" : "off"}"></output>` : "";
  return (
    `<figure class="small-live${turns ? " turns" : clip.curve ? " draws" : ""}" data-chapter="${page.live}" data-root="${page.root}" data-clip="${escaped(JSON.stringify(clip))}">` +
    `<canvas role="img" aria-label="${escaped([words, ...names].join("; "))}" style="aspect-ratio: ${turns ? 1.5 : aspect}"></canvas>` +
    (names.length > 1 && !turns ? `<div class="small-lanes">${lanes}</div>` : "") +
    `<div class="small-controls"><button type="button" aria-label="Play: ${escaped(words)}" disabled>${icons}</button>${set}</div>` +
    `${turns ? "" : `<figcaption>${escaped(withUnits(words))}${output}</figcaption>`}</figure>\n`
  );
}

// ---- words that set the experiment

/// The state that a mark asks for: as an address has it (`link`), and for who plays it. Throws with what does not exist.
export function stateOf(asked, engine) {
  const chosen = chosenBy(asked, "set", engine);
  const { key, steps } = chosen.scene;
  const step = Math.round((asked.at === undefined ? 0 : valueOf(asked.at)) / engine.dt);
  if (step < 0 || step > steps) refuse(`${asked.at} s is not within the scene's ${steps * engine.dt} s`);
  const link = new URLSearchParams({ live: engine.description.name, scene: key });
  if (asked.variants !== undefined) link.set("show", chosen.places.join(","));
  else chosen.places = [0, 1, 2, 3];
  for (const [flag, value] of Object.entries(chosen.own)) link.set(flag.slice(2), value);
  link.set(step ? "step" : "play", step || 1);
  return { ...chosen, link: String(link), step };
}

/// In the inline content of a page: a link in the place of each pair of comments.
export function settingSentences(tokens, page) {
  let line = 1;
  for (const { type, map, content, children } of tokens) {
    const unpaired = () => page.problem(line, `a mark "set" stands within a line, has its words, and then ${end}`);
    line = map ? map[0] + 1 : line;
    if (type === "html_block" && content.startsWith("<!-- set:")) unpaired();
    if (type !== "inline") continue;
    let open = null;
    for (const child of children.filter((one) => one.type === "html_inline")) {
      const asked = markIn(child.content, "set");
      if (!asked && child.content !== end) continue;
      if (Boolean(asked) === Boolean(open)) unpaired();
      const state = asked && lookedUp(page, line, (engine) => stateOf(asked, engine));
      child.content = state ? `<a class="sets" href="#${escaped(state.link)}">` : !asked && open?.content ? "</a>" : "";
      open = asked && child;
    }
    if (open) unpaired();
  }
}

// ---- challenges

/// Each mark of the page with what stands above it: {line, asked, title, rule}, `rule` being the first paragraph below the heading.
export function challengesIn(text) {
  let line = 1;
  return text.split(/^(?=### )/m).flatMap((part) => {
    const at = line;
    line += (part.match(/\n/g) ?? []).length;
    const [html] = /<!-- challenge: .*?-->/s.exec(part) ?? [];
    if (!html) return [];
    const [heading, paragraph] = part.split(/\n\n+/);
    const rule = paragraph
      .replace(/\s+\[Chapter\s\d\d\]\(\S*\)\.\s*$/, "")
      .replace(/\[([^\]]*)\]\([^)]*\)/g, "$1")
      .replace(/[*`$]/g, "")
      .replace(/\s+/g, " ");
    return [{ line: at, asked: markIn(html, "challenge"), title: heading.replace(/^### /, ""), rule }];
  });
}

/// All that a figure has to be told. Throws with what does not exist.
export function challengeOf({ asked, title, rule }, engine) {
  const { scene, index, places, own } = chosenBy(asked, "challenge", engine);
  const flagOf = (name) => parameterOf(engine, name).flag;
  const numberOf = (name) => find(scene.numbers, "name", name, "number");
  const asks = asked.asks.split(" | ").map((words) => {
    const [, name, relation, value, within = 0, unit] =
      /^(.*) (<=|>=|=) (-?[\d.]+)(?: ± ([\d.]+))? ?(.*)$/.exec(words) ?? refuse(`it asks for ${words}`);
    const shown = words.replace("<=", "≤").replace(">=", "≥");
    return { which: numberOf(name), relation, value: Number(value), within: Number(within), unit, words: shown };
  });
  return {
    key: asked.key,
    title,
    rule,
    scene: index,
    place: places[0],
    fixed: Object.entries(own),
    free: asked.set.split(/\s+/).map(flagOf),
    asks,
    score: scoreOf(asked.score, engine, flagOf, numberOf),
    most: asked.best === "most",
    unit: asked.unit,
    ours: valueOf(asked.scored),
    best: Object.entries(valuesIn(asked.ours)),
  };
}

function scoreOf(text, engine, flagOf, numberOf) {
  const [, per] = /^(\S+) \/ dt$/.exec(text) ?? [];
  if (per) return { flag: per === "1" ? null : flagOf(per), perSecond: true };
  if (engine.parameters.some(({ flag }) => flag === `--${text}`)) return { flag: flagOf(text) };
  const [, name, less] = /^(.*) - ([\d.]+)$/.exec(text) ?? [];
  return { which: numberOf(name ?? text), less: less && Number(less) };
}

/// In the place of each mark a link to the experiment; `page.challenged`: of each chapter its challenges.
export function challengeLinks(tokens, page) {
  for (const token of tokens) {
    const asked = token.type === "html_block" && markIn(token.content, "challenge");
    if (!asked) continue;
    const { chapter, key } = asked;
    const there = page.challenged?.get(chapter)?.find((one) => one.key === key);
    token.content = there
      ? `<p class="challenge"><a href="${page.root}/chapters/${chapter}/index.html#live=${chapter}&amp;challenge=${escaped(key)}">Take it up</a> ` +
        `<small>Ours: ${Number(there.ours.toPrecision(4))} ${escaped(there.unit)}</small></p>\n`
      : "";
  }
}
