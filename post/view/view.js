"use strict";
// The page has `runs` and `colours` as the program wrote them. Names are put into it as text.
const element = id => document.getElementById(id), sharpness = () => Math.min(2, devicePixelRatio || 1);
const runs = JSON.parse(element("runs").textContent), colours = JSON.parse(element("colours").textContent);
const seen = {at: 0, zoom: 1, x: 0, y: 0, picked: null};  // x, y: the middle of all maps, m
let panes = [], places = [], ratio = sharpness(), playing = 0, asked = 0;

function made(name, text = "", attributes = {}, space = "http://www.w3.org/1999/xhtml") {
  const node = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.textContent = text;
  return node;
}

// Numbers as `packed` of the program leaves them; of steps, those that they stand for.
async function unpacked({low, step, data}) {
  const bytes = Uint8Array.from(atob(data), letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer()), n = planes.length / 4;
  const values = step == null ? new Int32Array(n) : new Float32Array(n);
  for (let i = 0, sum = 0; i < n; ++i) {
    const code = planes[i] | planes[n + i] << 8 | planes[2 * n + i] << 16 | planes[3 * n + i] << 24;
    sum = (sum + (code >>> 1 ^ -(code & 1))) | 0;
    values[i] = step == null ? sum : low + step * sum;
  }
  return Object.assign(values, {step});
}
const opened = part => Promise.all(Object.keys(part).map(async key => { if (part[key]?.data) part[key] = await unpacked(part[key]); }));

// A stress as a share of its limit: compression blue, tension orange, white between.
function stressColour(share) {
  const [end, far] = share < 0 ? [[0, 114, 178], [0, 40, 90]] : [[230, 140, 30], [120, 40, 0]], size = Math.min(1, Math.abs(share));
  return end.map((c, k) => Math.round(size < 0.7 ? 255 + (c - 255) * size / 0.7 : c + (far[k] - c) * (size - 0.7) / 0.3));
}
const pixelOf = ([r, g, b]) => (255 << 24 | b << 16 | g << 8 | r) >>> 0;
const stressPixels = Uint32Array.from({length: 257}, (_, i) => pixelOf(stressColour(i / 128 - 1)));

// Colours the pixels whose centre lies in a triangle: neighbours neither overlap nor leave a seam.
function fillTriangle({width, height, pixels}, ax, ay, bx, by, cx, cy, colour) {
  const last = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
  for (let row = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)); row <= last; ++row) {
    const y = row + 0.5, cuts = (p, q) => p <= y !== q <= y;
    const ab = cuts(ay, by) ? ax + (y - ay) * (bx - ax) / (by - ay) : NaN;
    const bc = cuts(by, cy) ? bx + (y - by) * (cx - bx) / (cy - by) : NaN;
    const ca = cuts(cy, ay) ? cx + (y - cy) * (ax - cx) / (ay - cy) : NaN;
    const one = ab === ab ? ab : bc, other = ca === ca ? ca : bc;
    const end = Math.min(width, Math.ceil(Math.max(one, other) - 0.5)) + row * width;
    for (let i = Math.max(0, Math.ceil(Math.min(one, other) - 0.5)) + row * width; i < end; ++i) pixels[i] = colour;
  }
}

// Both principal stresses of an element, the greater first, and the direction of that, from x.
function principal({xx, yy, xy}, e) {
  const mean = (xx[e] + yy[e]) / 2, radius = Math.hypot((xx[e] - yy[e]) / 2, xy[e]);
  return [mean + radius, mean - radius, Math.atan2(2 * xy[e], xx[e] - yy[e]) / 2];
}
const mean = (p, q) => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];

// The map of a run. Its canvas tells how many half contacts are drawn red and black.
class Pane {
  constructor(run) {
    Object.assign(this, {run, figure: made("figure"), caption: made("figcaption")}, run.specimen);
    this.canvas = made("canvas", "", {tabindex: 0, role: "img"});
    this.figure.append(this.caption, this.canvas);
    listen(this);
  }

