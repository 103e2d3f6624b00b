// Vectors of three, quaternions w x y z, and matrices of four by four, column by column.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.sqrt(dot(a, a));
const direction = (a) => scaled(a, 1 / (length(a) || 1));

function product(a, b) {
  const m = new Float32Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      for (let k = 0; k < 4; k++) m[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    }
  }
  return m;
}

function perspective(angle, aspect, near, far) {
  const f = 1 / Math.tan(angle / 2);
  return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0];
}

function lookingAt(eye, target) {
  const z = direction(sub(eye, target));
  const x = direction(cross([0, 0, 1], z));
  const y = cross(z, x);
  return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1];
}

// The rotation that brings z to a direction.
function turnFromZ(to) {
  if (to[2] < -0.999999) return [0, 1, 0, 0];
  const q = [1 + to[2], -to[1], to[0], 0];
  const size = Math.hypot(...q);
  return q.map((part) => part / size);
}

// The pose between two frames; whole numbers give the frame itself.
function poseAt(poses, at) {
  const last = poses.length / 7 - 1;
  const first = Math.min(Math.floor(at), last);
  const second = Math.min(first + 1, last);
  const part = Math.min(at - first, 1);
  const a = poses.slice(7 * first, 7 * first + 7);
  if (part <= 0 || second === first) return { position: a.slice(0, 3), turn: a.slice(3) };
  const b = poses.slice(7 * second, 7 * second + 7);
  const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
  const mixed = a.map((x, i) => x * (1 - part) + b[i] * part * (i < 3 ? 1 : sign));
  const size = Math.hypot(...mixed.slice(3));
  return { position: mixed.slice(0, 3), turn: mixed.slice(3).map((x) => x / size) };
}
