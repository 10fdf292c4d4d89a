"use strict";
// Finds a page's figures with data-chapter and puts the experiment itself in the place of the picture, once it is asked for.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const own = document.currentScript.src.replace(/[^/]*$/, "");
  const players = new Map();

  function script(address) {
    return new Promise((resolve, reject) => {
      const element = document.createElement("script");
      Object.assign(element, {
        src: address,
        onload: resolve,
        onerror: () => reject(new Error(`${address} could not be loaded`)),
      });
      document.head.append(element);
    });
  }
  let loaded = null;
  function load() {
    loaded = loaded || script(`${own}pieces.js`);
    return loaded;
  }

  /** The answer that a page folds, if it asks for a guess. */
  function answer() {
    const heading = [...document.querySelectorAll("h2, h3")].find((one) => /^\s*your guess/i.test(one.textContent));
    if (!heading) return null;
    for (let next = heading.nextElementSibling; next && !/^H[12]$/.test(next.tagName); next = next.nextElementSibling) {
      const found = next.matches("details") ? next : next.querySelector("details");
      if (found) return found;
    }
    return null;
  }

  async function start(figure, state) {
    if (players.has(figure)) return players.get(figure);
    const panel = figure.querySelector(".pb-start");
    const said = figure.querySelector(".pb-start-said");
    said.textContent = "Loading …";
    for (const button of panel.querySelectorAll("button")) button.disabled = true;
    try {
      await load();
      const root = figure.dataset.root.replace(/\/$/, "");
      const engine = await live.Engine.load(figure.dataset.chapter, root);
      const player = new live.Player(figure, engine, root, state);
      panel.remove();
      players.set(figure, player);
      const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
      if (!state.of && !still) player.play();
      figure.dispatchEvent(new CustomEvent("pushback-live", { detail: player, bubbles: true }));
      return player;
    } catch (problem) {
      console.error(problem);
      for (const button of panel.querySelectorAll("button")) button.disabled = false;
      said.textContent = `The experiment cannot be run here: ${problem.message}`;
      return null;
    }
  }

  function prepare(figure) {
    const folded = answer();
    const panel = document.createElement("div");
    panel.className = "pb-start";
    const button = (text, act) => {
      const made = document.createElement("button");
      Object.assign(made, { type: "button", textContent: text, className: "pb-run" });
      made.addEventListener("click", act);
      return made;
    };
    const said = document.createElement("p");
    said.className = "pb-start-said";
    said.setAttribute("role", "status");
    if (folded && !folded.open) {
      const guess = document.createElement("input");
      Object.assign(guess, {
        type: "text",
        placeholder: "in a few words",
        className: "pb-guess",
        id: `pb-guess-${figure.dataset.chapter}`,
      });
      const label = document.createElement("label");
      label.htmlFor = guess.id;
      label.textContent = "Your guess: ";
      const run = async (text) => {
        const player = await start(figure, {});
        if (player && text) player.guess(text);
      };
      const guessed = button("Run it", () => run(guess.value.trim()));
      guessed.disabled = true;
      guess.addEventListener("input", () => {
        guessed.disabled = !guess.value.trim();
      });
      guess.addEventListener("keydown", (event) => {
        if (event.key === "Enter" && guess.value.trim()) run(guess.value.trim());
      });
      panel.append(
        label,
        guess,
        guessed,
        button("Show me", () => run("")),
      );
    } else {
      panel.append(button("Run it here", () => start(figure, {})));
    }
    panel.append(said);
    figure.insertBefore(panel, figure.querySelector("figcaption"));
  }

  function begin() {
    const figures = [...document.querySelectorAll("figure.live[data-chapter]")];
    for (const figure of figures) prepare(figure);
    const state = new URLSearchParams(location.hash.slice(1));
    const wanted = figures.find((figure) => figure.dataset.chapter === state.get("live"));
    if (!wanted) return;
    start(wanted, { of: state }).then((player) => {
      const part = state.has("problem") || state.has("iteration") ? player?.iterations.element : null;
      (part ?? wanted).scrollIntoView();
    });
  }

  // For tests, and for who wants to look inside: the player of a figure, once it runs.
  window.PUSHBACK_LIVE_TEST = {
    players,
    start: (figure = document.querySelector("figure.live[data-chapter]"), state = {}) => start(figure, state),
    player: (figure = document.querySelector("figure.live[data-chapter]")) => players.get(figure),
  };
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", begin);
  else begin();
})();
