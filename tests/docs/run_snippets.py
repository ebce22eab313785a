# SPDX-License-Identifier: MIT
"""run_snippets.py BUILD COMPILER C_COMPILER [TEST...]: every code block of README.md and docs/library.md does what it
shows.

Blocks of C++ of one page are, one after the other, the body of one program, and so are those of C and of Python;
CMake's is that of a project; commands are run where the files are that they name. All against what
`cmake --install BUILD` puts down.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from pages_commands import NOT_RUN, make_files, quick

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "docs" / "library.md"]
KNOWN = {"cpp", "c", "python", "cmake", "sh", "text"}  # the last is no code
# What blocks leave to the reader.
WAYS_IN = {name: "".join(f"#include <{header}>\n" for header in headers) for name, headers in (
    ("cpp", ("array", "cassert", "cstdint", "cstdio", "iterator", "vector")), ("c", ("assert.h", "stdio.h")))}
BODY = {"cpp": "int main() try {\n%s\n} catch (const penumbra::Error& error) {\n  std::puts(error.what());\n"
               "  return 1;\n}\n",
        "c": "int main(void) {\n%s\nreturn 0;\n}\n"}


def blocks(page):
    """(language, line, text) of all; '' is the language of those without one."""
    text = page.read_text(encoding="utf-8")
    for match in re.finditer(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield match[1], text[:match.start()].count("\n") + 2, match[2]


def of_language(page, language):
    return [(line, text) for name, line, text in blocks(page) if name == language]


class Snippets(unittest.TestCase):
    build = compiler = c_compiler = ""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="penumbra-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.prefix = cls.folder / "prefix"
        cls.environment = dict(os.environ)
        cls.run_there("cmake", "--install", cls.build, "--prefix", cls.prefix)
        libraries = next(cls.prefix.glob("lib/**/libpenumbra.so")).parent
        cls.environment.update(
            PATH=f"{cls.prefix / 'bin'}:{os.environ['PATH']}", LD_LIBRARY_PATH=str(libraries),
            PYTHONPATH=str(next(cls.prefix.glob("lib/**/penumbra/__init__.py")).parents[1]),
            LIBRARY_PATH=str(libraries), CPATH=str(cls.prefix / "include"),
            PKG_CONFIG_PATH=str(libraries / "pkgconfig"))

    @classmethod
    def run_there(cls, *command, says=""):
        result = subprocess.run([str(word) for word in command], cwd=cls.folder, env=cls.environment, timeout=300,
                                capture_output=True, text=True, check=False)
        if result.returncode:
            raise AssertionError(f"{says or command}: {result.returncode}\n{result.stdout}\n{result.stderr}")
        return result.stdout

    def program(self, page, language):
        """Source of all blocks of a page, whose errors name the page's lines. Includes go to the top."""
        found = of_language(page, language)
        self.assertTrue(found, f"{page.name} has no {language}")
        above, body = WAYS_IN[language], ""
        for line, text in found:
            above += "".join(f"{include}\n" for include in re.findall(r"^#include.*$", text, re.MULTILINE))
            body += f'#line {line} "{page.name}"\n' + re.sub(r"^#include.*$", "", text, flags=re.MULTILINE)
        return above + BODY[language] % body

    def compile_and_run(self, page, language, *command):
        source = self.folder / f"{page.stem}.{language}"
        source.write_text(self.program(page, language))
        self.run_there(*command, source.name, "-o", source.stem + language, "-lpenumbra", "-lpenumbra_render")
        return self.run_there(f"./{source.stem + language}", says=f"{page.name}'s {language}")

    def test_cpp(self):
        make_files(self.folder, self.run_there)
        for page in PAGES:
            self.compile_and_run(page, "cpp", self.compiler, "-std=c++20", "-Wall", "-Wextra")
        self.assertTrue((self.folder / "bust.png").exists() and (self.folder / "balls.png").exists())

    def test_c(self):
        printed = [self.compile_and_run(page, "c", self.c_compiler, "-std=c99", "-Wall", "-Wextra") for page in PAGES]
        self.assertEqual(printed[0], "")  # no error
        self.assertIn("penumbra_remove_geometry: ", printed[1])

    def test_python(self):
        for page in PAGES:
            source = self.folder / f"{page.stem}.py"
            source.write_text("\n".join(text for _, text in of_language(page, "python")))
            self.run_there(sys.executable, source, says=f"{page.name}'s Python")

    def test_cmake(self):
        """One after the other: each is configured in a project that has the targets and sources which it names."""
        for number, (page, text) in enumerate((page, text) for page in PAGES
                                              for _, text in of_language(page, "cmake")):
            project = self.folder / f"project{number}"
            project.mkdir()
            (project / "mine.cpp").write_text("#include <penumbra/penumbra.h>\nint main() { penumbra::Occluders o; }\n")
            named = set(re.findall(r"target_link_libraries\((\w+)", text))
            named -= set(re.findall(r"add_executable\((\w+)", text))
            before = "".join(f"add_executable({name} mine.cpp)\n" for name in sorted(named))
            (project / "CMakeLists.txt").write_text(
                f"cmake_minimum_required(VERSION 3.23)\nproject(it LANGUAGES C CXX)\n{before}{text}")
            self.run_there("cmake", "-S", project, "-B", project / "build", "-G", "Ninja",
                           f"-DCMAKE_PREFIX_PATH={self.prefix}", says=f"{page.name}'s CMake")
            self.run_there("cmake", "--build", project / "build", says=f"{page.name}'s CMake")

    def test_commands(self):
        make_files(self.folder, self.run_there)
        (self.folder / "mine.cpp").write_text("#include <penumbra/penumbra.h>\nint main() { penumbra::Occluders(); }\n")
        (self.folder / "mine.c").write_text(self.program(PAGES[1], "c"))
        not_run = set(NOT_RUN)
        for page in PAGES:
            for line, text in [*of_language(page, ""), *of_language(page, "sh")]:
                for offset, command in enumerate(text.splitlines()):
                    command = re.sub(r"\s+#.*", "", command).strip()
                    with self.subTest(page=page.name, line=line + offset, command=command):
                        if command in NOT_RUN:
                            not_run.discard(command)
                        elif command:
                            self.run_there("bash", "-ec", quick(command), says=quick(command))
        self.assertEqual(not_run, set(), "no page has these any more")

    def test_every_block_is_of_a_kind_that_is_run(self):
        for page in PAGES:
            self.assertLessEqual({name for name, _, _ in blocks(page)} - {""}, KNOWN, page.name)


if __name__ == "__main__":
    Snippets.build = pathlib.Path(sys.argv.pop(1)).resolve()
    Snippets.compiler, Snippets.c_compiler = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
