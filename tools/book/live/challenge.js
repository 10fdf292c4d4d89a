"use strict";
// A challenge: numbers that a scene has to reach at its end, parameters that may be set for it, and a score.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});

  /** "< 1e-6 m/s" as { value: 1e-6, unit: "m/s" }; null of what is no number. */
  const measured = (text) => {
    const [, value, unit] = /^(?:< )?(-?\d[\d.]*(?:e[+-]?\d+)?)\s*(.*)$/.exec(text) ?? [];
    return value === undefined ? null : { value: Number(value), unit };
  };
  const holds = {
    "=": (is, value, within) => Math.abs(is - value) <= within * (1 + 1e-9),
    "<=": (is, value) => is <= value,
    ">=": (is, value) => is >= value,
  };
  const rounded = (value) => Number(value.toPrecision(4)).toString();

  live.Challenge = class {
    /** `asked`: what tools/book/marks.js has read of a page. */
    constructor(asked, engine) {
      Object.assign(this, asked, { engine });
    }

    /** The scene, the variant and what is fixed, as the challenge begins, and `own` of what may be set. Returns what is wrong. */
    begin(own = new Map()) {
      const set = new Map([...this.fixed, ...[...own].filter(([flag]) => this.free.includes(flag))]);
      const problem = this.engine.set([...set].map(([flag, value]) => `${flag}=${value}`).join(";"));
      if (!problem) this.engine.choose(this.scene, [this.place]);
      return problem;
    }

    /** Of a parameter that is one number; sweeps are the variant's own where nobody has set them. */
    valueOf(flag) {
      const { engine } = this;
      const [set] = engine.values[flag];
      if (flag === "--sweeps" && !set) return engine.lanes[0].sweeps;
      return set ?? engine.parameters.find((one) => one.flag === flag).default[0];
    }

    /** Once the scene has been played: { asks: [{ words, is, met }], met, score, words }. */
    verdict() {
      const { engine } = this;
      const numbers = engine.scene.numbers.map((_, which) => engine.number(0, which)[0]);
      const mishap = engine.mishap(0);
      const asks = this.asks.map(({ which, relation, value, within, unit }) => {
        const is = measured(numbers[which]);
        const met = !mishap && is !== null && is.unit === unit && holds[relation](is.value, value, within);
        return { words: engine.scene.numbers[which].name, is: numbers[which], met };
      });
      const score = this.scored(numbers);
      return { asks, met: score !== null && asks.every(({ met }) => met), score };
    }
    scored(numbers) {
      const { flag, perSecond, which, less } = this.score;
      if (flag || perSecond) return (flag ? this.valueOf(flag) : 1) / (perSecond ? this.valueOf("--dt") : 1);
      const is = measured(numbers[which]);
      return is && (less === undefined ? is.value : Math.abs(is.value - less));
    }
    /** Whether the first score is the better one, by more than rounding. */
    better(one, other) {
      return (this.most ? one - other : other - one) > 1e-6 * Math.abs(other);
    }
  };

  /** What stands above the picture while a challenge is on. `player` plays it. */
  live.ChallengePanel = class {
    constructor(element, player, challenge) {
      Object.assign(this, { element, player, challenge });
      this.list = live.make("ul", {});
      this.said = live.make("p", { role: "status" });
      element.replaceChildren(
        live.make("p", {}, live.make("b", { textContent: challenge.title }), ` ${challenge.rule}`),
        this.list,
        this.said,
        live.small("play it to its end", () => player.playToEnd()),
        " ",
        live.small("copy its link: it is your score", () => player.copyLink()),
        " ",
        live.small("leave the challenge", () => player.leaveChallenge()),
      );
    }
    /** At a step; `pulled`: somebody has pulled a body. */
    update(now, pulled) {
      const { challenge } = this,
        { steps } = challenge.engine;
      const played = now >= steps && challenge.engine.known >= steps && !pulled;
      const key = `${played} ${now}`;
      if (key === this.key && !played) return;
      this.key = key;
      const { asks, met, score } = played ? challenge.verdict() : { asks: challenge.asks.map(() => null) };
      this.list.replaceChildren(
        ...challenge.asks.map(({ words }, i) =>
          live.make("li", { textContent: asks[i] ? `${words}: ${asks[i].is} ${asks[i].met ? "✓" : "✗"}` : words }),
        ),
      );
      const { unit, ours } = challenge;
      const words = !played
        ? pulled
          ? "A body was pulled: from the start again, it counts."
          : "Played to its end, it has a score."
        : met
          ? `Your score: ${rounded(score)} ${unit}. Ours: ${rounded(ours)}.${challenge.better(score, ours) ? " Yours is the better one." : ""}`
          : "Not reached: no score.";
      if (this.said.textContent !== words) this.said.textContent = words;
    }
  };
})();
