"use strict";
// What is seen now as a PNG: the question, the picture, the parameters and the numbers.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const shorter = (x) => Number(x.toPrecision(4)).toString();

  function lines(pen, text, width) {
    const all = [];
    for (const word of text.split(" ")) {
      const longer = all.length ? `${all[all.length - 1]} ${word}` : word;
      if (all.length && pen.measureText(longer).width <= width) all[all.length - 1] = longer;
      else all.push(word);
    }
    return all;
  }

  /** "β = 0, 0.2, d₀ = 0.06 m, h = 0.01667 s": all that changes something in this scene. */
  live.parametersInWords = function (player) {
    return player.controls.acting
      .map((parameter) => {
        const { flag, symbol, unit } = parameter,
          what = player.controls.inWords(parameter.what);
        const values = player.controls.own.get(flag) || player.controls.usual(parameter);
        if (values.length > 8) return "";
        return `${symbol || what} = ${values.map(shorter).join(", ")}${unit ? ` ${unit}` : ""}`;
      })
      .filter(Boolean)
      .join("  ·  ");
  };

  /** A canvas. */
  live.pictureOf = function (player) {
    const { engine, stage } = player;
    stage.coarse = false;
    stage.draw();
    const canvas = document.createElement("canvas"),
      pen = canvas.getContext("2d");
    const k = stage.canvas.width / stage.size.width,
      margin = 20 * k,
      wide = stage.canvas.width + 2 * margin;
    const font = (size, weight = "") => `${weight} ${size * k}px "DejaVu Sans", system-ui, sans-serif`;
    const inner = wide - 2 * margin;
    const parts = []; // { height, draw(y) }
    const text = (words, size, colour = "#1c202a", weight = "") => {
      pen.font = font(size, weight);
      for (const line of lines(pen, words, inner)) {
        parts.push({
          height: 1.45 * size * k,
          draw: (y) => {
            pen.font = font(size, weight);
            pen.fillStyle = colour;
            pen.fillText(line, margin, y + 1.1 * size * k);
          },
        });
      }
    };
    const gap = (size) => parts.push({ height: size * k, draw() {} });
    text(engine.description.question, 20, "#1c202a", "bold");
    text(`${engine.scene.name}, t = ${(engine.now * engine.dt).toFixed(3)} s`, 14);
    gap(8);
    const named = ({ marker, name }) => `${marker} ${name}`;
    if (stage.tabbed) text(named(engine.lanes[stage.tab]), 13, engine.lanes[stage.tab].colour, "bold");
    parts.push({
      height: stage.canvas.height,
      draw: (y) => {
        if (stage.problem) return;
        pen.drawImage(stage.canvas, margin, y);
        if (stage.tabbed) return;
        pen.font = font(13, "bold");
        stage.panes.forEach((pane) => {
          const lane = engine.lanes[pane.lane];
          const right = stage.wiping && pane.lane === 1,
            label = named(lane);
          const width = pen.measureText(label).width + 12 * k;
          const x = margin + k * pane.left + (right ? k * pane.width - width : 0),
            top = y + k * (pane.top - live.Stage.head);
          pen.fillStyle = "#ffffff";
          pen.fillRect(x, top, right ? width : k * pane.width, k * live.Stage.head);
          pen.fillStyle = lane.colour;
          pen.fillText(label, x, top + 18 * k);
        });
      },
    });
    gap(10);
    text(live.parametersInWords(player), 12, "#1c202a");
    gap(6);
    engine.scene.numbers.forEach(({ name }, which) => {
      const values = engine.lanes.map(({ lane, name: variant, marker }) => {
        const [is, should] = engine.number(lane, which);
        return `${marker} ${variant} ${is}${should ? ` (should be ${should})` : ""}`;
      });
      text(`${name}:  ${values.join("   ")}`, 12, "#41454f");
    });
    gap(6);
    text(`Pushback, ${engine.description.name}`, 11, "#6a6f7a");
    canvas.width = wide;
    canvas.height = Math.ceil(parts.reduce((sum, { height }) => sum + height, 2 * margin));
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    let y = margin;
    for (const part of parts) {
      part.draw(y);
      y += part.height;
    }
    return canvas;
  };

  live.savePicture = function (player) {
    live.pictureOf(player).toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = `${player.engine.description.name}_${player.engine.scene.key}.png`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    }, "image/png");
  };
})();
