// Draws a moment of the replay.

const LIGHT = direction([-0.45, -0.5, 0.95]);
const LAYERS = 10;

class Scene {
  constructor(canvas, replay) {
    const gl = canvas.getContext("webgl2", { antialias: true, stencil: true, alpha: false });
    if (!gl) throw new Error("This browser offers no WebGL 2, which the picture is drawn with.");
    Object.assign(this, { canvas, replay, gl });
    this.solid = this.program(SOLID_VERTEX, SOLID_FRAGMENT);
    this.floor = this.program(FLOOR_VERTEX, FLOOR_FRAGMENT);
    this.shadow = this.program(SHADOW_VERTEX, SHADOW_FRAGMENT);
    this.meshes = replay.meshes.map((mesh) => this.upload(mesh));
    [this.arrow, this.dot] = [this.upload(replay.arrow), this.upload(replay.dot)];
    this.ground = this.upload(floorMesh(replay.stage));
    this.walls = this.upload(wallMesh(replay.stage));
    this.strongest = Math.max(1e-12, ...replay.pushes.flat().map((mark) => mark.impulse));
  }

  program(vertex, fragment) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    ["point", "normal", "paint"].forEach((name, place) => gl.bindAttribLocation(program, place, name));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const places = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
      const { name } = gl.getActiveUniform(program, i);
      places[name] = gl.getUniformLocation(program, name);
    }
    return { program, places };
  }

  upload({ points, normals, paints, triangles }) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    [[points, 3], [normals, 3], [paints, 1]].forEach(([data, size], place) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(triangles), gl.STATIC_DRAW);
    return { array, count: triangles.length };
  }

  // Sets what is given: numbers, vectors, the matrix.
  use({ program, places }, values) {
    const gl = this.gl;
    gl.useProgram(program);
    this.set({ places }, values);
  }

  set({ places }, values) {
    const gl = this.gl;
    for (const [name, value] of Object.entries(values)) {
      const place = places[name];
      if (!place) continue;
      if (typeof value === "number") gl.uniform1f(place, value);
      else if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
      else gl[`uniform${value.length}fv`](place, value);
    }
  }

  put(mesh, program, { position, turn }, size = [1, 1, 1]) {
    this.set(program, { position, turn, size });
    this.gl.bindVertexArray(mesh.array);
    this.gl.drawElements(this.gl.TRIANGLES, mesh.count, this.gl.UNSIGNED_SHORT, 0);
  }

  // `at` is a frame, or between two.
  draw(at, camera, shown, theme) {
    const { gl, canvas, replay } = this;
    const sharp = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth * sharp | 0, canvas.clientHeight * sharp | 0];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(...theme.sky, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    const [view, eye, stage] = [camera.matrix(width / height), camera.eye(), replay.stage];
    const common = { view, eye, light: LIGHT, night: theme.night, low: stage.floor, tall: 0.25 * stage.reach, ghost: 0 };
    const visible = replay.actors.filter((actor) => !actor.sensor).map((actor) => [actor, poseAt(actor.poses, at)]);

    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    this.use(this.floor, { view, ground: theme.floor, lines: theme.grid, sky: theme.sky, middle: stage.middle.slice(0, 2), grid: stage.grid, reach: stage.reach, solid: stage.solid ? 1 : 0.45 });
    this.gl.bindVertexArray(this.ground.array);
    gl.drawElements(gl.TRIANGLES, this.ground.count, gl.UNSIGNED_SHORT, 0);
    this.drawShadows(visible, view, stage, theme);

    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    this.use(this.solid, { ...common, alpha: 1, colour: theme.wall });
    this.put(this.walls, this.solid, { position: [0, 0, 0], turn: [1, 0, 0, 0] });
    for (const [actor, pose] of visible) {
      this.set(this.solid, { colour: actor.colour });
      this.put(this.meshes[actor.mesh], this.solid, pose);
    }

    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    for (const actor of replay.actors.filter((actor) => actor.sensor)) {
      this.set(this.solid, { colour: theme.good, alpha: 0.35, ghost: 1 });
      this.put(this.meshes[actor.mesh], this.solid, poseAt(actor.poses, at));
    }
    if (replay.ghost && shown.ghost) {
      // Where both are at one place the body is in front.
      gl.enable(gl.POLYGON_OFFSET_FILL);
      gl.polygonOffset(1, 4);
      this.set(this.solid, { colour: theme.ghost, alpha: 0.55, ghost: 1 });
      for (const actor of replay.actors) {
        if (actor.free && actor.ghost.length) this.put(this.meshes[actor.mesh], this.solid, poseAt(actor.ghost, at));
      }
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.depthMask(true);
    if (shown.contacts) this.drawPushes(at, theme);
    gl.disable(gl.BLEND);
  }

  // Several hard shadows of a light that is not quite a point make a soft one; each covers a pixel once.
  drawShadows(visible, view, stage, theme) {
    const gl = this.gl;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE);
    for (let layer = 0; layer < LAYERS; layer++) {
      const [angle, out] = [layer * 2.39996, 0.11 * Math.sqrt((layer + 0.5) / LAYERS)];
      const light = direction(add(LIGHT, [out * Math.cos(angle), out * Math.sin(angle), 0]));
      gl.stencilFunc(gl.NOTEQUAL, layer + 1, 255);
      this.use(this.shadow, { view, light, low: stage.floor, alpha: 1 - (1 - theme.shadow) ** (1 / LAYERS) });
      for (const [actor, pose] of visible) this.put(this.meshes[actor.mesh], this.shadow, pose);
    }
    gl.disable(gl.STENCIL_TEST);
  }

  // Blows fade within a tenth of a second. They are seen through the bodies.
  drawPushes(at, theme) {
    const { gl, replay } = this;
    const { size } = replay.stage;
    const last = Math.min(Math.floor(at + 1e-6), replay.times.length - 1);
    gl.disable(gl.DEPTH_TEST);
    for (let frame = last; frame >= 0; frame--) {
      const age = (replay.times[last] - replay.times[frame]) / 0.12;
      if (age >= 1) break;
      for (const mark of replay.pushes[frame]) {
        if (!mark.struck && frame !== last) continue;
        const fresh = mark.struck ? 1 - age : 1;
        const long = 6 * size * Math.sqrt(mark.impulse / this.strongest) * fresh;
        const middle = scaled(mark.points.reduce(add), 1 / mark.points.length);
        this.set(this.solid, { colour: theme.push, alpha: 0.9 * fresh, ghost: 0 });
        for (const point of mark.points) this.put(this.dot, this.solid, { position: point, turn: [1, 0, 0, 0] }, [0.09 * size, 0.09 * size, 0.09 * size]);
        const thick = Math.min(long, 3 * size);
        this.put(this.arrow, this.solid, { position: middle, turn: turnFromZ(mark.direction) }, [thick, thick, long]);
      }
    }
  }

  // Where a point of the world is in the picture, in parts of its width and height from the upper left.
  place(point, camera) {
    const m = camera.matrix(this.canvas.clientWidth / this.canvas.clientHeight);
    const [x, y, , w] = [0, 1, 2, 3].map((row) => m[row] * point[0] + m[4 + row] * point[1] + m[8 + row] * point[2] + m[12 + row]);
    return [0.5 + (0.5 * x) / w, 0.5 - (0.5 * y) / w];
  }
}

function floorMesh({ outline, floor }) {
  const points = outline.flatMap(([x, y]) => [x, y, floor]);
  const triangles = outline.slice(2).flatMap((_, i) => [0, i + 1, i + 2]);
  return { points, normals: outline.flatMap(() => [0, 0, 1]), paints: outline.map(() => 0), triangles };
}

function wallMesh({ outline, walled, floor, wall }) {
  const mesh = { points: [], normals: [], paints: [], triangles: [] };
  outline.forEach(([x0, y0], side) => {
    if (!walled[side]) return;
    const [x1, y1] = outline[(side + 1) % outline.length];
    const first = mesh.paints.length;
    const inwards = direction([-(y1 - y0), x1 - x0, 0]);
    for (const corner of [[x0, y0, floor], [x1, y1, floor], [x1, y1, floor + wall], [x0, y0, floor + wall]]) {
      mesh.points.push(...corner);
      mesh.normals.push(...inwards);
      mesh.paints.push(0);
    }
    mesh.triangles.push(first, first + 2, first + 1, first, first + 3, first + 2);
  });
  return mesh;
}
