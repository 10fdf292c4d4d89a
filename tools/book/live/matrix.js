"use strict";
// The matrix of a problem as a picture, a cell a number, and beside it the impulses of each method as they are now, a column each.
(function () {
  const live = (self.PushbackLive = self.PushbackLive || {});
  const { make } = live;
  const decades = 4; // from the faintest colour to the strongest
  const positive = [0, 114, 178], // blue and vermilion of Okabe and Ito, which the colour-blind can tell apart
    negative = [213, 94, 0];
  const widest = 560; // CSS pixels
  const head = 18; // over the columns, for their markers

  /** Into four numbers of an image: the sign as a colour, the size, relative to the largest, by powers of ten as its strength. */
  function paint(data, at, value, largest) {
    const strength = 1 + Math.log10(Math.abs(value) / largest) / decades;
    if (!(strength > 0)) return;
    data.set(value > 0 ? positive : negative, 4 * at);
    data[4 * at + 3] = Math.round(255 * (0.12 + 0.88 * Math.min(1, strength)));
  }

  /** An image as a canvas, which can be drawn in any size. */
  function canvasOf(image) {
    const canvas = make("canvas", { width: image.width, height: image.height });
    canvas.getContext("2d").putImageData(image, 0, 0);
    return canvas;
  }

  live.MatrixPicture = class {
    constructor(element) {
      this.canvas = make("canvas", { className: "pb-matrix", role: "img" });
      this.words = make("p", { className: "pb-caption" });
      const fainter = `fainter: smaller, by powers of ten; empty: 0, or less than 1e-${decades} of the largest`;
      element.append(
        this.words,
        this.canvas,
        make(
          "ul",
          { className: "pb-legend" },
          make("li", {}, ...live.swatch("body", `rgb(${positive})`, "positive")),
          make("li", {}, ...live.swatch("body", `rgb(${negative})`, "negative")),
          make("li", { textContent: fainter }),
        ),
      );
    }

    /** `problem`: as the engine describes it; `numbers`: row, column and value of each that is stored. */
    begin(problem, numbers) {
      const { rows, block, blockName } = problem;
      this.problem = problem;
      this.impulses = [];
      let largest = 0;
      for (let i = 2; i < numbers.length; i += 3) largest = Math.max(largest, Math.abs(numbers[i]));
      const image = new ImageData(rows, rows);
      for (let i = 0; i < numbers.length; i += 3)
        paint(image.data, numbers[i] * rows + numbers[i + 1], numbers[i + 2], largest);
      this.image = canvasOf(image);
      const size = `${rows} rows and columns, ${block} for each of ${rows / block} ${blockName}s`;
      this.words.textContent = `The matrix: ${size}. ${blockName[0].toUpperCase()}${blockName.slice(1)}s that share no moving body have zeros. To the right the impulses as they are now, a column for each method.`;
      this.canvas.setAttribute("aria-label", `The matrix of ${size}; ${numbers.length / 3} numbers are stored.`);
      this.resize();
    }

    resize() {
      if (!this.problem) return;
      const { rows, methods } = this.problem;
      this.scale = Math.min(2, window.devicePixelRatio || 1);
      const room = Math.min(widest, this.canvas.parentElement.clientWidth || widest) * this.scale;
      this.column = Math.round(11 * this.scale);
      this.cell = Math.max(1, Math.floor((room - (methods.length + 0.5) * this.column) / rows));
      const width = this.cell * rows + Math.ceil((methods.length + 0.5) * this.column) + 2;
      Object.assign(this.canvas, { width, height: this.cell * rows + head * this.scale + 2 });
      this.canvas.style.width = `${width / this.scale}px`;
      this.draw(this.impulses);
    }

    /** `impulses`: of each method, a number a row. */
    draw(impulses) {
      this.impulses = impulses;
      const { canvas, cell, column, scale } = this,
        { rows, block, methods } = this.problem,
        pen = canvas.getContext("2d"),
        wide = cell * rows,
        top = head * scale;
      pen.clearRect(0, 0, canvas.width, canvas.height);
      pen.imageSmoothingEnabled = false;
      pen.drawImage(this.image, 1, top, wide, wide);
      pen.strokeStyle = getComputedStyle(canvas).outlineColor;
      pen.strokeRect(0.5, top - 0.5, wide + 1, wide + 1);
      if (cell * block >= 9)
        // there is room for lines between blocks
        for (let at = block; at < rows; at += block) {
          pen.strokeRect(1 + at * cell, top, 0, wide);
          pen.strokeRect(1, top + at * cell, wide, 0);
        }
      const largest = Math.max(...impulses.flatMap((one) => [...one].map(Math.abs)));
      pen.font = `${0.6 * top}px system-ui, sans-serif`;
      pen.textAlign = "center";
      impulses.forEach((one, method) => {
        const from = Math.round(wide + column * (method + 0.5)),
          image = new ImageData(1, rows);
        one.forEach((value, row) => paint(image.data, row, value, largest));
        pen.drawImage(canvasOf(image), from, top, column - 2, wide);
        pen.strokeRect(from - 0.5, top - 0.5, column - 1, wide + 1);
        pen.fillStyle = methods[method].colour;
        pen.fillText(methods[method].marker, from + column / 2 - 1, 0.75 * top);
      });
    }
  };
})();
