"use strict";
// Small pictures beside a sentence: a clip of one scene, with one slider. One engine and one WebGL canvas play and draw all of a
// chapter, one at a time; each picture keeps what it shows on a canvas of its own. In a wall of symptoms each has another chapter, plays
// again and again, and a switch shows its other variant.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const slice = 10; // ms of a frame for steps: what takes longer is played slower
  const rest = 0.7; // s at the end of a clip that begins again

  /** Gives canvases the size that the first has on the page: width and height in pixels, and how many there are to a CSS pixel. */
  live.sized = function (canvases) {
    const scale = Math.min(2, Math.max(1, window.devicePixelRatio || 1)),
      [{ clientWidth, clientHeight }] = canvases;
    const [width, height] = [clientWidth, clientHeight].map((pixels) => Math.round(scale * pixels));
    for (const one of width && height ? canvases : [])
      if (one.width !== width || one.height !== height) Object.assign(one, { width, height });
    return [width, height, scale];
  };

  class Workshop {
    constructor(engine) {
      this.engine = engine;
      this.shown = null; // the picture whose clip the engine plays
      this.playing = null;
      this.pictures = [];
      this.open();
      document.documentElement.addEventListener("lit", () => this.light());
    }

    open() {
      this.canvas?.remove();
      this.canvas = document.createElement("canvas");
      Object.assign(this.canvas, { id: `pushback-small-${this.engine.description.name}`, hidden: true });
      document.body.append(this.canvas);
      this.problem = this.engine.open(`#${this.canvas.id}`);
      // A browser has few contexts, and takes away the oldest: the next picture opens another.
      this.canvas.addEventListener("webglcontextlost", () => (this.problem = "lost"));
    }

    /** What plays is drawn by itself. */
    light() {
      if (this.playing) return;
      for (const picture of this.pictures.filter(({ inSight }) => inSight)) {
        picture.take(1000);
        picture.draw();
      }
    }
    /** The next one in sight that has not been seen yet begins by itself, unless nothing should. */
    next() {
      if (this.playing || live.stillness()) return;
      this.pictures.find(({ inSight, begun }) => inSight && !begun)?.play();
    }
  }

  live.Small = class {
    constructor(figure, workshop) {
      Object.assign(this, { figure, workshop, clip: JSON.parse(figure.dataset.clip) });
      this.engine = workshop.engine;
      this.canvas = figure.querySelector("canvas");
      this.pen = this.canvas.getContext("2d");
      this.button = figure.querySelector("button");
      this.slider = figure.querySelector("[type=range]");
      this.mended = figure.querySelector("[type=checkbox]");
      this.value = figure.querySelector("label output");
      this.number = figure.querySelector("figcaption output");
      this.time = this.mended && live.stillness() ? this.clip.seconds : 0; // s, of the clip
      this.drawn = null; // the step that is seen
      const { guess, curve } = this.clip;
      this.guess = curve ? new live.DrawnGuess(this) : guess && new live.Guess(this);
      this.begun = Boolean(this.guess);
      this.inSight = false;
      this.button.addEventListener("click", () => (this.playing ? this.pause() : this.play()));
      this.slider?.addEventListener("input", () => this.slide());
      this.mended?.addEventListener("change", () => this.draw());
      this.listen();
      this.label();
      for (const control of [this.button, this.slider, this.mended]) if (control) control.disabled = false;
      workshop.pictures.push(this);
    }

    get playing() {
      return this.workshop.playing === this;
    }
    /** The lanes that are seen: all, or the one that is chosen. */
    get lanes() {
      const { lanes } = this.engine;
      return this.mended ? lanes.filter(({ place }) => place === this.clip.places[Number(this.mended.checked)]) : lanes;
    }
    get steps() {
      return Math.min(this.engine.steps, Math.round(this.clip.seconds / this.engine.dt));
    }
    get step() {
      return Math.min(this.steps, Math.round(this.time / this.engine.dt));
    }

    /** Pauses out of sight, and goes on when it is seen again. */
    listen() {
      new IntersectionObserver(
        ([{ isIntersecting, intersectionRatio }]) => {
          const seen = isIntersecting && intersectionRatio > 0.6;
          if (seen === this.inSight) return;
          this.inSight = seen;
          if (!seen) {
            this.left = this.playing;
            if (this.left) this.pause();
            this.workshop.next(); // what came into sight while this one played
          } else if (this.left) this.play();
          else this.workshop.next();
        },
        { threshold: [0, 0.6, 0.8] },
      ).observe(this.canvas);
      new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    /** The slider's value. */
    get chosen() {
      const { from, step, at, value } = this.clip.slider,
        notch = Number(this.slider.value);
      return notch === at ? value : Number((from + notch * step).toPrecision(9));
    }

    // ---- the engine
    /** The engine plays this clip, as far as `time`, or as far as it comes. */
    take(milliseconds = slice) {
      const { engine, workshop, clip } = this;
      if (workshop.shown !== this) {
        const before = workshop.shown;
        workshop.shown = this;
        if (before && workshop.playing === before) before.pause();
        this.set();
        engine.choose(clip.scene, clip.places);
      }
      if (engine.now !== this.step) engine.goTo(this.step, milliseconds);
    }
    set() {
      const { slider, assignments } = this.clip;
      const own = slider?.flag ? [`${slider.flag}=${this.chosen}`] : [];
      const problem = this.engine.set([assignments, ...own].filter(Boolean).join(";"));
      if (problem) throw new Error(problem);
    }

    // ---- what somebody does
    play() {
      const { workshop } = this;
      workshop.playing?.pause();
      if (this.step >= this.steps) this.time = 0;
      this.begun = true;
      this.take();
      workshop.playing = this;
      this.label();
      this.before = null;
      requestAnimationFrame((now) => this.frame(now));
    }
    pause() {
      this.workshop.playing = null;
      this.label();
      this.draw();
    }
    /** To the start: nothing of the truth is seen before the guess is placed. */
    rewind() {
      if (this.playing) this.pause();
      this.time = 0;
    }
    /** With the new value at the same instant; at the end of the clip where it has not begun yet. */
    slide() {
      if (this.guess) this.rewind();
      if (!this.begun) this.time = this.clip.seconds;
      this.begun = true;
      this.say();
      if (this.workshop.shown === this && !this.guess) this.set();
      this.draw();
    }
    frame(now) {
      if (!this.playing) return;
      const passed = this.before === null ? 0 : now - this.before;
      this.before = now;
      this.time += Math.min(passed, 100) / 1000 / this.clip.slow;
      if (this.mended && this.time > this.clip.seconds + rest / this.clip.slow) this.time = 0;
      const reached = this.engine.now;
      if (this.step !== this.drawn) this.draw();
      if (this.engine.now < this.step) this.time = Math.max(this.engine.now, reached) * this.engine.dt;
      if (this.mended || this.step < this.steps) requestAnimationFrame((then) => this.frame(then));
      else {
        this.pause();
        this.workshop.next();
      }
    }

    // ---- what is seen
    label() {
      const doing = this.playing ? "Pause" : "Play";
      this.button.setAttribute("aria-label", `${doing}: ${this.clip.words}`);
      this.button.title = doing;
      this.figure.classList.toggle("playing", this.playing);
    }
    say() {
      const { unit } = this.clip.slider;
      const text = `${Number(this.chosen.toPrecision(3))}${unit ? ` ${unit}` : ""}`;
      this.value.textContent = text;
      this.slider.setAttribute("aria-valuetext", text);
    }
    draw() {
      const { engine, workshop, canvas } = this;
      if (workshop.problem) workshop.open();
      if (workshop.problem) return;
      const [width, height, scale] = live.sized([canvas, workshop.canvas]);
      if (!width || !height) return;
      this.take();
      const { scene } = engine,
        { lanes } = this;
      const guessing = this.guess && engine.now < this.steps;
      const shown = (scene.contacts ? 1 : 0) | (scene.impulses ? 2 : 0) | (guessing ? 0 : 4) | live.lit();
      engine.look(this.camera(width / lanes.length / height));
      const said = this.number && (this.guess ? this.guess.verdict() : this.numbers());
      engine.outline(this.guess ?? live.Guess.none, ...(this.guess?.ways ?? [NaN, NaN]));
      engine.begin();
      lanes.forEach(({ lane }, at) => {
        const from = Math.round((at * width) / lanes.length),
          to = Math.round(((at + 1) * width) / lanes.length);
        engine.draw(lane, shown, from, 0, to - from, height);
      });
      this.pen.drawImage(workshop.canvas, 0, 0);
      for (let lane = 1; lane < lanes.length; ++lane)
        this.pen.clearRect(Math.round((lane * width) / lanes.length) - scale, 0, 2 * scale, height);
      this.drawn = engine.now;
      if (this.number) this.number.textContent = said;
      // What takes more than a frame comes as fast as it can.
      if (!this.playing && engine.now !== this.step) requestAnimationFrame(() => this.draw());
    }
    numbers() {
      const { engine, clip } = this;
      const all = engine.lanes.map(({ lane }) => engine.number(lane, clip.number.which)[0]);
      const { name } = engine.scene.numbers[clip.number.which];
      return `${name}: ${engine.now ? all.join(" | ") : "–"}`;
    }
    camera(aspect) {
      const { eye, target, field_of_view } = live.cameraOf(this.engine, aspect, true);
      const raised = ([x, y, z]) => [x, y + (this.guess?.middle ?? 0), z];
      return {
        eye: raised(eye),
        target: raised(target),
        fieldOfView: 2 * Math.atan(Math.tan(field_of_view / 2) / this.clip.zoom),
      };
    }
  };

  /** The small pictures of a page; where they cannot be drawn, pictures of a wall stay. */
  live.beginSmall = async function (figures) {
    try {
      const { chapter, root } = figures[0].dataset;
      const workshop = new Workshop(await live.Engine.load(chapter, root));
      if (!workshop.problem)
        return figures.map((figure) => new (figure.dataset.rows ? live.Rows : live.Small)(figure, workshop));
    } catch (problem) {
      console.error(problem);
    }
    for (const figure of figures) {
      for (const part of figure.querySelectorAll("canvas, .small-controls")) part.remove();
      figure.hidden = !figure.querySelector("img");
    }
    return [];
  };
})();
