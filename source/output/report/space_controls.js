"use strict";
// What turns, cuts and takes apart the view: mouse, fingers, keys and the form.
const spaceControls = ({canvas, view, extent, redraw, choose, data, id}) => {
  const {sight} = view;
  const oblique = [-Math.PI / 4, Math.atan(Math.SQRT1_2)];
  const perPixel = 0.008; // radians
  const turn = (azimuth, elevation) => {
    sight.azimuth = azimuth;
    sight.elevation = Math.min(Math.max(elevation, -Math.PI / 2), Math.PI / 2);
    redraw();
  };
  // All of it, with a margin.
  const fit = () => {
    const {right, up} = view.frame(), {x, y} = view.span();
    const half = a => a.reduce((s, c, d) => s + Math.abs(c) * extent[d] * (1 + sight.apart), 0);
    sight.target = [0, 0, 0];
    sight.reach *= 1.08 * Math.max(half(right) / x, half(up) / y);
    redraw();
  };
  const lengths = () => { // of a pixel, in those of the page
    const {x, y} = view.span();
    return [2 * x / canvas.clientWidth, 2 * y / canvas.clientHeight];
  };
  const move = (dx, dy) => {
    const {right, up} = view.frame(), [lx, ly] = lengths();
    sight.target = sight.target.map((t, d) => t - dx * lx * right[d] + dy * ly * up[d]);
    redraw();
  };
  const zoom = (factor, x, y) => {
    const before = sight.reach;
    sight.reach = Math.min(Math.max(before * factor, 1e-4), 20);
    const kept = before / sight.reach - 1; // what is under the pointer stays
    move(-kept * (x - canvas.clientWidth / 2), -kept * (y - canvas.clientHeight / 2));
  };
  const placeOf = event => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left - canvas.clientLeft, event.clientY - box.top - canvas.clientTop];
  };

  const fingers = new Map();
  let dragged = 0; // pixels
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, placeOf(event));
    dragged = fingers.size > 1 ? Infinity : 0;
  });
  canvas.addEventListener("pointermove", event => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const now = placeOf(event), [dx, dy] = now.map((p, d) => p - before[d]);
    dragged += Math.hypot(dx, dy);
    if (fingers.size > 1) {
      const [other] = [...fingers].filter(([key]) => key !== event.pointerId).map(f => f[1]);
      const apart = p => Math.hypot(p[0] - other[0], p[1] - other[1]);
      if (apart(now) > 0) zoom(apart(before) / apart(now), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
      move(dx / 2, dy / 2);
    } else if (event.shiftKey || (event.buttons & 6))
      move(dx, dy);
    else
      turn(sight.azimuth - perPixel * dx, sight.elevation + perPixel * dy);
    fingers.set(event.pointerId, now);
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, event => fingers.delete(event.pointerId));
  canvas.addEventListener("click", event => {
    if (dragged < 4) choose(view.pick(...placeOf(event)));
  });
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("dblclick", fit);
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    zoom(Math.exp(0.0015 * event.deltaY), ...placeOf(event));
  }, {passive: false});
  const keys = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  canvas.addEventListener("keydown", event => {
    const middle = [canvas.clientWidth / 2, canvas.clientHeight / 2];
    if (keys[event.key]) {
      const [dx, dy] = keys[event.key].map(k => 12 * k);
      if (event.shiftKey) move(dx, dy);
      else turn(sight.azimuth - perPixel * dx, sight.elevation + perPixel * dy);
    } else if (event.key === "+" || event.key === "=") zoom(0.85, ...middle);
    else if (event.key === "-") zoom(1 / 0.85, ...middle);
    else if (event.key === "Home") fit();
    else if (event.key === "Escape") choose(-1);
    else return;
    event.preventDefault();
  });

  const cut = () => {
    const axis = id("axis").value;
    sight.axis = axis === "" ? null : Number(axis);
    sight.side = id("other").checked ? -1 : 1;
    id("cut-row").style.visibility = axis === "" ? "hidden" : "";
    if (axis !== "") {
      sight.cut = (2 * Number(id("cut").value) - 1) * extent[axis] * 1.001;
      const place = data.centre[axis] + data.scale * sight.cut;
      id("cut-at").textContent = "xyz"[axis] + " = " + Number(place.toPrecision(4));
    }
    view.setOutline();
    redraw();
  };
  for (const name of ["axis", "cut", "other"]) id(name).addEventListener("input", cut);
  id("blocks").addEventListener("input", event => { sight.blocks = event.target.value; redraw(); });
  id("joints").addEventListener("input", event => { sight.joints = event.target.checked; redraw(); });
  id("apart").addEventListener("input", event => {
    const before = 1 + sight.apart;
    sight.apart = Number(event.target.value);
    sight.reach *= (1 + sight.apart) / before;
    redraw();
  });
  const swing = () => { sight.motion = Number(id("motion").value); redraw(); };
  id("motion-row").hidden = !data.motion;
  id("motion").addEventListener("input", swing);
  id("perspective").addEventListener("input", event => {
    sight.perspective = event.target.checked;
    redraw();
  });
  for (const button of document.querySelectorAll("[data-turn]"))
    button.addEventListener("click", () => {
      turn(...button.dataset.turn.split(" ").map(Number));
      fit();
    });
  id("save").addEventListener("click", () => {
    const link = document.createElement("a");
    link.download = document.title + ".png";
    link.href = canvas.toDataURL();
    link.click();
  });
  new ResizeObserver(redraw).observe(canvas);
  id("controls").reset();
  // Of a load that is not carried the mechanism is the answer.
  id("motion").value = data.motion && data.collapses ? 1 : 0;
  swing();
  cut();
  view.draw();
  turn(...oblique);
  fit();
};
