// The slider for the size of the motion that is drawn, and the button that plays it; calls
// `moved` when it has moved anything, and tells where blocks are.
const pageMotion = (tables, data, moved) => {
  const tools = document.getElementById("motion-tools");
  const blocks = tables.tableOf("blocks").rows.length;
  const motion = data.motion;
  if (!motion || !blocks) { tools.remove(); return {matrixOf: () => new DOMMatrix()}; }
  const kind = tables.tableOf("motion").rows.length ? "motion" : "blocks";
  const [slider, output, button] =
    ["enlargement", "enlarged", "play"].map(id => document.getElementById(id));
  const period = 3000; // milliseconds, there and back
  let factor = motion.factor, largest = motion.factor, phase = 0, last = 0, frame = 0;

  // Block c moved: turned about its centre by the whole angle, as it is drawn.
  const matrix = (c, by) => {
    if (c < 0) return new DOMMatrix();
    const of = (table, name) => tables.value(table, c, name) || 0;
    const x = (of("blocks", "x") - data.origin[0]) / data.length;
    const y = (data.origin[1] - of("blocks", "y")) / data.length;
    const shift = by / data.length, turn = -by * of(kind, "rotation") * 180 / Math.PI;
    return new DOMMatrix().translate(x + shift * of(kind, "ux"), y - shift * of(kind, "uy"))
      .rotate(turn).translate(-x, -y);
  };
  const backwards = Array.from({length: blocks}, (_, c) => matrix(c, motion.factor).inverse());
  const fromDrawn = c => c < 0 ? new DOMMatrix() : matrix(c, factor).multiply(backwards[c]);

  // Elements are as the program has drawn them, and are moved from there.
  const items = [...document.querySelectorAll("#moved > *")].map((element, c) => ({element, cells: [c]}))
    .concat([...document.querySelectorAll("[data-cells]")].map(element =>
      ({element, cells: element.dataset.cells.split(" ").map(Number),
        ends: element.getAttribute("d").match(/-?[\d.]+/g).map(Number)})));
  const move = ({element, cells, ends}) => {
    if (cells.length === 1) {
      element.setAttribute("transform", fromDrawn(cells[0]).toString());
      return;
    }
    const [a, b] = cells.map((c, k) =>
      new DOMPoint(ends[2 * k], ends[2 * k + 1]).matrixTransform(fromDrawn(c)));
    element.setAttribute("d", `M${a.x} ${a.y}L${b.x} ${b.y}`);
  };
  const show = by => {
    factor = by;
    items.forEach(move);
    moved();
    slider.value = by;
    output.textContent = written(by) + (motion.hasSize && by === 1 ? ", as large as they are" : "");
    slider.setAttribute("aria-valuetext", "displacements times " + output.textContent);
  };

  const stop = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    button.textContent = "Play the movement";
  };
  const step = now => {
    phase = (phase + (now - last) / period) % 1;
    last = now;
    show(largest * (1 + Math.cos(2 * Math.PI * phase)) / 2);
    frame = requestAnimationFrame(step);
  };
  // It begins only here: at the wish of who has pressed the button.
  const play = () => {
    if (largest === 0) largest = motion.factor;
    last = performance.now();
    button.textContent = "Stop";
    frame = requestAnimationFrame(step);
  };
  slider.max = motion.most;
  slider.addEventListener("input", () => {
    stop();
    phase = 0;
    largest = Number(slider.value);
    show(largest);
  });
  button.addEventListener("click", () => { if (frame) stop(); else play(); });
  for (const choice of document.querySelectorAll("input[name=view]"))
    choice.addEventListener("change", stop);
  slider.value = factor;
  output.textContent = written(factor);
  return {matrixOf: c => matrix(c, factor)};
};
