"use strict";
// Finds a page's figures with data-chapter and puts the experiment itself in the place of the picture, once it is asked for.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const own = document.currentScript.src.replace(/[^/]*$/, "");
  const players = new Map();

  const scripts = new Map();
  /** Loads a classic script once: it also works where a page is opened from a folder. */
  live.loadScript = function (address) {
    if (!scripts.has(address)) {
      const load = (resolve, reject) => {
        const element = document.createElement("script");
        Object.assign(element, {
          src: address,
          onload: resolve,
          onerror: () => {
            scripts.delete(address);
            reject(new Error(`${address} could not be loaded`));
          },
        });
        document.head.append(element);
      };
      scripts.set(address, new Promise(load));
    }
    return scripts.get(address);
  };
  /** What plays a program, and at the same time the program. */
  async function load({ chapter, root }) {
    const programs = [`${root}/live/programs/common.js`, `${root}/live/programs/${chapter}.js`];
    for (const address of programs) live.loadScript(address).catch(() => {}); // said to who needs it
    await live.loadScript(`${own}engine.js`);
  }
  /** The rest of a large figure. */
  const loadPieces = () => live.loadScript(`${own}pieces.js`);

  function make(tag, properties, ...children) {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  }

  /** What a page asks for a guess: the answer that it folds, and the list of choices before that, if there is one. */
  function question() {
    const heading = [...document.querySelectorAll("h2, h3")].find((one) => /^\s*your guess/i.test(one.textContent));
    let choices = null;
    for (
      let next = heading?.nextElementSibling;
      next && !/^H[12]$/.test(next.tagName);
      next = next.nextElementSibling
    ) {
      const answer = next.matches("details") ? next : next.querySelector("details");
      if (answer) return answer.open ? null : { answer, choices };
      if (next.matches("ul, ol")) choices = next;
    }
    return null;
  }
  /** The words of a choice: of a formula each sign once, of a picture its number and what is said of it. */
  function wordsOf(choice, place) {
    const copy = choice.cloneNode(true);
    for (const twice of copy.querySelectorAll(".katex-mathml annotation, .katex-html")) twice.remove();
    for (const picture of copy.querySelectorAll("img")) picture.replaceWith(`picture ${place + 1}: ${picture.alt}`);
    return copy.textContent.replace(/\s+/g, " ").trim();
  }

  /**
   * The guess is made where the page asks for it, or at the figure; `run(guess)` plays then. Where the page lists choices, one of them
   * is taken.
   */
  function ask({ answer, choices }, figure, run) {
    const runs = [],
      texts = [];
    let guess = "",
      picture = null;
    const take = (text, seen = null) => {
      guess = text;
      picture = seen;
      for (const button of runs) button.disabled = !guess;
      for (const input of texts) if (input.value.trim() !== guess) input.value = guess;
    };
    const form = (id, label) => {
      const made = make("form", { className: "pb-start" });
      made.addEventListener("submit", (event) => {
        event.preventDefault();
        if (guess) run({ text: guess, picture });
      });
      if (!choices) {
        const input = make("input", { type: "text", placeholder: "in a few words", className: "pb-guess", id });
        input.addEventListener("input", () => take(input.value.trim()));
        texts.push(input);
        made.append(make("label", { htmlFor: id, textContent: "Your guess: " }), input);
      }
      const button = make("button", { className: "pb-run", textContent: label, disabled: true });
      runs.push(button);
      made.append(button);
      return made;
    };
    const name = `pb-guess-${figure.dataset.chapter}`;
    const there = form(`${name}-asked`, "Guess, then run it"),
      here = form(name, "Run it");
    if (choices) {
      const all = make("fieldset", { className: "pb-choices" });
      all.append(make("legend", { textContent: "Your guess" }));
      const pictures = choices.querySelectorAll("img");
      if (pictures.length) all.classList.add("pb-pictures");
      if ([...pictures].some((one) => one.getAttribute("width") > 3 * one.getAttribute("height")))
        all.classList.add("pb-strips-of-pictures");
      [...choices.children].forEach((choice, place) => {
        const radio = make("input", { type: "radio", name, value: wordsOf(choice, place) });
        const image = choice.querySelector("img");
        radio.addEventListener("change", () => take(radio.value, image?.cloneNode()));
        const number = image ? [make("b", { textContent: place + 1, "aria-hidden": "true" })] : [];
        const seen = image ? [image] : choice.childNodes; // without the link that enlarges it: a click is a choice
        all.append(make("label", {}, radio, ...number, make("span", {}, ...seen)));
      });
      choices.remove();
      there.prepend(all);
      here.prepend(
        make("a", {
          href: "#",
          textContent: "Make a guess",
          onclick: (event) => {
            event.preventDefault();
            all.scrollIntoView({ block: "center" });
            all.querySelector("input").focus({ preventScroll: true });
          },
        }),
      );
    }
    there.classList.add("pb-asked");
    answer.before(there);
    here.append(
      make("button", { type: "button", className: "pb-run", textContent: "Show me", onclick: () => run(null) }),
    );
    return here;
  }

  async function start(figure, state) {
    if (players.has(figure)) return players.get(figure);
    const panel = figure.querySelector(".pb-panel"),
      asked = document.querySelector(".pb-asked");
    const said = figure.querySelector(".pb-start-said");
    said.textContent = "Loading …";
    const buttons = [panel, asked].flatMap((one) => [...(one?.querySelectorAll("button:enabled") ?? [])]);
    for (const button of buttons) button.disabled = true;
    try {
      const { chapter, root } = figure.dataset;
      await Promise.all([load({ chapter, root }), loadPieces()]);
      const engine = await live.Engine.load(chapter, root);
      const player = new live.Player(figure, engine, root, state);
      panel.remove();
      asked?.remove();
      players.set(figure, player);
      const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
      if (!state.of && !still) player.play();
      figure.dispatchEvent(new CustomEvent("pushback-live", { detail: player, bubbles: true }));
      return player;
    } catch (problem) {
      console.error(problem);
      for (const button of buttons) button.disabled = false;
      said.textContent = `The experiment cannot be run here: ${problem.message}`;
      return null;
    }
  }

  function prepare(figure) {
    const asked = question();
    const run = async (guess) => {
      const player = await start(figure, {});
      if (!player) return;
      player.bringIntoView();
      if (guess) player.guess(guess, asked.answer);
    };
    const panel = make("div", { className: "pb-panel" });
    const said = make("p", { className: "pb-start-said" });
    said.setAttribute("role", "status");
    const button = () =>
      make(
        "div",
        { className: "pb-start" },
        make("button", { type: "button", className: "pb-run", textContent: "Run it here", onclick: () => run(null) }),
      );
    panel.append(asked ? ask(asked, figure, run) : button(), said);
    figure.insertBefore(panel, figure.querySelector("figcaption"));
  }

  /** Words that set a figure: it shows what they say. */
  function follow(figures) {
    document.addEventListener("click", async (event) => {
      const link = event.target.closest?.("a.sets");
      if (!link || event.ctrlKey || event.metaKey || event.shiftKey || event.button) return;
      const chapter = new URLSearchParams(link.hash.slice(1)).get("live");
      const figure = figures.find((one) => one.dataset.chapter === chapter);
      if (!figure) return;
      event.preventDefault();
      const player = players.get(figure) ?? (await start(figure, { of: new URLSearchParams() }));
      if (!player) return figure.scrollIntoView();
      player.showFor(link);
      player.bringIntoView();
    });
  }

  /** What figures need comes as they come near the window; the small ones begin then, all of them with the first. */
  function whenNear(figures, small) {
    const near = new IntersectionObserver(
      (seen) => {
        for (const { isIntersecting, target } of seen) {
          if (!isIntersecting) continue;
          near.unobserve(target);
          const large = figures.includes(target);
          const loaded = load(target.dataset).catch(() => {}); // said to who asks for it
          if (large) loaded.then(loadPieces).catch(() => {});
          if (!large)
            window.PUSHBACK_LIVE_TEST.small =
              window.PUSHBACK_LIVE_TEST.small || loaded.then(() => live.beginSmall(small));
        }
      },
      { rootMargin: "100%" },
    );
    for (const figure of [...figures, ...small]) near.observe(figure);
  }

  function begin() {
    const figures = [...document.querySelectorAll("figure.live[data-chapter]")];
    for (const figure of figures) prepare(figure);
    follow(figures);
    whenNear(figures, [...document.querySelectorAll("figure.small-live")]);
    const state = new URLSearchParams(location.hash.slice(1));
    const wanted = figures.find((figure) => figure.dataset.chapter === state.get("live"));
    if (!wanted) return;
    start(wanted, { of: state }).then((player) => {
      if (state.has("problem") || state.has("iteration")) player?.iterations.element.scrollIntoView();
      else if (player) player.bringIntoView();
      else wanted.scrollIntoView();
    });
  }

  // For tests, and for who wants to look inside: the player of a figure, once it runs.
  window.PUSHBACK_LIVE_TEST = {
    players,
    start: (figure = document.querySelector("figure.live[data-chapter]"), state = {}) => start(figure, state),
    player: (figure = document.querySelector("figure.live[data-chapter]")) => players.get(figure),
  };
  // As soon as the page is read: other scripts may take longer.
  if (document.readyState === "loading") document.addEventListener("readystatechange", begin, { once: true });
  else begin();
})();
