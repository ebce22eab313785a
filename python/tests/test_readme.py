# SPDX-License-Identifier: MIT
"""What the README shows of Python runs."""
import os
import pathlib
import re
import tempfile
import unittest

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"


class Readme(unittest.TestCase):
    def test_its_python_runs(self):
        blocks = re.findall(r"^```python\n(.*?)^```", README.read_text(encoding="utf-8"),
                            re.MULTILINE | re.DOTALL)
        self.assertGreaterEqual(len(blocks), 1)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for block in blocks:
                    names = {}
                    exec(compile(block, str(README), "exec"), names)  # pylint: disable=exec-used
                self.assertTrue(pathlib.Path("bust.png").stat().st_size > 1000)
                self.assertEqual(list(names["classes"]), [names["penumbra"].PENUMBRA,
                                                          names["penumbra"].PENUMBRA])
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
