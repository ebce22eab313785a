# SPDX-License-Identifier: MIT
"""What setuptools packs as the source is all that the module is built of."""
import importlib.util
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]


@unittest.skipUnless(importlib.util.find_spec("setuptools") and shutil.which("ninja"),
                     "needs setuptools and ninja")
class SourcePackage(unittest.TestCase):
    def test_cmake_finds_every_source_of_the_module_in_it(self):
        def run(folder, *words):
            result = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            # A copy, since setup.py builds in the folder that it lies in.
            others = shutil.ignore_patterns("build", "build-*", "out", ".*", "__pycache__")
            shutil.copytree(SOURCE, folder / "source", ignore=others)
            run(folder / "source", sys.executable, "setup.py", "-q", "sdist", "--formats=tar",
                "-d", str(folder))
            package, = folder.glob("*.tar")
            with tarfile.open(package) as tar:
                tar.extractall(folder / "unpacked")
            unpacked, = (folder / "unpacked").iterdir()
            self.assertTrue((unpacked / "python" / "penumbra" / "_penumbra.pyi").is_file())
            run(unpacked, "cmake", "-G", "Ninja", "-S", ".", "-B", "build",
                "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
                f"-DPython3_EXECUTABLE={sys.executable}")
            run(unpacked, "cmake", "--build", "build", "--target", "penumbra_python", "--", "-n")


if __name__ == "__main__":
    unittest.main()
