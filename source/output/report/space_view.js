"use strict";
// The view of a packing in space, by WebGL 2. Blocks and joints are the items
// of one numbering: each has a colour and a place to which it moves away in two
// textures, so that none of their vertices changes when the reader does
// something.
const spaceView = (canvas, items) => {
  const textureWidth = 2048; // texels, which every implementation has
  const fieldOfView = Math.PI / 7; // radians, of the perspective
  const lineLift = 2e-3; // of lines before faces, in the depth from -1 to 1
  const light = [-0.45, 0.65, 0.61]; // in the frame of the view, as in the picture of the page
  const edgeColour = [0.25, 0.28, 0.31, 0.75];
  const gl = canvas.getContext("webgl2", {antialias: true, stencil: true, preserveDrawingBuffer: true});
  if (!gl) return null;

  // What the reader sees: angles and lengths of the page's units.
  const sight = {azimuth: 0, elevation: 0, target: [0, 0, 0], reach: 1.5,
    perspective: false, apart: 0, motion: 0, axis: null, cut: 0, side: 1,
    blocks: "solid", joints: true, chosen: -1};

  const {program, at} = spaceProgram(gl, textureWidth);

  // A mesh has places, items, triangles and edges.
  const buffer = (target, array, usage = gl.STATIC_DRAW) => {
    const made = gl.createBuffer();
    gl.bindBuffer(target, made);
    gl.bufferData(target, array, usage);
    return made;
  };
  const arrays = (places, numbers, indices) => {
    const made = gl.createVertexArray();
    gl.bindVertexArray(made);
    gl.bindBuffer(gl.ARRAY_BUFFER, places);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, numbers);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribIPointer(1, 1, gl.UNSIGNED_INT, 0, 0);
    if (indices) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bindVertexArray(null);
    return made;
  };
  const upload = mesh => {
    const places = buffer(gl.ARRAY_BUFFER, mesh.places);
    const numbers = buffer(gl.ARRAY_BUFFER, mesh.items);
    const list = indices => {
      gl.bindVertexArray(null);
      return {arrays: arrays(places, numbers, buffer(gl.ELEMENT_ARRAY_BUFFER, indices)),
        n: indices.length};
    };
    return {faces: list(mesh.triangles), edges: list(mesh.edges)};
  };
  const blocks = upload(items.blocks), joints = upload(items.joints);
  const outline = {places: gl.createBuffer(), numbers: gl.createBuffer(), n: 0};
  outline.arrays = arrays(outline.places, outline.numbers, null);

  const textureOf = (unit, format, layout, type, array, each) => {
    const height = Math.max(1, Math.ceil(items.n / textureWidth));
    const padded = new array.constructor(textureWidth * height * each);
    padded.set(array);
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, textureWidth, height, 0, layout, type, padded);
  };
  textureOf(0, gl.RGBA32F, gl.RGBA, gl.FLOAT, items.ways, 4);
  if (items.motion)
    ["shifts", "turns", "pivots"].forEach((name, k) =>
      textureOf(2 + k, gl.RGBA32F, gl.RGBA, gl.FLOAT, items.motion[name], 4));
  const setColours = colours => {
    gl.activeTexture(gl.TEXTURE1);
    gl.deleteTexture(gl.getParameter(gl.TEXTURE_BINDING_2D));
    textureOf(1, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, colours, 4);
  };

  // The outlines of the section: where it cuts the triangles of blocks.
  const setOutline = () => {
    const {places, items: numbers, triangles} = items.blocks, a = sight.axis;
    const points = [], owners = [];
    if (a !== null)
      for (let t = 0; t < triangles.length; t += 3) {
        const before = points.length;
        for (let k = 0; k < 3; ++k) {
          const p = 3 * triangles[t + k], q = 3 * triangles[t + (k + 1) % 3];
          const s = places[p + a] - sight.cut, e = places[q + a] - sight.cut;
          if (s < 0 === e < 0) continue;
          const share = s / (s - e);
          for (let d = 0; d < 3; ++d)
            points.push(places[p + d] + share * (places[q + d] - places[p + d]));
        }
        if (points.length - before === 6) owners.push(numbers[triangles[t]], numbers[triangles[t]]);
      }
    // Not to be cut away by the plane itself.
    for (let k = a; a !== null && k < points.length; k += 3) points[k] = sight.cut - 1e-5 * sight.side;
    gl.bindBuffer(gl.ARRAY_BUFFER, outline.places);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points), gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, outline.numbers);
    gl.bufferData(gl.ARRAY_BUFFER, new Uint32Array(owners), gl.DYNAMIC_DRAW);
    outline.n = owners.length;
  };

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const along = (s, a) => a.map(x => s * x);
  const sum = (...all) => all.reduce((a, b) => a.map((x, d) => x + b[d]));
  const frame = () => {
    const [ca, sa] = [Math.cos(sight.azimuth), Math.sin(sight.azimuth)];
    const [ce, se] = [Math.cos(sight.elevation), Math.sin(sight.elevation)];
    return {right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], towards: [ce * ca, ce * sa, se]};
  };
  // The reach is half the height that is seen at the target, in all ways half
  // the width if that is less.
  const span = () => {
    const aspect = canvas.width / Math.max(1, canvas.height);
    return {x: sight.reach * Math.max(1, aspect), y: sight.reach * Math.max(1, 1 / aspect)};
  };
  const distance = () => sight.reach / Math.tan(fieldOfView / 2);
  const camera = () => {
    const {right, up, towards} = frame(), {x, y} = span();
    const depth = items.radius * (1 + sight.apart) + sight.motion + Math.hypot(...sight.target) + 1e-3;
    const far = distance(), rows = [along(1 / x, right), along(1 / y, up)]
      .map(r => [...r, -dot(r, sight.target)]);
    const toward = [...towards, -dot(towards, sight.target)]; // nearness
    if (!sight.perspective)
      rows.push(along(-1 / depth, toward), [0, 0, 0, 1]);
    else {
      const near = Math.max(far - depth, 0.01 * far), end = far + depth;
      // w = 1 - nearness / far, and depth from -1 at near to 1 at end
      const w = sum(along(-1 / far, toward), [0, 0, 0, 1]);
      const A = (end + near) / (end - near), B = 2 * end * near / (end - near) / far;
      rows.push(sum(along(A, w), [0, 0, 0, -B]), w);
    }
    return Float32Array.from({length: 16}, (_, k) => rows[k % 4][k >> 2]);
  };

  const paint = (list, mode, values) => {
    if (list.n === 0) return;
    gl.uniform1i(at.asLine, mode === gl.LINES ? 1 : 0);
    gl.uniform1f(at.lift, values.lift || 0);
    gl.uniform1f(at.opacity, values.opacity || 1);
    gl.uniform4fv(at.lineColour, values.colour || edgeColour);
    gl.bindVertexArray(list.arrays);
    if (list === outline) gl.drawArrays(mode, 0, list.n);
    else gl.drawElements(mode, list.n, gl.UNSIGNED_INT, 0);
  };
  // Joints between solid blocks are hidden.
  const showsJoints = () => sight.joints && (sight.blocks !== "solid" || sight.apart + sight.motion > 0);
  const begin = asNumber => {
    const {right, up, towards} = frame();
    gl.useProgram(program);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.uniformMatrix4fv(at.camera, false, camera());
    gl.uniform1i(at.ways, 0);
    gl.uniform1i(at.colours, 1);
    gl.uniform1f(at.apart, sight.apart);
    gl.uniform1f(at.motion, items.motion ? sight.motion : 0);
    ["shifts", "turns", "pivots"].forEach((name, k) => gl.uniform1i(at[name], items.motion ? 2 + k : 0));
    gl.uniform1ui(at.blocks, items.nBlocks);
    gl.uniform1ui(at.chosen, sight.chosen < 0 || asNumber ? 0xffffffff : sight.chosen);
    gl.uniform1i(at.asNumber, asNumber ? 1 : 0);
    gl.uniform3fv(at.light, sum(along(light[0], right), along(light[1], up), along(light[2], towards)));
    const plane = [0, 0, 0, 1]; // cuts nothing away
    if (sight.axis !== null) {
      plane[sight.axis] = sight.side;
      plane[3] = sight.side * sight.cut;
    }
    gl.uniform4fv(at.plane, plane);
    gl.uniform1i(at.hatched, sight.axis !== null && sight.blocks === "solid" ? 1 : 0);
  };

  const draw = () => {
    const ratio = window.devicePixelRatio || 1;
    const size = [canvas.clientWidth, canvas.clientHeight].map(s => Math.max(1, Math.round(s * ratio)));
    if (canvas.width !== size[0]) canvas.width = size[0];
    if (canvas.height !== size[1]) canvas.height = size[1];
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, ...size);
    gl.clearColor(1, 1, 1, 1);
    gl.depthMask(true);
    gl.disable(gl.SCISSOR_TEST);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    begin(false);
    if (sight.blocks === "solid") {
      // Where the inside of a block is seen, what lies behind it is not; nor is
      // the front of another block that touches it there.
      gl.enable(gl.CULL_FACE);
      gl.enable(gl.STENCIL_TEST);
      gl.enable(gl.POLYGON_OFFSET_FILL);
      gl.polygonOffset(1, 4);
      gl.stencilFunc(gl.ALWAYS, 1, 1);
      for (const [culled, operation] of [[gl.BACK, gl.ZERO], [gl.FRONT, gl.REPLACE]]) {
        gl.cullFace(culled);
        gl.stencilOp(gl.KEEP, gl.KEEP, operation);
        if (culled === gl.BACK || sight.axis !== null) paint(blocks.faces, gl.TRIANGLES, {});
        gl.disable(gl.POLYGON_OFFSET_FILL);
      }
      gl.disable(gl.CULL_FACE);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
      gl.stencilFunc(gl.EQUAL, 0, 1);
    }
    if (showsJoints()) {
      paint(joints.faces, gl.TRIANGLES, {lift: lineLift / 2});
      paint(joints.edges, gl.LINES, {lift: lineLift});
    }
    const faint = sight.blocks === "solid" ? edgeColour : [...edgeColour.slice(0, 3), 0.35];
    paint(blocks.edges, gl.LINES, {lift: lineLift, colour: faint});
    gl.disable(gl.STENCIL_TEST);
    paint(outline, gl.LINES, {lift: lineLift, colour: [0.1, 0.11, 0.13, 1]});
    if (sight.blocks === "clear") {
      gl.depthMask(false);
      paint(blocks.faces, gl.TRIANGLES, {opacity: 0.16});
      gl.depthMask(true);
    }
  };

  // The number of the item at a place of the canvas, or -1.
  const target = {frame: gl.createFramebuffer(), colour: gl.createRenderbuffer(),
    depth: gl.createRenderbuffer()};
  const pick = (x, y) => {
    const {width, height} = canvas;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
    for (const [store, format, point] of [[target.colour, gl.RGBA8, gl.COLOR_ATTACHMENT0],
      [target.depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
      gl.bindRenderbuffer(gl.RENDERBUFFER, store);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, point, gl.RENDERBUFFER, store);
    }
    const at = [Math.floor(x * width / canvas.clientWidth),
      height - 1 - Math.floor(y * height / canvas.clientHeight)];
    gl.viewport(0, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(...at, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.disable(gl.BLEND);
    begin(true);
    if (sight.blocks !== "edges") paint(blocks.faces, gl.TRIANGLES, {});
    // Joints show through blocks that are clear.
    if (sight.blocks !== "solid") gl.clear(gl.DEPTH_BUFFER_BIT);
    if (showsJoints()) paint(joints.faces, gl.TRIANGLES, {lift: lineLift / 2});
    const code = new Uint8Array(4);
    gl.readPixels(...at, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, code);
    gl.disable(gl.SCISSOR_TEST);
    return new DataView(code.buffer).getUint32(0, true) - 1;
  };

  return {sight, frame, span, draw, pick, setColours, setOutline};
};
