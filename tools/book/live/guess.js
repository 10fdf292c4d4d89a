"use strict";
// A guess: the reader drags a body's outline, in the picture or by the slider, and is told at the end of the clip whether it was right.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});

  live.Guess = class {
    constructor(picture) {
      const { clip, canvas } = picture;
      Object.assign(this, clip.guess, { picture, perMetre: clip.slider.unit === "mm" ? 1000 : 1 });
      const { from, notches, step } = clip.slider;
      this.middle = this.axis[1] === 1 ? Math.max(0, from + notches * step - this.zero) / this.perMetre / 2 : 0; // m, up
      canvas.classList.add("guess");
      canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        this.drag(event);
      });
      canvas.addEventListener("pointermove", (event) => canvas.hasPointerCapture(event.pointerId) && this.drag(event));
    }
    drag({ offsetX, offsetY }) {
      const { picture, zero, perMetre } = this,
        { engine, slider, canvas } = picture,
        { from, step } = picture.clip.slider;
      this.placed();
      picture.take();
      const aspect = canvas.clientWidth / canvas.clientHeight;
      engine.look(picture.camera(aspect));
      const [x, y] = [(2 * offsetX) / canvas.clientWidth - 1, 1 - (2 * offsetY) / canvas.clientHeight];
      slider.value = Math.round((zero + perMetre * engine.way(this, aspect, x, y) - from) / step);
      picture.slide();
    }
    /** From the start again: nothing of the truth is seen before the guess is placed. */
    placed() {
      if (this.picture.playing) this.picture.pause();
      this.picture.time = 0;
    }
    verdict() {
      const { engine, chosen, clip, steps } = this.picture;
      const metres = (number) => (number - this.zero) / this.perMetre;
      this.ways = [metres(chosen), NaN];
      if (engine.now < steps) return "";
      const [words] = engine.number(0, clip.number.which),
        off = chosen - parseFloat(words);
      this.ways[1] = metres(chosen - off);
      const right = Math.abs(off) <= this.within;
      const [less, more] = Math.abs(this.axis[1]) === 1 ? ["Too low.", "Too high."] : ["Not far enough.", "Too far."];
      return `You: ${chosen} ${clip.slider.unit}. It is ${words}. ${right ? "✓ Right." : off < 0 ? `✗ ${less}` : `✗ ${more}`}`;
    }
  };
  live.Guess.none = { axis: [0, 0, 0] };
})();
