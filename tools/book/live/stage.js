"use strict";
// The canvas: panes side by side, camera, hand.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});

  const minus = (a, b) => a.map((x, i) => x - b[i]);
  const plus = (a, b, k = 1) => a.map((x, i) => x + k * b[i]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = (a) => Math.hypot(...a);
  const unit = (a) => a.map((x) => x / length(a));
  const clamp = (x, low, high) => Math.min(high, Math.max(low, x));

  const slow = 60; // ms: a picture that takes longer is drawn coarsely while something moves
  const coarseness = 0.4; // of its pixels along each side
  const head = 26; // CSS pixels over each pane, for the variant's name
  const gutter = 10; // CSS pixels between panes
  const narrow = 480; // CSS pixels: what is less has room for one variant
  const least = 84; // CSS pixels of a pane's height
  const hold = 250; // ms that a finger rests before it takes hold of a body: a swipe scrolls or turns
  const slack = 8; // CSS pixels that a finger that rests may move

  /** A camera that goes about its target. Angles in rad; `distance` and `pan` as factors of the scene's own distance. */
  class Camera {
    constructor() {
      this.reset();
    }
    reset() {
      Object.assign(this, { turn: 0, rise: 0, zoom: 1, pan: [0, 0] });
    }
    get isReset() {
      return this.turn === 0 && this.rise === 0 && this.zoom === 1 && !this.pan[0] && !this.pan[1];
    }
    orbit(turn, rise) {
      this.turn = (this.turn + turn) % (2 * Math.PI);
      this.rise += rise;
    }
    zoomBy(factor) {
      this.zoom = clamp(this.zoom * factor, 0.05, 20);
    }
    panBy(x, y) {
      this.pan = [this.pan[0] + x, this.pan[1] + y];
    }
    /** `from`: the scene's { eye, target, field_of_view }. */
    seen(from) {
      const away = minus(from.eye, from.target),
        distance = length(away);
      const level = Math.hypot(away[0], away[2]);
      const heading = Math.atan2(away[0], away[2]) + this.turn;
      const height = clamp(Math.atan2(away[1], level) + this.rise, -1.5, 1.5);
      this.rise = height - Math.atan2(away[1], level);
      const direction = [Math.cos(height) * Math.sin(heading), Math.sin(height), Math.cos(height) * Math.cos(heading)];
      const right = unit(cross([0, 1, 0], direction)),
        up = cross(direction, right);
      const across = 2 * distance * this.zoom * Math.tan(from.field_of_view / 2);
      const target = plus(plus(from.target, right, across * this.pan[0]), up, across * this.pan[1]);
      return { eye: plus(target, direction, distance * this.zoom), target, fieldOfView: from.field_of_view };
    }
  }

  /**
   * The scene's camera, which sees as far to both sides as the sheet shows, also in a narrower picture; `close`: to what goes across it
   * in a scene of many instants.
   */
  live.cameraOf = function (engine, own, close) {
    const { camera, strobe, aspect } = engine.scene;
    const from = { ...camera };
    if (strobe && close) {
      const { centre, radius } = engine.reach(),
        away = unit(minus(from.eye, from.target));
      from.field_of_view = 0.5;
      from.target = plus(plus(centre, engine.shift()), [0, 0.15 * radius, 0]);
      from.eye = plus(from.target, away, (1.5 * radius) / Math.tan(0.25));
    }
    const wanted = strobe && close ? 1.3 : aspect;
    if (own < wanted) from.field_of_view = 2 * Math.atan((Math.tan(from.field_of_view / 2) * wanted) / own);
    return from;
  };

  live.Stage = class {
    /** `player`: what is played; it is asked for lanes and told of what the hand does. */
    constructor(player, element) {
      Object.assign(this, { player, element, camera: new Camera(), follow: false, coarse: false });
      this.numbers = Array.from({ length: 4 }, () => [live.make("span"), live.make("span")]); // of each lane: its name, and what it is
      this.tab = 0; // the lane that is seen where there is room for one
      this.room = 0.72 * window.innerHeight; // CSS pixels of height
      this.cost = Infinity; // ms, of a whole picture, as far as that is known: what moves is drawn coarsely until then
      this.guesses = 5; // of the cost, from coarse pictures: the first ones compile shaders
      this.canvas = live.make("canvas", { className: "pb-canvas", tabIndex: 0, role: "img" });
      this.canvas.id = `pushback-live-${++live.Stage.count}`;
      this.tabs = live.make("div", { className: "pb-tabs", role: "tablist", "aria-label": "Variant that is seen" });
      this.labels = live.make("div", { className: "pb-labels" });
      element.append(this.canvas, this.labels);
      element.before(this.tabs);
      this.problem = player.engine.open(`#${this.canvas.id}`);
      this.listen();
    }

    begin() {
      this.tab = Math.min(this.tab, this.player.engine.lanes.length - 1);
    }

    // ---- panes
    /** CSS pixels over each pane: a tab has the name already. */
    get head() {
      return this.tabbed ? 0 : head;
    }
    /** Rectangles, CSS pixels from the upper left corner, one a lane; one for all where it is narrow. */
    arrange() {
      const { lanes, scene } = this.player.engine;
      const width = this.element.clientWidth || 640;
      this.tabbed = width < narrow && lanes.length > 1 && !this.player.toy;
      const seen = this.tabbed ? [lanes[this.tab]] : lanes;
      const count = seen.length;
      const aspect = scene.strobe && this.follow ? 1.6 : scene.aspect;
      // In as many columns as show the bodies largest.
      let best = null;
      for (let columns = 1; columns <= count; ++columns) {
        const wide = (width - gutter * (columns - 1)) / columns,
          rows = Math.ceil(count / columns),
          high = Math.min(wide / aspect, this.room / rows - this.head);
        if (!best || high > best.high + 1) best = { columns, rows, wide, high };
      }
      const { columns, rows, wide } = best,
        high = Math.round(Math.max(least, best.high));
      this.panes = seen.map(({ lane }, at) => {
        const left = Math.round((at % columns) * (wide + gutter)),
          top = Math.floor(at / columns) * (high + this.head) + this.head;
        const right = Math.round((at % columns) * (wide + gutter) + wide);
        return { lane, left, top, width: right - left, height: high };
      });
      const empty = rows * columns - count; // panes of the last row
      this.empty = empty && { left: this.panes.at(-1).left + this.panes.at(-1).width, top: this.panes.at(-1).top };
      this.size = { width, height: rows * (high + this.head) };
      const scale = clamp(window.devicePixelRatio || 1, 1, 2) * (this.coarse ? coarseness : 1);
      const [w, h] = [Math.round(scale * width), Math.round(scale * this.size.height)];
      if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, { width: w, height: h });
      this.canvas.style.height = `${this.size.height}px`;
      this.scale = scale;
    }

    cameraFor(pane) {
      return this.camera.seen(live.cameraOf(this.player.engine, pane.width / pane.height, this.follow));
    }

    draw() {
      this.arrange();
      this.label();
      if (this.problem) return;
      const { engine } = this.player,
        shown = this.player.shown | live.lit() | (this.coarse ? 8 : 0),
        began = performance.now();
      engine.begin();
      for (const pane of this.panes) {
        const pixels = (x) => Math.round(this.scale * x);
        const x = pixels(pane.left),
          width = pixels(pane.left + pane.width) - x,
          height = pixels(pane.height);
        engine.look(this.cameraFor(pane));
        const y = this.canvas.height - pixels(pane.top) - height;
        this.problem ||= engine.draw(pane.lane, shown, x, y, width, height);
      }
      if (this.problem || (this.coarse && this.guesses-- <= 0)) return;
      // Until the picture is there: a processor that draws may take longer than a hand waits.
      const gl = this.canvas.getContext("webgl2");
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      const took = performance.now() - began;
      this.cost = this.coarse ? Math.min(this.cost, took / coarseness ** 2) : took;
    }
    /** Until nothing has moved for a while, where whole pictures take long. */
    hurry() {
      this.coarse = this.cost > slow;
      clearTimeout(this.refining);
      if (!this.coarse) return;
      this.refining = setTimeout(() => {
        this.coarse = false;
        this.player.changed();
      }, 250);
    }

    /** Names over the panes, or tabs; and what lies between panes. */
    label() {
      const { engine, names } = this.player,
        { lanes } = engine,
        { make } = live;
      const wanted = this.panes.map((pane) => {
        const own = { name: names[pane.lane], mishap: engine.mishap(pane.lane) };
        return { pane, ...lanes[pane.lane], ...own };
      });
      const key = JSON.stringify([wanted, this.size, this.tabbed && lanes]);
      if (key === this.labelled) return;
      this.labelled = key;
      const within = (className, left, top, width, height, ...children) => {
        const element = make("div", { className }, ...children);
        const box = { left, top, width, height };
        for (const [side, value] of Object.entries(box)) element.style[side] = `${value}px`;
        return element;
      };
      const labelled = wanted.filter(({ mishap }) => mishap || !this.tabbed); // what a tab names needs no label on its picture
      const labels = labelled.map(({ pane, mishap, ...lane }) => {
        const marked = this.tabbed
          ? [mishap]
          : live.marked({ ...lane, name: [lane.name, mishap].filter(Boolean).join(": ") });
        const words = [make("span", {}, ...marked), ...(this.tabbed ? [] : this.numbers[pane.lane])];
        return within("pb-label", pane.left, pane.top - this.head, pane.width, head, ...words);
      });
      const gutters = this.panes
        .filter(({ left }) => left > 0)
        .map(({ left, top, height }) => within("pb-gutter", left - gutter - 1, top - head, gutter + 1, height + head));
      if (this.empty) {
        const { left, top } = this.empty;
        const height = this.size.height - top + this.head;
        gutters.push(within("pb-gutter", left, top - this.head, this.size.width - left, height));
      }
      this.labels.replaceChildren(...labels, ...gutters);
      this.tabs.hidden = !this.tabbed;
      const tabs = (this.tabbed ? lanes : []).map((lane) => this.tabOf(lane, lanes.length));
      live.keepingFocus(this.tabs, () => this.tabs.replaceChildren(...tabs));
    }
    tabOf(lane, count) {
      const seen = lane.lane === this.tab;
      const properties = {
        type: "button",
        role: "tab",
        tabIndex: seen ? 0 : -1,
        "aria-selected": seen,
        "aria-controls": this.canvas.id,
        onclick: () => this.show(lane.lane),
        onkeydown: (event) => {
          const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
          if (!by) return;
          event.preventDefault();
          this.show((lane.lane + by + count) % count);
          this.tabs.children[this.tab].focus();
        },
      };
      return live.make("button", properties, ...live.marked(lane), this.numbers[lane.lane][1]);
    }
    /** Beside the name of a variant its first number. */
    number(lane, ...words) {
      this.numbers[lane].forEach((element, i) => (element.textContent = words[i]));
    }
    /** Where there is room for one variant: this one. */
    show(lane) {
      this.tab = lane;
      this.arrange();
      this.label();
      this.player.changed();
    }

    // ---- pointer
    paneAt(x, y) {
      return this.panes.find((p) => x >= p.left && x < p.left + p.width && y >= p.top && y < p.top + p.height);
    }
    spot(pane, x, y) {
      return [(2 * (x - pane.left)) / pane.width - 1, 1 - (2 * (y - pane.top)) / pane.height];
    }
    /** Where the plane z = 0 is seen, [x, y], m. */
    onPlane(x, y) {
      const pane = this.paneAt(x, y);
      if (!pane) return null;
      const { eye, target, fieldOfView } = this.cameraFor(pane),
        half = Math.tan(fieldOfView / 2),
        ahead = unit(minus(target, eye)),
        right = unit(cross(ahead, [0, 1, 0])),
        [across, up] = this.spot(pane, x, y);
      const aside = plus(ahead, right, (half * across * pane.width) / pane.height);
      const towards = plus(aside, cross(right, ahead), half * up);
      const away = -eye[2] / towards[2];
      return away > 0 ? plus(eye, towards, away).slice(0, 2) : null;
    }
    place(event) {
      const box = this.canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    }
    /** Whether there is a body under the finger, or close to it. */
    grabAt(x, y, slack) {
      const pane = this.paneAt(x, y);
      if (!pane) return null;
      const { engine } = this.player;
      engine.look(this.cameraFor(pane));
      const around = [[0, 0]];
      for (let k = 0; k < 6 && slack > 0; ++k) around.push([slack * Math.cos(k), slack * Math.sin(k)]);
      for (const [dx, dy] of around) {
        if (engine.grab(pane.lane, pane.width / pane.height, ...this.spot(pane, x + dx, y + dy))) return pane;
      }
      return null;
    }

    listen() {
      const { canvas } = this;
      const fingers = new Map();
      let action = null,
        held = null;
      canvas.addEventListener("contextmenu", (event) => event.preventDefault());
      const take = (x, y, around) => {
        held = this.grabAt(x, y, around);
        if (!held) return;
        action = "pull";
        this.player.grabbed();
      };
      let resting = 0,
        began = null;
      canvas.addEventListener("blur", () => (this.clicked = false));
      canvas.addEventListener("pointerdown", (event) => {
        if (this.problem) return;
        this.clicked = true;
        const [x, y] = this.place(event);
        fingers.set(event.pointerId, [x, y]);
        canvas.setPointerCapture(event.pointerId);
        clearTimeout(resting);
        if (fingers.size > 1) {
          this.player.release();
          action = "pinch";
        } else if (event.pointerType === "touch") {
          action = "rest";
          began = [x, y];
          resting = setTimeout(() => take(x, y, 14), hold);
        } else {
          action = event.button === 2 || event.shiftKey ? "pan" : "orbit";
          if (action === "orbit") take(x, y, 0);
        }
      });
      canvas.addEventListener("pointermove", (event) => {
        const [x, y] = this.place(event),
          before = fingers.get(event.pointerId);
        if (!before) return;
        const [dx, dy] = [x - before[0], y - before[1]];
        const high = this.panes[0].height;
        if (action === "rest" && Math.hypot(x - began[0], y - began[1]) > slack) {
          clearTimeout(resting);
          action = Math.abs(x - began[0]) > Math.abs(y - began[1]) ? "turn" : "scroll";
        }
        if (action === "pinch") {
          const other = [...fingers].find(([id]) => id !== event.pointerId);
          if (other) {
            const apart = (p) => Math.hypot(p[0] - other[1][0], p[1] - other[1][1]);
            this.camera.zoomBy(apart(before) / Math.max(1, apart([x, y])));
            this.camera.panBy(-dx / high / 2, dy / high / 2);
          }
        } else if (action === "pull") {
          this.player.engine.look(this.cameraFor(held));
          this.player.engine.pull(held.width / held.height, ...this.spot(held, x, y));
        } else if (action === "pan") {
          this.camera.panBy(-dx / high, dy / high);
        } else if (action === "orbit") {
          this.camera.orbit(-dx * 0.008, dy * 0.008);
        } else if (action === "turn") {
          this.camera.orbit(-dx * 0.008, 0);
        }
        fingers.set(event.pointerId, [x, y]);
        this.player.changed();
      });
      const end = (event) => {
        clearTimeout(resting);
        fingers.delete(event.pointerId);
        if (action === "pull") this.player.release();
        if (fingers.size === 0) action = null;
        this.player.remember();
      };
      canvas.addEventListener("pointerup", end);
      canvas.addEventListener("pointercancel", end);
      // The page scrolls under a finger that moves up or down, unless it holds a body.
      canvas.addEventListener(
        "touchmove",
        (event) => {
          if (action === "pull" || action === "pinch") event.preventDefault();
        },
        { passive: false },
      );
      canvas.addEventListener(
        "wheel",
        (event) => {
          if (!this.clicked && !event.ctrlKey) return; // a page that is scrolled past the picture goes on
          event.preventDefault();
          this.camera.zoomBy(Math.exp(event.deltaY * 0.0012));
          this.player.changed();
          this.player.remember();
        },
        { passive: false },
      );
      canvas.addEventListener("webglcontextlost", (event) => {
        event.preventDefault();
        this.problem = "The browser took the graphics of this page away.";
        this.player.changed();
      });
      canvas.addEventListener("webglcontextrestored", () => {
        this.problem = this.player.engine.open(`#${canvas.id}`);
        this.player.changed();
      });
    }
  };
  live.Stage.count = 0;
  live.Stage.narrow = narrow;
})();
