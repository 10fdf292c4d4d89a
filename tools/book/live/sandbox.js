"use strict";
// The sandbox: effects as switches, boxes and balls. All that was done is one parameter, a list of actions with their steps, so that a
// link makes the same motion again.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;

  const flag = "--actions"; // of each its step, its kind and two numbers, as tools/sandbox/main.cpp reads them
  const [flip, box, ball] = [0, 1, 2];
  const effects =
    "01 velocity constraint|02 clamping|03 Baumgarte|04 slop|05 restitution|06 friction|07 warm start|08 cone";
  const places = [0, 1.5, -1.5, 0.75, -0.75]; // m, of boxes, one after the other
  const still = 6; // CSS pixels that a pointer may move in a click

  /** What belongs to `player` where its experiment is the sandbox. */
  live.Sandbox = class {
    constructor(player) {
      this.player = player;
      const { view, figure } = player,
        { stage } = view;
      figure.classList.add("sandbox");
      this.switches = effects.split("|").map((name, which) => {
        const input = make("input", { type: "checkbox", onchange: () => this.act(flip, which, Number(input.checked)) });
        return { input, label: make("label", { className: "pb-check" }, input, name) };
      });
      const buttons = [
        live.small("add a box", () => this.act(box, places[this.actions.length % places.length], 0)),
        live.small("throw a ball", () => this.act(ball, 0, 3)),
        live.small("start again", () => this.list([], 0)),
        live.small("copy a link to this", async ({ target }) => {
          await player.copyLink();
          target.textContent = view.said.textContent;
        }),
      ];
      const panel = (...children) => make("div", { className: "pb-sandbox" }, ...children);
      view.top.after(panel(...buttons), panel(...this.switches.map(({ label }) => label)));
      stage.grabAt = () => null; // a pull is in no list
      let pressed = [0, 0];
      stage.canvas.addEventListener("pointerdown", (event) => (pressed = stage.place(event)));
      stage.canvas.addEventListener("click", (event) => {
        const [x, y] = stage.place(event);
        if (Math.hypot(x - pressed[0], y - pressed[1]) < still) this.throwTo(stage.onPlane(x, y));
      });
    }
    /** As the engine has them: [step, kind, x, y] each. */
    get actions() {
      const numbers = this.player.engine.values[flag];
      return Array.from({ length: numbers.length / 4 }, (_, i) => numbers.slice(4 * i, 4 * i + 4));
    }
    /** At this instant; what was done after it is forgotten. */
    act(kind, x, y) {
      const { now } = this.player.engine;
      this.list([...this.actions.filter(([step]) => step <= now), [now, kind, x, y]], now);
    }
    throwTo(point) {
      if (point) this.act(ball, ...point.map((x) => Number(x.toFixed(2))));
    }
    /** The whole motion with these actions, and on from a step. */
    list(actions, step) {
      const { player } = this,
        { engine, view } = player;
      if (actions.length) view.controls.own.set(flag, actions.flat());
      else view.controls.own.delete(flag);
      player.set(view.controls.assignments, true);
      engine.goTo(step, 1e4); // at once: what was seen is not played again
      player.play();
    }
    /** The switches as they are now. */
    read() {
      const { now } = this.player.engine;
      const on = this.switches.map(() => true);
      for (const [step, kind, which, yes] of this.actions) if (kind === flip && step <= now) on[which] = yes === 1;
      this.switches.forEach(({ input }, which) => (input.checked = on[which]));
    }
  };
})();
