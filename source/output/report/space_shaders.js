"use strict";
// The program by which faces and lines are drawn, and the places of its uniforms.
// Each vertex has a place and the number of its item; textures of a width hold what
// belongs to an item: its colour, the way that it moves when all lie apart, and its motion,
// a shift and a turn about a pivot.
const spaceProgram = (gl, textureWidth) => {
  const vertexShader = `#version 300 es
    precision highp float;
    precision highp int;
    in vec3 place;
    in uint item;
    uniform mat4 camera;
    uniform float apart, lift, motion;
    uniform highp sampler2D ways, shifts, turns, pivots;
    uniform sampler2D colours;
    flat out vec4 colour;
    flat out uint number;
    out vec3 rest, moved;
    // About an axis by the angle that its length is.
    vec3 turned(vec3 arm, vec3 turn) {
      float angle = length(turn);
      if (angle < 1e-7) return arm;
      vec3 axis = turn / angle;
      return mix(dot(axis, arm) * axis, arm, cos(angle)) + sin(angle) * cross(axis, arm);
    }
    void main() {
      ivec2 texel = ivec2(item % ${textureWidth}u, item / ${textureWidth}u);
      vec3 way = apart * texelFetch(ways, texel, 0).xyz;
      colour = texelFetch(colours, texel, 0);
      number = item;
      rest = place;
      moved = place + way;
      if (motion > 0.) {
        vec3 pivot = texelFetch(pivots, texel, 0).xyz;
        moved = pivot + way + turned(place - pivot, motion * texelFetch(turns, texel, 0).xyz)
          + motion * texelFetch(shifts, texel, 0).xyz;
      }
      gl_Position = camera * vec4(moved, 1.);
      gl_Position.z -= lift * gl_Position.w;
    }`;
  // Behind the plane of a section the back of a face is the inside of a block
  // that is cut: it is painted flat and hatched, as the plane would be.
  const fragmentShader = `#version 300 es
    precision highp float;
    precision highp int;
    flat in vec4 colour;
    flat in uint number;
    in vec3 rest, moved;
    uniform vec4 plane;
    uniform vec3 light;
    uniform float opacity;
    uniform uint blocks, chosen;
    uniform bool asNumber, asLine, hatched;
    uniform vec4 lineColour;
    out vec4 shown;
    vec4 code(uint n) {
      return vec4(n & 255u, (n >> 8) & 255u, (n >> 16) & 255u, n >> 24) / 255.;
    }
    void main() {
      vec3 normal = normalize(cross(dFdx(moved), dFdy(moved)));
      if (dot(plane.xyz, rest) > plane.w) discard;
      float bright = 0.68 + 0.32 * clamp(dot(normal, light), 0., 1.);
      if (hatched && !gl_FrontFacing && number < blocks)
        bright = mod(gl_FragCoord.x + gl_FragCoord.y, 9.) < 1.3 ? 0.7 : 0.97;
      vec4 paint = asLine ? lineColour : vec4(colour.rgb * bright, opacity);
      if (number == chosen)
        paint = asLine ? vec4(.76, 0., .48, 1.)
          : vec4(mix(paint.rgb, vec3(.76, 0., .48), 0.35), max(opacity, 0.6));
      shown = asNumber ? code(number + 1u) : paint;
    }`;

  const program = gl.createProgram(), at = {};
  for (const [type, source] of [[gl.VERTEX_SHADER, vertexShader],
    [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.bindAttribLocation(program, 0, "place");
  gl.bindAttribLocation(program, 1, "item");
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(program) +
      gl.getAttachedShaders(program).map(s => gl.getShaderInfoLog(s)).join(""));
  for (let k = 0; k < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++k) {
    const {name} = gl.getActiveUniform(program, k);
    at[name] = gl.getUniformLocation(program, name);
  }
  return {program, at};
};