  // The size on the screen, with room for platens, what bulges, and the scale.
  fit(across, down) {
    this.whole = Math.min(across / 1.12 / this.width, (down - 56) / 1.08 / this.height);  // pixels of a metre
    this.size = [Math.min(across, Math.max(1.12 * this.whole * this.width, 250)), 1.08 * this.whole * this.height + 56].map(Math.floor);
    Object.assign(this.canvas, {width: this.size[0] * ratio, height: this.size[1] * ratio});
    this.canvas.style.width = this.figure.style.width = `${this.size[0]}px`;
    this.context = this.canvas.getContext("2d");
    this.image = this.context.createImageData(this.canvas.width, this.canvas.height);
  }
  get scale() { return this.whole * seen.zoom * ratio; }
  pixel(x, y) { return [this.canvas.width / 2 + (x - seen.x) * this.scale, this.canvas.height / 2 - (y - seen.y) * this.scale]; }

  draw(frame) {
    const {scale, run: {file, facts, title}} = this, [left, top] = this.pixel(0, 0);
    const factor = Math.max(0, Number(element("factor").value) || 0), exaggerated = factor == 1 ? "" : `; displacements × ${factor}`;
    this.frame = frame;
    this.px = this.x.map((x, i) => left + scale * (x + factor * frame.u[i]));
    this.py = this.y.map((y, i) => top - scale * (y + factor * frame.v[i]));
    this.crackWidth = Math.min(6, Math.max(1.2, 0.1 * this.edge * scale / ratio)) * ratio;
    this.fill(element("fill").value);
    this.outline();
    this.platens(factor);
    if (element("directions").checked) this.directions();
    this.cracks(element("cracks").value, element("pair").value);
    this.bar();
    const text = `${frame.text}; cracks: ${frame.counts[0]} tensile, ${frame.counts[1]} shear${exaggerated}`;
    this.caption.replaceChildren(made("b", file), facts, made("br"), text);
    this.canvas.setAttribute("aria-label", `${title}: ${text}`);
  }

