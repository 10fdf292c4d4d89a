"use strict";
// Curves of a scene's series, a colour a variant, with a line at the present instant.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const three = (value) => (value === null || value === undefined ? "–" : Number(value.toPrecision(3)).toString());

  /** How an axis looks where the page has this style: in its ink, the grid in the colour of its outlines. */
  live.axisIn = ({ color, outlineColor }) => ({
    stroke: color,
    grid: { stroke: outlineColor, width: 1 },
    ticks: { stroke: outlineColor, width: 1 },
    font: "12px system-ui, sans-serif",
    labelFont: "12px system-ui, sans-serif",
    labelSize: 18,
  });

  /** A line across a plot, at this value of x. */
  live.lineAt = function (plot, value, colour) {
    const { left, top, height, width } = plot.bbox;
    const x = plot.valToPos(value, "x", true);
    if (x < left - 1 || x > left + width + 1) return;
    const pen = plot.ctx;
    pen.save();
    pen.strokeStyle = colour;
    pen.setLineDash([]);
    pen.globalAlpha = 0.6;
    pen.lineWidth = window.devicePixelRatio || 1;
    pen.beginPath();
    pen.moveTo(x, top);
    pen.lineTo(x, top + height);
    pen.stroke();
    pen.restore();
  };

  live.Curves = class {
    /** `seek(step)`: to this instant. */
    constructor(element, seek) {
      this.element = element;
      this.seek = seek;
      this.plots = [];
    }

    /** For the scene as it is now. */
    begin(engine) {
      this.engine = engine;
      for (const { plot } of this.plots) plot.destroy();
      this.plots = [];
      this.element.replaceChildren();
      if (!window.uPlot) return;
      const lanes = engine.lanes.filter((lane) => lane.curves);
      const { dt, scene, steps } = engine;
      this.times = Float64Array.from({ length: steps }, (_, i) => (i + 1) * dt);
      const style = getComputedStyle(this.element);
      const ink = style.color;
      scene.series.forEach((series, which) => {
        if (!series.drawn || !lanes.length) return;
        const figure = document.createElement("div");
        figure.className = "pb-plot";
        this.element.append(figure);
        const references =
          which > 0
            ? []
            : lanes.flatMap((lane) =>
                lane.references.map((label, i) => ({ label, values: Array.from(engine.reference(lane.lane, i)) })),
              );
        const axis = live.axisIn(style);
        const title = series.unit ? `${series.name}, ${series.unit}` : series.name;
        const plot = new window.uPlot(
          {
            title,
            width: Math.max(200, this.element.clientWidth || 600),
            height: 210,
            scales: { x: { time: false, range: [0, steps * dt] }, y: { distr: series.log ? 3 : 1 } },
            axes: [
              { ...axis, label: "time, s", size: 34 },
              { ...axis, size: 58 },
            ],
            series: [
              { label: "t", value: (_, value) => `${three(value)} s` },
              ...lanes.map((lane) => ({
                label: `${lane.marker} ${lane.name}`,
                stroke: lane.colour,
                width: 2,
                pxAlign: 0,
                points: { show: false },
                value: (_, value) => three(value),
              })),
              ...references.map(({ label }) => ({
                label: label || "should be",
                stroke: ink,
                dash: [5, 4],
                width: 1.2,
                pxAlign: 0,
                points: { show: false },
                value: (_, value) => three(value),
              })),
            ],
            cursor: { y: false, drag: { x: false, y: false } },
            hooks: { draw: [(drawn) => live.lineAt(drawn, engine.now * engine.dt, ink)] },
          },
          this.data(lanes, which, references),
          figure,
        );
        const point = (event) => {
          const x = event.clientX - plot.over.getBoundingClientRect().left;
          this.seek(Math.round(plot.posToVal(x, "x") / dt));
        };
        plot.over.addEventListener("pointerdown", (event) => {
          plot.over.setPointerCapture(event.pointerId);
          point(event);
        });
        plot.over.addEventListener("pointermove", (event) => {
          if (event.buttons & 1) point(event);
        });
        this.plots.push({ plot, lanes, which, references, log: series.log });
      });
    }

    data(lanes, which, references) {
      const { steps } = this.engine,
        log = this.engine.scene.series[which].log;
      const fit = (values) =>
        Array.from({ length: steps }, (_, i) =>
          i < values.length && Number.isFinite(values[i]) && (!log || values[i] > 0) ? values[i] : null,
        );
      return [
        this.times,
        ...lanes.map((lane) => fit(this.engine.series(lane.lane, which))),
        ...references.map(({ values }) => fit(values)),
      ];
    }

    /** What was played since. */
    update() {
      for (const { plot, lanes, which, references } of this.plots) {
        plot.setData(this.data(lanes, which, references));
        const at = Math.min(this.engine.now, this.engine.known) - 1;
        if (at >= 0 && plot.cursor.left < 0) plot.setLegend({ idx: at });
      }
    }

    resize() {
      const width = Math.max(200, this.element.clientWidth);
      for (const { plot } of this.plots) if (plot.width !== width) plot.setSize({ width, height: 210 });
    }
  };
})();
