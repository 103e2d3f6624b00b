// Time: plays, pauses, goes to a frame. It stays a moment on the last one, then begins anew.

class Player {
  constructor(times, changed) {
    Object.assign(this, { times, changed, at: 0, playing: false, speed: 1, before: null, rest: 0 });
  }

  get end() { return this.times.length - 1; }
  get time() { return this.times[Math.min(Math.floor(this.at + 1e-6), this.end)]; }

  seek(at) {
    this.at = Math.min(this.end, Math.max(0, at));
    this.rest = 0;
    this.changed();
  }

  step(count) {
    this.pause();
    this.seek(Math.round(this.at) + count);
  }

  toggle() { this.playing ? this.pause() : this.play(); }

  play() {
    if (this.playing) return;
    if (this.at >= this.end) this.at = 0;
    [this.playing, this.before] = [true, null];
    requestAnimationFrame((now) => this.tick(now));
    this.changed();
  }

  pause() {
    this.playing = false;
    this.changed();
  }

  tick(now) {
    if (!this.playing) return;
    const passed = this.before === null ? 0 : Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    const frames = this.end / (this.times[this.end] || 1);
    if (this.at >= this.end) {
      this.rest += passed;
      if (this.rest > 1.2) [this.at, this.rest] = [0, 0];
    } else {
      this.at = Math.min(this.end, this.at + passed * this.speed * frames);
    }
    this.changed();
    requestAnimationFrame((then) => this.tick(then));
  }
}