  fill(kind) {
    const {px, py, frame, elements, phase, phases, image: {width, height, data}} = this, which = kind == "most" ? 0 : 1;
    const image = {width, height, pixels: new Uint32Array(data.buffer).fill(0xffffffff)}, unit = 128 / this.run.limits[which];
    const phasePixels = phases.map(({colour}) => pixelOf([1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16))));
    for (let e = 0; e < phase.length; ++e) {
      const a = elements[3 * e], b = elements[3 * e + 1], c = elements[3 * e + 2];
      const colour = kind == "phase" ? phasePixels[phase[e]]
                                     : stressPixels[Math.round(Math.max(0, Math.min(256, 128 + unit * principal(frame, e)[which])))];
      fillTriangle(image, px[a], py[a], px[b], py[b], px[c], py[c], colour);
    }
    this.context.putImageData(this.image, 0, 0);
  }

  stroke(path, strokeStyle, lineWidth) { Object.assign(this.context, {strokeStyle, lineWidth, lineCap: "round"}).stroke(path); }
  line(path, a, b) {
    path.moveTo(this.px[a], this.py[a]);
    path.lineTo(this.px[b], this.py[b]);
  }
  gap(a, b) { return Math.hypot(this.px[a] - this.px[b], this.py[a] - this.py[b]); }
  // Its nodes a1, a2, b1, b2.
  contact(c) { return [0, 1, 2, 3].map(k => this.contacts[k * this.within.length + c]); }

  outline() {
    const {within, broken, boundary} = this, half = boundary.length / 2, size = this.edge * this.scale;
    const [between, inside, open, rim, picked] = Array.from({length: 5}, () => new Path2D());
    const thin = Math.min(1.2 * ratio, Math.max(0.3 * ratio, 0.03 * size));
    const some = element("outlines").checked && size >= 4 * ratio;  // of smaller grains they would cover the map
    for (let c = 0; c < within.length; ++c) {
      if (!some && !broken[c]) continue;
      const [a1, a2, b1, b2] = this.contact(c), path = broken[c] ? open : within[c] ? inside : between;
      this.line(path, a1, a2);
      if (Math.max(this.gap(a1, b1), this.gap(a2, b2)) > 0.2 * thin) this.line(path, b1, b2);
    }
    for (let i = 0; i < half; ++i) this.line(rim, boundary[i], boundary[half + i]);
    this.stroke(inside, colours.outline, 0.6 * thin);
    this.stroke(between, this.phases.length > 1 ? colours.rim : colours.outline, thin);
    this.stroke(rim, colours.rim, Math.max(1.6 * thin, ratio));
    this.stroke(open, colours.open, this.crackWidth);
    if (seen.picked?.pane == this) this.line(picked, ...this.contact(seen.picked.contact));
    this.stroke(picked, "#00a0ffa0", this.crackWidth + 8 * ratio);
  }

  platens(factor) {
    this.context.fillStyle = colours.platen;
    for (const {corners, way} of this.run.platens) {
      const [dx, dy] = way.map(each => each * factor * this.frame.approach);
      this.context.beginPath();
      for (const [x, y] of corners) this.context.lineTo(...this.pixel(x + dx, y + dy));
      this.context.fill();
    }
  }

  // Crosses along the principal directions, as long as the stress: one in each element, or as many as have room.
  directions() {
    const {elements, canvas} = this, reach = Math.max(13 * ratio, 0.4 * this.edge * this.scale), limit = Math.max(...this.run.limits);
    const paths = [new Path2D(), new Path2D()], taken = new Set();
    for (let e = 0; e < elements.length / 3; ++e) {
      const [x, y] = [this.px, this.py].map(p => (p[elements[3 * e]] + p[elements[3 * e + 1]] + p[elements[3 * e + 2]]) / 3);
      const cell = `${Math.floor(x / reach)} ${Math.floor(y / reach)}`, [most, least, angle] = principal(this.frame, e);
      if (x < 0 || y < 0 || x > canvas.width || y > canvas.height || taken.has(cell)) continue;
      taken.add(cell);
      for (const [value, turn] of [[most, angle], [least, angle + Math.PI / 2]]) {
        const half = Math.min(1, Math.abs(value) / limit) * 0.6 * reach, [dx, dy] = [half * Math.cos(turn), half * Math.sin(turn)];
        paths[value < 0 ? 0 : 1].moveTo(x - dx, y + dy);
        paths[value < 0 ? 0 : 1].lineTo(x + dx, y - dy);
      }
    }
    paths.forEach((path, i) => this.stroke(path, colours.directions[i], 1.6 * ratio));
  }

  // Half a contact for each of its points that has cracked: a line midway, or where it gapes one on each side.
  cracks(by, pair) {
    const {frame, run: {cracks}} = this, paths = new Map(), drawn = [0, 0];
    this.groups = {};
    for (const shear of by == "none" ? [] : [1, 0]) {  // tensile cracks lie above
      for (let i = 0; i < frame.cracks; ++i) {
        const c = cracks.contact[i], kind = this.classes[this.class[c]], end = cracks.point[i];
        if (cracks.shear[i] != shear || pair >= 0 && this.class[c] != pair) continue;
        ++drawn[shear];
        (this.groups[kind.group] ??= {colour: kind.colour, points: 0}).points += 1;
        const nodes = this.contact(c), [a1, a2, b1, b2] = nodes.map(node => [this.px[node], this.py[node]]);
        const width = (this.within[c] ? 0.55 : 1) * this.crackWidth, gapes = this.gap(nodes[end], nodes[2 + end]) > 2 * width;
        const colour = by == "class" ? kind.colour : shear ? colours.shear : colours.tensile, key = `${colour} ${width} ${gapes}`;
        if (!paths.has(key)) paths.set(key, [new Path2D(), colour, gapes ? 0.7 * width : width]);
        for (const side of gapes ? [[a1, a2], [b1, b2]] : [[mean(a1, b1), mean(a2, b2)]]) {
          paths.get(key)[0].moveTo(...side[end]);
          paths.get(key)[0].lineTo(...mean(...side));
        }
      }
    }
    for (const each of paths.values()) this.stroke(...each);
    Object.assign(this.canvas.dataset, {tensile: drawn[0], shear: drawn[1], frame: frame.index});
  }

  bar() {
    const length = niceBelow(0.3 * this.canvas.width / this.scale), [x, y] = [10 * ratio, this.canvas.height - 12 * ratio];
    Object.assign(this.context, {fillStyle: "#1e1e1e", strokeStyle: "#fff", lineWidth: 4 * ratio, font: `${12 * ratio}px sans-serif`});
    this.context.fillRect(x, y, length * this.scale, 3 * ratio);
    for (const draw of ["strokeText", "fillText"]) this.context[draw](`${Number((1e3 * length).toPrecision(2))} mm`, x, y - 4 * ratio);
  }

  // The contact at a place in pixels of the screen: that by whose line the detour from end to end over the place is least.
  pick(x, y) {
    const detour = (a, b) => {
      const far = node => Math.hypot(this.px[node] - x * ratio, this.py[node] - y * ratio);
      return far(a) + far(b) - this.gap(a, b);
    };
    let best = 20 * ratio;
    seen.picked = null;
    for (let contact = 0; contact < this.within.length; ++contact) {
      const [a1, a2, b1, b2] = this.contact(contact), least = Math.min(detour(a1, a2), detour(b1, b2));
      if (least < best) [best, seen.picked] = [least, {pane: this, contact}];
    }
    redraw();
  }

  // What happened to a contact.
  story(c) {
    const {frame, run: {cracks, curve: {marks, unit}}} = this, peak = marks.at(-1), events = [];
    for (let i = 0; i < frame.cracks; ++i) {
      if (cracks.contact[i] != c) continue;
      const share = peak ? `, ${Math.round(100 * cracks.load[i] / peak.y)} % of the ${peak.symbol}` : "";
      events.push(`${cracks.point[i] ? "second" : "first"} end cracked in ${cracks.shear[i] ? "shear" : "tension"} at ` +
                  `${cracks.load[i].toFixed(1)} ${unit}${share}`);
    }
    const digits = values => Math.max(0, Math.min(4, -Math.floor(Math.log10(values.step || 1))));
    const both = values => [c, this.within.length + c].map(i => values[i].toFixed(digits(values))).join(" and ");
    const kind = this.broken[c] ? "broken from the start" : this.within[c] ? "within a crystal" : "between crystals";
    return `Contact ${c}: ${this.classes[this.class[c]].name}, ${kind}.\n${events.join("; ") || "Not cracked"}.\n` +
           `Opening ${both(frame.opening)} µm, sliding ${both(frame.sliding)} µm at its ends.`;
  }
}

