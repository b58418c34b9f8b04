#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scripts/measure: what it puts into documents, and that it leaves them alone when it fails."""

import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

MEASURE = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "measure"

# Stands for the program: counts its calls, prints its arguments, draws, or fails.
PROGRAM = """#!/bin/sh
[ "$1" = --version ] && { echo cigsim 1.2; exit 0; }
[ "$1" = fail ] && exit 2
echo call >> "$(dirname "$0")/calls"
echo "arguments: $1 $2"
if [ "$3" = --out ]; then echo picture > "$4/a.svg"; echo "$4/a.svg written"; fi
[ "$1" = differs ] && exit 1
exit 0
"""

MARK = "<!-- measured\n{}\n-->\nold\n<!-- end of measured -->\n"


class Measure(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)
        self.program = self.folder / "program"
        self.program.write_text(PROGRAM)
        self.program.chmod(self.program.stat().st_mode | stat.S_IXUSR)
        self.document = self.folder / "page.md"

    def tearDown(self):
        self.scratch.cleanup()

    def measure(self, text):
        self.document.write_text(text)
        return subprocess.run([str(MEASURE), "--cigsim", str(self.program), str(self.document)],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def test_output_and_command_stand_between_the_marks(self):
        text = "before\n" + MARK.format("cigsim sweep 'two words'") + "after\n"
        self.assertEqual(self.measure(text).returncode, 0)
        got = self.document.read_text()
        self.assertTrue(got.startswith("before\n") and got.endswith("after\n"))
        self.assertIn("    cigsim sweep 'two words'\n", got)
        self.assertIn("```text\narguments: sweep two words\n```", got)
        self.assertNotIn("old", got)
        self.assertEqual(self.measure(got).returncode, 0)
        self.assertEqual(self.document.read_text(), got, "a second time changes nothing")

    def test_pictures_are_taken_and_folders_are_not_told(self):
        text = MARK.format("cigsim draw x --out {out}\na.svg -> pictures/b.svg")
        self.assertEqual(self.measure(text).returncode, 0)
        self.assertEqual((self.folder / "pictures/b.svg").read_text(), "picture\n")
        self.assertNotIn("written", self.document.read_text())
        self.assertIn("    cigsim draw x\n", self.document.read_text())

    def test_a_check_that_does_not_hold_is_told(self):
        self.assertEqual(self.measure(MARK.format("cigsim differs a")).returncode, 0)
        self.assertIn("arguments: differs a", self.document.read_text())

    def test_the_host_is_named(self):
        self.assertEqual(self.measure(MARK.format("host")).returncode, 0)
        self.assertIn("with cigsim 1.2 on ", self.document.read_text())

    def test_nothing_is_written_when_a_command_fails(self):
        for bad in ("cigsim fail", "rm -r x", "cigsim draw x --out {out}\nb.svg -> b.svg"):
            text = MARK.format("cigsim good 1") + MARK.format(bad)
            done = self.measure(text)
            self.assertEqual(done.returncode, 2, bad)
            self.assertTrue(done.stderr.startswith("measure: "), done.stderr)
            self.assertEqual(self.document.read_text(), text)

    def test_a_mark_without_an_end_is_refused(self):
        text = MARK.format("cigsim a") + "<!-- measured\ncigsim b\n-->\n"
        self.assertEqual(self.measure(text).returncode, 2)
        self.assertEqual(self.document.read_text(), text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
