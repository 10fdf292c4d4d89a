"use strict";
// Curves of a scene's series, a colour a variant, with a line at the present instant.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const three = (value) => (value === null || value === undefined ? "–" : Number(value.toPrecision(3)).toString());

  /** How an axis looks in this element, also when the page's colours change: in its ink, the grid in that of its outlines. */
  live.axisIn = (element) => {
    const style = getComputedStyle(element), // as it is whenever it is asked
      line = { stroke: () => style.outlineColor, width: 1 };
    return {
      stroke: () => style.color,
      grid: line,
      ticks: line,
      ...{ font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif" },
      labelSize: 18,
    };
  };

  /** Powers of ten for an axis with equal factors, `most` at most, from the highest down. */
  live.powers = (most) => (_, which, low, high) => {
    const last = Math.floor(Math.log10(high) + 1e-9),
      first = Math.ceil(Math.log10(low) - 1e-9),
      stride = Math.ceil((last - first + 1) / most);
    return Array.from(
      { length: Math.floor((last - first) / stride) + 1 },
      (_, i) => 10 ** (last - i * stride),
    ).reverse();
  };
  live.inWords = (_, all) =>
    all.map((value) => {
      const size = Math.abs(value);
      if (size === 0 || (size > 9e-4 && size < 1e4)) return String(Number(value.toPrecision(6)));
      return value.toExponential().replace("e+", "e");
    });
  const line = (label, look) => ({
    ...{ label, pxAlign: 0, points: { show: false }, value: (_, value) => three(value) },
    ...look,
  });
  /** As wide as its longest label. */
  const fitting = (_, labels) => 18 + 7 * Math.max(3, ...(labels ?? []).map((label) => label?.length ?? 0));

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

  /** `to(x)`: where somebody points, with the button down; CSS pixels from the left. */
  live.pointing = function (element, to) {
    const point = (event) => to(event.clientX - element.getBoundingClientRect().left);
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      point(event);
    });
    element.addEventListener("pointermove", (event) => event.buttons & 1 && point(event));
  };

  /** CSS pixels: the curve that stands beside the sliders leaves room for the picture. */
  const heightIn = (place) => (place.parentElement.classList.contains("pb-deck") ? 150 : 210);

  live.Curves = class {
    /** The first curve stands in `element`, the others in `others`. `seek(step)`: to this instant. */
    constructor(element, others, seek) {
      Object.assign(this, { element, others, seek });
      this.plots = [];
    }
    /** How many others there are. */
    get further() {
      return Math.max(0, this.plots.length - 1);
    }

    /** For the scene as it is now. */
    begin(engine) {
      this.engine = engine;
      for (const { plot } of this.plots) plot.destroy();
      this.plots = [];
      this.element.replaceChildren();
      this.others.replaceChildren();
      if (!window.uPlot) return;
      const lanes = engine.lanes.filter((lane) => lane.curves);
      const { dt, scene, steps } = engine;
      this.times = Float64Array.from({ length: steps }, (_, i) => (i + 1) * dt);
      const style = getComputedStyle(this.element),
        ink = () => style.color;
      scene.series.forEach((series, which) => {
        if (!series.drawn || !lanes.length) return;
        const figure = document.createElement("div");
        figure.className = "pb-plot";
        const place = this.plots.length ? this.others : this.element;
        place.append(figure);
        const references =
          which > 0
            ? []
            : lanes.flatMap((lane) =>
                lane.references.map((label, i) => ({ label, values: Array.from(engine.reference(lane.lane, i)) })),
              );
        const axis = live.axisIn(place);
        const title = series.unit ? `${series.name}, ${series.unit}` : series.name;
        const plot = new window.uPlot(
          {
            title,
            width: Math.max(200, place.clientWidth || 600),
            height: heightIn(place),
            scales: { x: { time: false, range: [0, steps * dt] }, y: { distr: series.log ? 3 : 1 } },
            axes: [
              { ...axis, label: "time, s", size: 34, values: live.inWords },
              {
                ...axis,
                size: fitting,
                values: live.inWords,
                ...(series.log && { splits: live.powers(5), filter: (_, all) => all }), // uPlot would draw all between, too
              },
            ],
            series: [
              { label: "t", value: (_, value) => `${three(value)} s` },
              ...lanes.map((lane) => line(lane.name, { stroke: lane.colour, width: 2 })),
              ...references.map(({ label }) => line(label || "should be", { stroke: ink, dash: [5, 4], width: 1.2 })),
            ],
            cursor: { y: false, drag: { x: false, y: false } },
            hooks: { draw: [(drawn) => live.lineAt(drawn, engine.now * engine.dt, ink())] },
          },
          this.data(lanes, which, references),
          figure,
        );
        const [, ...marks] = plot.root.querySelectorAll(".u-legend .u-marker");
        lanes.forEach((lane, i) => marks[i].replaceWith(live.marked(lane)[0]));
        live.pointing(plot.over, (x) => this.seek(Math.round(plot.posToVal(x, "x") / dt)));
        this.plots.push({ plot, place, lanes, which, references });
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
      for (const { plot, place, lanes, which, references } of this.plots) {
        if (!place.clientWidth) continue; // folded
        plot.setData(this.data(lanes, which, references));
        const at = Math.min(this.engine.now, this.engine.known) - 1;
        if (at >= 0 && plot.cursor.left < 0) plot.setLegend({ idx: at });
      }
    }

    resize() {
      for (const { plot, place } of this.plots) {
        const width = Math.max(200, place.clientWidth);
        if (place.clientWidth && plot.width !== width) plot.setSize({ width, height: heightIn(place) });
      }
      this.update();
    }
    recolour() {
      for (const { plot } of this.plots) plot.redraw(false);
    }
  };
})();
