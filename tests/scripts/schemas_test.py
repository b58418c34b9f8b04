#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What experiments write fits the schemas of docs/schemas, and is the same for the same seed but for
what depends on the computer. Takes the program as its argument."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ImportError:
    print("skipped: the Python package jsonschema (Debian's python3-jsonschema) is missing")
    sys.exit(77)

SCHEMAS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "schemas"
CIGSIM = sys.argv.pop(1)

EXPERIMENTS = {
    "economies": ["experiment", "economies", "--quick"],
    "growth": ["experiment", "growth", "--quick"],
    "stability": ["stability", "--trials", "1", "--part", "decisions", "--part", "envelope",
                  "--part", "flicker", "--part", "accumulation", "--part", "published"],
    "tradeoff": ["tradeoff", "--path", "builtin", "--frames", "2", "--raster", "48x48", "--rounds",
                 "1", "--levels", "functional,timed"],
}


def without_host(value):
    """The figures without those of the computer, which stand under keys named host."""
    if isinstance(value, dict):
        return {k: without_host(v) for k, v in value.items() if k != "host"}
    if isinstance(value, list):
        return [without_host(v) for v in value]
    return value


class Schemas(unittest.TestCase):
    def figures(self, name, *more):
        done = subprocess.run([CIGSIM] + EXPERIMENTS[name] + ["--seed", "7", "--json", *more],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def written(self, name, schema):
        """The figures; beside them in a folder stand the same, with the names of the drawings."""
        with tempfile.TemporaryDirectory() as folder:
            figures = self.figures(name, "--out", folder)
            files = {f.name for f in pathlib.Path(folder).iterdir()}
            written = json.loads((pathlib.Path(folder) / f"{name}.json").read_text())
        jsonschema.validate(written, schema)
        self.assertEqual(files, {f"{name}.json", *written["plots"]})
        self.assertGreater(len(files), 1)
        self.assertEqual({k: v for k, v in written.items() if k != "plots"}, figures)
        return figures

    def check(self, name):
        schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        figures = self.written(name, schema)
        jsonschema.validate(figures, schema)
        self.assertEqual(figures["seed"], 7)
        self.assertEqual(without_host(figures), without_host(self.figures(name)))
        # The schema can refuse: a key too many, and each key too few.
        strange = copy.deepcopy(figures)
        strange["strange"] = 1
        for bad in [strange] + [{k: v for k, v in figures.items() if k != key}
                                for key in ("experiment", "seed", "host", "versions")]:
            with self.assertRaises(jsonschema.ValidationError):
                jsonschema.validate(bad, schema)

    def test_every_schema_has_an_experiment(self):
        self.assertEqual(sorted(f.name for f in SCHEMAS.glob("*.json")),
                         sorted(f"{name}.schema.json" for name in EXPERIMENTS))


for experiment in EXPERIMENTS:
    setattr(Schemas, f"test_{experiment}", lambda self, name=experiment: self.check(name))

if __name__ == "__main__":
    unittest.main(verbosity=2)
