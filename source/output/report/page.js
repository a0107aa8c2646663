// The page: what is chosen in the drawing, by mouse or by the address.
(() => {
  document.documentElement.classList.add("scripted"); // the tools are of use
  const svg = document.getElementById("drawing"), panel = document.getElementById("numbers");
  const data = JSON.parse(document.getElementById("page-data").textContent);
  const tables = pageTables();
  const zoom = pageZoom(svg, data);
  const motion = pageMotion(tables, data, () => placeMark());
  pageSaving(svg, document.querySelector("h1").textContent);

  const kinds = {
    blocks: {title: "Block ", words: wordsOfBlock, cellOf: c => c, also: () => [mark]},
    joints: {title: "Joint ", words: wordsOfJoint, also: () => [mark],
      cellOf: e => tables.value("joints", e, "cell_minus")},
    links: {title: "Tie ", words: wordsOfLink,
      also: k => svg.querySelectorAll(`[data-link="${k}"]`)}
  };
  const view = () => document.querySelector("input[name=view]:checked").id.slice(5);
  let chosen = {kind: null, index: -1}, pinned = false;
  // An outline over all else of what is chosen: in a motion of a joint on its block c-.
  const mark = document.createElementNS(svg.namespaceURI, "path");
  mark.id = "mark";
  svg.append(mark);
  const placeMark = () => {
    const {kind, index} = chosen, cellOf = kind && kinds[kind].cellOf;
    const shape = cellOf && document.getElementById(kind).children[index];
    const at = shape && view() === "motion" ? motion.matrixOf(cellOf(index)) : new DOMMatrix();
    mark.setAttribute("d", !shape ? "" : shape.getAttribute("d") || `M${shape.getAttribute("points")}z`);
    mark.setAttribute("transform", at.toString());
  };
  const choose = (kind, index) => {
    if (kind !== null && kind === chosen.kind && index === chosen.index && panel.firstChild &&
        chosen.view === view()) return;
    for (const element of svg.querySelectorAll(".chosen")) element.classList.remove("chosen");
    chosen = {kind, index, view: view()};
    placeMark();
    const table = kind && tables.tableOf(kind);
    if (!table || !table.rows[index]) { panel.replaceChildren(); return; }
    for (const element of kinds[kind].also(index)) if (element) element.classList.add("chosen");
    showNumbers(panel, kinds[kind].title + index,
      kinds[kind].words(tables, data, index, view()), table, index);
  };

  const near = 4; // pixels within which a line is pointed at
  const kindOf = element => {
    if (element.dataset && element.dataset.joint) return ["joints", Number(element.dataset.joint)];
    if (element.dataset && element.dataset.link) return ["links", Number(element.dataset.link)];
    if (element.parentNode && element.parentNode.id === "joints")
      return ["joints", [...element.parentNode.children].indexOf(element)];
    return null;
  };
  const pointed = event => {
    for (const r of [0, near])
      for (const [dx, dy] of [[0, 0], [r, 0], [-r, 0], [0, r], [0, -r]])
        for (const element of document.elementsFromPoint(event.clientX + dx, event.clientY + dy)) {
          const found = kindOf(element);
          if (found) return found;
        }
    for (const element of document.elementsFromPoint(event.clientX, event.clientY))
      if (element.parentNode && ["blocks", "moved"].includes(element.parentNode.id))
        return ["blocks", [...element.parentNode.children].indexOf(element)];
    return [null, -1];
  };
  const choosePointed = event => {
    const found = pointed(event);
    choose(...found);
    return found[0] !== null;
  };
  svg.addEventListener("pointermove", event => {
    if (!zoom.isHeld(event) && !pinned) choosePointed(event);
  });
  svg.addEventListener("click", event => {
    if (!zoom.wasDragged()) pinned = choosePointed(event);
  });
  for (const choice of document.querySelectorAll("input[name=view]"))
    choice.addEventListener("change", () => choose(chosen.kind, chosen.index));

  // "#view=forces&joint=7" leads to a view and to what is in it.
  const follow = () => {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const button = document.getElementById("view-" + wanted.get("view"));
    if (button) {
      button.checked = true;
      button.dispatchEvent(new Event("change"));
    }
    for (const [name, kind] of [["block", "blocks"], ["joint", "joints"], ["link", "links"]])
      if (wanted.has(name)) {
        choose(kind, Number(wanted.get(name)));
        pinned = true;
      }
  };
  addEventListener("hashchange", follow);
  addEventListener("beforeprint", () => {
    const proof = document.getElementById("certificate");
    if (proof) proof.open = true;
  });
  follow();
})();