function niceBelow(length) {
  const decade = 10 ** Math.floor(Math.log10(length));
  return decade * [5, 2, 1].find(each => each * decade <= 1.000001 * length);
}

// The load curves of the runs seen, thresholds and peaks, and points where the maps stand.
function drawCurve() {
  const svg = element("curve"), width = svg.clientWidth || 400, height = Math.round(Math.min(320, 0.62 * width)), to = {};
  const curves = panes.map(pane => pane.run.curve), left = 54, right = width - 12, top = 12, bottom = height - 40;
  const add = (name, attributes, text) => svg.append(made(name, text, attributes, svg.namespaceURI));
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.style.height = `${height}px`;
  svg.replaceChildren();
  for (const [axis, from, end] of [["x", left, right], ["y", bottom, top]]) {
    const ends = curves.reduce((found, curve) => curve[axis].reduce(([l, h], v) => [Math.min(l, v), Math.max(h, v)], found), [0, 0]);
    const room = 0.07 * (ends[1] - ends[0] || 1), low = ends[0] - (ends[0] < 0 ? room : 0), high = ends[1] + room;
    const step = niceBelow((high - low) / 3), digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    to[axis] = value => from + (value - low) / (high - low) * (end - from);
    for (let i = Math.ceil(low / step); i * step <= high; ++i) {
      const at = to[axis](i * step), text = (i * step).toFixed(digits).replace("-", "−");
      add("path", {d: axis == "x" ? `M${at} ${top}V${bottom}` : `M${left} ${at}H${right}`, class: "grid"});
      add("text", axis == "x" ? {x: at, y: bottom + 15, class: "middle"} : {x: left - 5, y: at + 4, class: "end"}, text);
    }
  }
  add("text", {x: (left + right) / 2, y: height - 6, class: "middle"}, curves[0].across);
  add("text", {class: "middle", transform: `translate(12 ${(top + bottom) / 2}) rotate(-90)`}, curves[0].up);
  panes.forEach(({run: {curve}, frame}, i) => {
    const stroke = colours.series[i], points = Array.from(curve.x, (x, k) => `${to.x(x).toFixed(1)} ${to.y(curve.y[k]).toFixed(1)}`);
    add("path", {d: `M${points.join("L")}`, stroke});
    for (const {symbol, x, y} of curve.marks) {
      if (x != null) add("circle", {cx: to.x(x), cy: to.y(y), r: 4, fill: "#fff", stroke});
      else add("path", {d: `M${left} ${to.y(y)}H${right}`, stroke, "stroke-dasharray": symbol == "CI" ? "6 4" : "8 3 2 3"});
      if (x == null) add("text", {x: i ? right - 22 : left + 4, y: to.y(y) + (symbol == "CI" ? -4 : 13)}, symbol);
    }
    add("circle", {cx: to.x(frame.x), cy: to.y(frame.y), r: 6, fill: stroke, stroke: "#fff"});
  });
  svg.onclick = ({offsetX, offsetY}) => {
    const far = ([i], {x, y} = panes[0].run.frames[i]) => Math.hypot(to.x(x) - offsetX, to.y(y) - offsetY);
    show(places.reduce((best, place, i) => far(place) < far(places[best]) ? i : best, 0));
  };
  element("marks").replaceChildren(...panes.flatMap(({run: {curve, file}}, i) => curve.marks.map(({text}) =>
    made("li", panes.length > 1 ? `${file}: ${text}` : text, {style: `color: ${colours.series[i]}`}))));
}

