"""Opens pages of graincrack-post view in a browser, headless Chromium.

Usage: view_page_test.py BIN. Ends with 77, "skipped", and the reason, where chromium is not installed. GRAINCRACK_SCREENSHOTS=FOLDER keeps
pictures of the pages as a person sees them.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, skip_without

# Goes through the states, then does what a person does at the keyboard and with a pointer.
MEASURE = """<script>
const press = async key => {
  document.body.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
  await show(seen.at);
};
const shown = () => panes.map(pane => ({...pane.canvas.dataset}));
const colours_of = () => {
  const {width, height} = panes[0].canvas, copy = Object.assign(document.createElement("canvas"), {width, height}).getContext("2d", {willReadFrequently: true});
  copy.drawImage(panes[0].canvas, 0, 0);
  const {data} = copy.getImageData(0, 0, width, height);
  return new Set(new Uint32Array(data.buffer)).size;
};
ready.then(async () => {
  const found = {window: innerWidth, width: document.documentElement.scrollWidth, title: document.querySelector("h1").textContent,
                 tags: document.querySelectorAll("h1 *, figcaption img, option *").length, states: [], files: []};
  for (let i = 0; i < places.length; ++i) {
    await show(i);
    found.states.push(shown());
  }
  found.files = panes.map(pane => pane.figure.querySelector("b").textContent);
  found.bottom = Math.max(...panes.map(pane => pane.canvas.getBoundingClientRect().bottom + scrollY));
  found.height = innerHeight;
  await press("ArrowLeft");
  found.back = shown();
  const {scale} = panes[0];
  await press("+");
  found.zoom = panes[0].scale / scale;
  await press("0");
  found.whole = panes[0].scale / scale;
  await press("End");
  found.colours = colours_of();
  element("fill").value = "least";
  element("directions").checked = true;
  element("directions").oninput();
  found.stresses = colours_of();
  element("cracks").value = "class";
  element("factor").value = 30;
  element("pair").value = 0;
  element("pair").oninput();
  found.pair = shown();
  found.legend = element("legend").textContent;
  const {canvas, run: {cracks}, px, py} = panes[0], nodes = panes[0].contact(cracks.contact[0]), box = canvas.getBoundingClientRect();
  const at = (p, from) => from + (p[nodes[0]] + p[nodes[1]]) / 2 / ratio;
  for (const type of ["pointerdown", "pointerup"]) {
    try { canvas.dispatchEvent(new PointerEvent(type, {pointerId: 1, clientX: at(px, box.left), clientY: at(py, box.top)})); } catch {}
  }
  pick(panes[0], at(px, 0), at(py, 0));
  found.contact = element("contact").textContent;
  parent.document.body.append(Object.assign(parent.document.createElement("pre"), {id: "measured", textContent: JSON.stringify(found)}));
});
</script>"""
NAME = '</script><img src=x onerror=alert(1)>\\" & é'
FILE = "<b onclick=alert(1)>'&.h5"


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="graincrack-view."))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.browser = Browser(cls.folder)
        materials = Path(__file__).resolve().parents[2] / "share" / "materials"
        text = re.sub(r'^name = .*', lambda _: f'name = "{NAME}"', (materials / "augig-granite-triangles.toml").read_text(), count=1, flags=re.M)
        (cls.folder / "rock.toml").write_text(text)
        cls.run_in_folder(f"""
            graincrack-mesh rectangle --width 20mm --height 40mm --edge 4mm --material rock.toml --quiet -o specimen.h5
            graincrack-solve uniaxial specimen.h5 --material rock.toml --rate-tolerance 0.006 --frames 8 --quiet -o "{FILE}"
            graincrack-mesh disc --diameter 25mm --material augig-granite-calibrated --quiet -o disc.h5
            graincrack-solve brazilian disc.h5 --material augig-granite-calibrated --rate-tolerance 0.02 --frames 8 --quiet -o brazilian.h5
            graincrack-post view "{FILE}" --quiet -o hostile.html
            graincrack-post view brazilian.h5 --quiet -o one.html
            graincrack-post view "{FILE}" brazilian.h5 --quiet -o two.html""")
        cls.pages = [cls.folder / f"{name}.html" for name in ("hostile", "one", "two")]
        if pictures := os.environ.get("GRAINCRACK_SCREENSHOTS"):
            for page in cls.pages:
                cls.browser(page, f"--screenshot={Path(pictures).resolve()}/{page.stem}.png", "--window-size=1100,1000", "--virtual-time-budget=20000")

    @classmethod
    def run_in_folder(cls, script):
        environment = {**os.environ, "PATH": f"{Path(sys.argv[1]).resolve()}:{os.environ['PATH']}"}
        return subprocess.run(["bash", "-euc", script], check=True, cwd=cls.folder, env=environment, capture_output=True, encoding="utf-8").stdout

    def segments(self, file, frame):
        """Half contacts that plot cracks draws red and black: strokes of the widths of cracks, of those on both sides of an open one the half."""
        self.run_in_folder(f'graincrack-post plot cracks "{file}" --frame {frame} --quiet -o map.svg')
        counts = {"tensile": -1.0, "shear": -1.0}  # less the stroke in the legend
        for width, red, path in re.findall(r'style="fill:none;stroke-width:([\d.]+);[^"]*;stroke:rgb\(([\d.]+)%,[^"]*" d="([^"]*)"',
                                           (self.folder / "map.svg").read_text()):
            mode = {"90.980392": "tensile", "0": "shear"}.get(red)
            if mode:
                counts[mode] += path.count("L") * {"6": 1, "3.3": 1, "4.2": 0.5, "2.31": 0.5}[width]
        return counts

    def logged(self, file):
        """Modes of the rows of the table of cracks that have lost half of their cohesion: the cracks of laws with friction in addition."""
        self.run_in_folder(f'graincrack-post cracks "{file}" --quiet -o cracks')
        head, *rows = [line.split("\t") for line in (self.folder / "cracks" / "cracks.tsv").read_text().splitlines()]
        return [row[head.index("mode")] for row in rows if row[head.index("time_damaged_50_s")]]

    def test_states_have_the_cracks_of_the_log_and_of_plot_cracks(self):
        for page, file in ((self.pages[0], FILE), (self.pages[1], "brazilian.h5")):
            found, console = self.browser.measured(page, 1100, MEASURE)
            self.assertEqual(console, [])
            states = [{key: int(value) for key, value in state[0].items()} for state in found["states"]]
            self.assertGreater(len(states), 8)
            self.assertGreater(states[-1]["tensile"] * states[-1]["shear"], 0)
            modes = self.logged(file)
            self.assertEqual([states[-1]["tensile"], states[-1]["shear"]], [modes.count("tensile"), modes.count("shear")])
            for state in states[-4:]:
                self.assertEqual(self.segments(file, state["frame"]), {"tensile": state["tensile"], "shear": state["shear"]}, (page, state))

    def test_keys_pointers_and_choices_change_what_is_seen(self):
        found, _ = self.browser.measured(self.pages[1], 1100, MEASURE)
        self.assertEqual(found["back"], found["states"][-2])
        self.assertAlmostEqual(found["zoom"], 1.25)
        self.assertAlmostEqual(found["whole"], 1)
        self.assertGreater(found["colours"], 5)
        self.assertGreater(found["stresses"], found["colours"])
        last = found["states"][-1][0]
        self.assertLess(sum(int(found["pair"][0][mode]) for mode in ("tensile", "shear")), int(last["tensile"]) + int(last["shear"]))
        self.assertRegex(found["contact"], r"(?s)^Contact \d+: [\w-]+.*end cracked in (tension|shear) at [\d.]+ MPa, \d+ % of the (peak|largest stress).*"
                                           r"Opening -?[\d.]+ and -?[\d.]+ µm, sliding -?[\d.]+ and -?[\d.]+ µm")

    def test_names_stay_text_and_no_page_is_wider_than_its_window(self):
        for page in self.pages:
            for width in (400, 1100):
                found, console = self.browser.measured(page, width, MEASURE)
                self.assertEqual(console, [], page)
                self.assertEqual(found["window"], width)
                self.assertLessEqual(found["width"], width, page)
                if width > 760:
                    self.assertLessEqual(found["bottom"], found["height"], page)
                self.assertEqual(found["tags"], 0)
                if page != self.pages[1]:
                    self.assertIn(NAME.replace("\\", ""), found["title"])
                    self.assertEqual(found["files"][0], FILE)

    def test_two_runs_have_one_slider(self):
        found, _ = self.browser.measured(self.pages[2], 1100, MEASURE)
        for side, alone in enumerate(self.pages[:2]):
            own = self.browser.measured(alone, 1100, MEASURE)[0]["states"]
            self.assertEqual([states[side] for states in found["states"]][-1], own[-1][0])
            self.assertEqual(len({states[side]["frame"] for states in found["states"]}), len(own))
        for file in (FILE, "brazilian.h5"):  # each counts its own cracks, and has a scale of its own
            self.assertRegex(found["legend"], re.escape(file) + r": [\w –-]+: \d+")
            self.assertRegex(found["legend"], re.escape(file) + r": −[\d.]+ to [\d.]+ MPa")


if __name__ == "__main__":
    skip_without("view_page", ("chromium", "chromium"))
    unittest.main(argv=sys.argv[:1])
