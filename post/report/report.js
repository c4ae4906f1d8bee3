// Maps of the runs, each in its figure, and what their colours mean.
const maps = [...document.querySelectorAll("figure.map")], plain = {zoom: 1, x: 0, y: 0, fill: "phase", cracks: "mode", pair: -1, factor: 1, outlines: true};
let panes = [];
function drawMaps() {
  for (const pane of panes) {
    pane.fit(pane.figure.clientWidth, pane.figure.dataset.height * 1);
    pane.draw(pane.run.frames[pane.figure.dataset.frame]);
  }
}
const ready = Promise.all(maps.map(async figure => {
  const run = runs[figure.dataset.run], frame = run.frames[figure.dataset.frame];
  for (const part of [run.specimen, run.cracks, frame]) await (part.ready ??= opened(part));
  panes.push(new Pane(run, plain, figure));
  const legend = made("ul", "", {class: "legend"});
  legend.append(...legendOf(panes.at(-1)), ...run.notes.map(note => made("li", note)));
  figure.append(legend);
})).then(drawMaps);
ready.catch(() => maps[0].append("These maps need a browser of 2023 or later."));
for (const [event, sharp] of Object.entries({resize: sharpness, beforeprint: () => 3, afterprint: sharpness})) {
  addEventListener(event, () => { ratio = sharp(); drawMaps(); });
}
