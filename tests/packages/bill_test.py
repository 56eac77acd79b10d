#!/usr/bin/env python3
"""The bill of materials of a build: complete for what the program is known to need, and refused without a build.

usage: bill_test.py BUILD
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "packaging/sbom.py"
BUILD = sys.argv.pop()


def run(*arguments):
    return subprocess.run([sys.executable, SCRIPT, *map(str, arguments)], capture_output=True, text=True, check=False)


class Bill(unittest.TestCase):
    def test_names_libraries_headers_and_bundled_packages(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "bill.json"
            self.assertEqual(run(BUILD, "--out", file).returncode, 0)
            bill = json.loads(file.read_text(encoding="utf-8"))
        self.assertEqual((bill["bomFormat"], bill["specVersion"]), ("CycloneDX", "1.5"))
        scopes = {one["name"]: one["scope"] for one in bill["components"]}
        for name in ("libsimbody3.7", "libfcl0.7", "libccd2", "libhdf5-103-1", "libtinyxml2-9", "zlib1g", "three", "uplot"):
            self.assertEqual(scopes.get(name), "required", name)
        for name in ("libeigen3-dev", "libcgal-dev", "libcli11-dev", "nlohmann-json3-dev"):
            self.assertEqual(scopes.get(name), "optional", name)
        self.assertNotIn("libgtest-dev", scopes)
        for one in bill["components"]:
            self.assertTrue(one["version"] and one["purl"] and one["licenses"], one["name"])
        listed = [one["bom-ref"] for one in bill["components"]]
        self.assertEqual(len(set(listed)), len(listed))
        self.assertEqual(bill["dependencies"][0]["dependsOn"], listed)

    def test_is_refused_without_a_build(self):
        with tempfile.TemporaryDirectory() as folder:
            refused = run(folder)
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"{folder} holds no finished build", refused.stderr)


if __name__ == "__main__":
    unittest.main()
