/// Small live pictures beside a sentence. A comment on a line of its own below a paragraph, a list or a formula asks for one:
///
///   <!-- live: scene="gravity" values="beta=1" slider="beta" from="0" to="1.5" seconds="0.4" number="highest jump" says="631 mm" -->
///
/// GitHub shows nothing of it. In the book the picture stands beside the paragraph, or below it on a telephone.
///
///   scene     its key, as in links: #live=…&scene=gravity
///   variants  their names, with | between them; the first where there is none. At most two
///   values    of parameters, apart from their defaults: "beta=1 dt=1/240"
///   slider    the parameter that a reader sets, as `label` calls it; `from`, `to`, `step` where its own range is not meant
///   seconds   how long the clip is, of simulated time; `slow`: how many times slower it is shown
///   number    one of the scene's numbers, shown below; `says`: what the sentence says it is
///   words     the caption
///   aspect, zoom   of the picture, where the scene's own are not meant
import { escaped } from "./sources.js";

const known = "scene variants values slider label from to step seconds slow number says words aspect zoom".split(" ");

/// What a mark asks for, as text by its names; null where the HTML is no mark.
export function markIn(html, kind = "live") {
  const [, of, text] = /^<!-- (\w+): (.*?) *-->\s*$/s.exec(html) ?? [];
  if (of !== kind) return null;
  const asked = {};
  const rest = text.replace(/(\w+)="([^"]*)"/g, (all, name, value) => {
    asked[name] = value;
    return "";
  });
  return { asked, rest: rest.trim() };
}

/// Puts the picture of each mark before what stands above it. Without an experiment, a mark is nothing.
export function smallPictures(tokens, page) {
  const { engine } = page;
  for (let i = 0; i < tokens.length; ++i) {
    const mark = tokens[i].type === "html_block" && markIn(tokens[i].content);
    if (!mark) continue;
    const line = tokens[i].map[0] + 1;
    let from = i - 1;
    if (!/^((paragraph|bullet_list|ordered_list)_close|math_block)$/.test(tokens[from]?.type))
      page.problem(line, "a live picture stands below a paragraph, a list or a formula");
    else if (tokens[from].nesting === -1)
      while (tokens[from].nesting !== 1 || tokens[from].level !== tokens[i - 1].level) --from;
    tokens[i].content = "";
    if (!engine) continue;
    try {
      const clip = clipOf(mark, engine);
      const open = new tokens[i].constructor("html_block", "", 0);
      open.content = `<div class="at-sentence">\n${figure(clip, page)}`;
      tokens[i].content = "</div>\n";
      tokens.splice(from, 0, open);
      ++i;
    } catch (problem) {
      page.problem(line, `the live picture: ${problem.message}`);
    }
    engine.set("");
  }
}

/// All that a page has to be told of a mark. Throws with what does not exist.
export function clipOf({ asked, rest }, engine) {
  const { index, scene, places, which, number, own, set, assignments } = chosenBy(
    { asked, rest, known, most: 2 },
    engine,
  );
  const seconds = number("seconds", scene.steps * engine.dt);
  if (!(seconds > 0)) refuse("its seconds are not above 0");
  let slider = null;
  if (asked.slider !== undefined) {
    const flag = `--${asked.slider}`;
    const parameter = engine.parameters.find((one) => one.flag === flag);
    if (!parameter) refuse(`there is no parameter ${asked.slider}; there are ${keys(engine.parameters, "flag")}`);
    const { what, unit, whole, least, most } = parameter;
    const [usual, ...more] = parameter.default;
    const value =
      own.get(flag) ?? (more.length ? refuse(`its values do not say what ${asked.slider} is at first`) : usual);
    const from = number("from", least);
    const to = number("to", most);
    const step = number("step", whole ? 1 : (to - from) / 100);
    if (from < least || to > most || from >= to) refuse(`${asked.slider} goes from ${least} to ${most}`);
    const at = Math.round((value - from) / step);
    if (Math.abs(from + at * step - value) > 1e-6 * (to - from) || value < from || value > to)
      refuse(`from ${from} to ${to} in steps of ${step}, its slider does not come to ${value}`);
    for (const end of [from, to]) {
      own.set(flag, end);
      set();
      const there = engine.description.scenes[index];
      if (!places.every((place) => there?.variants[place]) || (which >= 0 && !there.numbers[which]))
        refuse(`where ${asked.slider} is ${end}, there is no such scene, variant or number`);
    }
    own.delete(flag);
    const notches = Math.round((to - from) / step);
    slider = { flag, label: asked.label ?? (parameter.symbol || what), unit, from, step, notches, at, value };
  }
  return {
    scene: index,
    places,
    assignments: assignments(),
    slider,
    seconds,
    slow: number("slow", 1),
    number: which < 0 ? null : { which, name: scene.numbers[which].name },
    says: asked.says,
    names: places.map((place) => scene.variants[place].name),
    words: asked.words ?? scene.name,
    aspect: number("aspect", scene.strobe ? 1.6 : Math.min(2, Math.max(1, scene.aspect))),
    zoom: number("zoom", 1),
  };
}

