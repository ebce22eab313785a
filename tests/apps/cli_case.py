# SPDX-License-Identifier: MIT
"""What tests of the command line share: a folder of their own, a small scene, runs of the program."""
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

SMALL = ["--size", "24x24", "--shadow-samples", "4"]

NFF = """v
from 0 -6 3
at 0 0 0.5
up 0 0 1
angle 40
hither 0.1
resolution 24 24
l 3 -2 5
b 0.1 0.2 0.3
f 0.8 0.7 0.6 0.8 0 0 0 0
s 0 0 1 1
p 4
-5 -5 0
5 -5 0
5 5 0
-5 5 0
"""


def exr(pixels, names=("B", "G", "R")):
    """An uncompressed one-line OpenEXR file of these rows of floats, one a channel."""
    width = len(pixels[0])

    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value

    channels = b"".join(n.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for n in names) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, 0)
    head = struct.pack("<ii", 20000630, 2)
    head += attribute(b"channels", b"chlist", channels)
    head += attribute(b"compression", b"compression", b"\0")
    head += attribute(b"dataWindow", b"box2i", window) + attribute(b"displayWindow", b"box2i", window)
    head += attribute(b"lineOrder", b"lineOrder", b"\0")
    head += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
    head += attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0))
    head += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0"
    line = b"".join(struct.pack(f"<{width}f", *row) for row in pixels)
    return head + struct.pack("<Q", len(head) + 8) + struct.pack("<ii", 0, len(line)) + line


class CliTest(unittest.TestCase):
    program = ""  # path, given to `main`

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="penumbra-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "small.nff").write_text(NFF)

    def run_program(self, *arguments, **more):
        return subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                              timeout=300, check=False, **more)

    def succeed(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stderr}")
        return result

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def fail_with(self, code, *arguments, says=""):
        before = self.files()
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, code, f"{arguments}\n{result.stderr}")
        if says:
            self.assertRegex(result.stderr, says)
        self.assertNotRegex(result.stderr, "terminate|runtime error|Sanitizer")
        self.assertEqual(self.files(), before, f"{arguments} left a file")
        return result


def main():
    """For `FILE.py PROGRAM [TEST...]`."""
    CliTest.program = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(module="__main__")
