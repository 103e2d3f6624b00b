// A camera that goes round what happens: mouse, touch and wheel.

class Camera {
  constructor(canvas, stage, changed) {
    Object.assign(this, { canvas, stage, changed, fingers: new Map() });
    this.reset();
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => { event.preventDefault(); this.zoom(Math.exp(event.deltaY * 0.0012)); }, { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("dblclick", () => { this.reset(); changed(); });
  }

  reset() {
    const { middle, azimuth, elevation, distance } = this.stage;
    Object.assign(this, { target: [...middle], azimuth, elevation, distance });
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  move(event) {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const [x, y] = [now[0] - before[0], now[1] - before[1]];
    const spread = () => { const [a, b] = [...this.fingers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
    const two = this.fingers.size > 1;
    const apart = two ? spread() : 0;
    this.fingers.set(event.pointerId, now);
    if (two) {
      this.zoom(apart / Math.max(spread(), 1));
      this.pan(x / 2, y / 2);
    } else if (event.buttons & 2 || event.shiftKey) {
      this.pan(x, y);
    } else {
      this.azimuth -= x * 0.006;
      this.elevation = Math.min(1.55, Math.max(0.03, this.elevation + y * 0.006));
    }
    this.changed();
  }

  pan(x, y) {
    const step = this.distance / this.canvas.clientHeight;
    const [s, c] = [Math.sin(this.azimuth), Math.cos(this.azimuth)];
    this.target = add(this.target, add(scaled([-s, c, 0], -x * step), [-c * Math.sin(this.elevation) * y * step, -s * Math.sin(this.elevation) * y * step, Math.cos(this.elevation) * y * step]));
  }

  zoom(factor) {
    this.distance = Math.min(20 * this.stage.reach, Math.max(0.1 * this.stage.reach, this.distance * factor));
    this.changed();
  }

  eye() {
    const flat = Math.cos(this.elevation);
    return add(this.target, scaled([flat * Math.cos(this.azimuth), flat * Math.sin(this.azimuth), Math.sin(this.elevation)], this.distance));
  }

  matrix(aspect) {
    // A scene that is wider than the picture is seen from farther away.
    const angle = 2 * Math.atan(Math.tan(0.33) * Math.max(1, 1.7 / aspect));
    return product(perspective(angle, aspect, this.distance * 0.02, this.distance * 20), lookingAt(this.eye(), this.target));
  }
}