// What the colours mean.
function drawLegend() {
  const [{groups, phases, broken, run}] = panes, fill = element("fill").value, by = element("cracks").value, items = [];
  const add = (colour, text, kind = "") => {
    items.push(made("li"));
    items.at(-1).append(made("i", "", {class: kind, style: `background: ${colour}`}), text);
  };
  if (by == "mode") for (const mode of ["tensile", "shear"]) add(colours[mode], `${mode} cracks`, "stroke");
  for (const group in by == "class" ? groups : {}) add(groups[group].colour, `${group}: ${Math.ceil(groups[group].points / 2)}`, "stroke");
  if (broken.includes(1)) add(colours.open, "broken from the start", "stroke");
  if (fill == "phase" && phases.length > 1) for (const {name, colour} of phases) add(colour, name);
  if (fill != "phase") {
    const limit = run.limits[fill == "most" ? 0 : 1].toPrecision(3), steps = [-4, -3, -2, -1, 0, 1, 2, 3, 4];
    add(`linear-gradient(to right, ${steps.map(i => `rgb(${stressColour(i / 4)})`)})`, `−${limit} to ${limit} MPa, tension positive`, "scale");
  }
  if (element("directions").checked) ["compression", "tension"].forEach((name, i) => add(colours.directions[i], name, "stroke"));
  element("legend").replaceChildren(...items);
}

function redraw() {
  if (panes.some(pane => !pane.frame)) return;
  for (const pane of panes) pane.draw(pane.frame);
  drawLegend();
  drawCurve();
  const {picked} = seen, contact = element("contact"), text = picked ? picked.pane.story(picked.contact) : contact.dataset.hint;
  if (contact.textContent != text) contact.textContent = text;  // what stays is not read aloud again
}

// Shows a position of the slider; of several that are asked for while frames are unpacked, the last.
async function show(at) {
  seen.at = Math.max(0, Math.min(places.length - 1, at));
  element("frame").value = seen.at;
  const turn = ++asked, frames = panes.map((pane, i) => pane.run.frames[places[seen.at][i]]);
  await Promise.all(frames.map(opened));
  if (turn != asked) return;
  panes.forEach((pane, i) => { pane.frame = frames[i]; });
  element("frame").setAttribute("aria-valuetext", frames.map(frame => frame.text).join("; "));
  redraw();
}

function layout() {
  const width = element("page").clientWidth, room = innerWidth <= 760 ? width : width - 28 - Math.max(320, 0.33 * width);
  const own = panes.length > 1 && room >= 376 ? room / 2 - 8 : room;
  for (const pane of panes) pane.fit(own - 2, Math.max(280, Math.min(860, 0.76 * innerHeight)));
  redraw();
}

// Shows the runs that are chosen. For each position of the slider `places` has their frames: two runs stand at the same strain
// where that grows from frame to frame, else at the same share of their frames.
async function choose() {
  const chosen = [element("left"), element("right")].map(each => runs[each.value]).filter(Boolean), {specimen, notes} = chosen[0];
  await Promise.all(chosen.flatMap(run => [run.specimen, run.cracks, run.curve].map(opened)));
  const grows = chosen.every(({frames}) => frames.every((frame, i) => !i || frame.x > frames[i - 1].x));
  const keys = chosen.map(({frames}) => frames.map((frame, i) => grows ? frame.x : i / Math.max(1, frames.length - 1)));
  const nearest = (own, key) => own.reduce((best, each, i) => Math.abs(each - key) < Math.abs(own[best] - key) ? i : best, 0);
  places = [...new Set(keys.flat())].sort((a, b) => a - b).map(key => keys.map(own => nearest(own, key)));
  panes = chosen.map(run => new Pane(run));
  seen.picked = null;
  element("frame").max = places.length - 1;
  element("maps").replaceChildren(...panes.map(pane => pane.figure));
  const pairs = specimen.classes.map(({name}, value) => made("option", name, {value}));
  element("pair").replaceChildren(made("option", "all pairs", {value: -1}), ...pairs);
  element("notes").replaceChildren(...notes.map(note => made("li", note)));
  layout();
  await show(places.length - 1);
}

