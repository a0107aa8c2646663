"use strict";
// What of the drawing is seen, moved by wheel, fingers and double click, and its scale bar.
const pageZoom = (svg, data) => {
  const whole = svg.getAttribute("viewBox").split(" ").map(Number);
  const fingers = new Map();
  let box = whole.slice(), dragged = false;

  // Units of the picture in a pixel.
  const scale = () => Math.max(box[2] / svg.clientWidth, box[3] / svg.clientHeight);
  const roundBelow = x => {
    const power = 10 ** Math.floor(Math.log10(x));
    return power * (x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1);
  };
  const bar = document.getElementById("scale");
  const measure = () => {
    const unit = scale();
    if (!bar || !Number.isFinite(unit)) return;
    const length = roundBelow(120 * unit * data.length), end = length / data.length;
    const [x, y] = [box[0] + 12 * unit, box[1] + box[3] - 12 * unit];
    const [line, words] = bar.children;
    line.setAttribute("d", `M${x} ${y - 4 * unit}v${4 * unit}h${end}v${-4 * unit}`);
    words.textContent = `${Number(length.toPrecision(1))} ${data.units.length}`.trim();
    for (const [name, value] of [["x", x + end], ["y", y], ["dx", 5 * unit], ["dy", 0],
      ["font-size", 13 * unit]])
      words.setAttribute(name, value);
  };
  const show = () => {
    svg.setAttribute("viewBox", box.join(" "));
    measure();
  };
  const zoom = (factor, event) => {
    const at = new DOMPoint(event.clientX, event.clientY)
      .matrixTransform(svg.getScreenCTM().inverse());
    const width = Math.min(Math.max(box[2] * factor, whole[2] / 1000), 4 * whole[2]);
    const by = width / box[2];
    box = [at.x - by * (at.x - box[0]), at.y - by * (at.y - box[1]), width, by * box[3]];
    show();
  };
  const apart = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  const drag = (before, event) => {
    if (fingers.size === 2) {
      const distance = apart();
      fingers.set(event.pointerId, event);
      if (apart() > 0) zoom(distance / apart(), event);
      return;
    }
    box[0] -= scale() * (event.clientX - before.clientX);
    box[1] -= scale() * (event.clientY - before.clientY);
    show();
    fingers.set(event.pointerId, event);
  };

  svg.addEventListener("wheel", event => {
    event.preventDefault();
    zoom(Math.exp(0.0015 * event.deltaY), event);
  }, {passive: false});
  svg.addEventListener("dblclick", () => { box = whole.slice(); show(); });
  svg.addEventListener("pointerdown", event => {
    fingers.set(event.pointerId, event);
    dragged = false;
  });
  for (const end of ["pointerup", "pointercancel", "pointerleave"])
    svg.addEventListener(end, event => fingers.delete(event.pointerId));
  svg.addEventListener("pointermove", event => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    drag(before, event);
    dragged = true;
  });
  new ResizeObserver(measure).observe(svg);
  measure();
  return {isHeld: event => fingers.has(event.pointerId), wasDragged: () => dragged};
};
