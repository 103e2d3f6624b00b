// Curves over time. A click goes to the moment.

class Plot {
  constructor(parent, { title, unit, series, log = false, mark = null, level = null }, times, seek) {
    Object.assign(this, { series, unit, log, mark, level, times });
    const card = document.createElement("div");
    card.className = "plot";
    card.innerHTML = `<h2></h2><div class="keys"></div><canvas></canvas>`;
    card.querySelector("h2").textContent = `${title}${unit ? `, ${unit}` : ""}`;
    this.keys = card.querySelector(".keys");
    this.canvas = card.querySelector("canvas");
    parent.append(card);
    this.range();
    const pick = (event) => {
      if (event.type === "pointermove" && !event.buttons) return;
      const box = this.canvas.getBoundingClientRect();
      const part = (event.clientX - box.left - this.left) / (box.width - this.left - 8);
      seek(Math.min(1, Math.max(0, part)) * (times.length - 1));
    };
    for (const name of ["pointerdown", "pointermove"]) this.canvas.addEventListener(name, pick);
    this.left = 52;
  }

  range() {
    const values = this.series.flatMap(({ values }) => values).filter((x) => !this.log || x > 0);
    let [low, high] = values.length ? [Math.min(...values), Math.max(...values)] : [0, 1];
    if (this.level) high = Math.max(high, this.level);
    if (this.log) {
      [this.low, this.high] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high) + 0.05)];
      return;
    }
    if (low > 0 && low < 0.5 * high) low = 0;
    const room = (high - low || Math.abs(high) || 1) * 0.07;
    [this.low, this.high] = [low === 0 ? 0 : low - room, high + room];
  }

  lines() {
    if (this.log) {
      const every = Math.ceil((this.high - this.low) / 5);
      return Array.from({ length: this.high - this.low + 1 }, (_, i) => this.low + i).filter((x) => (x - this.low) % every === 0);
    }
    const wanted = (this.high - this.low) / 4;
    const decade = 10 ** Math.floor(Math.log10(wanted));
    const step = [1, 2, 5, 10].map((x) => x * decade).find((x) => x >= wanted);
    const first = Math.ceil(this.low / step - 1e-9);
    return Array.from({ length: Math.floor(this.high / step + 1e-9) - first + 1 }, (_, i) => (first + i) * step);
  }

  draw(at) {
    const { canvas, times } = this;
    const sharp = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!width) return;
    [canvas.width, canvas.height] = [width * sharp, height * sharp];
    const pen = canvas.getContext("2d");
    pen.scale(sharp, sharp);
    const style = getComputedStyle(document.documentElement);
    const ink = (name) => style.getPropertyValue(name).trim();
    const [left, right, top, bottom] = [this.left, width - 8, 8, height - 20];
    const end = times[times.length - 1] || 1;
    const x = (time) => left + ((right - left) * time) / end;
    const y = (value) => bottom - ((bottom - top) * (value - this.low)) / (this.high - this.low || 1);
    const height_of = (value) => y(this.log ? Math.log10(Math.max(value, 10 ** this.low)) : value);

    pen.font = "11px system-ui, sans-serif";
    pen.lineWidth = 1;
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    for (const line of this.lines()) {
      pen.strokeStyle = ink("--line");
      stroke(pen, [[left, y(line)], [right, y(line)]]);
      pen.fillStyle = ink("--soft");
      pen.fillText(this.log ? decade(line) : short(line), left - 6, y(line));
    }
    pen.textAlign = "center";
    const step = [0.1, 0.2, 0.5, 1, 2, 5, 10].find((step) => end / step <= 7) || 20;
    for (let time = 0; x(time) < right - 12; time += step) pen.fillText(`${short(time)} s`, Math.max(left + 8, x(time)), bottom + 12);
    if (this.level) {
      pen.strokeStyle = ink("--soft");
      pen.setLineDash([4, 4]);
      stroke(pen, [[left, height_of(this.level)], [right, height_of(this.level)]]);
      pen.setLineDash([]);
    }
    if (this.mark !== null) {
      pen.fillStyle = ink("--push");
      pen.globalAlpha = 0.09;
      pen.fillRect(x(this.mark), top, right - x(this.mark), bottom - top);
      pen.globalAlpha = 1;
    }
    pen.lineWidth = 1.6;
    pen.lineJoin = "round";
    for (const { colour, values, dashed } of this.series) {
      pen.strokeStyle = ink(colour);
      pen.setLineDash(dashed ? [5, 3] : []);
      stroke(pen, values.map((value, i) => [x(times[i]), height_of(value)]));
    }
    pen.setLineDash([]);
    pen.strokeStyle = ink("--ink");
    pen.lineWidth = 1;
    const now = times[Math.min(Math.floor(at + 1e-6), times.length - 1)];
    stroke(pen, [[x(now), top], [x(now), bottom]]);
    this.tell(at, ink);
  }

  tell(at, ink) {
    const index = Math.min(Math.floor(at + 1e-6), this.times.length - 1);
    this.keys.replaceChildren(...this.series.map(({ name, colour, values }) => {
      const key = document.createElement("span");
      key.innerHTML = `<b></b> `;
      key.firstChild.textContent = name;
      key.firstChild.style.color = ink(colour);
      key.append(short(values[index]));
      return key;
    }));
  }
}

function stroke(pen, points) {
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  pen.stroke();
}

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const decade = (power) => `10${power < 0 ? "⁻" : ""}${[...String(Math.abs(power))].map((digit) => SUPERSCRIPTS[digit]).join("")}`;

// Three digits, without needless noughts.
function short(x) {
  const size = Math.abs(x);
  if (size < 1e-12) return "0";
  if (size >= 1e5 || size < 1e-3) return x.toExponential(1).replace("e+", "e").replace("-", "−");
  return String(Number(x.toPrecision(3))).replace("-", "−");
}
