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
      const { chapter, root } = figure.dataset;
      await Promise.all([load({ chapter, root }), loadPieces()]);
      const engine = await live.Engine.load(chapter, root);
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
    whenNear(figures, [...document.querySelectorAll("figure.small-live")]);
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
  // As soon as the page is read: other scripts may take longer.
  if (document.readyState === "loading") document.addEventListener("readystatechange", begin, { once: true });
  else begin();
})();
