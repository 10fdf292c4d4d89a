"use strict";
// One figure of a page: the experiment in the place of its picture, in time, by hand, and as an address has it.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const slice = 25; // ms: what takes long is played bit by bit

  live.Player = class {
    /** In `figure`, whose picture goes while this runs. `state`: of an address, as `state` gives it. */
    constructor(figure, engine, state) {
      Object.assign(this, { figure, engine, playing: false, target: 0 });
      this.view = new live.View(this, figure);
      this.iterations = new live.Iterations(this.view.iterations, engine, () => this.remember());
      this.toy = figure.matches(".toy") ? new live.Toy(this) : null;
      this.sandbox = engine.description.name === "sandbox" ? new live.Sandbox(this) : null;
      if (this.sandbox && !state.has("show")) state.set("show", 0);
      this.arrive(this.toy?.state ?? state);
    }

    /** What an address says, in the place of what is played; what it says wrongly is left as it is. */
    arrive(from) {
      const { engine, view } = this,
        { stage } = view,
        { sheet } = this.figure.dataset;
      this.stop();
      this.challenge = this.speed = null;
      engine.set("");
      const scenes = () => engine.description.scenes; // their variants depend on the parameters
      const usual = Math.max(
        0,
        scenes().findIndex(({ key, pictures }) => (sheet ? key === sheet : pictures)),
      ); // that of the sheet
      engine.choose(usual, [0, 1, 2, 3]);
      const own = engine.parameters
        .filter(({ flag }) => from.has(flag.slice(2)))
        .map(({ flag }) => [flag, from.get(flag.slice(2))]);
      const list = (name) => (from.has(name) ? from.get(name).split(",").map(Number).filter(Number.isFinite) : []);
      let problem = engine.set(own.map((pair) => pair.join("=")).join(";"));
      const scene = scenes().findIndex(({ key }) => key === from.get("scene"));
      const places = list("show").filter((place) => place >= 0 && place < 32);
      const refused = engine.choose(scene < 0 ? usual : scene, places.length ? places : [0, 1, 2, 3]);
      problem ||= refused;
      const first = places[0] ?? live.askedOf(engine.scene.variants);
      stage.tab = Math.max(
        0,
        engine.lanes.findIndex(({ place }) => place === first),
      );
      const challenges = JSON.parse(this.figure.dataset.challenges ?? "[]");
      const taken = challenges.find(({ key }) => key === from.get("challenge"));
      if (taken) {
        this.challenge = new live.Challenge(taken, engine);
        problem = this.challenge.begin(new Map(own));
      }
      const [turn, rise, zoom, ...pan] = list("view");
      stage.camera.reset();
      if (zoom > 0 && pan.length === 2) Object.assign(stage.camera, { turn, rise, zoom, pan });
      stage.follow = from.has("close") || (engine.scene.strobe && stage.element.clientWidth < 560);
      this.shown = from.has("see") ? Number(from.get("see")) & 7 : this.usualShown();
      if (live.speeds.includes(Number(from.get("pace")))) this.speed = Number(from.get("pace"));
      this.beginChallenge();
      this.begin();
      this.iterations.begin(Number(from.get("problem")), Number(from.get("iteration")));
      view.tell(problem);
      view.fit();
      this.seek(Math.round(Number(from.get("step"))) || 0);
      if (from.has("play") && !live.stillness()) this.play();
    }
    usualShown() {
      const { contacts, impulses } = this.engine.scene;
      return 4 | (contacts ? 1 : 0) | (impulses ? 2 : 0);
    }
    beginChallenge() {
      const { challenge, view } = this;
      view.challenging(challenge);
      this.panel = challenge && new live.ChallengePanel(view.task, this, challenge);
    }
    leaveChallenge() {
      this.challenge = null;
      this.beginChallenge();
      this.view.list();
      this.remember();
    }

    /** The scene that is chosen, from its start. */
    begin() {
      this.pulled = false;
      this.speed ??= this.usualSpeed();
      this.view.begin();
    }
    /** So that the scene takes three to six seconds; a sandbox is no film. */
    usualSpeed() {
      if (this.sandbox) return 1;
      const seconds = this.engine.steps * this.engine.dt;
      return live.speeds.filter((speed) => seconds / speed >= 3).pop() ?? live.speeds[0];
    }

    // ---- what somebody chooses
    chooseScene(scene) {
      const { engine } = this;
      const names = ({ variants }) => variants.map(({ name }) => name).join("\n");
      const same = names(engine.description.scenes[scene]) === names(engine.scene);
      engine.choose(scene, same ? engine.lanes.map(({ place }) => place) : [0, 1, 2, 3]);
      this.stop();
      this.speed = null;
      this.shown = this.usualShown();
      this.view.controls.build();
      this.begin();
      this.view.fit();
      this.seek(0);
      this.remember();
    }
    chooseVariant(place, yes) {
      const { engine, view } = this;
      let places = engine.lanes.map((lane) => lane.place).filter((one) => one !== place);
      if (yes) places = [...places.slice(-3), place];
      if (!places.length) return view.list(); // one at least has to be shown
      this.again(() => engine.choose(engine.sceneIndex, places));
      view.controls.build(); // a variant may have sweeps of its own
      this.remember();
    }
    set(assignments, done) {
      const { engine } = this,
        { name } = engine.scene,
        scene = engine.sceneIndex;
      this.again(() => {
        const before = engine.scene.variants.length,
          all = engine.lanes.length === Math.min(4, before);
        const problem = engine.set(assignments);
        if (!problem && all && engine.scene.variants.length > before) engine.choose(engine.sceneIndex, [0, 1, 2, 3]);
        if (!problem) this.iterations.changed();
        return problem;
      });
      if (engine.sceneIndex !== scene) this.view.tell(`“${name}” has no variant with these values.`);
      if (!done) return this.view.stage.hurry();
      this.view.controls.build();
      this.remember();
    }
    /** After a change the scene is played again, up to where it was. */
    again(change) {
      const step = this.playing ? this.engine.now : this.target;
      const problem = change();
      this.view.tell(problem);
      if (problem) return;
      this.begin();
      this.seek(step);
    }
    show(bit, yes) {
      this.shown = yes ? this.shown | bit : this.shown & ~bit;
      this.view.list();
      this.changed();
      this.remember();
    }

    /** Of the variants that are shown. */
    get names() {
      return this.toy?.names ?? this.engine.lanes.map(({ name }) => name);
    }

    // ---- the hand
    /** The time goes on, and farther than the scene's own where it was about to end. */
    grabbed() {
      this.held = this.pulled = true;
      this.toy?.hint.remove();
      this.target = this.engine.now;
      this.view.lengthened();
      if (!this.playing) this.play();
    }
    release() {
      if (this.held) this.engine.letGo();
      this.held = false;
    }
    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const { camera } = this.view.stage,
        { now, steps } = this.engine;
      const keys = {
        " ": () => this.toggle(),
        ".": () => this.go(now + 1),
        ",": () => this.go(now - 1),
        Home: () => this.go(0),
        End: () => this.go(steps),
        ArrowLeft: () => camera.orbit(0.1, 0),
        ArrowRight: () => camera.orbit(-0.1, 0),
        ArrowUp: () => camera.orbit(0, 0.08),
        ArrowDown: () => camera.orbit(0, -0.08),
        "+": () => camera.zoomBy(0.87),
        "-": () => camera.zoomBy(1.15),
        0: () => camera.reset(),
        c: () => this.show(1, !(this.shown & 1)),
        i: () => this.show(2, !(this.shown & 2)),
      };
      const act = keys[event.key] ?? keys[event.key.toLowerCase()];
      if (!act) return;
      event.preventDefault();
      act();
      this.changed();
      this.remember();
    }

    // ---- time
    toggle() {
      if (this.playing) this.pause();
      else this.play();
    }
    play() {
      if (this.engine.now >= this.engine.steps) this.seek(0);
      Object.assign(this, { playing: true, waits: false, before: performance.now(), owed: 0 });
      this.changed();
    }
    stop() {
      this.playing = this.waits = false;
      this.release();
    }
    pause() {
      this.stop();
      this.remember();
      this.changed();
      this.view.say();
    }
    go(step) {
      this.playing = this.waits = false;
      this.seek(step);
      this.remember();
    }
    seek(step) {
      this.target = Math.min(this.engine.steps, Math.max(0, step));
      this.engine.goTo(this.target, slice);
      this.changed();
    }
    /** At once; what was pulled is forgotten. */
    playToEnd() {
      this.stop();
      if (this.pulled) this.again(() => this.engine.set(this.view.controls.assignments));
      this.go(this.engine.steps);
    }
    /** What leaves the window waits until it is back. */
    see(inSight) {
      if (inSight && this.waits) this.play();
      else if (!inSight && this.playing && !this.held) {
        this.pause();
        this.waits = true;
      }
    }
    changed() {
      this.asked ||= requestAnimationFrame(() => this.frame());
    }
    frame() {
      this.asked = 0;
      const { engine, view } = this,
        now = performance.now();
      if (this.playing) {
        this.owed += (Math.min(100, now - this.before) / 1000) * (this.speed / engine.dt);
        this.before = now;
        const steps = Math.floor(this.owed),
          wanted = Math.min(engine.steps, engine.now + steps);
        this.target = steps > 0 ? engine.goTo(wanted, slice) : engine.now;
        this.owed = this.target < wanted ? 0 : this.owed - steps;
        if (this.target >= engine.steps) this.pause();
      } else if (engine.now !== this.target) engine.goTo(this.target, slice);
      const moving = this.playing || engine.now !== this.target;
      if (moving) view.stage.hurry();
      view.stage.draw();
      view.read(now);
      this.sandbox?.read();
      if (moving) this.changed();
    }

    // ---- the address
    bringIntoView() {
      this.view.bringIntoView();
    }
    get state() {
      const { engine, iterations } = this,
        { stage, controls } = this.view,
        { camera } = stage;
      const state = new URLSearchParams({ live: engine.description.name });
      if (this.challenge) state.set("challenge", this.challenge.key);
      state.set("scene", engine.scene.key);
      const places = engine.lanes.map(({ place }) => place).join();
      if (!"0,1,2,3".startsWith(places) || engine.lanes.length < Math.min(4, engine.scene.variants.length))
        state.set("show", places);
      for (const [flag, values] of controls.own) state.set(flag.slice(2), values.join(","));
      if (this.target) state.set("step", this.target);
      if (this.speed !== this.usualSpeed()) state.set("pace", this.speed);
      const view = [camera.turn, camera.rise, camera.zoom, ...camera.pan].map((x) => Number(x.toFixed(4)));
      if (!camera.isReset) state.set("view", view.join(","));
      if (this.shown !== this.usualShown()) state.set("see", this.shown);
      if (stage.follow) state.set("close", 1);
      if (iterations.which) state.set("problem", iterations.which);
      if (iterations.target) state.set("iteration", iterations.target);
      return state;
    }
    /** Into the address, once nothing has changed for a moment. */
    remember() {
      clearTimeout(this.remembering);
      if (this.toy) return;
      this.remembering = setTimeout(() => {
        try {
          history.replaceState(null, "", `#${this.state}`);
        } catch {
          /* some browsers refuse it for files: the link can still be copied */
        }
      }, 250);
    }
    async copyLink() {
      try {
        await navigator.clipboard.writeText(`${location.href.split("#")[0]}#${this.state}`);
        this.view.said.textContent = "The link was copied.";
      } catch {
        history.replaceState(null, "", `#${this.state}`);
        this.view.said.textContent = "The link stands in the address line.";
      }
    }
  };
})();
