"use strict";
// One step of the chapter's own solver, row by row: each click solves the next contact. Labels beside the contacts have the numbers.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;
  const away = 40; // m, from the eye to the boxes: nearly without perspective
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
      this.labels = this.told.points.map(() => make("div"));
      this.picture.replaceChildren(this.canvas, ...this.labels);
      this.workshop.rows = this;
      this.show(at);
    }
    get last() {
      return this.told.states.length - 1;
    }
    go(at) {
      clearTimeout(this.playing);
      this.playing = null;
      this.show(at);
    }
    run() {
      this.show(this.at === this.last ? 0 : this.at + 1);
      this.playing = this.at < this.last ? setTimeout(() => this.run(), pause) : null;
      this.show(this.at);
    }

    // ---- what is seen
    show(at) {
      this.at = Math.min(at, this.last);
      this.next.disabled = this.at === this.last;
      this.play.textContent = this.playing ? "Pause" : "Play";
      const { solved, said, labels } = this.told.states[this.at];
      this.said.textContent = said;
      this.labels.forEach((label, contact) => {
        const side = this.told.points[contact][0] < 0 ? " left" : "";
        label.className = `rows-label${side}${contact === solved ? " solved" : ""}`;
        label.replaceChildren(
          ...labels[contact].map(([className, textContent]) => make("span", { className, textContent })),
        );
      });
      this.draw();
    }
    draw() {
      const { canvas, engine, workshop } = this,
        { points, top } = this.told;
      const [width, height] = live.sized([canvas, workshop.canvas]);
      if (!width || !height) return;
      if (workshop.rows !== this) engine.rows(this.step);
      workshop.rows = this;
      const seen = 1.2 * top; // m, from the picture's bottom to its top
      engine.look({
        eye: [0, top / 2 + 2, away],
        target: [0, top / 2, 0],
        fieldOfView: 2 * Math.atan(seen / 2 / away),
      });
      engine.drawRows(this.at, width, height);
      canvas.getContext("2d").drawImage(workshop.canvas, 0, 0);
      this.labels.forEach(({ style }, contact) => {
        const [x, y] = points[contact],
          perMetre = canvas.clientHeight / seen;
        style.left = `${canvas.clientWidth / 2 + x * perMetre}px`;
        style.top = `${canvas.clientHeight / 2 + (top / 2 - y) * perMetre}px`;
      });
    }
  };
})();
