#!/usr/bin/env python3
"""Shows that a row of tests/end_to_end/*.toml fails where the value of a key is wrong, for each key and for what holds without a key.

Usage: wrong_rows.py END_TO_END_TESTS

Prints a table: key, wrong value, and what the program END_TO_END_TESTS said; ends with 1 if it passed, or if a right row failed.
"""
import os
import re
import subprocess
import sys
import tempfile

# Keys of a right row; its command needs no program.
RIGHT = {
    "requires": '"A row"', "command": "'echo out; echo err >&2; touch made'", "exit": "0", "stdout": '"out"', "stderr": '["e", "rr"]',
    "stdout_is": r'"out\n"', "stderr_is": r'"err\n"', "stdout_lines": "1", "stderr_lines": "1", "stdout_lacks": '"x"', "stderr_lacks": '["x"]',
    "leaves": '"made"', "only_where": '"true"',
}
REFUSED = {"requires": '"A row"', "command": "'echo graincrack-mesh: no >&2; exit 3'", "exit": "3", "stderr": '"no"'}
EACH = {"requires": '"A row"', "command": "'echo {each}'", "for_each": '["a", "b"]'}
PLACES = {"requires": '"A row"', "command": "'echo {word}'", "for_each": r'[{ word = "a", stdout_is = "a\n" }]'}
THEN = {"requires": '"A row"', "command": '"true"', "then": r"""[{ command = "echo a", stdout_is = "a\n" }]"""}
MESHED = {"requires": '"A row"', "files": '["disc.h5"]', "command": """'same "$(digest disc.h5)" "$(digest disc.h5)"'"""}
TABLE = {"requires": '"A row"', "command": """'near "$(printf "a\\tb\\n1\\t2\\n" | cell b)" 2 0.1'"""}
# Row, key, wrong values; None: without the key.
WRONG = [
    (RIGHT, "requires", ['""', None, "3"]),
    (RIGHT, "command", ["'false; echo out; echo err >&2; touch made'", "'echo out; touch made'", None, "3"]),
    (RIGHT, "exit", ["1", '"0"']),
    (RIGHT, "stdout", ['"in"', '["out", "in"]', "3"]),
    (RIGHT, "stderr", ['"in"', '["err", "in"]', "3"]),
    (RIGHT, "stdout_is", ['"out"', '""', "3"]),
    (RIGHT, "stderr_is", ['"err"', '""', "3"]),
    (RIGHT, "stdout_lines", ["2", '"1"']),
    (RIGHT, "stderr_lines", ["2", '"1"']),
    (RIGHT, "stdout_lacks", ['"out"', '["x", "u"]', "3"]),
    (RIGHT, "stderr_lacks", ['"err"', '["x", "r"]', "3"]),
    (RIGHT, "leaves", ['"other"', '""', '"made other"', "3"]),
    (RIGHT, "only_where", ['"no_such_command"', "3"]),
    (RIGHT, "files", ['["nothing.h5"]', '"nothing.h5"', "[3]"]),
    (RIGHT, "stdot", ['"out"']),
    (REFUSED, "exit", ["2", None]),
    (REFUSED, "stderr", ['"yes"']),
    (REFUSED, "command", ["'echo no >&2; exit 3'", "'echo graincrack-mesh: no >&2; echo more >&2; exit 3'",
                          "'echo graincrack-mesh: no >&2; echo out; exit 3'", "'echo graincrack-mesh: no >&2; touch made; exit 3'"]),
    (EACH, "for_each", ["[]", '"a"', "[3]", '[{ other = "a" }]', r'[{ each = "a", stdout_is = "b\n" }]', r'[{ each = "a", stdot_is = "a\n" }]']),
    (EACH, "command", ["'echo'"]),
    (PLACES, "for_each", [r'[{ word = "a", stdout_is = "b\n" }]', '[{ word = "a", exit = 1 }]', "[{ word = 3 }]"]),
    (THEN, "then", [r'[{ command = "echo a", stdout_is = "b\n" }]', '[{ command = "false" }]', '[{ comand = "true" }]', '{ command = "true" }', "[3]"]),
    (TABLE, "command", ["""'near "$(printf "a\\tb\\n1\\t2\\n" | cell b)" 3 0.1'""", """'near "$(printf "a\\tb\\n1\\t2\\n" | cell c)" 2 0.1'"""]),
    (MESHED, "command", ["""'graincrack-mesh disc --diameter 20mm --grains 60 --seed 2 --quiet -o b.h5; same "$(digest disc.h5)" "$(digest b.h5)"'""",
                         """'same "$(digest none.h5)" "$(digest none.h5)"'"""]),
    (MESHED, "files", ["[]"]),
]


def said(program, rows, tables="case"):
    """What the program says of a row where it fails; "" where it passes. A row that is skipped passes."""
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/wrong.toml", "w") as file:
            file.write(f"[[{tables}]]\n" + "".join(f"{key} = {value}\n" for key, value in rows.items() if value is not None))
        done = subprocess.run([program, "--gtest_filter=Commands.*"], capture_output=True, text=True, env={**os.environ, "GRAINCRACK_ROWS": folder})
    lines = (done.stdout + done.stderr).splitlines()
    if done.returncode == 0 and any("[  PASSED  ] 1 test" in line or "[  SKIPPED ] 1 test" in line for line in lines):
        return ""
    own = [line.strip() for line in lines if line.strip() and not re.match(r"\[|Note:|Running|.*: Failure|\d+ FAILED", line.strip())]
    return "; ".join(own)[:160] or f"exit code {done.returncode}"


def main():
    program, broken = sys.argv[1], 0
    for row in (RIGHT, REFUSED, EACH, PLACES, THEN, TABLE, MESHED):
        answer = said(program, row)
        broken += answer != ""
        print(f"| right row | {row['command']} | {answer or 'passes'} |")
    for row, key, values in WRONG:
        for value in values:
            answer = said(program, {**row, key: value})
            broken += answer == ""
            print(f"| {key} | {'missing' if value is None else value} | {answer or 'PASSES'} |".replace("\n", " "))
    answer = said(program, RIGHT, "cases")
    broken += answer == ""
    print(f"| another table than [[case]] | [[cases]] | {answer or 'PASSES'} |")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
