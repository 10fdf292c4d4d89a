"use strict";
// One figure of a page: the experiment in the place of its picture.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;
  const speeds = [1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 4, 8];
  const speedName = (speed) =>
    speed < 1 ? `1/${Math.round(1 / speed)} of real time` : speed === 1 ? "real time" : `${speed} times as fast`;
  const slowNumber = 12; // ms: what takes longer is worked out when nothing moves

  const symbols = {
    play: "M3 1.5v13l11-6.5z",
    pause: "M3 2h4v12H3zM9 2h4v12H9z",
    step: "M6 2v12l8-6zM2 2h3v12H2z",
    back: "M10 2v12L2 8zM14 2h-3v12h3z",
    begin: "M1.5 2h2v12h-2zM9 2v12L4 8zM15 2v12l-5-6z",
  };
  function icon(name) {
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("viewBox", "0 0 16 16");
    svg.setAttribute("aria-hidden", "true");
    const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
    path.setAttribute("d", symbols[name]);
    svg.append(path);
    return svg;
  }
  function button(name, label, onclick) {
    return make(
      "button",
      { type: "button", className: "pb-button", "aria-label": label, title: label, onclick },
      icon(name),
    );
  }

  live.transport = { icon, button };

  /** A caption says "the last row" where a sheet has a row for each variant: here its name. */
  live.captionOf = function ({ caption, variants }) {
    const places = { first: 0, second: 1, third: 2, last: variants.length - 1 };
    return caption.replace(/\bthe (first|second|third|last) row\b(?! of)/g, (all, which) => {
      const variant = variants[places[which]];
      return variant ? `“${variant.name}”` : all;
    });
  };
  /** s: when a number is what its name says, "drift after 60 s". */
  const due = (name) => Number(/\b(?:after|to) ([\d.]+) s\b/.exec(name)?.[1] ?? 0);

  /** What is folded until somebody asks for it. `opened`: called then. */
  function fold(title, opened, ...children) {
    const summary = make("summary", { textContent: title });
    const details = make("details", { className: "pb-fold" }, summary, ...children);
    details.addEventListener("toggle", () => details.open && opened());
    return details;
  }

  live.Player = class {
    /** In `figure`, whose picture goes while this runs. `state`: of an address, as `state` gives it. */
    constructor(figure, engine, root, state = {}) {
      Object.assign(this, { figure, engine, root });
      this.playing = false;
      this.told = "";
      this.shown = 7;
      this.grabbing = true;
      this.target = 0;
      this.owed = 0;
      this.slow = new Set();
      this.take(state);
      this.build();
      this.iterations.begin(state.problem, state.iteration);
      this.arrive(state);
    }
    /** What was taken of an address is drawn. */
    arrive(state) {
      const { stage, engine } = this;
      if (state.view) Object.assign(stage.camera, state.view);
      stage.wipe = state.wipe ?? null;
      stage.follow = state.follow ?? (engine.scene.strobe && stage.element.clientWidth < 560);
      this.begin();
      this.challenged();
      this.tell(this.problem);
      this.fit();
      this.seek(state.step || 0);
    }
    /** What the address has taken up, with its own parameters; or nothing any more. */
    challenged() {
      const { challenge } = this;
      const leave = () => {
        this.challenge = null;
        this.challenged();
        this.listVariants();
        this.fit();
        this.remember();
      };
      this.task.hidden = !challenge;
      this.scenes.parentElement.hidden = this.caption.hidden = Boolean(challenge);
      this.controls.only = challenge?.free;
      this.controls.build();
      this.panel = challenge && new live.ChallengePanel(this.task, this, challenge, leave);
    }
    /** At once; what was pulled is forgotten. */
    playToEnd() {
      this.playing = this.waits = false;
      if (this.pulled) this.again(() => this.engine.set(this.controls.assignments));
      this.seek(this.engine.steps);
      this.remember();
    }
    /** What words of the page ask for, in the place of what is played; `link` holds the words, and leads back to them. */
    showFor(link) {
      const state = { of: new URLSearchParams(link.hash.slice(1)) };
      this.playing = this.waits = false;
      this.release();
      this.engine.set("");
      this.speed = this.challenge = null;
      this.take(state);
      this.stage.camera.reset();
      delete state.follow;
      this.arrive(state);
      this.returnTo(link, state.step);
    }
    /** Played from the start, where the words name no instant. */
    returnTo(link, step) {
      this.sentence.replaceChildren(
        `“${link.textContent.trim()}” `,
        make("button", {
          type: "button",
          className: "pb-small",
          textContent: "back to the sentence",
          onclick: () => {
            link.scrollIntoView({ block: "center" });
            link.focus({ preventScroll: true });
          },
        }),
      );
      this.sentence.hidden = false;
      if (!step && !matchMedia("(prefers-reduced-motion: reduce)").matches) this.play();
      this.remember();
    }

    // ---- the page
    build() {
      this.root_ = make("div", { className: "pb-live" });
      this.alert = make("p", { className: "pb-alert", role: "alert", hidden: true });
      this.scenes = make("select", {
        "aria-label": "Scene",
        onchange: () => this.chooseScene(this.scenes.selectedIndex),
      });
      this.caption = make("p", { className: "pb-caption" });
      this.sentence = make("p", { className: "pb-caption pb-sentence", hidden: true });
      this.task = make("section", { className: "pb-challenge", "aria-label": "Challenge", hidden: true });
      const stage = make("div", { className: "pb-stage" });
      this.view = make("div", { className: "pb-view" });
      this.deck = make("div", { className: "pb-deck" });
      this.legend = make("ul", { className: "pb-legend", "aria-label": "What dots, arrows and colours mean" });
      this.playButton = button("play", "Play", () => this.toggle());
      this.line = make("input", {
        type: "range",
        min: 0,
        className: "pb-time",
        "aria-label": "Time",
        oninput: () => this.seek(Number(this.line.value)),
        onchange: () => this.remember(),
      });
      this.clock = make("output", { className: "pb-clock" });
      this.speeds = make(
        "select",
        {
          className: "pb-speed",
          "aria-label": "Speed",
          onchange: () => {
            this.speed = Number(this.speeds.value);
            this.remember();
          },
        },
        ...speeds.map((speed) => make("option", { value: speed, textContent: speedName(speed) })),
      );
      const transport = make(
        "div",
        { className: "pb-transport", role: "group", "aria-label": "Time" },
        button("begin", "To the start", () => this.go(0)),
        button("back", "One step back", () => this.go(this.engine.now - 1)),
        this.playButton,
        button("step", "One step on", () => this.go(this.engine.now + 1)),
        this.line,
        this.clock,
        this.speeds,
      );
      this.variants = make("fieldset", { className: "pb-variants" });
      const toggle = (text, bit) => {
        const box = make("input", {
          type: "checkbox",
          onchange: () => {
            this.show(bit, box.checked);
          },
        });
        return [box, make("label", { className: "pb-check" }, box, text)];
      };
      const [points, pointsLabel] = toggle("contact points", 1);
      const [impulses, impulsesLabel] = toggle("impulses", 2);
      const [marks, marksLabel] = toggle("what should be", 4);
      this.toggles = [
        [1, points],
        [2, impulses],
        [4, marks],
      ];
      this.wiping = make("input", { type: "checkbox", onchange: () => this.setWipe(this.wiping.checked ? 0.5 : null) });
      this.wipeLabel = make("label", { className: "pb-check" }, this.wiping, "wipe between the two");
      this.following = make("input", {
        type: "checkbox",
        onchange: () => {
          this.stage.follow = this.following.checked;
          this.changed();
          this.remember();
        },
      });
      this.followLabel = make("label", { className: "pb-check" }, this.following, "stay close");
      const look = make(
        "div",
        { className: "pb-look", role: "group", "aria-label": "Picture" },
        pointsLabel,
        impulsesLabel,
        marksLabel,
        this.followLabel,
        this.wipeLabel,
        make("button", {
          type: "button",
          className: "pb-small",
          textContent: "camera as it was",
          onclick: () => {
            this.stage.camera.reset();
            this.changed();
            this.remember();
          },
        }),
      );
      this.numbers = make("div", { className: "pb-numbers" });
      const sliders = make("div", { className: "pb-sliders", role: "group", "aria-label": "Parameters" }),
        furtherSliders = make("div", { className: "pb-sliders", role: "group", "aria-label": "Further parameters" });
      const plots = make("div", { className: "pb-plots" }),
        furtherPlots = make("div", { className: "pb-plots" }),
        strips = make("div", { className: "pb-strips" }),
        iterations = make("section", { className: "pb-iterations" });
      const none = () => {};
      this.furtherCurves = fold("Further curves", () => this.curves.resize(), furtherPlots);
      this.furtherSliders = fold("Further parameters", none, furtherSliders);
      this.measured = fold("What was measured", none, this.numbers);
      const bench = make(
        "div",
        {},
        this.view,
        this.deck,
        strips,
        this.furtherSliders,
        this.measured,
        this.furtherCurves,
        fold("What is drawn", none, look),
      );
      this.said = make("p", { className: "pb-said", role: "status", "aria-live": "polite" });
      this.link = make("button", {
        type: "button",
        className: "pb-small",
        textContent: "copy a link to this",
        onclick: () => this.copyLink(),
      });
      const foot = make(
        "div",
        { className: "pb-foot" },
        make("button", {
          type: "button",
          className: "pb-small",
          textContent: "save as a picture",
          onclick: () => live.savePicture(this),
        }),
        this.link,
        make(
          "details",
          { className: "pb-help" },
          make("summary", { textContent: "mouse, touch and keys" }),
          make("p", {
            textContent:
              "Pull a body: it hangs on a spring, in every variant; with a finger, rest on it for a moment first. Beside the bodies, dragging turns the camera; with Shift or the right button it moves it; the wheel zooms once the picture has been clicked; two fingers zoom and move. Keys, when the picture has the focus: space plays, comma and full stop go one step back and on, Home and End to the ends, the arrows turn the camera, plus and minus zoom, 0 puts it back, C shows contact points, I impulses.",
          }),
        ),
      );
      this.root_.append(
        make(
          "div",
          { className: "pb-top" },
          make("label", { className: "pb-scene" }, "Scene ", this.scenes),
          this.variants,
        ),
        this.task,
        this.caption,
        this.alert,
        bench,
        iterations,
        foot,
        this.said,
      );
      this.view.append(this.sentence, stage, transport);
      this.deck.append(sliders, plots, this.legend);
      this.figure.insertBefore(this.root_, this.figure.querySelector(":scope > figcaption"));
      this.figure.classList.add("pb-running");
      this.stage = new live.Stage(this, stage);
      this.curves = new live.Curves(plots, furtherPlots, (step) => this.go(step));
      this.strips = new live.Strips(strips, (step) => this.go(step));
      this.controls = new live.Controls(
        { first: sliders, further: furtherSliders, fold: this.furtherSliders },
        this.engine,
        JSON.parse(this.figure.dataset.idle ?? "{}"),
        (assignments, done) => this.set(assignments, done),
      );
      this.iterations = new live.Iterations(iterations, this.engine, () => this.remember());
      this.stage.canvas.addEventListener("keydown", (event) => this.key(event));
      this.watch = new ResizeObserver(() => {
        this.curves.resize();
        this.iterations.resize();
        this.fit();
      });
      for (const element of [this.root_, this.deck]) this.watch.observe(element);
      addEventListener("resize", () => this.fit());
      new IntersectionObserver(([{ isIntersecting }]) => this.see(isIntersecting)).observe(this.view);
      // Canvases are drawn in the colours that the page has at that moment.
      const recolour = () => {
        this.curves.recolour();
        this.iterations.recolour();
      };
      document.documentElement.addEventListener("theme", recolour);
      matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolour);
    }

    // ---- the window
    /** On a telephone the picture stays above what is scrolled. */
    get narrow() {
      return this.root_.clientWidth < live.Stage.narrow;
    }
    get barred() {
      return parseFloat(getComputedStyle(document.documentElement).scrollPaddingTop) || 0;
    }
    /** The picture is as high as leaves room for what changes it, and for the curve of what comes of it. */
    fit() {
      const { stage, view, deck, root_ } = this,
        own = stage.element.offsetHeight;
      const rest = this.narrow
        ? view.offsetHeight - own + deck.offsetHeight
        : deck.getBoundingClientRect().bottom - root_.getBoundingClientRect().top - own;
      stage.room = Math.max(240, Math.min(0.72 * innerHeight, innerHeight - this.barred - rest - 8));
      stage.arrange();
      stage.label();
      this.changed();
    }
    /** Into the window, and the keys go to it. */
    bringIntoView() {
      const whole = this.deck.getBoundingClientRect().bottom - this.root_.getBoundingClientRect().top;
      (this.narrow || whole > innerHeight - this.barred ? this.view : this.root_).scrollIntoView();
      this.stage.canvas.focus({ preventScroll: true });
    }
    /** What leaves the window waits until it is back. */
    see(inSight) {
      if (inSight && this.waits) this.play();
      else if (!inSight && this.playing && !this.held) {
        this.pause();
        this.waits = true;
      }
    }

    /** The scene that is chosen, from its start. */
    begin() {
      const { engine } = this,
        { scene } = engine;
      this.scenes.replaceChildren(
        ...engine.description.scenes.map(({ name }) => make("option", { textContent: name })),
      );
      this.scenes.selectedIndex = engine.sceneIndex;
      this.caption.textContent = live.captionOf(scene);
      this.caption.hidden = !scene.caption || Boolean(this.challenge);
      this.pulled = false;
      this.line.max = engine.steps;
      this.listVariants();
      this.followLabel.hidden = !scene.strobe;
      this.wipeLabel.hidden = engine.lanes.length !== 2;
      if (engine.lanes.length !== 2) this.stage.wipe = null;
      this.wiping.checked = this.stage.wipe !== null;
      this.following.checked = this.stage.follow;
      for (const [bit, box] of this.toggles) box.checked = (this.shown & bit) !== 0;
      this.speed = this.speed || this.usualSpeed();
      this.speeds.value = this.speed;
      this.slow.clear();
      this.listNumbers();
      this.stage.begin();
      this.curves.begin(engine);
      this.strips.begin(engine);
      this.furtherCurves.hidden = !this.curves.further;
      this.measured.hidden = !scene.numbers.length;
      this.read = null;
    }

    usualSpeed() {
      const seconds = this.engine.steps * this.engine.dt;
      return speeds.filter((speed) => speed <= 1 && seconds / speed >= 3).pop() || speeds[0];
    }

    listVariants() {
      const { engine } = this,
        shown = new Set(engine.lanes.map(({ place }) => place)),
        { variants } = engine.scene;
      this.variants.hidden = variants.length < 2 || Boolean(this.challenge);
      live.keepingFocus(this.variants, () => {
        this.variants.replaceChildren(
          make("legend", { textContent: variants.length > 4 ? "Variants, up to four" : "Variants" }),
          ...variants.map(({ name, colour, marker }, place) => {
            const box = make("input", {
              type: "checkbox",
              checked: shown.has(place),
              onchange: () => this.chooseVariant(place, box.checked),
            });
            const mark = make("span", { textContent: `${marker} `, "aria-hidden": "true" });
            mark.style.color = colour;
            return make("label", { className: "pb-check" }, box, mark, name);
          }),
        );
      });
    }

    listNumbers() {
      const { engine } = this,
        { scene } = engine;
      this.numbers.replaceChildren();
      this.cells = [];
      if (!scene.numbers.length) return;
      this.numbers.append(
        make("p", { textContent: "Measured up to now. What it should be is said of the whole scene." }),
      );
      const table = make("table", { "aria-label": "What was measured up to now" });
      table.append(
        make(
          "thead",
          {},
          make(
            "tr",
            {},
            make("td"),
            ...engine.lanes.map(({ name, colour, marker }) => {
              const mark = make("span", { textContent: `${marker} `, "aria-hidden": "true" });
              mark.style.color = colour;
              return make("th", { scope: "col" }, mark, name);
            }),
          ),
        ),
      );
      const body = make("tbody");
      scene.numbers.forEach(({ name }, which) => {
        body.append(
          make(
            "tr",
            {},
            make("th", { scope: "row", textContent: name }),
            ...engine.lanes.map(({ lane }) => {
              const cell = make("td", { textContent: "–" });
              this.cells.push({ cell, lane, which });
              return cell;
            }),
          ),
        );
      });
      table.append(body);
      this.numbers.append(make("div", { className: "pb-scroll" }, table));
    }

    // ---- what somebody does
    toggle() {
      this.playing ? this.pause() : this.play();
    }
    play() {
      if (this.engine.now >= this.engine.steps) this.seek(0);
      this.playing = true;
      this.waits = false;
      this.before = performance.now();
      this.owed = 0;
      this.changed();
    }
    pause() {
      this.playing = this.waits = false;
      this.release();
      this.remember();
      this.changed();
      this.measure();
      this.say();
    }
    go(step) {
      this.playing = this.waits = false;
      this.seek(step);
      this.remember();
    }
    /** ms: what takes long is played bit by bit, in smaller bits until a slider has its first picture. */
    get slice() {
      return this.answer?.first === null ? 10 : 25;
    }
    seek(step) {
      this.target = Math.min(this.engine.steps, Math.max(0, step));
      this.engine.goTo(this.target, this.slice);
      this.changed();
    }
    show(bit, yes) {
      this.shown = yes ? this.shown | bit : this.shown & ~bit;
      this.changed();
      this.remember();
    }
    setWipe(part) {
      this.stage.wipe = part;
      this.wiping.checked = part !== null;
      this.changed();
      this.remember();
    }
    chooseScene(scene) {
      this.playing = this.waits = false;
      this.tell(this.engine.choose(scene, this.shownIn(scene)));
      this.stage.camera.reset();
      this.speed = null;
      this.target = 0;
      this.shownOf(this.engine.scene);
      this.begin();
      this.controls.build();
      this.changed();
      this.remember();
    }
    /** Of another scene the same variants, where it has the same; else the first four. */
    shownIn(scene) {
      const { engine } = this;
      const names = ({ variants }) => variants.map(({ name }) => name).join("\n");
      const same = names(engine.description.scenes[scene]) === names(engine.scene);
      return same ? engine.lanes.map(({ place }) => place) : [0, 1, 2, 3];
    }
    shownOf(scene) {
      this.shown = 4 | (scene.contacts ? 1 : 0) | (scene.impulses ? 2 : 0);
    }
    chooseVariant(place, yes) {
      let places = this.engine.lanes.map((lane) => lane.place).filter((one) => one !== place);
      if (yes) places = [...places.slice(-3), place];
      if (!places.length) {
        this.tell("One variant at least has to be shown.");
        return this.listVariants();
      }
      this.again(() => this.engine.choose(this.engine.sceneIndex, places));
      this.controls.build(); // a variant may have sweeps of its own
      this.remember();
    }
    /** After a change the scene is played again, up to where it was. */
    again(change) {
      const step = this.playing ? this.engine.now : this.target;
      const problem = change();
      this.tell(problem);
      if (problem) return;
      this.begin();
      this.seek(step);
    }
    set(assignments, done) {
      const { engine } = this;
      // Slices that were spent on steps; those before the first picture; ms until that is there, and the last one.
      this.answer = { began: performance.now(), slices: 0, first: null, shown: null, complete: null };
      this.again(() => {
        const before = engine.scene.variants.length,
          all = engine.lanes.length === Math.min(4, before);
        const problem = engine.set(assignments);
        if (!problem && all && engine.scene.variants.length > before) engine.choose(engine.sceneIndex, [0, 1, 2, 3]);
        if (!problem) this.iterations.changed();
        return problem;
      });
      this.answer.slices = 1;
      if (!done) this.stage.hurry();
      if (done) {
        this.controls.build();
        this.remember();
      }
    }
    /** The time goes on, and farther than the scene's own where it was about to end. */
    grabbed() {
      this.held = this.pulled = true;
      this.target = this.engine.now;
      this.line.max = this.engine.steps;
      this.curves.begin(this.engine);
      this.strips.begin(this.engine);
      if (!this.playing) this.play();
    }
    release() {
      if (!this.held) return;
      this.held = false;
      this.engine.letGo();
    }
    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const { camera } = this.stage;
      const keys = {
        " ": () => this.toggle(),
        ".": () => this.go(this.engine.now + 1),
        ",": () => this.go(this.engine.now - 1),
        Home: () => this.go(0),
        End: () => this.go(this.engine.steps),
        ArrowLeft: () => camera.orbit(0.1, 0),
        ArrowRight: () => camera.orbit(-0.1, 0),
        ArrowUp: () => camera.orbit(0, 0.08),
        ArrowDown: () => camera.orbit(0, -0.08),
        "+": () => camera.zoomBy(0.87),
        "-": () => camera.zoomBy(1.15),
        0: () => camera.reset(),
        c: () => this.flip(1),
        i: () => this.flip(2),
      };
      const act = keys[event.key] || keys[event.key.toLowerCase()];
      if (!act) return;
      event.preventDefault();
      act();
      this.changed();
      this.remember();
    }
    flip(bit) {
      this.show(bit, (this.shown & bit) === 0);
      for (const [each, box] of this.toggles) if (each === bit) box.checked = (this.shown & bit) !== 0;
    }

    // ---- time
    changed() {
      this.dirty = true;
      if (!this.asked) this.asked = requestAnimationFrame(() => this.frame());
    }
    frame() {
      this.asked = 0;
      this.dirty = false;
      const { engine } = this,
        now = performance.now();
      if (this.playing) {
        this.owed += (Math.min(100, now - this.before) / 1000) * (this.speed / engine.dt);
        this.before = now;
        const steps = Math.floor(this.owed);
        if (steps > 0) {
          this.target = Math.min(engine.steps, engine.now + steps);
          const reached = engine.goTo(this.target, 20);
          this.owed = reached < this.target ? 0 : this.owed - steps;
          this.target = reached;
          if (reached >= engine.steps) {
            this.pause();
            this.compare();
          }
        }
      } else if (engine.now !== this.target) {
        engine.goTo(this.target, this.slice);
        if (this.answer) ++this.answer.slices;
      }
      const moving = this.playing || engine.now !== this.target;
      if (moving) this.stage.hurry();
      // One picture at a time: where they take long, those that wait would come later than what is asked for next.
      this.late = Boolean(this.stage.drawing);
      if (!this.late) {
        this.stage.draw();
        if (this.answer) this.answer.first ??= this.answer.slices;
      }
      // Where pictures take long, numbers and curves come after them, not between a slider and its picture.
      this.unread = this.stage.coarse && Boolean(this.stage.drawing);
      if (!this.unread) this.readings(now);
      if (moving) this.changed();
    }
    /** The graphics are done with the picture that they were given then. */
    drawn(began) {
      const { answer, engine } = this,
        now = performance.now();
      if (answer && !answer.complete && began >= answer.began) {
        answer.shown ??= now - answer.began;
        if (engine.now === this.target && !this.late) answer.complete = now - answer.began;
      }
      if (this.unread) this.readings(now);
      this.unread = false;
      if (this.late) this.changed();
    }
    readings(now) {
      const { engine } = this;
      const time = engine.now * engine.dt,
        whole = engine.steps * engine.dt;
      this.line.value = engine.now;
      this.clock.textContent = `${time.toFixed(3)} s of ${Number(whole.toPrecision(4))} s`;
      this.line.setAttribute("aria-valuetext", `${time.toFixed(3)} seconds, step ${engine.now}`);
      this.line.style.setProperty("--pb-known", `${(100 * engine.known) / engine.steps}%`);
      const name = this.playing ? "pause" : "play";
      if (this.playButton.dataset.name !== name) {
        this.playButton.dataset.name = name;
        this.playButton.replaceChildren(icon(name));
        this.playButton.title = this.playing ? "Pause" : "Play";
        this.playButton.setAttribute("aria-label", this.playButton.title);
      }
      this.figure.classList.toggle("pb-still", Boolean(this.stage.problem));
      this.tellStage(this.stage.problem);
      if (!this.stage.problem) this.listLegend();
      const key = `${engine.now} ${engine.known} ${this.playing}`;
      if (this.read && this.read.key === key) return;
      if (this.playing && this.read && now - this.read.at < 200) return;
      this.read = { key, at: now };
      this.measure();
      this.curves.update();
      this.strips.update();
      const lanes = engine.lanes.map(({ name: one }) => one).join("; ");
      this.stage.canvas.setAttribute(
        "aria-label",
        [
          `${engine.scene.name}, at ${time.toFixed(2)} s.`,
          this.stage.tabbed
            ? `${engine.lanes[this.stage.tab].name}.`
            : `From left to right and from the top: ${lanes}.`,
          this.stage.outside ? `Outside of the picture: ${this.stage.outside}.` : "",
        ].join(" "),
      );
    }
    /** What takes long is worked out when nothing moves. */
    measure() {
      const { engine } = this;
      this.panel?.update(engine.now, this.pulled);
      for (const { cell, lane, which } of this.cells) {
        const key = `${lane} ${which}`,
          from = due(engine.scene.numbers[which].name);
        if (engine.now * engine.dt < from - engine.dt / 2) {
          cell.replaceChildren(`from ${from} s on`);
          continue;
        }
        if (this.playing && this.slow.has(key)) continue;
        const began = performance.now();
        const [is, should] = engine.number(lane, which);
        if (performance.now() - began > slowNumber) this.slow.add(key);
        cell.replaceChildren(is);
        if (should)
          cell.append(make("span", { className: "pb-should", textContent: `\u00a0(should be\u00a0${should})` }));
      }
    }
    listLegend() {
      const ofScene = this.engine.scene.colours.map(({ colour, text }) => ["body", colour, text]),
        entries = [...this.engine.legend(), ...ofScene],
        key = JSON.stringify(entries);
      if (key === this.legendKey) return;
      this.legendKey = key;
      this.legend.replaceChildren(
        ...entries.map(([kind, colour, text]) => {
          const mark = make("span", { className: `pb-mark pb-${kind}`, "aria-hidden": "true" });
          mark.style.setProperty("--pb-mark", colour);
          return make("li", {}, mark, text);
        }),
      );
    }

    // ---- words
    /** What was guessed, and the answer that the page folds: beside each other, once it has been played. */
    guess({ text, picture }, answer) {
      this.guessed = { text, picture, answer };
      if (!this.playing) this.compare();
    }
    compare() {
      if (!this.guessed) return;
      const { text, picture, answer } = this.guessed;
      this.guessed = null;
      answer.open = true;
      answer.before(make("p", { className: "pb-guessed", textContent: `Your guess: ${text}` }));
      const copy = answer.cloneNode(true);
      copy.querySelector("summary").remove();
      for (const element of copy.querySelectorAll("[id]")) element.removeAttribute("id");
      const both = make(
        "details",
        { className: "pb-fold pb-compare", open: true },
        make("summary", { textContent: "Your guess and the answer" }),
        make(
          "div",
          {},
          make("p", { className: "pb-guessed" }, ...(picture ? [picture, `${text.split(":")[0]}`] : [text])),
          make("div", {}, ...copy.childNodes),
        ),
      );
      this.view.after(both);
      this.fit();
    }
    tell(problem) {
      this.alert.textContent = problem;
      this.alert.hidden = !problem;
    }
    tellStage(problem) {
      if (problem === this.told) return;
      this.told = problem;
      this.tell(problem && `${problem} The picture stays still; numbers and curves go on.`);
    }
    /** For those who listen: what there is where it stopped. */
    say() {
      const { engine } = this;
      const time = `At ${(engine.now * engine.dt).toFixed(2)} s`;
      const numbers = engine.scene.numbers
        .slice(0, 2)
        .map(
          ({ name }, which) =>
            `${name}: ${engine.lanes.map((lane) => `${lane.name} ${this.cells.find((c) => c.lane === lane.lane && c.which === which).cell.textContent}`).join(", ")}`,
        );
      this.said.textContent = [time, ...numbers].join(". ");
    }

    // ---- the address
    get state() {
      const { engine, stage } = this,
        { camera } = stage;
      const state = new URLSearchParams();
      state.set("live", engine.description.name);
      if (this.challenge) state.set("challenge", this.challenge.key);
      state.set("scene", engine.scene.key);
      const places = engine.lanes.map(({ place }) => place);
      if (
        places.join() !==
        engine.scene.variants
          .slice(0, 4)
          .map((_, i) => i)
          .join()
      )
        state.set("show", places.join(","));
      for (const [flag, values] of this.controls.own) state.set(flag.slice(2), values.join(","));
      if (this.target) state.set("step", this.target);
      if (this.speed !== this.usualSpeed()) state.set("pace", this.speed);
      if (!camera.isReset)
        state.set(
          "view",
          [camera.turn, camera.rise, camera.zoom, ...camera.pan].map((x) => Number(x.toFixed(4))).join(","),
        );
      state.set("see", this.shown);
      if (stage.wipe !== null) state.set("wipe", stage.wipe.toFixed(3));
      if (stage.follow) state.set("close", 1);
      if (this.iterations.which) state.set("problem", this.iterations.which);
      if (this.iterations.target) state.set("iteration", this.iterations.target);
      return state;
    }
    /** The state that an address says; what it says wrongly is left as it is. */
    take(state) {
      const { engine } = this;
      const pictured = engine.description.scenes.findIndex(({ pictures }) => pictures);
      if (pictured > 0) engine.choose(pictured, [0, 1, 2, 3]); // the scene of the sheet
      this.shownOf(engine.scene);
      if (!state.of) return;
      const from = state.of;
      const own = engine.parameters
        .filter(({ flag }) => from.has(flag.slice(2)))
        .map(({ flag }) => `${flag}=${from.get(flag.slice(2))}`);
      this.problem = own.length ? engine.set(own.join(";")) : "";
      const scene = engine.description.scenes.findIndex(({ key }) => key === from.get("scene"));
      const list = (name) => (from.has(name) ? from.get(name).split(",").map(Number).filter(Number.isFinite) : null);
      if (scene >= 0 || from.has("show"))
        engine.choose(
          scene < 0 ? engine.sceneIndex : scene,
          (list("show") || [0, 1, 2, 3]).filter((place) => place >= 0 && place < 32),
        );
      const challenges = JSON.parse(this.figure.dataset.challenges ?? "[]");
      const taken = challenges.find(({ key }) => key === from.get("challenge"));
      if (taken) {
        this.challenge = new live.Challenge(taken, engine);
        this.problem = this.challenge.begin(new Map(own.map((one) => one.split("="))));
      }
      this.shownOf(engine.scene);
      if (from.has("see")) this.shown = Number(from.get("see")) & 7;
      if (speeds.includes(Number(from.get("pace")))) this.speed = Number(from.get("pace"));
      state.step = Math.max(0, Math.round(Number(from.get("step")) || 0));
      const view = list("view");
      if (view && view.length === 5 && view[2] > 0)
        state.view = { turn: view[0], rise: view[1], zoom: view[2], pan: [view[3], view[4]] };
      const wipe = Number(from.get("wipe"));
      if (from.has("wipe") && wipe >= 0 && wipe <= 1) state.wipe = wipe;
      state.follow = from.has("close");
      state.problem = Number(from.get("problem"));
      state.iteration = Number(from.get("iteration"));
    }
    /** Into the address, once nothing has changed for a moment. */
    remember() {
      clearTimeout(this.remembering);
      this.remembering = setTimeout(() => {
        try {
          history.replaceState(null, "", `#${this.state}`);
        } catch (ignored) {
          /* some browsers refuse it for files: the link can still be copied */
        }
      }, 250);
    }
    async copyLink() {
      const address = `${location.href.split("#")[0]}#${this.state}`;
      try {
        await navigator.clipboard.writeText(address);
        this.said.textContent = "The link was copied.";
      } catch (ignored) {
        location.hash = this.state;
        this.said.textContent = "The link stands in the address line.";
      }
    }
  };
})();
