"""Opens reports in a browser, headless Chromium: on a screen, on a narrow one, and printed.

Usage: report_page_test.py BIN. Ends with 77, "skipped", and the reason, where chromium or pdftotext is not installed. A script at the end of a
copy of the page measures it and leaves what it found in the page, which --dump-dom prints; a policy in the head of the copy reports what the page
asks for outside itself. GRAINCRACK_SCREENSHOTS=FOLDER keeps pictures of the pages as a person sees them.
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

MEASURE = """<script>
for (const each of document.querySelectorAll("details")) each.open = true;
const page = document.documentElement, broken = [...document.images].filter(each => !each.naturalWidth).length;
parent.document.body.append(Object.assign(parent.document.createElement("pre"), {id: "measured", textContent: JSON.stringify({
  window: innerWidth, width: page.scrollWidth, images: document.images.length, broken})}));
</script>"""
# Two marks at opposite corners of each figure and of the first row of each table: where they are in a print, these are.
MARK = """<script>
const mark = (kind, each, i) => {
  each.style.position = "relative";
  for (const [end, corner] of [["A", "top: 0; left: 0"], ["B", "bottom: 0; right: 0"]]) {
    each.append(Object.assign(document.createElement("span"),
                              {textContent: `${kind}${end}${1000 + i}`,
                               style: `position: absolute; font-size: 3px; line-height: 1; white-space: nowrap; ${corner}`}));
  }
};
document.querySelectorAll("figure").forEach((each, i) => mark("FIG", each, i));
document.querySelectorAll("thead > tr > th:last-child").forEach((each, i) => mark("TAB", each, i));
</script>"""
A4 = (595, 842)  # points


class Printer(Browser):
    def printed(self, page):
        """Sizes of the pages of a print, and the marks on them: name to list of (page, xMin, yMin, xMax, yMax)."""
        copy, pdf = self.folder / "copy.html", self.folder / "print.pdf"
        copy.write_text(page.read_text().replace("</body>", MARK + "</body>"))
        self(copy, f"--print-to-pdf={pdf}", "--no-pdf-header-footer", "--virtual-time-budget=20000")
        boxes = subprocess.run(["pdftotext", "-bbox", pdf, "-"], check=True, capture_output=True, encoding="utf-8").stdout
        sizes, marks = [], {}
        for line in boxes.splitlines():
            if found := re.search(r'<page width="(\S+)" height="(\S+)"', line):
                sizes.append(tuple(float(each) for each in found.groups()))
            elif found := re.search(r'<word xMin="(\S+)" yMin="(\S+)" xMax="(\S+)" yMax="(\S+)">(.*)</word>', line):
                for name in re.findall(r"(?:FIG|TAB)[AB]1\d{3}", found[5]):
                    marks.setdefault(name, []).append((len(sizes), *(float(each) for each in found.groups()[:4])))
        return sizes, marks


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="graincrack-page."))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.browser = Printer(cls.folder)
        size = "--edge 4mm --material augig-granite-triangles --quiet"
        solve = "--material augig-granite-triangles --rate-tolerance 0.006 --quiet"
        script = f"""
            for seed in 1 2; do
                graincrack-mesh rectangle --width 20mm --height 40mm {size} --seed $seed -o $seed.h5
                graincrack-solve uniaxial $seed.h5 {solve} -o u$seed.h5
                graincrack-solve triaxial $seed.h5 --confining-pressure 8MPa {solve} -o t$seed.h5
            done
            graincrack-mesh disc --diameter 25mm {size} -o disc.h5
            graincrack-solve brazilian disc.h5 {solve} -o b1.h5
            graincrack-post report u?.h5 t?.h5 b1.h5 --material augig-granite-triangles --quiet -o several.html
            graincrack-mesh disc --diameter 25mm --material augig-granite-calibrated --quiet -o crystals.h5
            graincrack-solve brazilian crystals.h5 --material augig-granite-calibrated --rate-tolerance 0.02 --quiet -o b2.h5
            graincrack-post report b2.h5 --quiet -o crystals.html  # has the widest table, with fourteen classes of contacts
            graincrack-post report u1.h5 --quiet -o one.html"""
        subprocess.run(["bash", "-euc", script], check=True, cwd=cls.folder, env={**os.environ, "PATH": f"{sys.argv[1]}:{os.environ['PATH']}"})
        cls.reports = [cls.folder / f"{name}.html" for name in ("several", "one", "crystals")]
        if pictures := os.environ.get("GRAINCRACK_SCREENSHOTS"):
            for page in cls.reports:
                for width in (400, 1200):
                    cls.browser(page, f"--screenshot={Path(pictures).resolve()}/{page.stem}-{width}.png", f"--window-size={width},6000")
                cls.browser(page, f"--print-to-pdf={Path(pictures).resolve()}/{page.stem}.pdf", "--no-pdf-header-footer", "--virtual-time-budget=20000")

    def test_no_report_is_wider_than_its_window_or_writes_to_the_console_or_asks_for_another_file(self):
        for page in self.reports:
            for width in (400, 800, 1200):
                found, console = self.browser.measured(page, width, MEASURE)
                self.assertEqual(found["window"], width)
                self.assertLessEqual(found["width"], width, page)
                self.assertEqual(console, [], page)
                self.assertGreater(found["images"], 3, page)
                self.assertEqual(found["broken"], 0, page)
            # Nor when a link is followed.
            for link in re.findall(r"\b(?:src|href|action|data|srcset)\s*=\s*\"([^\"]*)", page.read_text()):
                self.assertRegex(link, r"^(data:image/(png|svg\+xml);base64,|#)", page)

    def test_a_print_on_a4_cuts_no_figure_and_no_table(self):
        for page in self.reports:
            sizes, marks = self.browser.printed(page)
            for width, height in sizes:
                self.assertAlmostEqual(width, A4[0], delta=1)
                self.assertAlmostEqual(height, A4[1], delta=1)
            n_figures = page.read_text().count("<figure")
            n_tables = page.read_text().count("<thead")
            self.assertEqual(sum(name.startswith("FIGA") for name in marks), n_figures)
            self.assertEqual(sum(name.startswith("TABB") for name in marks), n_tables)
            for name, places in marks.items():
                for _, left, top, right, bottom in places:
                    self.assertTrue(30 < left < right < A4[0] - 30 and 30 < top < bottom < A4[1] - 30, f"{page}: {name} in the margin: {places}")
            for i in range(n_figures):
                (first, *begin), (last, *end) = marks[f"FIGA{1000 + i}"][0], marks[f"FIGB{1000 + i}"][0]
                self.assertEqual(first, last, f"{page}: figure {i} is cut")
                self.assertLess(begin[1] + 60, end[3], f"{page}: figure {i}")
                self.assertLess(begin[0] + 60, end[2], f"{page}: figure {i}")

    def test_what_is_wrong_is_seen(self):
        page = self.folder / "wrong.html"
        figure = '<figure style="break-inside: auto; height: 400mm; max-width: none; width: 300mm">tall</figure>'
        page.write_text(self.reports[1].read_text().replace("</body>", f'{figure}<img src="https://graincrack.invalid/a.png">'
                                                                       "<script>nothing.there();</script></body>"))
        found, console = self.browser.measured(page, 400, MEASURE)
        self.assertGreater(found["width"], 400)
        self.assertEqual(found["broken"], 1)
        self.assertIn("Content Security Policy", "".join(console))
        self.assertIn("nothing is not defined", "".join(console))
        _, marks = self.browser.printed(page)
        last = 1000 + page.read_text().count("<figure") - 1
        self.assertNotEqual(marks[f"FIGA{last}"][0][0], marks.get(f"FIGB{last}", [[0]])[0][0])


if __name__ == "__main__":
    skip_without("report_page", ("chromium", "chromium"), ("pdftotext", "poppler-utils"))
    unittest.main(argv=sys.argv[:1])
