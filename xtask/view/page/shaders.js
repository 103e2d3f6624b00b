// What the graphics processor runs.

const SOLID_VERTEX = `#version 300 es
in vec3 point; in vec3 normal; in float paint;
uniform mat4 view; uniform vec3 position; uniform vec4 turn; uniform vec3 size;
out vec3 world; out vec3 out_normal; out float out_paint;
vec3 rotate(vec3 v) { vec3 t = 2.0 * cross(turn.yzw, v); return v + turn.x * t + cross(turn.yzw, t); }
void main() {
  world = position + rotate(point * size);
  out_normal = rotate(normal / size);
  out_paint = paint;
  gl_Position = view * vec4(world, 1.0);
}`;

const SOLID_FRAGMENT = `#version 300 es
precision highp float;
in vec3 world; in vec3 out_normal; in float out_paint;
uniform vec3 colour; uniform vec3 eye; uniform vec3 light; uniform float night; uniform float alpha; uniform float ghost; uniform float low; uniform float tall;
out vec4 result;
void main() {
  vec3 n = normalize(out_normal), v = normalize(eye - world);
  float rim = pow(1.0 - max(dot(n, v), 0.0), 2.0);
  vec3 own = out_paint < 0.5 ? colour : out_paint < 1.5 ? vec3(0.10, 0.11, 0.14) : mix(colour, vec3(1.0), 0.8);
  if (ghost > 0.5) {
    if (out_paint > 0.5 && out_paint < 1.5) own = colour * 0.45;
    result = vec4(own * (0.75 + 0.35 * rim), alpha * mix(0.55, 1.35, rim));
    result.rgb *= result.a;
    return;
  }
  vec3 base = pow(own, vec3(2.2));
  float sky = 0.5 + 0.5 * n.z;
  // What lies close to the floor sees less of the sky.
  float open = mix(0.72, 1.0, smoothstep(0.0, 1.0, (world.z - low) / tall));
  vec3 ambient = mix(vec3(0.20, 0.19, 0.19), vec3(0.46, 0.49, 0.55), sky) * open * mix(1.0, 0.72, night);
  float lit = max(dot(n, light), 0.0);
  float gleam = pow(max(dot(n, normalize(light + v)), 0.0), 70.0) * 0.30;
  vec3 shine = base * (ambient + vec3(0.92, 0.89, 0.83) * lit) + gleam + rim * 0.05;
  result = vec4(pow(shine, vec3(1.0 / 2.2)) * alpha, alpha);
}`;

const FLOOR_VERTEX = `#version 300 es
in vec3 point;
uniform mat4 view;
out vec3 world;
void main() { world = point; gl_Position = view * vec4(point, 1.0); }`;

const FLOOR_FRAGMENT = `#version 300 es
precision highp float;
in vec3 world;
uniform vec3 ground; uniform vec3 lines; uniform vec3 sky; uniform vec2 middle; uniform float grid; uniform float reach; uniform float solid;
out vec4 result;
float rule(float spacing, float width) {
  vec2 at = world.xy / spacing;
  vec2 off = abs(fract(at - 0.5) - 0.5) / max(fwidth(at), 1e-6);
  return 1.0 - clamp(min(off.x, off.y) - width, 0.0, 1.0);
}
void main() {
  float far = length(world.xy - middle) / reach;
  float fade = 1.0 - smoothstep(1.2, 4.2, far);
  vec3 colour = mix(sky, ground, solid * fade);
  colour = mix(colour, lines, fade * max(0.55 * rule(grid, 0.0), rule(5.0 * grid, 0.3)) * 0.8);
  result = vec4(colour, 1.0);
}`;

const SHADOW_VERTEX = `#version 300 es
in vec3 point;
uniform mat4 view; uniform vec3 position; uniform vec4 turn; uniform vec3 size; uniform vec3 light; uniform float low;
vec3 rotate(vec3 v) { vec3 t = 2.0 * cross(turn.yzw, v); return v + turn.x * t + cross(turn.yzw, t); }
void main() {
  vec3 world = position + rotate(point * size);
  world -= light * (world.z - low) / light.z;
  gl_Position = view * vec4(world, 1.0);
}`;

const SHADOW_FRAGMENT = `#version 300 es
precision mediump float;
uniform float alpha;
out vec4 result;
void main() { result = vec4(0.0, 0.0, 0.0, alpha); }`;
