"""Headless Chromium for tests of pages: what a script at the end of a copy of a page found, and what the console says."""

import html
import json
import re
import shutil
import subprocess
import sys

POLICY = """<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">"""


class Browser:
    def __init__(self, folder):
        self.folder = folder

    def __call__(self, page, *options):
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--no-first-run",
                   f"--user-data-dir={self.folder}/profile", "--window-size=1300,900", "--enable-logging=stderr", *options, page.as_uri()]
        done = subprocess.run(command, check=True, capture_output=True, encoding="utf-8", timeout=120)
        return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]

    def measured(self, page, width, script):
        """What a script left in the element with the id `measured` of the frame around the page, as JSON, and what the console says. A policy in
        the head of the copy reports what the page asks for outside itself."""
        copy = self.folder / "copy.html"
        text = page.read_text().replace('<meta charset="utf-8">', '<meta charset="utf-8">' + POLICY, 1)
        copy.write_text(text.replace("</body>", script + "</body>"))
        frame = self.folder / "frame.html"  # a window of Chromium has at least 500 pixels, a frame in it as few as wanted
        frame.write_text(f'<iframe src="{copy.name}" style="border: 0; width: {width}px; height: 900px"></iframe>')
        dom, console = self(frame, "--dump-dom", "--allow-file-access-from-files", "--virtual-time-budget=20000")
        return json.loads(html.unescape(re.search(r'<pre id="measured">(.*?)</pre>', dom, re.S)[1])), console


def skip_without(test, *programs):
    """Ends with 77, "skipped", where a program is not installed. Each has the name of its package beside it."""
    for program, package in programs:
        if not shutil.which(program):
            print(f"{test}: skipped: {program} is not here (package {package})")
            sys.exit(77)
