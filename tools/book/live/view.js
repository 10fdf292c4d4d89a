"use strict";
// What stands in the place of a figure's picture: stage, time line, scenes, variants, parameters, numbers, curves.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;
  live.speeds = [1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 4, 8, 16, 32];
  const speedName = (speed) =>
    speed < 1 ? `1/${Math.round(1 / speed)} of real time` : speed === 1 ? "real time" : `${speed} times as fast`;
  const help =
    "Pull a body: it hangs on a spring, in every variant; with a finger, rest on it for a moment first. Beside the bodies, dragging turns the camera; with Shift or the right button it moves it; the wheel zooms once the picture has been clicked; two fingers zoom and move. Keys, when the picture has the focus: space plays, comma and full stop go one step back and on, Home and End to the ends, the arrows turn the camera, plus and minus zoom, 0 puts it back, C shows contact points, I impulses.";

  const shapes = {
    play: "M3 1.5v13l11-6.5z",
    pause: "M3 2h4v12H3zM9 2h4v12H9z",
    step: "M6 2v12l8-6zM2 2h3v12H2z",
    back: "M10 2v12L2 8zM14 2h-3v12h3z",
    begin: "M1.5 2h2v12h-2zM9 2v12L4 8zM15 2v12l-5-6z",
  };
  /** A button with a symbol: its shape and its name are `named` again where they change. */
  live.button = function (shape, label, onclick) {
    const button = make("button", { type: "button", className: "pb-button", onclick });
    button.named = (now, words) => {
      if (button.title === words) return;
      button.innerHTML = `<svg viewBox="0 0 16 16" aria-hidden="true"><path d="${shapes[now]}"/></svg>`;
      button.title = words;
      button.setAttribute("aria-label", words);
    };
    button.named(shape, label);
    return button;
  };
  /** The marker of a variant, in its colour. */
  live.marked = ({ marker, colour, name }) => {
    const mark = make("span", { textContent: `${marker} `, "aria-hidden": "true" });
    mark.style.color = colour;
    return [mark, name];
  };
  /** Where what is in the element is made anew: what had the focus has it again. */
  live.keepingFocus = function (element, work) {
    const all = () => [...element.querySelectorAll("input, button, select")];
    const had = all().indexOf(document.activeElement);
    work();
    if (had >= 0) all()[Math.min(had, all().length - 1)]?.focus();
  };

  /** A caption says "the last row" where a sheet has a row for each variant: here its name. */
  const captionOf = ({ caption, variants }) =>
    caption.replace(/\bthe (first|second|third|last) row\b(?! of)/g, (all, which) => {
      const place = { first: 0, second: 1, third: 2, last: variants.length - 1 }[which];
      return variants[place] ? `“${variants[place].name}”` : all;
    });
  /** s: when a number is what its name says, "drift after 60 s". */
  const due = (name) => Number(/\b(?:after|to) ([\d.]+) s\b/.exec(name)?.[1] ?? 0);

  /** What is folded until somebody asks for it. `opened`: called then. */
  function fold(title, opened, ...children) {
    const details = make("details", { className: "pb-fold" }, make("summary", { textContent: title }), ...children);
    details.addEventListener("toggle", () => details.open && opened());
    return details;
  }

  live.View = class {
    constructor(player, figure) {
      Object.assign(this, { player, figure, engine: player.engine, stageTold: "" });
      const div = (className, ...children) => make("div", { className }, ...children);
      const group = (className, label, ...children) =>
        make("div", { className, role: "group", "aria-label": label }, ...children);
      this.scenes = make("select", {
        "aria-label": "Scene",
        onchange: () => player.chooseScene(this.scenes.selectedIndex),
      });
      this.variants = make("fieldset", { className: "pb-variants" });
      this.sceneLabel = make("label", { className: "pb-scene" }, "Scene ", this.scenes);
      this.caption = make("p", { className: "pb-caption" });
      this.alert = make("p", { className: "pb-alert", role: "alert", hidden: true });
      this.task = make("section", { className: "pb-challenge", "aria-label": "Challenge", hidden: true });
      this.said = make("p", { className: "pb-said", role: "status", "aria-live": "polite" });
      this.iterations = make("section", { className: "pb-iterations" });
      this.legend = make("ul", { className: "pb-legend", "aria-label": "What dots, arrows and colours mean" });
      this.numbers = div("pb-numbers");
      this.top = div("pb-view");
      const sliders = group("pb-sliders", "Parameters"),
        furtherSliders = group("pb-sliders", "Further parameters"),
        plots = div("pb-plots"),
        furtherPlots = div("pb-plots"),
        strips = div("pb-strips"),
        stage = div("pb-stage");
      this.deck = div("pb-deck", sliders, plots, this.legend);
      this.furtherCurves = fold("Further curves", () => this.curves.resize(), furtherPlots);
      const furtherParameters = fold("Further parameters", () => {}, furtherSliders);
      this.measured = fold("What was measured", () => {}, this.numbers);
      this.root = div(
        "pb-live",
        div("pb-top", this.sceneLabel, this.variants),
        ...[this.task, this.caption, this.alert, this.top, this.deck, strips, furtherParameters, this.measured],
        ...[this.furtherCurves, fold("What is drawn", () => {}, this.look()), this.iterations],
        div(
          "pb-foot",
          live.small("copy a link to this", () => player.copyLink()),
          make(
            "details",
            { className: "pb-help" },
            make("summary", { textContent: "mouse, touch and keys" }),
            make("p", { textContent: help }),
          ),
        ),
        this.said,
      );
      this.top.append(stage, this.transport());
      figure.insertBefore(this.root, figure.querySelector(":scope > figcaption"));
      figure.classList.add("pb-running");
      this.stage = new live.Stage(player, stage);
      this.curves = new live.Curves(plots, furtherPlots, (step) => player.go(step));
      this.strips = new live.Strips(strips, (step) => player.go(step));
      this.controls = new live.Controls(
        { first: sliders, further: furtherSliders, fold: furtherParameters },
        this.engine,
        JSON.parse(figure.dataset.idle ?? "{}"),
        (assignments, done) => player.set(assignments, done),
      );
      this.stage.canvas.addEventListener("keydown", (event) => player.key(event));
      this.watch();
    }
    transport() {
      const { player } = this;
      this.playButton = live.button("play", "Play", () => player.toggle());
      this.line = make("input", {
        type: "range",
        min: 0,
        className: "pb-time",
        "aria-label": "Time",
        oninput: () => player.seek(Number(this.line.value)),
        onchange: () => player.remember(),
      });
      this.clock = make("output", { className: "pb-clock" });
      this.speeds = make(
        "select",
        {
          "aria-label": "Speed",
          onchange: () => {
            player.speed = Number(this.speeds.value);
            player.remember();
          },
        },
        ...live.speeds.map((speed) => make("option", { value: speed, textContent: speedName(speed) })),
      );
      return make(
        "div",
        { className: "pb-transport", role: "group", "aria-label": "Time" },
        live.button("begin", "To the start", () => player.go(0)),
        live.button("back", "One step back", () => player.go(player.engine.now - 1)),
        this.playButton,
        live.button("step", "One step on", () => player.go(player.engine.now + 1)),
        ...[this.line, this.clock, this.speeds],
      );
    }
    look() {
      const { player } = this;
      const check = (text, onchange) => {
        const box = make("input", { type: "checkbox", onchange: () => onchange(box.checked) });
        return [box, make("label", { className: "pb-check" }, box, text)];
      };
      const toggles = ["contact points", "impulses", "what should be"].map((text, i) =>
        check(text, (yes) => player.show(1 << i, yes)),
      );
      this.toggles = toggles.map(([box]) => box);
      [this.following, this.followLabel] = check("stay close", (yes) => {
        this.stage.follow = yes;
        player.changed();
        player.remember();
      });
      const back = live.small("camera as it was", () => {
        this.stage.camera.reset();
        player.changed();
        player.remember();
      });
      return make("div", { className: "pb-look" }, ...toggles.map(([, label]) => label), this.followLabel, back);
    }

    // ---- the window
    watch() {
      const sized = new ResizeObserver(() => {
        this.curves.resize();
        this.player.iterations?.resize();
        this.fit();
      });
      for (const element of [this.root, this.deck]) sized.observe(element);
      addEventListener("resize", () => this.fit());
      new IntersectionObserver(([{ isIntersecting }]) => this.player.see(isIntersecting)).observe(this.top);
      // Canvases are drawn in the colours that the page has at that moment.
      document.documentElement.addEventListener("theme", () => {
        this.curves.recolour();
        this.player.iterations.recolour();
      });
      document.documentElement.addEventListener("lit", () => this.player.changed());
    }
    /** On a telephone the picture stays above what is scrolled. */
    get narrow() {
      return this.root.clientWidth < live.Stage.narrow;
    }
    get barred() {
      return parseFloat(getComputedStyle(document.documentElement).scrollPaddingTop) || 0;
    }
    /** The picture is as high as leaves room for what changes it, and for the curve of what comes of it. */
    fit() {
      const { stage, top, deck, root } = this,
        own = stage.element.offsetHeight + this.legend.offsetHeight; // the legend grows while the picture keeps its size
      const rest = this.narrow
        ? top.offsetHeight - own + deck.offsetHeight
        : deck.getBoundingClientRect().bottom - root.getBoundingClientRect().top - own;
      stage.room = Math.max(
        240,
        Math.min((this.player.toy ? 0.5 : 0.72) * innerHeight, innerHeight - this.barred - rest - 8),
      );
      stage.arrange();
      stage.label();
      this.player.toy?.place();
      this.player.changed();
    }
    /** Into the window, and the keys go to it. */
    bringIntoView() {
      const whole = this.deck.getBoundingClientRect().bottom - this.root.getBoundingClientRect().top;
      (this.narrow || whole > innerHeight - this.barred ? this.top : this.root).scrollIntoView();
      this.stage.canvas.focus({ preventScroll: true });
    }

    // ---- of the scene
    begin() {
      const { engine } = this,
        { scene } = engine;
      this.caption.textContent = captionOf(scene);
      this.caption.hidden = !scene.caption || Boolean(this.player.challenge);
      this.stage.begin();
      this.list();
      this.listNumbers();
      this.lengthened();
      this.furtherCurves.hidden = !this.curves.further;
      this.measured.hidden = !scene.numbers.length;
    }
    /** The time line, and what has its length. */
    lengthened() {
      this.line.max = this.engine.steps;
      this.curves.begin(this.engine);
      this.strips.begin(this.engine);
      this.known = null;
    }
    challenging(challenge) {
      this.task.hidden = !challenge;
      this.sceneLabel.hidden = this.caption.hidden = Boolean(challenge);
      this.controls.only = challenge?.free;
      this.controls.build();
    }
    /** Scenes, variants, speed and what is drawn, as they are. */
    list() {
      const { engine, player } = this,
        { variants } = engine.scene;
      const shown = engine.lanes.map(({ place }) => place);
      this.scenes.replaceChildren(
        ...engine.description.scenes.map(({ name: textContent, variants }) =>
          make("option", { textContent, disabled: !variants.length }),
        ),
      );
      this.scenes.selectedIndex = engine.sceneIndex;
      this.speeds.value = player.speed;
      this.followLabel.hidden = !engine.scene.strobe;
      this.following.checked = this.stage.follow;
      this.toggles.forEach((box, i) => (box.checked = (player.shown & (1 << i)) !== 0));
      this.variants.hidden = variants.length < 2 || Boolean(player.challenge);
      const boxes = variants.map((variant, place) => {
        const onchange = () => player.chooseVariant(place, box.checked);
        const box = make("input", { type: "checkbox", checked: shown.includes(place), onchange });
        return make("label", { className: "pb-check" }, box, ...live.marked(variant));
      });
      const legend = make("legend", { textContent: variants.length > 4 ? "Variants, up to four" : "Variants" });
      live.keepingFocus(this.variants, () => this.variants.replaceChildren(legend, ...boxes));
    }
    listNumbers() {
      const { lanes, scene } = this.engine;
      this.cells = [];
      for (const lane of this.stage.numbers.keys()) this.stage.number(lane, "", "");
      const row = ({ name }, which) => {
        const cells = lanes.map(({ lane }) => {
          const cell = make("td", { textContent: "–" });
          this.cells.push({ cell, lane, which });
          return cell;
        });
        return make("tr", {}, make("th", { scope: "row", textContent: name }), ...cells);
      };
      const heads = lanes.map((lane) => make("th", { scope: "col" }, ...live.marked(lane)));
      const table = make(
        "table",
        { "aria-label": "What was measured up to now" },
        make("thead", {}, make("tr", {}, make("td"), ...heads)),
        make("tbody", {}, ...scene.numbers.map(row)),
      );
      const words = "Measured up to now. What it should be is said of the whole scene.";
      this.numbers.replaceChildren(make("p", { textContent: words }), make("div", { className: "pb-scroll" }, table));
    }
    listLegend() {
      const colours = this.engine.scene.colours.map(({ colour, text }) => ["body", colour, text]);
      const entries = [...this.engine.legend(), ...colours],
        key = JSON.stringify(entries);
      if (key === this.legendKey) return;
      this.legendKey = key;
      this.legend.replaceChildren(...entries.map((entry) => make("li", {}, ...live.swatch(...entry))));
    }

    // ---- of the instant
    read(now) {
      const { engine, player, stage } = this;
      const time = `${(engine.now * engine.dt).toFixed(3)} s`;
      this.line.value = engine.now;
      this.clock.textContent = `${time} of ${Number((engine.steps * engine.dt).toPrecision(4))} s`;
      this.line.setAttribute("aria-valuetext", `${time}, step ${engine.now}`);
      this.playButton.named(player.playing ? "pause" : "play", player.playing ? "Pause" : "Play");
      this.figure.classList.toggle("pb-still", Boolean(stage.problem));
      if (stage.problem !== this.stageTold) this.tell(stage.problem && `${stage.problem} The picture stays still.`);
      this.stageTold = stage.problem;
      if (!stage.problem && !live.lit()) this.listLegend(); // what is lit has a colour of its own
      const key = `${engine.now} ${engine.known} ${player.playing}`;
      if (this.known?.key === key || (player.playing && this.known && now - this.known.at < 200)) return;
      this.known = { key, at: now };
      player.panel?.update(engine.now, player.pulled);
      if (!player.playing || !(this.cost > 50)) this.measure();
      this.curves.update();
      this.strips.update();
      const { names } = player;
      const seen = stage.tabbed ? names[stage.tab] : `from left to right and from the top: ${names.join("; ")}`;
      stage.canvas.setAttribute("aria-label", `${engine.scene.name}, at ${time}: ${seen}.`);
    }
    measure() {
      const { engine } = this,
        began = performance.now();
      for (const { cell, lane, which } of this.cells) {
        const { name } = engine.scene.numbers[which],
          from = due(name);
        const early = engine.now * engine.dt < from - engine.dt / 2;
        const [is, should] = early ? [`from ${from} s on`] : engine.number(lane, which);
        cell.replaceChildren(is);
        if (which === 0) this.stage.number(lane, ...(early || !engine.now ? ["", ""] : [name, is]));
        const expected = `\u00a0(should be\u00a0${should})`;
        if (should) cell.append(make("span", { className: "pb-should", textContent: expected }));
      }
      this.cost = performance.now() - began; // ms: where it takes long, only when nothing moves
    }
    tell(problem) {
      this.alert.textContent = problem;
      this.alert.hidden = !problem;
    }
    /** For those who listen: what there is where it stopped. */
    say() {
      const { engine } = this;
      this.measure();
      const numbers = engine.scene.numbers.slice(0, 2).map(({ name }, which) => {
        const cells = this.cells.filter((one) => one.which === which);
        return `${name}: ${cells.map(({ cell, lane }) => `${engine.lanes[lane].name} ${cell.textContent}`).join(", ")}`;
      });
      this.said.textContent = [`At ${(engine.now * engine.dt).toFixed(2)} s`, ...numbers].join(". ");
    }
  };

  /** An entry of a legend. */
  live.swatch = function (kind, colour, text) {
    const mark = make("span", { className: `pb-mark pb-${kind}`, "aria-hidden": "true" });
    mark.style.setProperty("--pb-mark", colour);
    return [mark, text];
  };
})();
