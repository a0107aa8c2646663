"use strict";
(() => {
  const id = name => document.getElementById(name);
  const data = JSON.parse(id("data").textContent);
  const bytes = text => {
    const letters = atob(text), all = new Uint8Array(letters.length);
    for (let k = 0; k < letters.length; ++k) all[k] = letters.charCodeAt(k);
    return all;
  };
  const decode = (text, Type) => new Type(bytes(text).buffer);
  const list = (name, Type = Uint32Array) => decode(data[name], Type);
  const volumes = list("volumes", Float64Array), centroids = list("centroids", Float64Array);
  const groups = list("groups"), records = list("records");
  const jointCells = list("joint_cells"), areas = list("joint_areas", Float64Array);
  for (const field of data.fields) {
    field.values = decode(field.values, Float64Array);
    field.steps = bytes(field.steps);
  }
  const nItems = data.cells + data.joints;
  const numbers = id("numbers"), stage = id("stage"), canvas = id("view"), drawing = id("drawing");

  // Each block has vertices of its own, since it moves away from others.
  const meshOfBlocks = () => {
    const vertices = list("vertices", Float32Array), corners = list("corners");
    const cellFaces = list("cell_faces"), sizes = list("face_sizes");
    const cutFaces = list("cut_faces"), cutTriangles = list("cut_triangles");
    const mine = new Int32Array(vertices.length / 3).fill(-1); // number of a vertex in the mesh
    const places = new Float32Array(3 * corners.length), items = new Uint32Array(corners.length);
    const triangles = new Uint32Array(3 * corners.length), edges = new Uint32Array(2 * corners.length);
    const middles = new Float32Array(3 * data.cells);
    let n = 0, nTriangles = 0, nEdges = 0, face = 0, at = 0, cut = 0, cutAt = 0;
    const addTriangle = (a, b, c) => {
      triangles[nTriangles++] = mine[a];
      triangles[nTriangles++] = mine[b];
      triangles[nTriangles++] = mine[c];
    };
    const addVertex = (v, cell) => {
      mine[v] = n;
      items[n] = cell;
      for (let d = 0; d < 3; ++d) places[3 * n + d] = vertices[3 * v + d];
      ++n;
    };
    const addFace = (loop, cell) => {
      for (const v of loop) if (mine[v] < 0) addVertex(v, cell);
      for (let k = 0, last = loop[loop.length - 1]; k < loop.length; last = loop[k++])
        if (last < loop[k]) { // the other face has it the other way
          edges[nEdges++] = mine[last];
          edges[nEdges++] = mine[loop[k]];
        }
      if (cutFaces[cut] === face) {
        ++cut;
        for (const end = cutAt + 3 * (loop.length - 2); cutAt < end; cutAt += 3)
          addTriangle(cutTriangles[cutAt], cutTriangles[cutAt + 1], cutTriangles[cutAt + 2]);
      } else
        for (let k = 1; k + 1 < loop.length; ++k) addTriangle(loop[0], loop[k], loop[k + 1]);
    };
    for (let cell = 0; cell < data.cells; ++cell) {
      const first = n, begin = at;
      for (const end = face + cellFaces[cell]; face < end; ++face) {
        addFace(corners.subarray(at, at + sizes[face]), cell);
        at += sizes[face];
      }
      for (let k = begin; k < at; ++k) mine[corners[k]] = -1;
      // The middle of the block's box.
      for (let d = 0; d < 3 && n > first; ++d) {
        let low = Infinity, high = -Infinity;
        for (let v = first; v < n; ++v) {
          low = Math.min(low, places[3 * v + d]);
          high = Math.max(high, places[3 * v + d]);
        }
        middles[3 * cell + d] = (low + high) / 2;
      }
    }
    return {places: places.slice(0, 3 * n), items: items.slice(0, n),
      triangles: triangles.slice(0, nTriangles), edges: edges.slice(0, nEdges), middles};
  };
  const meshOfJoints = () => {
    const places = list("joint_vertices", Float32Array), sizes = list("joint_sizes");
    const items = [], triangles = [], edges = [];
    sizes.forEach((n, joint) => {
      const first = items.length;
      for (let k = 0; k < n; ++k) {
        items.push(data.cells + joint);
        edges.push(first + k, first + (k + 1) % n);
        if (k > 0 && k + 1 < n) triangles.push(first, first + k, first + k + 1);
      }
    });
    return {places, items: new Uint32Array(items), triangles: new Uint32Array(triangles),
      edges: new Uint32Array(edges)};
  };
  // Blocks move away from the middle of the packing, joints halfway with theirs.
  const waysOf = middles => {
    const ways = new Float32Array(4 * nItems);
    for (let d = 0; d < 3; ++d) {
      for (let k = 0; k < data.cells; ++k) ways[4 * k + d] = middles[3 * k + d];
      for (let j = 0; j < data.joints; ++j)
        ways[4 * (data.cells + j) + d] =
          (middles[3 * jointCells[2 * j] + d] + middles[3 * jointCells[2 * j + 1] + d]) / 2;
    }
    return ways;
  };
  // Shifts and turns of blocks about their centroids; joints move with the first.
  const motionOf = () => {
    const motion = list("motion", Float32Array);
    if (motion.length === 0) return null;
    const all = {shifts: new Float32Array(4 * nItems), turns: new Float32Array(4 * nItems),
      pivots: new Float32Array(4 * nItems)};
    for (let k = 0; k < nItems; ++k) {
      const cell = k < data.cells ? k : jointCells[2 * (k - data.cells)];
      for (let d = 0; d < 3; ++d) {
        all.shifts[4 * k + d] = motion[6 * cell + d];
        all.turns[4 * k + d] = motion[6 * cell + 3 + d];
        all.pivots[4 * k + d] = (centroids[3 * cell + d] - data.centre[d]) / data.scale;
      }
    }
    return all;
  };
  const blocks = meshOfBlocks();
  let radius = 0;
  const extent = [0, 0, 0]; // half of it: the box is about the origin
  for (let k = 0; k < blocks.places.length; ++k)
    extent[k % 3] = Math.max(extent[k % 3], Math.abs(blocks.places[k]));
  radius = Math.hypot(...extent);
  let view = null;
  if (radius > 0)
    try {
      view = spaceView(canvas, {n: nItems, nBlocks: data.cells, radius,
        ways: waysOf(blocks.middles), motion: motionOf(), blocks, joints: meshOfJoints()});
    } catch (error) { console.error(error); }
  let waiting = false;
  const redraw = () => {
    if (!view || waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; view.draw(); });
  };

  // Colours: those of the style sheet, or those of a field.
  const rgb = text => text.trim().match(/[0-9a-f]{2}/gi).map(x => parseInt(x, 16));
  const colour = name => rgb(getComputedStyle(document.documentElement).getPropertyValue(name));
  const paint = () => {
    const choices = [...document.querySelectorAll("input[name=colour]")];
    const field = data.fields[choices.findIndex(c => c.checked) - 1];
    if (!view) return;
    const rgba = new Uint8Array(4 * nItems);
    const [stone, fixed, joint, missing] = ["--stone", "--fixed", "--joint", "--missing"].map(colour);
    const steps = field ? field.colours.map(rgb) : [];
    for (let k = 0; k < nItems; ++k) {
      const isJoint = k >= data.cells, isFixed = !isJoint && k >= data.cells - data.fixed;
      let shown = isJoint ? joint : isFixed ? fixed : stone;
      if (field && !isFixed && isJoint === (field.of === "joints"))
        shown = steps[field.steps[isJoint ? k - data.cells : k]] || missing;
      rgba.set([...shown, 255], 4 * k);
    }
    view.setColours(rgba);
    // Joints are between blocks, which have to let them through.
    if (field && field.of === "joints" && view.sight.blocks === "solid")
      view.sight.blocks = id("blocks").value = "clear";
    redraw();
  };

  // The numbers of a block or a joint.
  const written = x => Number.isFinite(x) ? String(Number(x.toPrecision(6))) : "";
  const choose = item => {
    numbers.textContent = "";
    for (const group of document.querySelectorAll("#drawing .chosen")) group.classList.remove("chosen");
    if (view) view.sight.chosen = item;
    redraw();
    if (!(item >= 0 && item < nItems)) return;
    const isJoint = item >= data.cells, k = isJoint ? item - data.cells : item;
    const title = document.createElement("h3"), table = document.createElement("table");
    title.textContent = (isJoint ? "Joint " : "Block ") + k;
    const row = (name, value, link) => {
      if (value === "") return;
      const line = table.insertRow();
      line.insertCell().textContent = name;
      const cell = line.insertCell();
      cell.className = "number";
      if (link === undefined) { cell.textContent = value; return; }
      const button = document.createElement("button");
      button.textContent = value;
      button.addEventListener("click", () => choose(link));
      cell.append(button);
    };
    if (isJoint) {
      row("between block", String(jointCells[2 * k]), jointCells[2 * k]);
      if (jointCells[2 * k + 1] === jointCells[2 * k]) row("and", "the ground");
      else row("and block", String(jointCells[2 * k + 1]), jointCells[2 * k + 1]);
      row("area", written(areas[k]));
    } else {
      const group = drawing.querySelector(`[data-cell="${k}"]`);
      if (group) group.classList.add("chosen");
      row("group", data.names[groups.length ? groups[k] : 0] || "");
      if (records.length) row(data.record_name, String(records[k]));
      if (k >= data.cells - data.fixed) row("fixed", "yes");
      row("volume", written(volumes[k]));
      ["x", "y", "z"].forEach((name, d) => row("centroid " + name, written(centroids[3 * k + d])));
    }
    for (const field of data.fields)
      if (isJoint === (field.of === "joints"))
        row(field.name + (field.unit && ` (${field.unit})`), written(field.values[k]));
    for (let j = 0; j < data.joints && !isJoint; ++j)
      if (jointCells[2 * j] === k || jointCells[2 * j + 1] === k)
        row(jointCells[2 * j] === jointCells[2 * j + 1] ? "joint with the ground" :
            "joint with block " + (jointCells[2 * j] + jointCells[2 * j + 1] - k),
          String(j), data.cells + j);
    numbers.append(title, table);
  };

  // "#block=3&colour=1" leads to a block and to a way to colour.
  const follow = () => {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const way = wanted.has("colour") && id("colour-" + wanted.get("colour"));
    if (way) way.checked = true;
    paint();
    for (const [name, first] of [["block", 0], ["joint", data.cells]])
      if (wanted.has(name)) choose(first + Number(wanted.get(name)));
  };
  if (drawing.tagName !== "svg") stage.classList.add("without-drawing");
  drawing.addEventListener("click", event => {
    const group = event.target.closest("[data-cell]");
    choose(group ? Number(group.dataset.cell) : -1);
  });
  addEventListener("hashchange", follow);
  for (const choice of document.querySelectorAll("input[name=colour]"))
    choice.addEventListener("change", paint);
  if (!view) { follow(); return; }
  document.body.classList.add("in-space");
  canvas.addEventListener("webglcontextlost", () => document.body.classList.remove("in-space"));
  spaceControls({canvas, view, extent, redraw, choose, data, id});
  follow();
})();
