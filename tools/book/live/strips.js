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
          ...raster.meaning.flatMap(({ colour, text }) => {
            const mark = make("span", { className: "pb-mark", "aria-hidden": "true" });
            mark.style.setProperty("--pb-mark", colour);
            return [mark, ` ${text}   `];
          }),
        ),
      );
      for (const { lane, name, colour, marker } of engine.lanes) {
        const mark = make("span", { textContent: `${marker} `, "aria-hidden": "true" });
        mark.style.color = colour;
        const canvas = make("canvas", { className: "pb-strip", width: engine.steps, height: rowHeight });
        canvas.setAttribute("aria-hidden", "true");
        const line = make("div", { className: "pb-strip-now" });
        const point = (event) => {
          const box = canvas.getBoundingClientRect();
          this.seek(Math.round(((event.clientX - box.left) / box.width) * engine.steps));
        };
        canvas.addEventListener("pointerdown", (event) => {
          canvas.setPointerCapture(event.pointerId);
          point(event);
        });
        canvas.addEventListener("pointermove", (event) => {
          if (event.buttons & 1) point(event);
        });
        this.element.append(
          make("div", { className: "pb-strip-head" }, mark, name),
          make("div", { className: "pb-strip-frame" }, canvas, line),
        );
        this.strips.push({ lane, canvas, line, drawn: 0 });
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
