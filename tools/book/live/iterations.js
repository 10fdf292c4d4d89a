"use strict";
// One step's problem, solved iteration by iteration: what each method leaves unsolved, and the matrix.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;
  const perSecond = 12; // stops, while it plays
  const least = 1e-17; // what is less is drawn there
  const shown = (value) =>
    value === 0 || value >= 0.01 ? Number(value.toPrecision(3)).toString() : value.toExponential(1);

  /** Where the slider stops, and where it plays through: each of the first, then by ever longer strides. */
  function stopsUpTo(most) {
    const stops = [];
    for (let k = 0; k < most; k += Math.max(1, Math.floor(k / 20))) stops.push(k);
    return [...stops, most];
  }

  live.Iterations = class {
    /** `remember()`: what is shown has changed. */
    constructor(element, engine, remember) {
      Object.assign(this, { element, engine, remember });
      this.which = 0;
      this.target = 0;
      element.hidden = !engine.description.problems.length;
      if (!element.hidden) this.build();
    }

    build() {
      const div = (className, ...children) => make("div", { className }, ...children);
      this.problems = make("select", {
        "aria-label": "Problem",
        onchange: () => {
          this.begin(this.problems.selectedIndex, 0);
          this.remember();
        },
      });
      this.said = make("p", { className: "pb-caption" });
      this.playButton = live.button("play", "Play the iterations", () => this.toggle());
      this.line = make("input", {
        type: "range",
        min: 0,
        className: "pb-time",
        "aria-label": "Iteration",
        oninput: () => this.go(this.stops[Number(this.line.value)]),
      });
      this.clock = make("output", { className: "pb-clock" });
      this.table = make("tbody");
      this.measure = make("th", { scope: "col" });
      const head = make("thead", {}, make("tr", {}, make("td"), this.measure));
      const matrix = make("div");
      this.plotIn = div("pb-plot");
      this.element.append(
        make("h4", { className: "pb-heading", textContent: "One step, iteration by iteration" }),
        make("label", { className: "pb-scene" }, "The first step of ", this.problems),
        this.said,
        div(
          "pb-transport",
          live.button("begin", "Before the first iteration", () => this.go(0)),
          live.button("back", "One iteration back", () => this.go(this.target - 1)),
          this.playButton,
          live.button("step", "One iteration on", () => this.go(this.target + 1)),
          ...[this.line, this.clock],
        ),
        div("pb-numbers pb-scroll", make("table", { "aria-label": "What each method leaves" }, head, this.table)),
        ...[this.plotIn, matrix],
      );
      this.picture = new live.MatrixPicture(matrix);
    }

    // ---- which
    begin(which = 0, iteration = 0) {
      if (this.element.hidden) return;
      this.pause();
      const { engine } = this,
        { problems } = engine.description;
      this.which = problems[which] ? which : 0;
      engine.hold(this.which);
      const { problem } = engine;
      this.problems.replaceChildren(...problems.map((name) => make("option", { textContent: name })));
      this.problems.selectedIndex = this.which;
      this.stops = stopsUpTo(problem.most);
      this.line.max = this.stops.length - 1;
      this.said.textContent = `Every method begins with no impulse at all. An iteration is ${problem.iteration}.`;
      this.measure.textContent = problem.measure;
      this.cells = problem.methods.map(() => make("td"));
      this.table.replaceChildren(
        ...problem.methods.map((method, i) =>
          make("tr", {}, make("th", { scope: "row" }, ...live.marked(method)), this.cells[i]),
        ),
      );
      this.drawn = null;
      this.picture.begin(problem, engine.matrix);
      this.beginPlot();
      this.go(iteration);
    }
    /** A parameter has changed, and with it the problem: the same iteration of the new one, once the slider rests. */
    changed() {
      if (this.element.hidden) return;
      this.element.inert = true;
      clearTimeout(this.beginning);
      this.beginning = setTimeout(() => {
        this.element.inert = false;
        this.begin(this.which, this.target);
      }, 200);
    }

    // ---- to and fro
    go(iteration) {
      this.playing = false;
      this.target = Math.min(this.engine.problem.most, Math.max(0, Math.round(iteration) || 0));
      this.ask();
      this.remember();
    }
    ask() {
      this.asked ||= requestAnimationFrame(() => this.frame());
    }
    toggle() {
      if (this.playing) return this.pause();
      if (this.target >= this.engine.problem.most) this.target = 0;
      this.playing = true;
      this.before = performance.now();
      this.ask();
    }
    pause() {
      if (!this.playing) return;
      this.playing = false;
      this.remember();
      this.ask();
    }
    frame() {
      this.asked = 0;
      if (this.element.inert) return; // another problem comes
      const { engine } = this,
        now = performance.now();
      if (this.playing && now - this.before >= 1000 / perSecond && engine.iteration === this.target) {
        this.before = now;
        this.target = this.stops.find((stop) => stop > this.target) ?? this.target;
        if (this.target === engine.problem.most) this.pause();
      }
      engine.iterate(this.target);
      this.show();
      if (this.playing || engine.iteration !== this.target) this.ask();
    }

    // ---- what is seen
    show() {
      const { engine } = this,
        { problem, iteration } = engine;
      const playing = this.playing ? "pause" : "play";
      this.playButton.named(playing, `${this.playing ? "Pause" : "Play"} the iterations`);
      if (this.drawn === iteration) return;
      this.drawn = iteration;
      this.clock.textContent = `iteration ${iteration} of ${problem.most}`;
      this.line.value = this.stops.findLastIndex((stop) => stop <= iteration);
      this.line.setAttribute("aria-valuetext", this.clock.textContent);
      const residuals = problem.methods.map((_, i) => engine.residuals(i));
      residuals.forEach((all, i) => {
        const last = Math.min(iteration, all.length - 1);
        this.cells[i].textContent = `${shown(all[last])}${last < iteration ? `, at its end after ${last}` : ""}`;
      });
      if (this.plot) this.plot.setData(this.data(residuals));
      this.picture.draw(problem.methods.map((_, i) => engine.impulses(i)));
    }

    data(residuals) {
      const counts = Array.from({ length: this.engine.problem.most }, (_, i) => i + 1);
      return [counts, ...residuals.map((all) => counts.map((k) => (k < all.length ? Math.max(least, all[k]) : null)))];
    }
    beginPlot() {
      this.plot?.destroy();
      this.plot = null;
      if (!window.uPlot) return;
      const { problem } = this.engine,
        style = getComputedStyle(this.plotIn.parentElement),
        ink = () => style.color;
      const axis = {
        ...live.axisIn(this.plotIn.parentElement),
        splits: live.powers(8),
        values: live.inWords,
        filter: (_, all) => all, // uPlot would leave out all but the decades
      };
      this.plot = new window.uPlot(
        {
          title: problem.measure,
          width: Math.max(200, this.plotIn.clientWidth || 600),
          height: 260,
          scales: {
            x: { time: false, distr: 3, range: [1, problem.most] },
            y: {
              distr: 3,
              range: (_, low, high) =>
                low === null ? [0.01, 1] : [Math.min(0.1, 10 ** Math.floor(Math.log10(low))), Math.max(1, high)],
            },
          },
          axes: [
            { ...axis, label: "iterations", size: 34 },
            { ...axis, size: 58 },
          ],
          series: [
            {},
            ...problem.methods.map(({ name, colour, marker }) => ({
              label: `${marker} ${name}`,
              stroke: colour,
              width: 2,
              pxAlign: 0,
              points: { show: (plot, at) => plot.data[at].filter((value) => value !== null).length < 3, fill: colour },
            })),
          ],
          legend: { show: false }, // the table has it
          cursor: { y: false, drag: { x: false, y: false } },
          hooks: { draw: [(plot) => live.lineAt(plot, Math.max(1, this.engine.iteration), ink())] },
        },
        this.data(problem.methods.map(() => [1])),
        this.plotIn,
      );
      live.pointing(this.plot.over, (x) => this.go(this.plot.posToVal(x, "x")));
    }
    recolour() {
      if (this.element.hidden || !this.engine.problem) return;
      this.plot?.redraw(false);
      this.picture.draw(this.picture.impulses);
    }
    resize() {
      if (this.element.hidden || !this.engine.problem) return;
      const width = Math.max(200, this.plotIn.clientWidth);
      if (this.plot && this.plot.width !== width) this.plot.setSize({ width, height: 260 });
      this.picture.resize();
    }
  };
})();
