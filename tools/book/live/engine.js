"use strict";
// A chapter's program, which em++ made of its main.cpp: unpacked, and the calls of common/live/browser.cpp with JavaScript's values.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  async function unpacked(base64) {
    if (!self.DecompressionStream) throw new Error("this browser is too old to unpack it");
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  /** The bytes of which tools/book/difference.js has stored what differs from others. */
  live.joined = function (from, difference) {
    let at = 0;
    const number = () => {
      let value = 0;
      for (let place = 1; ; place *= 128) {
        const byte = difference[at++];
        value += (byte & 127) * place;
        if (byte < 128) return value;
      }
    };
    const parts = [];
    let length = 0,
      end = 0;
    for (const last = number() + at; at < last;) {
      const before = number(),
        size = number(),
        shift = number();
      const place = end + (shift & 1 ? -(shift + 1) / 2 : shift / 2);
      parts.push({ before, place, size });
      end = place + size;
      length += size;
    }
    let added = at; // these bytes, and behind them those between the parts
    at += length;
    const whole = new Uint8Array(difference.length - added);
    let done = 0;
    for (const { before, place, size } of parts) {
      whole.set(difference.subarray(at, at + before), done);
      at += before;
      done += before;
      for (let i = 0; i < size; ++i) whole[done++] = from[place + i] + difference[added++]; // modulo 256
    }
    whole.set(difference.subarray(at), done);
    return whole;
  };

  /** What `make` promises for a name: once, until it fails. The next time may be better. */
  function once(promises, name, make) {
    if (!promises.has(name)) {
      promises.set(name, make());
      promises.get(name).catch(() => promises.delete(name));
    }
    return promises.get(name);
  }

  const wholes = new Map();
  /** The bytes of a program, its loader and its code, of what differs from another and the other's bytes. */
  const bytesOf = (name, root) =>
    once(wholes, name, async () => {
      await live.loadScript(`${root}/live/programs/${name}.js`);
      const { from, packed } = self.PUSHBACK_PROGRAMS[name];
      if (!from) return unpacked(packed);
      const [other, own] = await Promise.all([bytesOf(from, root), unpacked(packed)]);
      return live.joined(other, own);
    });

  const programs = new Map();
  /** { create, module } of an experiment: its loader and its code, compiled. Loaded once, however many are played. */
  live.program = (name, root) =>
    once(programs, name, async () => {
      const bytes = await bytesOf(name, root);
      const { loader } = self.PUSHBACK_PROGRAMS[name];
      const text = new TextDecoder().decode(bytes.subarray(0, loader));
      return {
        create: new Function(`${text}; return createPushbackLive;`)(),
        module: await WebAssembly.compile(bytes.subarray(loader)),
      };
    });

  live.Engine = class {
    static async load(name, root) {
      return live.Engine.of(await live.program(name, root));
    }
    static async of({ create, module }) {
      const instantiateWasm = (imports, done) => {
        WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
        return {};
      };
      return new live.Engine(await create({ instantiateWasm }));
    }

    constructor(module) {
      this.module = module;
      this.describe();
    }

    // ---- what there is
    describe() {
      this.description = JSON.parse(this.text(this.module._live_description()));
      this.parameters = JSON.parse(this.text(this.module._live_parameters()));
      this.values = JSON.parse(this.text(this.module._live_values()));
    }
    /** "--beta=0,1.4;--depth=0.1"; what is not named has its default. Returns why it is not allowed, or "". */
    set(assignments) {
      const problem = this.told(assignments, (text) => this.module._live_set(text));
      this.describe();
      return problem;
    }
    choose(scene, variants) {
      const bits = variants.reduce((all, place) => all | (1 << place), 0);
      return this.text(this.module._live_choose(scene, bits));
    }
    get scene() {
      return this.description.scenes[this.module._live_scene()];
    }
    get sceneIndex() {
      return this.module._live_scene();
    }
    /** The variants that are shown, each with its place in the scene. */
    get lanes() {
      return Array.from({ length: this.module._live_lanes() }, (_, lane) => {
        const place = this.module._live_variant(lane);
        return { lane, place, ...this.scene.variants[place] };
      });
    }
    get dt() {
      return this.description.dt;
    }

    // ---- time
    get steps() {
      return this.module._live_steps();
    }
    get known() {
      return this.module._live_known();
    }
    get now() {
      return this.module._live_now();
    }
    /** Towards a step, for so many milliseconds. Returns where it is then. */
    goTo(step, milliseconds = 30) {
      return this.module._live_go_to(step, milliseconds);
    }
    played(lane) {
      return this.module._live_played(lane);
    }
    mishap(lane) {
      return this.text(this.module._live_mishap(lane));
    }

    // ---- numbers
    series(lane, which) {
      return this.numbers(this.module._live_series(lane, which), this.played(lane));
    }
    reference(lane, which) {
      return this.numbers(this.module._live_reference(lane, which), this.steps);
    }
    number(lane, which) {
      return JSON.parse(this.text(this.module._live_number(lane, which)));
    }
    column(lane, step) {
      const count = this.module._live_column(lane, step),
        first = this.module._live_cells() >> 2;
      return this.module.HEAP32.slice(first, first + count);
    }
    hash(lane) {
      return this.text(this.module._live_hash(lane));
    }
    /** { position, velocity } of a body. */
    body(lane, index) {
      const six = this.numbers(this.module._live_body(lane, index), 6);
      return { position: [...six.slice(0, 3)], velocity: [...six.slice(3)] };
    }
    bodies(lane) {
      return this.module._live_bodies(lane);
    }
    shift() {
      return [...this.numbers(this.module._live_shift(), 3)];
    }
    /** Where the bodies that move begin: centre and radius of a ball around them, m. */
    reach() {
      const four = this.numbers(this.module._live_reach(), 4);
      return { centre: [...four.slice(0, 3)], radius: four[3] };
    }

    // ---- a problem, iteration by iteration
    /** Begins one of the description's; `problem` says what it is. */
    hold(which) {
      const wrong = this.text(this.module._live_hold(which));
      if (wrong) throw new Error(wrong);
      this.problem = JSON.parse(this.text(this.module._live_problem()));
    }
    /** Of each number that is stored the row, the column, and itself, 1/kg. */
    get matrix() {
      return this.numbers(this.module._live_matrix(), 3 * this.module._live_stored());
    }
    get iteration() {
      return this.module._live_iteration();
    }
    /** Towards an iteration, for so many milliseconds. Returns where it is then. */
    iterate(target, milliseconds = 15) {
      return this.module._live_iterate(target, milliseconds);
    }
    /** After 0, 1, 2 ... iterations, as far as they are known. */
    residuals(method) {
      return this.numbers(this.module._live_residuals(method), this.module._live_iterated(method));
    }
    /** N s, a row each, as they are now. */
    impulses(method) {
      return this.numbers(this.module._live_impulses(method), this.problem.rows);
    }

    /** One of the description's steps, row by row: its states. drawRows draws one of them. */
    rows(step) {
      return JSON.parse(this.text(this.module._live_rows(step)));
    }
    drawRows(state, width, height) {
      this.module._live_draw_rows(state, width, height);
    }

    // ---- picture and hand
    open(selector) {
      return this.told(selector, (text) => this.module._live_open(text));
    }
    look(camera) {
      this.module.HEAPF64.set([...camera.eye, ...camera.target, camera.fieldOfView], this.module._live_camera() >> 3);
    }
    begin() {
      this.module._live_begin();
    }
    /** `shown`: 1 points, 2 impulses, 4 marks, 8 coarsely; 16, 32, 48: what is lit. */
    draw(lane, shown, x, y, width, height) {
      return this.text(this.module._live_draw(lane, shown, x, y, width, height));
    }
    legend() {
      return JSON.parse(this.text(this.module._live_legend()));
    }
    grab(lane, aspect, x, y) {
      return this.module._live_grab(lane, aspect, x, y) === 1;
    }
    pull(aspect, x, y) {
      this.module._live_pull(aspect, x, y);
    }
    /** m, along a guess's axis, at which its body is under a point of the picture. */
    way({ axis }, aspect, x, y) {
      return this.module._live_way(...axis, aspect, x, y);
    }
    /** Outlines of a guess's body there, m; NaN: none. */
    outline({ axis }, guess, truth) {
      this.module._live_guess(...axis, guess, truth);
    }
    letGo() {
      this.module._live_let_go();
    }

    // ---- across the border
    text(pointer) {
      return this.module.UTF8ToString(pointer);
    }
    told(text, call) {
      const { module } = this;
      const stack = module.stackSave(),
        size = module.lengthBytesUTF8(text) + 1;
      const at = module.stackAlloc(size);
      module.stringToUTF8(text, at, size);
      try {
        return this.text(call(at));
      } finally {
        module.stackRestore(stack);
      }
    }
    numbers(pointer, count) {
      return this.module.HEAPF64.slice(pointer >> 3, (pointer >> 3) + count);
    }
  };
})();
