"use strict";
// Sliders, one for each parameter that the chapter's --help lists, and of those of every experiment sweeps, step and time.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const notches = 400;
  const { make } = live;
  const shorter = (x) => Number(x.toPrecision(4)).toString();

  /** Between the notches of a slider and a value: by equal factors where the range spans a hundredfold. */
  class Scale {
    constructor({ least, most, whole }) {
      Object.assign(this, { least, most, whole, log: least > 0 && most / least >= 100 });
    }
    value(notch) {
      const share = notch / notches;
      const value = this.log
        ? this.least * (this.most / this.least) ** share
        : this.least + share * (this.most - this.least);
      return this.whole ? Math.round(value) : Number(value.toPrecision(3));
    }
    notch(value) {
      const along = this.log ? Math.log : (x) => x;
      const share = (along(value) - along(this.least)) / (along(this.most) - along(this.least));
      return Math.round(notches * Math.min(1, Math.max(0, share)));
    }
  }

  const mostSliders = 6;
  const beforeOnesEyes = 2; // parameters that stand below the picture, with as many sliders as leave room for it
  const mostBeforeOnesEyes = 4;

  live.Controls = class {
    /**
     * `places`: where the sliders stand that come first, where the further ones, and what folds these. `idle`: of each flag the
     * scenes in which it changes nothing. `set(assignments)`: of what is not as it is by default.
     */
    constructor(places, engine, idle, set) {
      Object.assign(this, { places, engine, idle, set });
      this.build();
    }

    /** Those that change something in this scene; `only`: those that a challenge leaves to whom it asks. */
    get acting() {
      const { parameters, sceneIndex } = this.engine;
      const may = ({ flag }) => (this.only ? this.only.includes(flag) : !this.idle[flag]?.includes(sceneIndex));
      return parameters.filter(may);
    }
    /** A label in which no flag of the command line is named. */
    inWords(text) {
      return text.replace(/--[a-z-]+/g, (flag) => {
        const { symbol, what } = this.engine.parameters.find((one) => one.flag === flag) ?? {};
        return symbol || what?.toLowerCase() || flag;
      });
    }

    get assignments() {
      return this.engine.parameters
        .filter(({ flag }) => this.own.has(flag))
        .map(({ flag }) => `${flag}=${this.own.get(flag).join(",")}`)
        .join(";");
    }

    build() {
      const { parameters, values } = this.engine;
      this.own = new Map();
      for (const { flag, default: usual } of parameters) {
        const now = values[flag];
        if (now.length && JSON.stringify(now) !== JSON.stringify(usual)) this.own.set(flag, now);
      }
      const { first, further, fold } = this.places,
        { acting } = this;
      let count = 0,
        sliders = 0;
      for (const parameter of acting.slice(0, beforeOnesEyes)) {
        sliders += (this.own.get(parameter.flag) || this.usual(parameter)).length;
        if (count === 0 || sliders <= mostBeforeOnesEyes) ++count;
      }
      const rows = acting.map((parameter) => this.row(parameter));
      const still = parameters.filter((parameter) => !acting.includes(parameter)).map(({ what }) => this.inWords(what));
      live.keepingFocus(first, () => first.replaceChildren(...rows.slice(0, count)));
      live.keepingFocus(further, () => {
        further.replaceChildren(...rows.slice(count));
        if (still.length && !this.only)
          further.append(
            make("p", { className: "pb-idle", textContent: `Without effect in this scene: ${still.join("; ")}.` }),
          );
      });
      fold.hidden = !further.childElementCount;
    }

    /** What a parameter is where nobody has set it: of the time and the sweeps what scene and variant say. */
    usual({ flag, default: usual }) {
      const { engine } = this;
      if (flag === "--seconds") return [Number((engine.steps * engine.dt).toPrecision(6))];
      if (flag === "--sweeps") return [Math.max(1, ...engine.lanes.map(({ sweeps }) => sweeps))];
      return usual;
    }

    row(parameter) {
      const { flag, symbol, unit } = parameter,
        what = this.inWords(parameter.what);
      const now = this.own.get(flag) || this.usual(parameter);
      const list = parameter.default.length > 1;
      const title = make("span", { className: "pb-what" });
      if (symbol) title.append(make("i", { textContent: symbol }), "  ");
      title.append(what);
      const reset = live.small("reset", () => this.change(parameter, null, true), {
        "aria-label": `Reset: ${what}`,
        hidden: !this.own.has(flag),
      });
      const row = make(
        "div",
        { className: "pb-parameter", role: "group", "aria-label": what },
        make("div", { className: "pb-head" }, title, reset),
      );
      row.dataset.flag = flag;
      if (document.querySelector(`article [data-symbol="${symbol}"]`)) row.dataset.symbol = symbol;
      if (now.length > mostSliders) {
        const onchange = ({ target }) =>
          this.change(parameter, (target.value.match(/[^,\s]+/g) ?? []).map(Number), true);
        const label = `${what}, separated by commas`;
        row.append(
          make("input", { type: "text", className: "pb-list", value: now.join(", "), "aria-label": label, onchange }),
        );
        return row;
      }
      now.forEach((value, i) => row.append(this.slider(parameter, now, i, list, unit, what)));
      const longer = () => this.change(parameter, [...now, this.another(parameter, now)], true);
      if (list && now.length < mostSliders)
        row.append(live.small("+ one more", longer, { "aria-label": `One more: ${what}` }));
      return row;
    }

    another(parameter, now) {
      const scale = new Scale(parameter);
      for (const notch of [0.5, 0.7, 0.3, 0.9, 0.1, 0.6, 0.8].map((x) => Math.round(x * notches))) {
        if (!now.includes(scale.value(notch))) return scale.value(notch);
      }
      return parameter.most;
    }

    slider(parameter, now, i, list, unit, what) {
      const { least, most, whole } = parameter,
        scale = new Scale(parameter);
      const label = list ? `${what}, ${i + 1} of ${now.length}` : what;
      const range = make("input", {
        type: "range",
        min: 0,
        max: notches,
        step: whole && !scale.log ? Math.max(1, notches / (most - least)) : 1,
        value: scale.notch(now[i]),
        "aria-label": label,
      });
      range.setAttribute("aria-valuetext", `${shorter(now[i])} ${unit}`);
      const number = make("input", {
        type: "number",
        min: least,
        max: most,
        step: whole ? 1 : "any",
        value: shorter(now[i]),
        "aria-label": `${label}, as a number`,
      });
      const told = (value, done) => {
        const values = [...(this.own.get(parameter.flag) || now)];
        values[i] = value;
        this.change(parameter, values, done);
      };
      range.addEventListener("input", () => {
        const value = scale.value(Number(range.value));
        number.value = shorter(value);
        range.setAttribute("aria-valuetext", `${shorter(value)} ${unit}`);
        told(value, false);
      });
      range.addEventListener("change", () => told(scale.value(Number(range.value)), true));
      number.addEventListener("change", () => told(Number(number.value), true));
      const row = make(
        "div",
        { className: "pb-slider" },
        range,
        number,
        make("span", { className: "pb-unit", textContent: unit }),
      );
      if (list && now.length > 1) {
        const without = now.filter((_, k) => k !== i);
        row.append(
          live.small("×", () => this.change(parameter, without, true), { "aria-label": `Leave out: ${label}` }),
        );
      }
      return row;
    }

    /** `done`: not while a slider is still moving; only then are the sliders drawn anew. */
    change(parameter, values, done) {
      if (values === null) this.own.delete(parameter.flag);
      else this.own.set(parameter.flag, values);
      this.set(this.assignments, done);
      const flag = `[data-flag="${parameter.flag}"]`;
      for (const place of [this.places.first, this.places.further]) {
        const reset = place.querySelector(`${flag} .pb-head button`);
        if (reset) reset.hidden = !this.own.has(parameter.flag);
      }
    }
  };
})();
