"use strict";
// One step of the chapter's own solver, row by row: each click solves the next contact. Labels beside the contacts have the numbers.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;
  const away = 40; // m, from the eye to the boxes: nearly without perspective
  const seen = 1.2; // from the picture's bottom to its top, in heights of what stands there
  const pause = 450; // ms between two contacts, while it plays

  live.Rows = class {
    constructor(figure, workshop) {
      Object.assign(this, { figure, workshop, engine: workshop.engine });
      this.begun = true; // plays only when somebody asks for it
      this.canvas = make("canvas", { role: "img", "aria-label": figure.textContent });
      this.picture = make("div", { className: "rows-picture" });
      const button = (textContent, onclick) => make("button", { type: "button", textContent, onclick });
      this.next = button("Solve the next contact", () => this.go(this.at + 1));
      this.play = button("Play", () => (this.playing ? this.go(this.at) : this.run()));
      this.said = make("p", { role: "status" });
      const steps = JSON.parse(figure.dataset.rows);
      const choices = steps.map(({ name, step }, place) => {
        const onchange = () => this.begin(step, this.at);
        return make("label", {}, make("input", { type: "radio", name: "rows", checked: !place, onchange }), name);
      });
      const again = button("Start again", () => this.go(0));
      const controls = make("div", { className: "rows-controls" }, this.next, this.play, again);
      if (steps.length > 1) controls.append(...choices);
      figure.prepend(this.picture, controls, this.said);
      workshop.pictures.push(this);
      this.begin(steps[0].step, 0);
      new ResizeObserver(() => this.draw()).observe(this.canvas);
    }
    begin(step, at) {
      Object.assign(this, { step, told: this.engine.rows(step) });
      this.workshop.rows = this;
      const { points, top } = this.told;
      this.labels = points.map(() => make("div"));
      points.forEach(([x, y], contact) => {
        const { style } = this.labels[contact];
        style.left = `calc(50% + ${x / top / seen} * var(--rows))`;
        style.top = `${50 + (50 - (100 * y) / top) / seen}%`;
      });
      this.picture.replaceChildren(this.canvas, ...this.labels);
      this.show(at);
    }
    go(at) {
      clearTimeout(this.playing);
      this.playing = null;
      this.show(at);
    }
    run() {
      const last = this.told.states.length - 1;
      this.at = this.at === last ? 0 : this.at + 1;
      this.playing = this.at < last ? setTimeout(() => this.run(), pause) : null;
      this.show(this.at);
    }
    show(at) {
      const { points, states } = this.told;
      this.at = at;
      this.next.disabled = at === states.length - 1;
      this.play.textContent = this.playing ? "Pause" : "Play";
      this.said.textContent = states[at].said;
      this.labels.forEach((label, contact) => {
        const lines = states[at].labels[contact];
        label.className = `rows-label${points[contact][0] < 0 ? " left" : ""}${contact === states[at].solved ? " solved" : ""}`;
        label.replaceChildren(...lines.map(([className, textContent]) => make("span", { className, textContent })));
      });
      this.draw();
    }
    draw() {
      const { canvas, engine, workshop } = this,
        middle = this.told.top / 2;
      const [width, height] = live.sized([canvas, workshop.canvas]);
      if (!width || !height) return;
      if (workshop.rows !== this) engine.rows(this.step);
      workshop.rows = this;
      const fieldOfView = 2 * Math.atan((seen * middle) / away);
      engine.look({ eye: [0, middle + 2, away], target: [0, middle, 0], fieldOfView });
      engine.drawRows(this.at, width, height);
      canvas.getContext("2d").drawImage(workshop.canvas, 0, 0);
    }
  };
})();
