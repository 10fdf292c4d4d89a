"use strict";
// Finds a page's figures with data-chapter and puts the experiment itself in the place of the picture, once it is asked for.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const players = new Map();
  /** What engine.draw shows in front of all, for the symbol that is lit: normals, depths, impulses. */
  live.lit = () => ({ n: 16, d: 32, λ: 48 })[document.documentElement.dataset.lit] ?? 0;
  live.stillness = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

  live.make = function (tag, properties = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(properties)) {
      if (name.startsWith("aria-") || name === "role") element.setAttribute(name, value);
      else if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
      else element[name] = value;
    }
    element.append(...children);
    return element;
  };
  const { make } = live;
  live.small = (textContent, onclick, more) =>
    make("button", { type: "button", className: "pb-small", textContent, onclick, ...more });

  /** The place of the variant that the page's guess names first, to be seen first where there is room for one. */
  live.askedOf = function (variants) {
    let text = "",
      next = document.getElementById("your-guess")?.nextElementSibling;
    for (; next && !next.matches("h2, details"); next = next.nextElementSibling) {
      const copy = next.cloneNode(true);
      for (const twice of copy.querySelectorAll("annotation, .katex-html")) twice.remove();
      text += copy.textContent.replace(/\s/g, "");
    }
    const [shared] = /^(?:[^,]*, )?/.exec(variants[0].name); // "32 substeps, soft": the guess says "soft"
    const own = (name) => (variants.every((one) => one.name.startsWith(shared)) ? name.slice(shared.length) : name);
    const named = variants.map(({ name }, place) => ({ place, words: own(name).replace(/:.*|\s/g, "") }));
    const found = named.filter(({ words }) => text.includes(words));
    found.sort((a, b) => text.indexOf(a.words) - text.indexOf(b.words) || b.words.length - a.words.length);
    return found[0]?.place ?? 0;
  };

  const scripts = new Map();
  /** Loads a classic script once: it also works where a page is opened from a folder. */
  live.loadScript = function (src) {
    if (!scripts.has(src)) {
      const load = (resolve, reject) => {
        const failed = () => {
          scripts.delete(src);
          reject(new Error(`${src} could not be loaded`));
        };
        document.head.append(
          Object.assign(document.createElement("script"), { src, onload: resolve, onerror: failed }),
        );
      };
      scripts.set(src, new Promise(load));
    }
    return scripts.get(src);
  };

  /** `state`: of an address; without it, what is started plays. */
  async function start(figure, state = new URLSearchParams("play=1")) {
    if (players.has(figure)) return players.get(figure);
    const panel = figure.querySelector(".pb-start");
    const [button, said] = panel.children;
    button.disabled = true;
    said.textContent = "Loading …";
    try {
      const engine = await live.Engine.load(figure.dataset.chapter, figure.dataset.root);
      const player = new live.Player(figure, engine, state);
      panel.remove();
      players.set(figure, player);
      return player;
    } catch (problem) {
      console.error(problem);
      button.disabled = false;
      said.textContent = `The experiment cannot be run here: ${problem.message}`;
      return null;
    }
  }

  function prepare(figure) {
    const run = async () => (await start(figure))?.bringIntoView();
    const panel = make(
      "div",
      { className: "pb-start" },
      make("button", { type: "button", className: "pb-run", textContent: "Run it here", onclick: run }),
      make("p", { role: "status" }),
    );
    figure.insertBefore(panel, figure.querySelector("figcaption"));
  }

  let asked = true; // by the address, as the page is opened, or by a link: not by the browser's way back to a sentence
  /** Shows what the address says. */
  async function follow(figures) {
    const state = new URLSearchParams(location.hash.slice(1)),
      seen = asked;
    asked = false;
    const figure = figures.find((one) => one.dataset.chapter === state.get("live"));
    if (!figure) return;
    players.get(figure)?.toy?.leave();
    players.get(figure)?.arrive(state);
    const player = await start(figure, state);
    if (!seen) return;
    if (!player) figure.scrollIntoView();
    else if (state.has("problem") || state.has("iteration")) player.iterations.element.scrollIntoView();
    else player.bringIntoView();
  }
  function clicked({ target }, figures) {
    const link = target.closest?.('a[href*="#live="]');
    asked = Boolean(link);
    if (link?.href === location.href) follow(figures); // the address does not change then
  }

  /** Programs come as figures come near the window; the small ones begin then, all of a chapter with the first. */
  function whenNear(figures, small) {
    const begun = new Map();
    const begin = (chapter) => {
      if (begun.has(chapter)) return;
      begun.set(chapter, live.beginSmall(small.filter((one) => one.dataset.chapter === chapter)));
      test.small = Promise.all(begun.values()).then((all) => all.flat());
    };
    const near = new IntersectionObserver(
      (seen) => {
        for (const { target } of seen.filter(({ isIntersecting }) => isIntersecting)) {
          near.unobserve(target);
          const { chapter, root } = target.dataset;
          if (small.includes(target)) begin(chapter);
          else live.program(chapter, root).catch(() => {}); // said to who asks for it
        }
      },
      { rootMargin: "100%" },
    );
    for (const figure of [...figures, ...small]) near.observe(figure);
  }

  function begin() {
    const figures = [...document.querySelectorAll("figure.live[data-chapter]")];
    for (const figure of figures) prepare(figure);
    whenNear(figures, [...document.querySelectorAll("figure.small-live")]);
    document.addEventListener("click", (event) => clicked(event, figures));
    addEventListener("hashchange", () => follow(figures));
    const toy = document.querySelector("figure.toy");
    if (toy && !location.hash.startsWith("#live=")) start(toy).then((player) => player ?? toy.classList.remove("toy"));
    else toy?.classList.remove("toy");
    follow(figures);
  }

  // For tests, and for who wants to look inside: the player of a figure, once it runs.
  const first = () => document.querySelector("figure.live[data-chapter]");
  const test = {
    start: (state) => start(first(), new URLSearchParams(state)),
    player: () => players.get(first()),
  };
  window.PUSHBACK_LIVE_TEST = test;
  if (document.readyState === "loading") document.addEventListener("readystatechange", begin, { once: true });
  else queueMicrotask(begin); // once the rest of this script has run
})();
