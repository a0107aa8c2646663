"use strict";
(() => {
  const svg = document.getElementById("drawing");
  const numbers = document.getElementById("numbers");
  const whole = svg.getAttribute("viewBox").split(" ").map(Number);
  let box = whole.slice();

  // Pan and zoom: the view box is what is seen.
  const show = () => svg.setAttribute("viewBox", box.join(" "));
  const scale = () => Math.max(box[2] / svg.clientWidth, box[3] / svg.clientHeight);
  const zoom = (factor, event) => {
    const at = new DOMPoint(event.clientX, event.clientY)
      .matrixTransform(svg.getScreenCTM().inverse());
    const width = Math.min(Math.max(box[2] * factor, whole[2] / 1000), 4 * whole[2]);
    const by = width / box[2];
    box = [at.x - by * (at.x - box[0]), at.y - by * (at.y - box[1]), width, by * box[3]];
    show();
  };
  svg.addEventListener("wheel", event => {
    event.preventDefault();
    zoom(Math.exp(0.0015 * event.deltaY), event);
  }, {passive: false});
  svg.addEventListener("dblclick", () => { box = whole.slice(); show(); });
  const fingers = new Map();
  const apart = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  let dragged = false;
  svg.addEventListener("pointerdown", event => {
    fingers.set(event.pointerId, event);
    dragged = false;
  });
  for (const end of ["pointerup", "pointercancel", "pointerleave"])
    svg.addEventListener(end, event => fingers.delete(event.pointerId));

  // The numbers of what is pointed at: those of the .csv files.
  const tables = {};
  const table = kind => {
    if (!tables[kind]) {
      const lines = document.getElementById("table-" + kind).textContent.trim().split("\n");
      tables[kind] = {names: lines[0].split(","), rows: lines.slice(1)};
    }
    return tables[kind];
  };
  const elements = kind => document.getElementById(kind).children;
  let chosen = null, pinned = false;
  const choose = (kind, index) => {
    if (chosen) chosen.classList.remove("chosen");
    chosen = null;
    numbers.textContent = "";
    const row = kind && table(kind).rows[index];
    if (row === undefined || row === null) return;
    chosen = elements(kind)[index];
    chosen.classList.add("chosen");
    const title = document.createElement("h3");
    title.textContent = (kind === "blocks" ? "Block " : "Joint ") + index;
    const shown = document.createElement("table");
    row.split(",").forEach((value, k) => {
      if (value === "") return;
      const line = shown.insertRow();
      line.insertCell().textContent = table(kind).names[k];
      const cell = line.insertCell();
      cell.className = "number";
      cell.textContent = value;
    });
    numbers.append(title, shown);
  };
  const near = 4; // pixels within which a joint is pointed at
  const pointed = event => {
    for (const r of [0, near])
      for (const [dx, dy] of [[0, 0], [r, 0], [-r, 0], [0, r], [0, -r]])
        for (const element of document.elementsFromPoint(event.clientX + dx, event.clientY + dy))
          if (element.parentNode && element.parentNode.id === "joints")
            return ["joints", element];
    for (const element of document.elementsFromPoint(event.clientX, event.clientY))
      if (element.parentNode && ["blocks", "moved"].includes(element.parentNode.id))
        return ["blocks", element];
    return [null, null];
  };
  const choosePointed = event => {
    const [kind, element] = pointed(event);
    choose(kind, kind && [...element.parentNode.children].indexOf(element));
    return kind;
  };
  svg.addEventListener("pointermove", event => {
    const before = fingers.get(event.pointerId);
    if (!before) {
      if (!pinned) choosePointed(event);
      return;
    }
    if (fingers.size === 2) {
      const distance = apart();
      fingers.set(event.pointerId, event);
      if (apart() > 0) zoom(distance / apart(), event);
    } else {
      box[0] -= scale() * (event.clientX - before.clientX);
      box[1] -= scale() * (event.clientY - before.clientY);
      show();
      fingers.set(event.pointerId, event);
    }
    dragged = true;
  });
  svg.addEventListener("click", event => {
    if (!dragged) pinned = choosePointed(event) !== null;
  });

  // "#view=forces&joint=7" leads to a view and to what is in it.
  const follow = () => {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const view = document.getElementById("view-" + wanted.get("view"));
    if (view) view.checked = true;
    for (const [name, kind] of [["block", "blocks"], ["joint", "joints"]])
      if (wanted.has(name)) {
        choose(kind, Number(wanted.get(name)));
        pinned = true;
      }
  };
  addEventListener("hashchange", follow);
  follow();
})();
