// A picture that stands alone: the drawing as it is seen, under its title, over its legend.
const pagePicture = (svg, title) => {
  const space = "http://www.w3.org/2000/svg", line = 18, margin = 10;
  const properties = ["fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width",
    "stroke-dasharray", "stroke-linecap", "paint-order", "marker-end", "vector-effect"];
  const element = (name, attributes, text) => {
    const made = document.createElementNS(space, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    return made;
  };
  // The style that the page gives an element, written into its copy.
  const inline = (from, to) => {
    const style = getComputedStyle(from);
    if (style.display === "none" && !from.closest("defs")) { to.remove(); return; }
    if (!from.firstElementChild)
      for (const name of properties)
        if (style.stroke !== "none" || !name.startsWith("stroke"))
          to.setAttribute(name, style.getPropertyValue(name));
    to.removeAttribute("class");
    const copies = [...to.children];
    [...from.children].forEach((child, k) => inline(child, copies[k]));
  };
  const copyOfDrawing = (width, height) => {
    const copy = svg.cloneNode(true);
    inline(svg, copy);
    for (const name of ["id", "role", "aria-label", "style"]) copy.removeAttribute(name);
    for (const [name, value] of [["y", 2 * line], ["width", width], ["height", height]])
      copy.setAttribute(name, value);
    return copy;
  };
  // The bar of colours of a legend.
  const barOf = (bar, y) => {
    const colours = getComputedStyle(bar).backgroundImage.match(/rgb\([^)]*\)/g);
    const gradient = element("linearGradient", {id: "colours"});
    colours.forEach((colour, k) => gradient.append(
      element("stop", {offset: k / (colours.length - 1), "stop-color": colour})));
    return [gradient, element("rect", {x: margin, y: y - 12, width: 300, height: 12,
      fill: "url(#colours)"})];
  };
  const endsOf = (ends, y) => [...ends.children].map((end, k, all) => element("text",
    {x: margin + 300 * k / (all.length - 1), y, "text-anchor": ["start", "middle", "end"][k]},
    end.textContent));
  const wordsOf = (words, y) => {
    const swatch = words.querySelector(".swatch"), shown = [];
    if (swatch)
      shown.push(element("rect", {x: margin, y: y - 8, width: 18, height: 6,
        fill: getComputedStyle(swatch).backgroundColor}));
    shown.push(element("text", {x: margin + (swatch ? 26 : 0), y}, words.textContent.trim()));
    return shown;
  };
  const legendOf = (legend, y) => {
    const made = [];
    for (const child of legend ? legend.children : []) {
      made.push(...(child.className === "bar" ? barOf : child.className === "ends" ? endsOf :
        wordsOf)(child, y));
      y += line;
    }
    return {made, y};
  };

  const view = document.querySelector("input[name=view]:checked");
  const named = `${title}: ${view.nextElementSibling.textContent}`;
  const {width, height} = svg.getBoundingClientRect();
  const legend = legendOf(document.querySelector(`.legend.in-${view.id.slice(5)}`), 4 * line + height);
  const picture = element("svg", {xmlns: space, width, height: legend.y, "font-size": 13,
    viewBox: `0 0 ${width} ${legend.y}`, "font-family": "DejaVu Sans, sans-serif"});
  picture.append(element("title", {}, named),
    element("rect", {width, height: legend.y, fill: "#ffffff"}),
    element("text", {x: margin, y: line + 2, "font-weight": "bold"}, named),
    copyOfDrawing(width, height), ...legend.made);
  const letters = title.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "");
  return {width, height: legend.y, name: `${letters || "picture"}-${view.id.slice(5)}`,
    text: new XMLSerializer().serializeToString(picture)};
};

// The buttons that save it.
const pageSaving = (svg, title) => {
  const save = (blob, name) => {
    const link = document.createElement("a");
    link.download = name;
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  const saveSvg = () => {
    const {text, name} = pagePicture(svg, title);
    save(new Blob([text], {type: "image/svg+xml"}), name + ".svg");
  };
  const savePng = async () => {
    const {text, name, width, height} = pagePicture(svg, title);
    const image = new Image(), canvas = document.createElement("canvas");
    image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(text);
    await image.decode();
    canvas.width = Math.round(2 * width);
    canvas.height = Math.round(2 * height);
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob(blob => save(blob, name + ".png"));
  };
  document.getElementById("save-svg").addEventListener("click", saveSvg);
  document.getElementById("save-png").addEventListener("click", savePng);
};
