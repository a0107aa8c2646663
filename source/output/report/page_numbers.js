// The tables behind the drawing, by the ends of their ids: names and rows of texts.
const pageTables = () => {
  const rounding = 1e-10; // over the largest of a kind
  const read = {};
  const parse = kind => {
    const lines = document.getElementById("table-" + kind).textContent.trim().split("\n");
    return {names: lines[0].split(","), rows: lines.slice(1).map(line => line.split(",")), largest: {}};
  };
  const tableOf = kind => read[kind] || (read[kind] = parse(kind));
  const has = (kind, name) => tableOf(kind).names.includes(name);
  const value = (kind, index, name) => {
    const {names, rows} = tableOf(kind);
    const written = rows[index] && rows[index][names.indexOf(name)];
    return written === undefined || written === "" ? NaN : Number(written);
  };
  // The largest size in columns of a kind.
  const largest = (kind, columns) => {
    const table = tableOf(kind), key = columns.join();
    if (!(key in table.largest)) {
      const places = columns.map(name => table.names.indexOf(name)).filter(k => k >= 0);
      table.largest[key] = 0;
      for (const row of table.rows)
        for (const k of places)
          if (Math.abs(row[k]) > table.largest[key] && Number.isFinite(Number(row[k])))
            table.largest[key] = Math.abs(row[k]);
    }
    return table.largest[key];
  };
  // The numbers of some columns; what is rounding beside the largest of them is zero.
  const numbers = (kind, index, columns) => {
    const least = rounding * largest(kind, columns);
    return columns.map(name => value(kind, index, name)).map(x => Math.abs(x) <= least ? 0 : x);
  };
  return {tableOf, has, value, largest, numbers};
};

// A number with four digits, or with a unit behind it.
const written = x => String(Number(x.toPrecision(4)));
const amount = (x, unit) => x === 0 || !unit ? written(x) : written(x) + " " + unit;
const place = (x, y) => `(${written(x)}, ${written(y)})`;

// What the forces of a joint are, in words: pairs of a name and a text.
const wordsOfForces = (tables, data, e) => {
  const {length: unitL, force: unitF, stress: unitS} = data.units;
  const forces = ["normal_force", "tangential_force", "normal_force_0", "normal_force_1"];
  const [normal, shear, atStart, atEnd] = tables.numbers("joints", e, forces);
  const of = name => tables.value("joints", e, name);
  const size = of("length"), turns = tables.has("joints", "eccentricity");
  const [x0, y0, x1, y1] = tables.numbers("joints", e, ["x0", "y0", "x1", "y1"]);
  const kind = normal < 0 ? ", pressure" : normal > 0 ? ", tension" : "";
  const words = [["Normal force N", amount(Math.abs(normal), unitF) + kind],
    ["Shear force V", amount(Math.abs(shear), unitF)]];
  const share = (name, column) => {
    if (!tables.has("joints", column)) return;
    const used = of(column);
    words.push([name, Number.isFinite(used) ?
      `${Number((100 * used).toPrecision(3))} %` : "without bound"]);
  };
  share("Friction used", "utilisation");
  share("Crushing used", "crushing_utilisation");
  if (!turns) words.push(["Mean normal stress", amount(Math.abs(normal) / size, unitS) + kind]);
  if (!turns || normal === 0) return words;
  const eccentricity = of("eccentricity");
  const off = Math.abs(eccentricity) < 1e-10 ? 0 : eccentricity;
  if (normal < 0)
    words.push(["Acts at", off === 0 ? "the middle, e/h = 0" :
      `e = ${amount(Math.abs(off) * size, unitL)}, e/h = ${written(Math.abs(off))} towards ` +
      (off < 0 ? place(x0, y0) : place(x1, y1)) +
      (Math.abs(off) <= 1 / 6 ? "" : ", outside the middle third")]);
  words.push(["Normal stress, if linear", wordsOfStress(
    {normal, off, size, bearsTension: of("tensile_strength") > 0, kind,
      ends: [(4 * atStart - 2 * atEnd) / size, (4 * atEnd - 2 * atStart) / size]},
    [place(x0, y0), place(x1, y1)], unitS)]);
  return words;
};

// The normal stress at both ends of a joint whose stress is linear where it presses.
const wordsOfStress = ({normal, off, size, bearsTension, ends}, places, unit) => {
  const least = 1e-10 * Math.max(Math.abs(ends[0]), Math.abs(ends[1]));
  const sign = x => x < -least ? ", pressure" : x > least ? ", tension" : "";
  const at = (x, where) =>
    `${amount(Math.abs(x) <= least ? 0 : Math.abs(x), unit)}${sign(x)} at ${where}`;
  if (bearsTension || Math.abs(off) <= 1 / 6)
    return `${at(ends[0], places[0])}; ${at(ends[1], places[1])}`;
  const end = off < 0 ? 0 : 1, share = 3 * (0.5 - Math.abs(off));
  if (share < 1e-8) return `all of N acts at ${places[end]}: no finite stress`;
  return `${amount(2 * Math.abs(normal) / (share * size), unit)}, pressure at ${places[end]}; ` +
    `0 at ${places[1 - end]}, and from ${written(share)} of the length on`;
};

