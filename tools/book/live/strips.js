"use strict";
// A scene's strip of coloured cells, a column a step, one for each variant, with a line at the present instant.
(function () {
  const live = (window.PushbackLive = window.PushbackLive || {});
  const { make } = live;
  const rowHeight = 7;

  live.Strips = class {
    /** `seek(step)`: to this instant. */
    constructor(element, seek) {
      this.element = element;
      this.seek = seek;
      this.strips = [];
    }

    /** For the scene as it is now. */
    begin(engine) {
      this.engine = engine;
      this.strips = [];
      this.element.replaceChildren();
      const { raster } = engine.scene;
      if (!raster) return;
      this.element.append(
        make(
          "p",
          { className: "pb-strip-name" },
          `${raster.label[0].toUpperCase()}${raster.label.slice(1)}, from step to step:  `,
          ...raster.meaning.flatMap(({ colour, text }) => live.swatch("body", colour, ` ${text}   `)),
        ),
      );
      for (const lane of engine.lanes) {
        const canvas = make("canvas", { className: "pb-strip", width: engine.steps, height: rowHeight });
        canvas.setAttribute("aria-hidden", "true");
        const line = make("div", { className: "pb-strip-now" });
        live.pointing(canvas, (x) => this.seek(Math.round((x / canvas.clientWidth) * engine.steps)));
        this.element.append(
          make("div", { className: "pb-strip-head" }, ...live.marked(lane)),
          make("div", { className: "pb-strip-frame" }, canvas, line),
        );
        this.strips.push({ lane: lane.lane, canvas, line, drawn: 0 });
      }
    }

    /** What was played since. */
    update() {
      const { engine } = this;
      for (const strip of this.strips) {
        const pen = strip.canvas.getContext("2d"),
          played = engine.played(strip.lane);
        if (played < strip.drawn) strip.drawn = 0;
        for (; strip.drawn < played; ++strip.drawn) {
          const column = engine.column(strip.lane, strip.drawn);
          if (column.length * rowHeight > strip.canvas.height) {
            const before = pen.getImageData(0, 0, strip.canvas.width, strip.canvas.height);
            strip.canvas.height = column.length * rowHeight;
            pen.putImageData(before, 0, 0);
          }
          pen.clearRect(strip.drawn, 0, strip.canvas.width, strip.canvas.height);
          column.forEach((cell, row) => {
            if (cell < 0) return;
            pen.fillStyle = engine.scene.raster.meaning[cell].colour;
            pen.fillRect(strip.drawn, row * rowHeight, 1, rowHeight - 1);
          });
        }
        strip.canvas.style.height = `${strip.canvas.height}px`;
        strip.line.style.left = `${(100 * engine.now) / engine.steps}%`;
      }
    }
  };
})();
