// A click on the head of a column, or Enter, sorts the rows by it: by numbers, which stand before words, or by words; another one
// turns the order round. Empty entries stay last. Rows that do not repeat their first entry get it.
const sort = event => {
  const head = event.target.closest("th");
  if (!head || (event.key ?? "Enter") != "Enter") return;
  const column = head.cellIndex, up = head.ariaSort != "ascending", rows = [...head.closest("table").rows].slice(1);
  for (const other of head.parentNode.cells) other.ariaSort = null;
  head.ariaSort = up ? "ascending" : "descending";
  rows.forEach((row, i) => { if (i && !row.cells[0].textContent.trim()) row.cells[0].textContent = rows[i - 1].cells[0].textContent; });
  const text = row => (row.cells[column] ?? row.lastElementChild).textContent.trim().replace(/^[–-]$/, "").replace("−", "-");
  const order = (a, b) => {
    const [m, n] = [parseFloat(a), parseFloat(b)];
    if (!a || !b) return (up ? 1 : -1) * (!a - !b);
    return isNaN(m) - isNaN(n) || m - n || a.localeCompare(b, "en", {numeric: true});
  };
  rows.sort((a, b) => (up ? 1 : -1) * order(text(a), text(b)));
  for (const row of rows) row.parentNode.append(row);
};
for (const head of document.querySelectorAll("th")) head.tabIndex = 0;
for (const kind of ["click", "keydown"]) document.addEventListener(kind, sort);

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
