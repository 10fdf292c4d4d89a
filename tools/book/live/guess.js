"use strict";
// A guess: the reader drags a body's outline, in the picture or by the slider, or draws a curve into an empty plot, and is told at the
// end of the clip whether it was right.
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
      picture.rewind();
      picture.take();
      const aspect = canvas.clientWidth / canvas.clientHeight;
      engine.look(picture.camera(aspect));
      const [x, y] = [(2 * offsetX) / canvas.clientWidth - 1, 1 - (2 * offsetY) / canvas.clientHeight];
      slider.value = Math.round((zero + perMetre * engine.way(this, aspect, x, y) - from) / step);
      picture.slide();
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

  const early = 0.05; // of the clip: a curve that is so much too early or too late is not wrong for that
  const three = (number) => Number(number.toPrecision(3));

  /** A curve over the clip's time. The truth is drawn over it as the clip plays. */
  live.DrawnGuess = class {
    constructor(picture) {
      Object.assign(this, picture.clip.curve, live.Guess.none, { picture, values: [] });
      const { clip, figure } = picture,
        place = live.make("div", { className: "pb-plots pb-plot pb-empty" });
      figure.querySelector(".small-controls").before(place);
      const axis = live.axisIn(place),
        ink = axis.stroke;
      this.plot = new window.uPlot(
        {
          title: [this.name, this.unit].filter(Boolean).join(", "),
          width: place.clientWidth,
          height: 190,
          scales: { x: { time: false, range: [0, clip.seconds] }, y: { range: [this.from, this.to] } },
          axes: [
            { ...axis, label: "time, s", size: 34, values: live.inWords },
            { ...axis, size: 48, values: live.inWords },
          ],
          series: [
            {},
            { label: "your curve", stroke: ink, width: 2, dash: [6, 4], points: { show: false } },
            { label: clip.names[0], stroke: this.colour, width: 2.5, points: { show: false } },
          ],
          cursor: { show: false },
          legend: { live: false },
        },
        [[], [], []],
        place,
      );
      document.documentElement.addEventListener("theme", () => this.plot.redraw(false));
      this.listen(this.plot.over);
    }
    listen(area) {
      let last = null;
      area.addEventListener("pointerdown", (event) => {
        area.setPointerCapture(event.pointerId);
        this.picture.rewind();
        this.picture.take();
        last = this.at(event);
        this.draw(last, last);
      });
      area.addEventListener("pointermove", (event) => {
        if (area.hasPointerCapture(event.pointerId)) this.draw(last, (last = this.at(event)));
      });
    }
    /** The step and the value under the pen. */
    at({ clientX, clientY }) {
      const { plot, picture } = this,
        { left, top } = plot.over.getBoundingClientRect(),
        within = (value, least, most) => Math.min(most, Math.max(least, value));
      const step = Math.round(plot.posToVal(clientX - left, "x") / picture.engine.dt) - 1;
      const value = plot.posToVal(clientY - top, "y");
      return [within(step, 0, picture.steps - 1), within(value, this.from, this.to)];
    }
    draw([from, before], [to, value]) {
      for (let i = 0, count = Math.abs(to - from); i <= count; ++i)
        this.values[from + Math.sign(to - from) * i] = count ? before + ((value - before) * i) / count : value;
      this.picture.draw();
    }
    verdict() {
      const { picture, plot, values, within, unit } = this,
        { engine, steps } = picture,
        { dt } = engine,
        slack = Math.max(1, Math.round(early * steps));
      const truth = [...engine.series(0, this.which).slice(0, engine.now)];
      const all = Array.from({ length: steps }, (_, i) => i);
      const width = plot.root.parentElement.clientWidth;
      if (width && width !== plot.width) plot.setSize({ width, height: 190 });
      plot.setData([all.map((i) => (i + 1) * dt), all.map((i) => values[i] ?? null), all.map((i) => truth[i] ?? null)]);
      const whole = all.filter((i) => values[i] !== undefined).length >= 0.9 * steps;
      if (engine.now < steps)
        return `${whole ? "Now play." : "Draw it from the left edge to the right edge."} A curve within ${within}\u00a0${unit}, or ${Number((slack * dt).toPrecision(2))}\u00a0s early or late, is right.`;
      if (!whole) return "No verdict without a curve over the whole time.";
      // Each curve from what the other is nearby: none of the two may have a peak that the other has not.
      const off = (from, other, i) => {
        const near = other.slice(Math.max(0, i - slack), i + slack + 1).filter((value) => value !== undefined);
        return near.length ? from[i] - Math.min(Math.max(from[i], Math.min(...near)), Math.max(...near)) : 0;
      };
      const offs = all.flatMap((i) => [
        [i, values[i] === undefined ? 0 : off(values, truth, i)],
        [i, -off(truth, values, i)],
      ]);
      const [step, most] = offs.reduce((one, other) => (Math.abs(other[1]) > Math.abs(one[1]) ? other : one));
      const where = `${three(Math.abs(most))}\u00a0${unit} too ${most > 0 ? "high" : "low"} at ${three((step + 1) * dt)}\u00a0s`;
      return `Your curve is up to ${where}. ${Math.abs(most) <= within ? "✓ Right" : "✗ Wrong"}: up to ${within}\u00a0${unit} is right.`;
    }
  };
})();
