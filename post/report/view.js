"use strict";
// The page of view: controls, load curve and what happened to a contact, around the maps that `map.js` draws.
const seen = {
  at: 0, zoom: 1, x: 0, y: 0, picked: null,  // x, y: the middle of all maps, m
  get fill() { return element("fill").value; },
  get cracks() { return element("cracks").value; },
  get pair() { return element("pair").value; },
  get factor() { return Math.max(0, Number(element("factor").value) || 0); },
  get outlines() { return element("outlines").checked; },
  get directions() { return element("directions").checked; }
};
let panes = [], places = [], playing = 0, asked = 0;

// What happened to a contact.
function story(pane, c) {
  const {frame, within, broken, classes, run: {cracks, curve: {marks, unit}}} = pane, peak = marks.at(-1), events = [];
  for (let i = 0; i < frame.cracks; ++i) {
    if (cracks.contact[i] != c) continue;
    const share = peak ? `, ${Math.round(100 * cracks.load[i] / peak.y)} % of the ${peak.symbol}` : "";
    events.push(`${cracks.point[i] ? "second" : "first"} end cracked in ${cracks.shear[i] ? "shear" : "tension"} at ` +
                `${cracks.load[i].toFixed(1)} ${unit}${share}`);
  }
  const digits = values => Math.max(0, Math.min(4, -Math.floor(Math.log10(values.step || 1))));
  const both = values => [c, within.length + c].map(i => values[i].toFixed(digits(values))).join(" and ");
  const kind = broken[c] ? "broken from the start" : within[c] ? "within a crystal" : "between crystals";
  return `Contact ${c}: ${classes[pane.class[c]].name}, ${kind}.\n${events.join("; ") || "Not cracked"}.\n` +
         `Opening ${both(frame.opening)} µm, sliding ${both(frame.sliding)} µm at its ends.`;
}

function pick(pane, x, y) {
  const contact = pane.nearest(x, y);
  seen.picked = contact == null ? null : {pane, contact};
  redraw();
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

function redraw() {
  if (panes.some(pane => !pane.frame)) return;
  for (const pane of panes) pane.draw(pane.frame);
  element("legend").replaceChildren(...legendOf(...panes));
  drawCurve();
  const {picked} = seen, contact = element("contact"), text = picked ? story(picked.pane, picked.contact) : contact.dataset.hint;
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
  const caption = Math.max(100, ...panes.map(pane => pane.caption.offsetHeight)), below = innerHeight - element("maps").offsetTop - caption - 8;
  for (const pane of panes) pane.fit(own - 2, Math.max(280, Math.min(860, below)));
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
  panes = chosen.map(run => new Pane(run, seen, made("figure")));
  panes.forEach(listen);
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
  canvas.tabIndex = 0;
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
    if (event.type == "pointerup" && far < 5 && down.size == 1) pick(pane, event.offsetX, event.offsetY);
    down.delete(event.pointerId);
  };
  canvas.onwheel = event => {
    event.preventDefault();
    zoom(Math.exp(-0.0015 * event.deltaY), ...place(event));
  };
}

const keys = {ArrowRight: () => show(seen.at + 1), ArrowLeft: () => show(seen.at - 1), Home: () => show(0), " ": play, "0": reset,
              End: () => show(places.length - 1), "+": () => zoom(1.25), "-": () => zoom(0.8),
              Enter: () => pick(panes[0], ...panes[0].size.map(each => each / 2))};
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