// The jumps of a joint in the motion that is drawn.
const wordsOfJumps = (tables, data, e) => {
  const kind = tables.tableOf("jumps").rows.length ? "jumps" : "joints";
  const unit = data.motion.hasSize ? data.units.length : "";
  const atEnds = tables.has(kind, "opening_0");
  const columns = atEnds ? ["opening_0", "opening_1", "sliding"] : ["opening", "sliding"];
  const least = 1e-10 * data.motion.largest;
  const values = columns.map(name => tables.value(kind, e, name))
    .map(x => Math.abs(x) <= least ? 0 : x);
  const [x0, y0, x1, y1] = tables.numbers("joints", e, ["x0", "y0", "x1", "y1"]);
  const opened = x => amount(x, unit) + (x < 0 ? ", closes" : "");
  const opening = atEnds ? `${opened(values[0])} at ${place(x0, y0)}; ` +
    `${opened(values[1])} at ${place(x1, y1)}` : opened(values[0]);
  const words = [["Opening", opening], ["Sliding", amount(Math.abs(values[values.length - 1]), unit)]];
  return data.motion.hasSize ? words : words.concat([wordsOfSize(data)]);
};
const wordsOfSize = data =>
  ["Scale", `a mechanism has no size; its largest displacement here is ${written(data.motion.largest)}`];

const wordsOfJoint = (tables, data, e, view) => {
  const [minus, plus] = ["cell_minus", "cell_plus"].map(name => tables.value("joints", e, name));
  const words = [["Between", `block ${minus} and ${plus < 0 ? "the ground" : `block ${plus}`}`]];
  if (view === "motion" && data.motion) words.push(...wordsOfJumps(tables, data, e));
  if (tables.has("joints", "normal_force")) words.push(...wordsOfForces(tables, data, e));
  if (Number.isFinite(tables.value("joints", e, "p_min"))) {
    const [least, greatest] = tables.numbers("joints", e, ["p_min", "p_max"]);
    words.push(["Pressure in all states", `${amount(least, data.units.force)} to ` +
      amount(greatest, data.units.force)]);
  }
  return words;
};

const wordsOfBlock = (tables, data, c, view) => {
  const {length, force, stress} = data.units, words = [];
  const pair = (x, y, unit) => `${place(x, y)}${unit && (x || y) ? " " + unit : ""}`;
  const inMotion = view === "motion" && data.motion;
  const kind = inMotion && tables.tableOf("motion").rows.length ? "motion" : "blocks";
  const hasSize = !data.motion || !inMotion || data.motion.hasSize;
  words.push(["Load", pair(...tables.numbers("blocks", c, ["load_x", "load_y"]), force)]);
  if (inMotion || tables.largest("blocks", ["ux", "uy"]) > 0) {
    const [ux, uy] = tables.numbers(kind, c, ["ux", "uy"]);
    words.push(["Displacement", `${pair(ux, uy, hasSize ? length : "")}, ` +
      `size ${amount(Math.hypot(ux, uy), hasSize ? length : "")}`]);
    if (tables.has(kind, "rotation")) {
      const [turn] = tables.numbers(kind, c, ["rotation"]);
      words.push(["Rotation", written(Math.abs(turn)) + (turn === 0 ? "" :
        (hasSize ? " rad" : "") + (turn > 0 ? " counterclockwise" : " clockwise"))]);
    }
    if (!hasSize) words.push(wordsOfSize(data));
  }
  if (tables.has("blocks", "sxx")) {
    const [sxx, sxy, syx, syy] = tables.numbers("blocks", c, ["sxx", "sxy", "syx", "syy"]);
    const mean = (sxx + syy) / 2, radius = Math.hypot((sxx - syy) / 2, (sxy + syx) / 2);
    const least = 1e-10 * tables.largest("blocks", ["sxx", "sxy", "syx", "syy"]);
    const principal = [mean + radius, mean - radius].map(x => Math.abs(x) <= least ? 0 : x);
    words.push(["Mean principal stresses, tension positive",
      principal.map(x => amount(x, stress)).join("; ")]);
  }
  return words;
};

const wordsOfLink = (tables, data, k) => {
  const {names, rows} = tables.tableOf("links"), unit = data.units.force;
  const words = [["Name", rows[k][names.indexOf("link")]]];
  const [force, least, most] = tables.numbers("links", k, ["force", "least", "most"]);
  if (!Number.isNaN(force)) {
    words.push(["Force", amount(Math.abs(force), unit) +
      (force > 0 ? ", tension" : force < 0 ? ", pressure" : "")]);
    words.push(["Used", `${Number((100 * (force && tables.value("links", k, "utilisation")))
      .toPrecision(3))} % of what it bears`]);
  }
  words.push(["Bears", `${amount(least, unit)} to ${amount(most, unit)}, tension positive`]);
  if (tables.has("links", "elongation")) {
    const [longer] = tables.numbers("links", k, ["elongation"]);
    words.push([longer < 0 ? "Ends draw nearer by" : "Ends draw apart by",
      amount(Math.abs(longer), data.units.length)]);
    if (data.motion && !data.motion.hasSize) words.push(wordsOfSize(data));
  }
  return words;
};

// The panel of what is chosen: words, and the row of its .csv file behind a summary.
const showNumbers = (panel, title, words, {names, rows}, index) => {
  const tableOf = (kind, pairs) => {
    const table = document.createElement("table");
    table.className = kind;
    for (const [name, text] of pairs) {
      const line = table.insertRow();
      line.insertCell().textContent = name;
      line.insertCell().textContent = text;
    }
    return table;
  };
  const heading = document.createElement("h3"), raw = document.createElement("details");
  const wasOpen = panel.querySelector("details[open]") !== null;
  heading.textContent = title;
  raw.open = wasOpen;
  raw.append(document.createElement("summary"), tableOf("raw",
    names.map((name, k) => [name, rows[index][k]]).filter(pair => pair[1] !== "")));
  raw.firstChild.textContent = "All its numbers, as in the .csv file";
  panel.replaceChildren(heading, tableOf("words", words), raw);
};
