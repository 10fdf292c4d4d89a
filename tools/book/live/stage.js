"use strict";
// The canvas: panes side by side, camera, hand, wipe.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});

  const minus = (a, b) => a.map((x, i) => x - b[i]);
  const plus = (a, b, k = 1) => a.map((x, i) => x + k * b[i]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = (a) => Math.hypot(...a);
  const unit = (a) => a.map((x) => x / length(a));
  const clamp = (x, low, high) => Math.min(high, Math.max(low, x));

  const slow = 60; // ms: a picture that takes longer is drawn coarsely while a slider moves
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

  live.Stage = class {
    /** `player`: what is played; it is asked for lanes and told of what the hand does. */
    constructor(player, element) {
      this.player = player;
      this.element = element;
      this.camera = new Camera();
      this.follow = false;
      this.tab = 0; // the lane that is seen where there is room for one
      this.room = 0.72 * window.innerHeight; // CSS pixels of height
      this.cost = 0; // ms, of a whole picture, as far as that is known
      this.coarse = false;
      this.drawing = false; // whether the graphics still work on the picture that they were given
      this.wipe = null; // the part of the width at which one variant ends and the other begins
      this.canvas = document.createElement("canvas");
      this.canvas.id = `pushback-live-${++live.Stage.count}`;
      this.canvas.className = "pb-canvas";
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute("role", "img");
      this.tabs = live.make("div", { className: "pb-tabs", role: "tablist", "aria-label": "Variant that is seen" });
      this.labels = live.make("div", { className: "pb-labels" });
      this.edges = live.make("div", { className: "pb-labels", "aria-hidden": "true" });
      this.divider = document.createElement("input");
      Object.assign(this.divider, {
        type: "range",
        min: 0,
        max: 1000,
        value: 500,
        className: "pb-divider",
        hidden: true,
      });
      this.divider.setAttribute("aria-label", "Where one variant ends and the other begins");
      this.divider.addEventListener("input", () => {
        this.wipe = this.divider.value / 1000;
        player.changed();
      });
      element.append(this.canvas, this.labels, this.edges, this.divider);
      element.before(this.tabs);
      this.problem = player.engine.open(`#${this.canvas.id}`);
      this.listen();
    }

    /** Of the scene as it begins: where the bodies are. */
    begin() {
      const { engine } = this.player;
      this.starts = engine.lanes.map(({ lane }) => this.positions(lane));
      this.tab = Math.min(this.tab, engine.lanes.length - 1);
    }
    positions(lane) {
      const { engine } = this.player;
      return Array.from({ length: engine.bodies(lane) }, (_, body) => engine.body(lane, body).position);
    }

    // ---- panes
    /** CSS pixels over each pane: a tab has the name already. */
    get head() {
      return this.tabbed ? 0 : head;
    }
    /** Rectangles, CSS pixels from the upper left corner, one a lane; of a wipe one for both; one for all where it is narrow. */
    arrange() {
      const { lanes, scene } = this.player.engine;
      const width = this.element.clientWidth || 640;
      const wiping = this.wipe !== null && lanes.length === 2;
      this.tabbed = width < narrow && lanes.length > 1 && !wiping;
      const seen = this.tabbed ? [lanes[this.tab]] : lanes;
      const count = wiping ? 1 : seen.length;
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
      this.panes = seen.map(({ lane }, i) => {
        const at = wiping ? 0 : i;
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
      this.divider.hidden = !wiping;
      this.wiping = wiping;
    }

    /** As far to both sides as the sheet shows, also where the pane is narrower. */
    cameraFor(pane) {
      const { engine } = this.player;
      const scene = engine.scene;
      const from = { ...scene.camera };
      let aspect = scene.aspect;
      if (scene.strobe && this.follow) {
        const { centre, radius } = engine.reach(),
          away = unit(minus(from.eye, from.target));
        const shift = engine.shift();
        from.field_of_view = 0.5;
        from.target = plus(plus(centre, shift), [0, 0.15 * radius, 0]);
        from.eye = plus(from.target, away, (1.5 * radius) / Math.tan(0.25));
        aspect = 1.3;
      }
      const own = pane.width / pane.height;
      if (own < aspect) from.field_of_view = 2 * Math.atan((Math.tan(from.field_of_view / 2) * aspect) / own);
      return this.camera.seen(from);
    }

    draw() {
      this.arrange();
      this.label();
      this.markEdges();
      if (this.problem) return;
      const { engine } = this.player,
        shown = this.player.shown | (this.coarse ? 8 : 0);
      engine.begin();
      for (const pane of this.panes) {
        const pixels = (x) => Math.round(this.scale * x);
        const x = pixels(pane.left),
          width = pixels(pane.left + pane.width) - x,
          height = pixels(pane.height);
        const y = this.canvas.height - pixels(pane.top) - height;
        engine.look(this.cameraFor(pane));
        const at = this.wiping ? Math.round(width * this.wipe) : 0;
        const [from, to] = !this.wiping ? [0, width] : pane.lane === 0 ? [0, at] : [at, width];
        if (to > from) this.problem = engine.draw(pane.lane, shown, x, y, width, height, from, to);
        if (this.problem) break;
      }
      if (!this.problem) this.time();
    }
    /** How long the graphics take for the picture that they were given: software may take longer than a hand waits. */
    time() {
      if (this.drawing) return;
      const gl = this.canvas.getContext("webgl2"),
        fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0),
        began = performance.now(),
        { coarse } = this;
      this.drawing = true;
      gl.flush();
      const look = () => {
        if (fence && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) return setTimeout(look, 4);
        this.drawing = false;
        if (!coarse) this.cost = performance.now() - began;
        gl.deleteSync(fence);
        this.player.drawn(began);
      };
      setTimeout(look);
    }
    /** Until nothing has moved for a while, where whole pictures take long. */
    hurry() {
      this.coarse = this.cost > slow;
      clearTimeout(this.refining);
      this.refining = setTimeout(() => {
        this.coarse = false;
        this.player.changed();
      }, 250);
    }

    label() {
      const { lanes } = this.player.engine,
        { make } = live;
      const wanted = this.panes.map((pane) => {
        const { name, colour, marker } = lanes[pane.lane];
        return { pane, name, colour, marker, mishap: this.player.engine.mishap(pane.lane) };
      });
      const key = JSON.stringify([wanted, this.wiping && this.wipe, this.size, this.tabbed && lanes.length]);
      if (key === this.labelled) return;
      this.labelled = key;
      const within = (className, left, top, width, height) => {
        const element = make("div", { className });
        Object.assign(element.style, {
          left: `${left}px`,
          top: `${top}px`,
          width: `${width}px`,
          height: `${height}px`,
        });
        return element;
      };
      const inColour = (marker, colour) => {
        const mark = make("span", { textContent: `${marker} `, "aria-hidden": "true" });
        mark.style.color = colour;
        return mark;
      };
      this.labels.replaceChildren(
        ...wanted.map(({ pane, name, colour, marker, mishap }) => {
          const [part, from] = this.wiping ? [0.5, pane.lane / 2] : [1, 0];
          const label = within(
            "pb-label",
            pane.left + from * pane.width,
            pane.top - this.head,
            part * pane.width,
            head,
          );
          label.style.textAlign = from ? "right" : "left";
          if (!this.tabbed) label.append(inColour(marker, colour), mishap ? `${name}: ${mishap}` : name);
          else label.append(mishap); // the tab has the name
          return label;
        }),
        ...this.panes
          .filter(({ left }) => left > 0)
          .map(({ left, top, height }) => within("pb-gutter", left - gutter, top - head, gutter, height + head)),
      );
      if (this.empty) {
        const { left, top } = this.empty;
        this.labels.append(
          within("pb-gutter", left, top - this.head, this.size.width - left, this.size.height - top + this.head),
        );
      }
      if (this.wiping) {
        const { left, top, width, height } = this.panes[0];
        this.labels.append(within("pb-wipe", left + this.wipe * width - 1, top, 2, height));
      }
      this.tabs.hidden = !this.tabbed;
      live.keepingFocus(this.tabs, () =>
        this.tabs.replaceChildren(
          ...(this.tabbed ? lanes : []).map(({ lane, name, colour, marker }) =>
            make(
              "button",
              {
                type: "button",
                role: "tab",
                tabIndex: lane === this.tab ? 0 : -1,
                "aria-selected": lane === this.tab,
                "aria-controls": this.canvas.id,
                "aria-label": name,
                onclick: () => this.show(lane),
                onkeydown: (event) => {
                  const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
                  if (!by) return;
                  event.preventDefault();
                  this.show((lane + by + lanes.length) % lanes.length);
                  this.tabs.children[this.tab].focus();
                },
              },
              inColour(marker, colour),
              name,
            ),
          ),
        ),
      );
    }
    /** Where there is room for one variant: this one. */
    show(lane) {
      this.tab = lane;
      this.arrange();
      this.label();
      this.player.changed();
    }

    /** Bodies that have moved out of a pane: a mark at its edge, where they are. */
    markEdges() {
      const { engine } = this.player,
        marks = [];
      this.outside = 0;
      if (engine.scene.magnified === 1) for (const pane of this.panes) marks.push(...this.outsideOf(pane));
      const key = JSON.stringify(marks);
      if (key === this.marked) return;
      this.marked = key;
      this.edges.replaceChildren(
        ...marks.map(([x, y, angle]) => {
          const mark = live.make("div", { className: "pb-edge" });
          mark.style.transform = `translate(${x}px, ${y}px) rotate(${angle}deg)`;
          return mark;
        }),
      );
    }
    outsideOf(pane) {
      const { engine } = this.player,
        { eye, target, fieldOfView } = this.cameraFor(pane),
        shift = engine.shift();
      const away = unit(minus(eye, target)),
        right = unit(cross([0, 1, 0], away)),
        up = cross(away, right);
      const half = Math.tan(fieldOfView / 2),
        start = this.starts[pane.lane],
        dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
      const marks = new Map();
      this.positions(pane.lane).forEach((position, body) => {
        if (length(minus(position, start[body])) < 1e-9) return;
        const from = minus(plus(position, shift), eye),
          ahead = -dot(from, away);
        if (ahead <= 0) return;
        const x = (dot(from, right) / ahead / half) * (pane.height / pane.width),
          y = dot(from, up) / ahead / half;
        if (Math.max(Math.abs(x), Math.abs(y)) <= 1) return;
        ++this.outside;
        const margin = 9, // CSS pixels
          at = (share, from, size) => Math.round(from + clamp((size * (1 + share)) / 2, margin, size - margin));
        const angle = Math.abs(x) > Math.abs(y) ? (x > 0 ? 0 : 180) : y > 0 ? -90 : 90;
        const mark = [at(x, pane.left, pane.width), at(-y, pane.top, pane.height), angle];
        marks.set(mark.map((one) => Math.round(one / 12)).join(), mark); // those of a heap are one
      });
      return [...marks.values()];
    }

    // ---- pointer
    paneAt(x, y) {
      return this.panes.find((p) => x >= p.left && x < p.left + p.width && y >= p.top && y < p.top + p.height);
    }
    spot(pane, x, y) {
      return [(2 * (x - pane.left)) / pane.width - 1, 1 - (2 * (y - pane.top)) / pane.height];
    }
    place(event) {
      const box = this.canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    }
    /** Whether there is a body under the finger, or close to it. */
    grabAt(x, y, slack) {
      let pane = this.paneAt(x, y);
      if (!pane) return null;
      if (this.wiping && x > pane.left + this.wipe * pane.width) pane = { ...pane, lane: 1 };
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
        held = this.player.grabbing ? this.grabAt(x, y, around) : null;
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
  live.Stage.head = head;
  live.Stage.narrow = narrow;
})();
