"use strict";
// The experiment as the front page begins with it: two stacks that already run, a body to pull, and one switch.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;

  // The solvers of the film, in chapter 07: three sweeps in each half of a step.
  const stacks = "scene=stack&sweeps=3&seconds=120&pace=1&see=5&play=1";
  const names = { false: "impulses forgotten", true: "impulses remembered" };

  /** What belongs to `player` as long as it is a toy. The right stack always remembers its impulses. */
  live.Toy = class {
    constructor(player) {
      this.player = player;
      const { view } = player;
      this.box = make("input", { type: "checkbox", onchange: () => this.restart() });
      const finger = matchMedia("(pointer: coarse)").matches; // rests on a body before it takes hold of it
      this.hint = make("p", { className: "pb-hint", textContent: finger ? "← Hold and pull" : "← Pull me" });
      this.bar = [
        make("label", { className: "pb-check" }, this.box, "remember impulses"),
        live.small("all controls", () => this.leave()),
      ];
      view.playButton.parentElement.append(...this.bar);
      view.stage.element.append(this.hint);
    }
    /** With "wrong, by 0 places" the third variant remembers as the second one does, so both stacks can have the same solver. */
    get state() {
      return new URLSearchParams(`${stacks}&${this.box.checked ? "show=1,2&wrong-ids=0" : "show=0,1"}`);
    }
    /** Beside the top of the right stack. */
    place() {
      const { left, top, width, height } = this.player.view.stage.panes.at(-1);
      Object.assign(this.hint.style, { left: `${left + 0.6 * width}px`, top: `${top + 0.08 * height}px` });
    }
    get names() {
      return [names[this.box.checked], names.true];
    }
    restart() {
      this.player.arrive(this.state);
      this.player.play();
    }
    /** It becomes a figure as that of a chapter, in the state in which it is. */
    leave() {
      const { player } = this;
      for (const element of [...this.bar, this.hint]) element.remove();
      player.toy = null;
      player.figure.classList.remove("toy");
      player.view.fit();
      player.bringIntoView();
      player.remember();
    }
  };
})();