/// What a mark says of scene, variants, values and a number of it, each as the engine knows it; the engine is set so.
export function chosenBy({ asked, rest, known, most }, engine) {
  if (rest) refuse(`it has the form name="value": ${rest}`);
  for (const name of Object.keys(asked)) if (!known.includes(name)) refuse(`nothing is called ${name}`);
  const number = (name, usual) => {
    if (asked[name] === undefined) return usual;
    return valueOf(asked[name]) ?? refuse(`${name} is no number`);
  };
  const own = new Map();
  for (const assignment of (asked.values ?? "").split(/\s+/).filter(Boolean)) {
    const [name, value] = assignment.split("=");
    own.set(`--${name}`, valueOf(value) ?? refuse(`${assignment} is no number`));
  }
  const assignments = () => [...own].map(([flag, value]) => `${flag}=${value}`).join(";");
  const set = () => {
    const problem = engine.set(assignments());
    if (problem) refuse(problem);
  };
  set();
  const index = engine.description.scenes.findIndex(({ key }) => key === asked.scene);
  if (index < 0) refuse(`there is no scene ${asked.scene}; there are ${keys(engine.description.scenes, "key")}`);
  engine.choose(index, [0]);
  const { scene } = engine;
  const places = (asked.variants ?? scene.variants[0].name).split("|").map((name) => {
    const place = scene.variants.findIndex((variant) => variant.name === name);
    return place < 0 ? refuse(`there is no variant ${name}; there are ${keys(scene.variants, "name")}`) : place;
  });
  if (places.length > most) refuse(`more than ${["no", "one", "two", "three", "four"][most]} variants`);
  const which = scene.numbers.findIndex(({ name }) => name === asked.number);
  if (asked.number !== undefined && which < 0)
    refuse(`there is no number ${asked.number}; there are ${keys(scene.numbers, "name")}`);
  if (asked.says !== undefined && which < 0) refuse("it says a number, and shows none");
  return { index, scene, places, which, number, own, set, assignments };
}

function refuse(text) {
  throw new Error(text);
}

/// "0.5" or "1/60"; undefined where it is neither.
export function valueOf(text = "") {
  const [, above, below = 1] = /^(-?[\d.]+)(?:\/(\d+))?$/.exec(text) ?? [];
  const value = Number(above) / Number(below);
  return Number.isFinite(value) ? value : undefined;
}

const keys = (list, name) => list.map((one) => one[name]).join(", ");

/// In words, with three digits: "0.25 m".
const valued = (value, unit) => `${Number(value.toPrecision(3))}${unit ? ` ${unit}` : ""}`;

const symbol = (name, path) => `<svg class="${name}" viewBox="0 0 16 16" aria-hidden="true"><path d="${path}"/></svg>`;
const symbols = symbol("go", "M4 2v12l10-6z") + symbol("rest", "M3 2h4v12H3zM9 2h4v12H9z");

function figure(clip, page) {
  const { slider, words, names, aspect } = clip;
  const lanes =
    names.length > 1
      ? `<div class="small-lanes">${names.map((name) => `<span>${escaped(name)}</span>`).join("")}</div>`
      : "";
  const set = slider
    ? `<label><span>${escaped(slider.label)}</span><output aria-live="off">${escaped(valued(slider.value, slider.unit))}</output>` +
      `<input type="range" min="0" max="${slider.notches}" value="${slider.at}" ` +
      `aria-label="${escaped(slider.label)}" aria-valuetext="${escaped(valued(slider.value, slider.unit))}" disabled></label>`
    : "";
  return (
    `<figure class="small-live" data-chapter="${page.live}" data-root="${page.root}" data-clip="${escaped(JSON.stringify(clip))}">` +
    `<canvas role="img" aria-label="${escaped([words, ...names].join("; "))}" style="aspect-ratio: ${aspect}"></canvas>${lanes}` +
    `<div class="small-controls"><button type="button" aria-label="Play: ${escaped(words)}" disabled>${symbols}</button>${set}</div>` +
    `<figcaption>${escaped(words)}${clip.number ? '<output aria-live="off"></output>' : ""}</figcaption></figure>\n`
  );
}
