# SPDX-License-Identifier: MIT
"""install_test.py BUILD COMPILER [TEST...]: what `cmake --install BUILD` puts down is enough for an outside project,
wherever it is moved to."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
# Names of no variable through which anything but the prefix could be found.
ENVIRONMENT = {name: os.environ[name] for name in ("PATH", "HOME", "TMPDIR") if name in os.environ}


def run(*command, **more):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=False,
                            **{"env": ENVIRONMENT, **more})
    if result.returncode:
        raise AssertionError(f"{command}: {result.returncode}\n{result.stdout}\n{result.stderr}")
    return result.stdout


class InstallTest(unittest.TestCase):
    build = compiler = ""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="penumbra-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        first = cls.folder / "first"
        run("cmake", "--install", cls.build, "--prefix", first)
        cls.prefix = first.rename(cls.folder / "moved")
        cls.include = cls.prefix / "include"
        cls.libraries = sorted(cls.prefix.glob("lib/**/libpenumbra*.so.*.*.*"))

    def check_square_shadow(self, printed):
        """Umbra below the middle, soft below the edge, lit far off; and an error."""
        umbra, soft, lit, refused = printed.splitlines()
        self.assertEqual((umbra, lit), ("2 0", "0 1"))
        self.assertRegex(soft, r"^1 0\.\d+$")
        self.assertRegex(refused, "^refused: .*fewer than 3 corners")

    def test_a_cmake_project_finds_it_and_gets_the_fractions_of_the_renderer(self):
        build = self.folder / "consumer"
        run("cmake", "-S", HERE, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
            "-DCMAKE_BUILD_TYPE=Debug", f"-DCMAKE_CXX_COMPILER={self.compiler}")
        run("cmake", "--build", build)
        self.check_square_shadow(run(build / "square_shadow"))
        self.assertEqual(run(build / "square_shadow_c").splitlines()[:3], run(build / "square_shadow").splitlines()[:3])
        for scene in ("bust", "balls:2"):
            self.assertIn(" 0 differ", run(build / "as_rendered", scene))

    def test_the_examples_are_outside_projects_too(self):
        for name in ("c_api", "embree_renderer"):
            build = self.folder / name
            run("cmake", "-S", self.prefix / "share/doc/penumbra/examples" / name, "-B", build, "-G", "Ninja",
                f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_CXX_COMPILER={self.compiler}")
            run("cmake", "--build", build)
        self.assertIn("in umbra for sure", run(self.folder / "c_api" / "c_api"))
        run(self.prefix / "bin/penumbra", "generate", "bust", "-o", self.folder / "bust.ply")
        self.assertIn("times as fast", run(self.folder / "embree_renderer" / "embree_renderer", "bust.ply", "64",
                                           cwd=self.folder))

    @unittest.skipUnless(shutil.which("pkg-config"), "there is no pkg-config")
    def test_pkg_config_says_how_to_compile(self):
        pkgconfig = next(self.prefix.glob("lib/**/penumbra.pc")).parent
        flags = run("pkg-config", "--cflags", "--libs", "penumbra",
                    env={**ENVIRONMENT, "PKG_CONFIG_PATH": str(pkgconfig)}).split()
        program = self.folder / "by_pkg_config"
        run(self.compiler, "-std=c++20", HERE / "square_shadow.cpp", "-o", program, *flags)
        library_path = {**ENVIRONMENT, "LD_LIBRARY_PATH": str(pkgconfig.parent)}
        self.check_square_shadow(run(program, env=library_path))
        self.assertIn("-lpenumbra_render", run("pkg-config", "--libs", "penumbra-render", env={
            **ENVIRONMENT, "PKG_CONFIG_PATH": str(pkgconfig)}))

    def test_every_header_compiles_alone(self):
        headers = sorted(self.include.glob("**/*.h"))
        self.assertGreater(len(headers), 10)
        sources = []
        for number, header in enumerate(headers):
            sources.append(self.folder / f"alone{number}.cpp")
            sources[-1].write_text(f"#include <{header.relative_to(self.include)}>\n")
        run(self.compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", f"-I{self.include}", *sources)

    def test_headers_name_no_other_library(self):
        for header in self.include.glob("**/*.h"):
            for name in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)', header.read_text(), re.MULTILINE):
                is_standard = re.fullmatch(r"[a-z_]+(\.h)?", name)
                self.assertTrue(is_standard or (self.include / name).exists(), f"{header}: {name}")

    def test_libraries_show_nothing_of_other_libraries(self):
        self.assertEqual(len(self.libraries), 2)
        for library in self.libraries:
            for line in run("nm", "-D", "--defined-only", library).splitlines():
                name = line.split()[-1].split("@")[0]
                self.assertRegex(name, r"^(penumbra_|_Z(T[ISTV]|GV)?NK?8penumbra)", library)

    def test_nothing_names_the_folders_it_came_from(self):
        told = [path for path in self.prefix.glob("lib/**/*") if path.suffix in {".cmake", ".pc"}]
        self.assertGreater(len(told), 5)
        for path in told:
            for folder in (self.folder / "first", HERE.parent.parent):
                self.assertNotIn(str(folder), path.read_text(), path)
        for library in self.libraries:
            self.assertNotIn(str(self.build), run("readelf", "-d", library))

    def test_program_manual_and_completions_are_there(self):
        version = run(self.prefix / "bin/penumbra", "--version")
        self.assertIn(version.split()[1], (self.include / "penumbra/version.h").read_text())
        pages = {path.name for path in (self.prefix / "share/man/man1").iterdir()}
        self.assertLessEqual({"penumbra.1", "penumbra-render.1"}, pages)
        for path in ("bash-completion/completions/penumbra", "zsh/site-functions/_penumbra",
                     "fish/vendor_completions.d/penumbra.fish", "doc/penumbra/README.md", "doc/penumbra/copyright"):
            self.assertTrue((self.prefix / "share" / path).is_file(), path)


if __name__ == "__main__":
    InstallTest.build = pathlib.Path(sys.argv.pop(1)).resolve()
    InstallTest.compiler = sys.argv.pop(1)
    unittest.main()
