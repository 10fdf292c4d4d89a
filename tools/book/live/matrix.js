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
  const seen = 24; // rows and columns that the lens enlarges

  /** Into four numbers of an image: the sign as a colour, the size, relative to the largest, by powers of ten as its strength. */
  function paint(data, at, value, largest) {
    const strength = 1 + Math.log10(Math.abs(value) / largest) / decades;
    if (!(strength > 0)) return false;
    data.set(value > 0 ? positive : negative, 4 * at);
    data[4 * at + 3] = Math.round(255 * (0.12 + 0.88 * Math.min(1, strength)));
    return true;
  }

  live.MatrixPicture = class {
    constructor(element) {
      this.canvas = make("canvas", { className: "pb-matrix", role: "img" });
      this.lens = make("canvas", { className: "pb-lens", "aria-hidden": "true" });
      this.read = make("p", { className: "pb-read" });

      const swatch = (text, colour) => {
        const mark = make("span", { className: "pb-mark", "aria-hidden": "true" });
        mark.style.setProperty("--pb-mark", `rgb(${colour})`);
        return make("li", {}, mark, text);
      };
      this.words = make("p", { className: "pb-matrix-words" });
      element.append(
        this.words,
        make("div", { className: "pb-matrix-frame" }, this.canvas, this.lens),
        this.read,
        make(
          "ul",
          { className: "pb-legend" },
          swatch("positive", positive),
          swatch("negative", negative),
          make("li", {
            textContent: `fainter: smaller, by powers of ten; empty: 0, or less than 1e-${decades} of the largest`,
          }),
        ),
      );
      this.canvas.addEventListener("pointermove", (event) => this.point(event));
      this.canvas.addEventListener("pointerdown", (event) => this.point(event));
    }

    /** `problem`: as the engine describes it; `numbers`: row, column and value of each that is stored. */
    begin(problem, numbers) {
      const { rows, block, blockName } = problem;
      this.problem = problem;
      this.values = new Map();
      let largest = 0,
        filled = 0;
      for (let i = 2; i < numbers.length; i += 3) largest = Math.max(largest, Math.abs(numbers[i]));
      this.image = new ImageData(rows, rows);
      for (let i = 0; i < numbers.length; i += 3) {
        const at = numbers[i] * rows + numbers[i + 1];
        this.values.set(at, numbers[i + 2]);
        if (paint(this.image.data, at, numbers[i + 2], largest)) ++filled;
      }
      this.corner = [0, 0];
      this.read.textContent = "Point at a number of the matrix to read it.";
      const blocks = rows / block;
      const size = `${rows} rows and columns, ${block} for each of ${blocks} ${blockName}s`;
      this.words.textContent = `The matrix: ${size}. ${blockName[0].toUpperCase()}${blockName.slice(1)}s that share no moving body have zeros. To the right the impulses as they are now, a column for each method.`;
      this.alt = `The matrix of ${size}; ${filled} of its ${rows * rows} numbers are not 0.`;
      this.resize();
    }

    resize() {
      if (!this.problem) return;
      const { rows, block, methods } = this.problem;
      const scale = Math.min(2, window.devicePixelRatio || 1);
      const room = Math.min(widest, this.canvas.parentElement.clientWidth || widest) * scale;
      this.column = Math.round(11 * scale);
      this.head = Math.round(head * scale);
      this.left = 1; // for the frame
      this.cell = Math.max(1, Math.floor((room - (methods.length + 0.5) * this.column) / rows));
      const width = this.left + this.cell * rows + Math.ceil((methods.length + 0.5) * this.column);
      Object.assign(this.canvas, { width, height: this.cell * rows + this.head + 1 });
      this.canvas.style.width = `${width / scale}px`;
      this.lens.hidden = this.cell * block >= 9 * scale; // its blocks can be seen as they are
      const small = document.createElement("canvas");
      Object.assign(small, { width: rows, height: rows });
      small.getContext("2d").putImageData(this.image, 0, 0);
      this.small = small;
      this.draw(this.impulses || []);
    }

    /** `impulses`: of each method, a number a row. */
    draw(impulses) {
      this.impulses = impulses;
      const { canvas, cell, column } = this,
        { rows, methods } = this.problem,
        pen = canvas.getContext("2d");
      const wide = cell * rows,
        { left, head: top } = this;
      pen.clearRect(0, 0, canvas.width, canvas.height);
      pen.imageSmoothingEnabled = false;
      pen.drawImage(this.small, left, top, wide, wide);
      this.grid(pen, cell, [0, 0], rows, left, top);
      let largest = 0;
      for (const one of impulses) for (const value of one) largest = Math.max(largest, Math.abs(value));
      pen.font = `${0.6 * this.head}px system-ui, sans-serif`;
      pen.textAlign = "center";
      impulses.forEach((one, method) => {
        const from = left + Math.round(wide + column * (method + 0.5)),
          image = new ImageData(1, rows);
        one.forEach((value, row) => paint(image.data, row, value, largest));
        const strip = document.createElement("canvas");
        Object.assign(strip, { width: 1, height: rows });
        strip.getContext("2d").putImageData(image, 0, 0);
        pen.drawImage(strip, from, top, column - 2, wide);
        pen.strokeStyle = getComputedStyle(canvas).outlineColor;
        pen.strokeRect(from - 0.5, top - 0.5, column - 1, wide + 1);
        pen.fillStyle = methods[method].colour;
        pen.fillText(methods[method].marker, from + column / 2 - 1, 0.75 * this.head);
      });
      canvas.setAttribute("aria-label", this.alt);
      this.enlarge();
    }

    /** Around the cells, outside of them, and between blocks where there is room. */
    grid(pen, cell, [row, column], count, left, top) {
      const { block } = this.problem,
        size = count * cell;
      pen.fillStyle = getComputedStyle(this.canvas).outlineColor;
      for (const at of [-1, size]) {
        pen.fillRect(left - 1, top + at, size + 2, 1);
        pen.fillRect(left + at, top - 1, 1, size + 2);
      }
      if (cell * block < 9) return;
      for (let i = 1; i < count; ++i) {
        if ((row + i) % block === 0) pen.fillRect(left, top + i * cell, size, 1);
        if ((column + i) % block === 0) pen.fillRect(left + i * cell, top, 1, size);
      }
    }

    enlarge() {
      if (this.lens.hidden) return;
      const scale = Math.min(2, window.devicePixelRatio || 1),
        cell = Math.round(7 * scale),
        count = Math.min(seen, this.problem.rows),
        size = count * cell,
        [row, column] = this.corner,
        pen = this.lens.getContext("2d");
      Object.assign(this.lens, { width: size + 2, height: size + 2 });
      this.lens.style.width = `${(size + 2) / scale}px`;
      pen.imageSmoothingEnabled = false;
      pen.drawImage(this.small, column, row, count, count, 1, 1, size, size);
      this.grid(pen, cell, this.corner, count, 1, 1);
      const on = this.canvas.getContext("2d");
      on.strokeStyle = getComputedStyle(this.canvas).color;
      on.strokeRect(
        this.left + column * this.cell - 0.5,
        this.head + row * this.cell - 0.5,
        count * this.cell + 1,
        count * this.cell + 1,
      );
    }

    point(event) {
      if (!this.problem) return;
      const box = this.canvas.getBoundingClientRect(),
        scale = this.canvas.width / box.width,
        { rows, block, blockName } = this.problem;
      const column = Math.floor(((event.clientX - box.left) * scale - this.left) / this.cell),
        row = Math.floor(((event.clientY - box.top) * scale - this.head) / this.cell);
      if (row < 0 || row >= rows || column < 0 || column >= rows) return;
      const from = (at) => block * Math.floor(Math.min(Math.max(0, rows - seen), Math.max(0, at - seen / 2)) / block);
      this.corner = [from(row), from(column)];
      const value = this.values.get(row * rows + column) || 0;
      const one = (at) => `${blockName} ${Math.floor(at / block) + 1}, row ${(at % block) + 1}`;
      this.read.textContent = `${one(row)}, by an impulse on ${one(column)}: ${Number(value.toPrecision(3))} /kg`;
      this.draw(this.impulses);
    }
  };
})();
