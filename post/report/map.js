"use strict";
// Draws maps of runs. The page has `runs` and `colours` as the program wrote them. Names are put into it as text.
const element = id => document.getElementById(id), sharpness = () => Math.min(2, devicePixelRatio || 1);
const runs = JSON.parse(element("runs").textContent), colours = JSON.parse(element("colours").textContent);
let ratio = sharpness();  // pixels of a canvas over those of the screen

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

// The map of a run in a figure. `seen` is what of it is seen: zoom, and the middle x, y (m) of the map; fill, cracks, pair, factor on
// displacements, outlines, directions; picked contact. Its canvas tells how many half contacts are drawn red and black.
class Pane {
  constructor(run, seen, figure) {
    Object.assign(this, {run, seen, figure, caption: made("figcaption")}, run.specimen);
    this.canvas = made("canvas", "", {role: "img"});
    figure.append(this.caption, this.canvas);
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
  get scale() { return this.whole * this.seen.zoom * ratio; }
  pixel(x, y) { return [this.canvas.width / 2 + (x - this.seen.x) * this.scale, this.canvas.height / 2 - (y - this.seen.y) * this.scale]; }

  draw(frame) {
    const {scale, seen: {factor}, run: {file, facts, title}} = this, [left, top] = this.pixel(0, 0);
    const exaggerated = factor == 1 ? "" : `; displacements × ${factor}`;
    this.frame = frame;
    this.px = this.x.map((x, i) => left + scale * (x + factor * frame.u[i]));
    this.py = this.y.map((y, i) => top - scale * (y + factor * frame.v[i]));
    this.crackWidth = Math.min(6, Math.max(1.2, 0.1 * this.edge * scale / ratio)) * ratio;
    this.fill(this.seen.fill);
    this.outline();
    this.platens(factor);
    if (this.seen.directions) this.directions();
    this.cracks(this.seen.cracks, this.seen.pair);
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
    const some = this.seen.outlines && size >= 4 * ratio;  // of smaller grains they would cover the map
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
    if (this.seen.picked?.pane == this) this.line(picked, ...this.contact(this.seen.picked.contact));
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

  // The contact at a place in pixels of the screen: that by whose line the detour from end to end over the place is least; null: none is near.
  nearest(x, y) {
    const detour = (a, b) => {
      const far = node => Math.hypot(this.px[node] - x * ratio, this.py[node] - y * ratio);
      return far(a) + far(b) - this.gap(a, b);
    };
    let best = 20 * ratio, found = null;
    for (let contact = 0; contact < this.within.length; ++contact) {
      const [a1, a2, b1, b2] = this.contact(contact), least = Math.min(detour(a1, a2), detour(b1, b2));
      if (least < best) [best, found] = [least, contact];
    }
    return found;
  }
}

function niceBelow(length) {
  const decade = 10 ** Math.floor(Math.log10(length));
  return decade * [5, 2, 1].find(each => each * decade <= 1.000001 * length);
}

// What the colours of maps mean: numbers and scales of each run.
function legendOf(...panes) {
  const items = [], {fill, cracks: by, directions} = panes[0].seen, of = ({run: {file}}) => panes.length > 1 ? `${file}: ` : "";
  const phases = new Map(panes.flatMap(pane => pane.phases.map(({name, colour}) => [name, colour])));
  const add = (colour, text, kind = "") => {
    items.push(made("li"));
    items.at(-1).append(made("i", "", {class: kind, style: `background: ${colour}`}), text);
  };
  if (by == "mode") for (const mode of ["tensile", "shear"]) add(colours[mode], `${mode} cracks`, "stroke");
  for (const pane of by == "class" ? panes : []) {
    for (const [group, {colour, points}] of Object.entries(pane.groups)) add(colour, `${of(pane)}${group}: ${Math.ceil(points / 2)}`, "stroke");
  }
  if (panes.some(({broken}) => broken.includes(1))) add(colours.open, "broken from the start", "stroke");
  if (fill == "phase" && phases.size > 1) for (const [name, colour] of phases) add(colour, name);
  for (const pane of fill == "phase" ? [] : panes) {
    const limit = pane.run.limits[fill == "most" ? 0 : 1].toPrecision(3), steps = [-4, -3, -2, -1, 0, 1, 2, 3, 4];
    const scale = `linear-gradient(to right, ${steps.map(i => `rgb(${stressColour(i / 4)})`)})`;
    add(scale, `${of(pane)}−${limit} to ${limit} MPa, tension positive`, "scale");
  }
  if (directions) ["compression", "tension"].forEach((name, i) => add(colours.directions[i], name, "stroke"));
  return items;
}
