// Brings the parts together.

const byId = (id) => document.getElementById(id);

function start() {
  const replay = JSON.parse(byId("data").textContent);
  const { words, ghost, times } = replay;
  const shown = { contacts: true, ghost: true };
  const player = new Player(times, () => request());
  const scene = new Scene(byId("scene"), replay);
  const camera = new Camera(byId("scene"), replay.stage, () => request());
  let theme = themed();
  let asked = false;

  function request() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
  }

  function draw() {
    asked = false;
    scene.draw(player.at, camera, shown, theme);
    plots.forEach((plot) => plot.draw(player.at));
    byId("scrub").value = Math.round(player.at);
    byId("time").textContent = `${player.time.toFixed(3)} / ${times[player.end].toFixed(2)} s`;
    byId("play").textContent = player.playing ? "❚❚" : "►";
    byId("verdict").innerHTML = verdict(replay, player);
  }

  byId("title").textContent = title(words.example);
  byId("subtitle").textContent = subtitle(replay);
  byId("footer").innerHTML = `Steps of 1/${replay.rate} s in ${replay.sub_steps} sub-steps. Energy and momentum are computed from the trace, per unit of mass in the scene. Made by <code></code>`;
  byId("footer").querySelector("code").textContent = words.command;
  legend(replay, shown, request);
  const plots = curves(replay).map((curve) => new Plot(byId("plots"), curve, times, (at) => { player.pause(); player.seek(Math.round(at)); }));
  byId("scrub").max = player.end;
  byId("scrub").addEventListener("input", (event) => { player.pause(); player.seek(Number(event.target.value)); });
  byId("play").addEventListener("click", () => player.toggle());
  byId("back").addEventListener("click", () => player.step(-1));
  byId("forth").addEventListener("click", () => player.step(1));
  byId("speed").addEventListener("change", (event) => { player.speed = Number(event.target.value); });
  byId("theme").addEventListener("click", () => { theme = themed(true); ticks(replay); request(); });
  document.addEventListener("keydown", (event) => {
    if (/INPUT|SELECT|BUTTON/.test(event.target.tagName)) return;
    const act = { " ": () => player.toggle(), ArrowLeft: () => player.step(-1), ArrowRight: () => player.step(1) }[event.key];
    if (act) { event.preventDefault(); act(); }
  });
  new ResizeObserver(() => { ticks(replay); request(); }).observe(document.body);
  // For those who drive the page from outside.
  window.carom = { replay, player, camera, scene, draw };
  draw();
  document.documentElement.dataset.ready = "true";
  if (!/[?#&]still/.test(location.href)) player.play();
}

const title = (name) => { const words = name.replace(/_/g, " "); return words[0].toUpperCase() + words.slice(1); };
const typed = (scalar) => (/^i\d+f\d+$/.test(scalar) ? scalar.toUpperCase() : scalar);

function subtitle({ scalar, words, ghost }) {
  const fixed = /^i/.test(scalar) ? "fixed point " : "";
  const beside = ghost ? `, and beside it ${ghost.scalar} on ${words.ghost_place} from the same start` : "";
  return `${fixed}${typed(scalar)} on ${words.place}${beside}`;
}

// How far the two are apart, and since when one sees it.
function verdict({ ghost, times }, player) {
  if (!ghost) return "";
  const index = Math.min(Math.floor(player.at + 1e-6), player.end);
  const apart = `${metres(ghost.distance[index])} apart`;
  if (ghost.parted === null) return `${apart}<br>they never part by more than ${metres(ghost.bound)}`;
  const when = `${ghost.parted.toFixed(2)} s`;
  return times[index] < ghost.parted
    ? `${apart}<br>one run until ${when}`
    : `${apart}<br><b>parted at ${when}</b>: each blow multiplies what rounding has left`;
}

function metres(x) {
  const [unit, name] = x >= 1 ? [1, "m"] : x >= 1e-2 ? [1e2, "cm"] : x >= 1e-3 ? [1e3, "mm"] : x >= 1e-6 ? [1e6, "µm"] : [1e9, "nm"];
  return `${(x * unit).toPrecision(x ? 3 : 1)} ${name}`;
}

function legend(replay, shown, request) {
  const row = (colour, text, key) => {
    const label = document.createElement("label");
    label.innerHTML = key ? `<input type="checkbox" checked><i></i><span></span>` : `<i></i><span></span>`;
    label.querySelector("i").style.background = colour;
    label.querySelector("span").textContent = text;
    if (key) label.querySelector("input").addEventListener("change", (event) => { shown[key] = event.target.checked; request(); });
    byId("legend").append(label);
  };
  const first = replay.actors.find((actor) => actor.free);
  row(first ? `rgb(${first.colour.map((part) => part * 255)})` : "#888", `${typed(replay.scalar)}, ${replay.words.place.replace(/^a /, "")}`);
  if (replay.ghost) row("var(--accent)", `${replay.ghost.scalar}, ${replay.words.ghost_place}`, "ghost");
  row("var(--push)", "contacts and impulses", "contacts");
}

function curves(replay) {
  const { energy, ghost } = replay;
  const list = [
    {
      title: "Energy", unit: "J",
      series: [
        { name: "total", colour: "--d", values: energy.map((e) => e.motion + e.spin + e.height) },
        { name: "height", colour: "--b", values: energy.map((e) => e.height) },
        { name: "motion", colour: "--a", values: energy.map((e) => e.motion) },
        { name: "spin", colour: "--c", values: energy.map((e) => e.spin) },
      ],
    },
    {
      title: "Momentum", unit: "kg m/s",
      series: ["x", "y", "z"].map((name, axis) => ({ name, colour: ["--a", "--c", "--b"][axis], values: energy.map((e) => e.momentum[axis]) })),
    },
  ];
  if (ghost) {
    list.push({
      title: `Distance from ${ghost.scalar}`, unit: "m", log: true, mark: ghost.parted, level: ghost.bound,
      series: [{ name: "largest", colour: "--push", values: ghost.distance }],
    });
  }
  return list;
}

// Blows as ticks behind the slider, and the moment of parting.
function ticks({ pushes, times, ghost }) {
  const canvas = byId("ticks");
  const sharp = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  [canvas.width, canvas.height] = [width * sharp, height * sharp];
  const pen = canvas.getContext("2d");
  pen.scale(sharp, sharp);
  const style = getComputedStyle(document.documentElement);
  const x = (part) => 8 + (width - 16) * part;
  const strongest = Math.max(1e-12, ...pushes.flat().filter((mark) => mark.struck).map((mark) => mark.impulse));
  pen.fillStyle = style.getPropertyValue("--push");
  pushes.forEach((marks, frame) => {
    const blow = Math.max(0, ...marks.filter((mark) => mark.struck).map((mark) => mark.impulse));
    if (blow) pen.fillRect(x(frame / (times.length - 1)), height - 1 - 9 * Math.sqrt(blow / strongest), 1.5, 9 * Math.sqrt(blow / strongest));
  });
  if (ghost && ghost.parted !== null) {
    pen.fillStyle = style.getPropertyValue("--soft");
    pen.font = "10px system-ui, sans-serif";
    const at = x(ghost.parted / times[times.length - 1]);
    pen.textAlign = at > width - 50 ? "right" : "center";
    pen.fillText("part", at, 8);
  }
}

// The colours of the page for the picture; the other theme when asked.
function themed(change = false) {
  const root = document.documentElement;
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  const now = root.dataset.theme || (dark ? "dark" : "light");
  root.dataset.theme = change ? (now === "dark" ? "light" : "dark") : now;
  const style = getComputedStyle(root);
  const rgb = (name) => style.getPropertyValue(name).trim().match(/\w\w/g).map((part) => parseInt(part, 16) / 255);
  const night = root.dataset.theme === "dark" ? 1 : 0;
  return {
    night, sky: rgb("--sky"), floor: rgb("--floor"), grid: rgb("--grid"), push: rgb("--push"), ghost: rgb("--accent"), good: rgb("--c"),
    wall: night ? [0.25, 0.29, 0.35] : [0.80, 0.82, 0.86], shadow: night ? 0.5 : 0.3,
  };
}

try {
  start();
} catch (error) {
  byId("legend").textContent = error.message;
  throw error;
}