// \param x, y what stays where it is, in pixels from the middle of a map
function zoom(factor, x = 0, y = 0) {
  const before = seen.zoom;
  seen.zoom = Math.max(0.2, Math.min(200, before * factor));
  move(x * (1 - seen.zoom / before), y * (1 - seen.zoom / before));
}
function move(x, y) {
  seen.x -= x / panes[0].whole / seen.zoom;
  seen.y += y / panes[0].whole / seen.zoom;
  redraw();
}
function reset() {
  Object.assign(seen, {zoom: 1, x: 0, y: 0});
  redraw();
}
function play() {
  clearInterval(playing);
  if (!playing && seen.at + 1 >= places.length) show(0);
  playing = playing ? 0 : setInterval(() => seen.at + 1 < places.length ? show(seen.at + 1) : play(), 200);
  element("play").textContent = playing ? "❚❚" : "▶";
  element("play").setAttribute("aria-label", playing ? "stop" : "play");
}

// One pointer moves the map, two pinch it; one that stays where it came down picks.
function listen(pane) {
  const {canvas} = pane, down = new Map(), length = (p, q) => Math.max(1, Math.hypot(p[0] - q[0], p[1] - q[1]));
  const place = ({offsetX, offsetY}) => [offsetX - pane.size[0] / 2, offsetY - pane.size[1] / 2];
  let far = 0;
  canvas.onpointerdown = event => {
    if (!down.size) far = 0;
    down.set(event.pointerId, place(event));
    canvas.setPointerCapture(event.pointerId);
  };
  canvas.onpointermove = event => {
    const before = down.get(event.pointerId), now = place(event), other = [...down].find(([id]) => id != event.pointerId)?.[1];
    if (!before) return;
    far += Math.hypot(now[0] - before[0], now[1] - before[1]);
    if (far < 5) return;
    down.set(event.pointerId, now);
    if (other) zoom(length(now, other) / length(before, other), ...mean(now, other));
    move((now[0] - before[0]) / down.size, (now[1] - before[1]) / down.size);
  };
  canvas.onpointerup = canvas.onpointercancel = event => {
    if (event.type == "pointerup" && far < 5 && down.size == 1) pane.pick(event.offsetX, event.offsetY);
    down.delete(event.pointerId);
  };
  canvas.onwheel = event => {
    event.preventDefault();
    zoom(Math.exp(-0.0015 * event.deltaY), ...place(event));
  };
}

const keys = {ArrowRight: () => show(seen.at + 1), ArrowLeft: () => show(seen.at - 1), Home: () => show(0), " ": play, "0": reset,
              End: () => show(places.length - 1), "+": () => zoom(1.25), "-": () => zoom(0.8),
              Enter: () => panes[0].pick(...panes[0].size.map(each => each / 2))};
const shifted = {ArrowLeft: () => move(40, 0), ArrowRight: () => move(-40, 0), ArrowUp: () => move(0, 40), ArrowDown: () => move(0, -40)};
addEventListener("keydown", event => {
  const act = event.shiftKey && shifted[event.key] || keys[event.key], {target} = event;
  if (!act || event.ctrlKey || event.metaKey || event.altKey || target.matches("select, [type=number]")) return;
  if (" Enter".includes(event.key) && target.matches("button, [type=checkbox]")) return;
  event.preventDefault();
  act();
});
for (const side of ["left", "right"]) element(side).append(...runs.map(({file}, value) => made("option", file, {value})));
element("choice").hidden = runs.length < 2;
element("right").value = runs.length == 2 ? 1 : -1;
element("frame").oninput = event => show(Number(event.target.value));
for (const id of ["left", "right"]) element(id).onchange = choose;
for (const id of ["fill", "cracks", "pair", "factor", "outlines", "directions"]) element(id).oninput = redraw;
for (const [id, act] of Object.entries({play, reset, in: keys["+"], out: keys["-"]})) element(id).onclick = act;
for (const [event, sharp] of Object.entries({resize: sharpness, beforeprint: () => 3, afterprint: sharpness})) {
  addEventListener(event, () => { ratio = sharp(); layout(); });
}
const ready = choose();
ready.catch(() => element("maps").append("This page needs a browser of 2023 or later."));
