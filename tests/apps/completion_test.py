# SPDX-License-Identifier: MIT
"""completion_test.py PROGRAM: what shells offer to type next, and the manual pages, say what the program takes."""
import os
import re
import shutil
import subprocess
import unittest

import cli_case

# Completes the line $2, typed by somebody whose `penumbra` is $1, and prints what is offered.
BASH = r"""
penumbra() { "$program" "$@"; }
program=$1
source <("$program" completion bash)
COMP_LINE=$2 COMP_POINT=${#2}
_penumbra penumbra
printf '%s\n' "${COMPREPLY[@]}"
"""


class Completion(cli_case.CliTest):
    def completed(self, line):
        result = subprocess.run(["bash", "--norc", "-c", BASH, "bash", self.program, line], cwd=self.folder,
                                capture_output=True, text=True, timeout=60, check=True)
        self.assertEqual(result.stderr, "")
        return result.stdout.split()

    def help_of(self, *command):
        return self.succeed(*command, "--help").stdout

    def commands(self):
        listed = self.help_of().split("Subcommands:")[1].split("Examples:")[0]
        return re.findall(r"^  (\w+)", listed, re.MULTILINE)

    def test_commands_are_completed(self):
        self.assertEqual(self.completed("penumbra ren"), ["render"])
        self.assertLessEqual(set(self.commands()), set(self.completed("penumbra ")))
        self.assertNotIn("complete", self.completed("penumbra "))

    def test_every_option_of_the_help_is_completed(self):
        for command in self.commands():
            options = re.findall(r"^  (?:-\w,)?(--[\w-]+)", self.help_of(command), re.MULTILINE)
            self.assertIn("--help", options)
            self.assertEqual(sorted(self.completed(f"penumbra {command} --")), sorted(options))

    def test_values_are_those_that_the_program_takes(self):
        self.assertEqual(self.completed("penumbra render bust --method "),
                         ["hard", "stochastic", "offset", "reduced", "umbra", "shaft"])
        self.assertEqual(self.completed("penumbra render --method=sh"), ["shaft"])
        self.assertEqual(self.completed("penumbra visibility bust --method "), ["shaft", "stochastic"])
        self.assertEqual(self.completed("penumbra bake --bits "), ["8", "16"])
        self.assertEqual(self.completed("penumbra render --style sp"), ["space-filling"])
        self.assertEqual(self.completed("penumbra render --ground "), ["auto", "none"])
        self.assertEqual(self.completed("penumbra bench --embree-spheres "), ["native", "user"])
        self.assertEqual(self.completed("penumbra render --spp "), [])
        self.assertEqual(self.completed("penumbra completion "), ["bash", "zsh", "fish"])

    def test_the_last_word_of_a_list_is_completed(self):
        self.assertEqual(self.completed("penumbra render --aov class,de"), ["class,depth"])
        self.assertEqual(self.completed("penumbra bench --methods shaft,h"), ["shaft,hard"])

    def test_scenes_are_built_in_ones_and_files(self):
        (self.folder / "bust two.ply").touch()
        (self.folder / "room").mkdir()
        self.assertEqual(set(self.completed("penumbra info ")),
                         {"balls", "rings", "cylinders", "molecule", "bust", "bust", "two.ply", "room", "small.nff"})
        self.assertEqual(self.completed("penumbra render --spp 4 s"), ["small.nff"])
        self.assertEqual(self.completed("penumbra render bust --progress -o sm"), ["small.nff"])
        self.assertEqual(self.completed("penumbra render --output=sm"), ["small.nff"])
        self.assertEqual(self.completed("penumbra generate s"), [])

    def test_the_program_may_be_in_a_home(self):
        (self.folder / "bin").mkdir()
        (self.folder / "bin/penumbra").symlink_to(self.program)
        script = ('HOME=$PWD; source <("$1" completion bash); COMP_LINE="~/bin/penumbra ren"; '
                  'COMP_POINT=${#COMP_LINE}; _penumbra penumbra; echo "${COMPREPLY[@]}"')
        result = subprocess.run(["bash", "--norc", "-c", script, "bash", self.program], cwd=self.folder,
                                capture_output=True, text=True, timeout=60, check=True)
        self.assertEqual((result.stdout, result.stderr), ("render\n", ""))

    def test_what_cannot_be_completed_is_left_alone(self):
        for line in ("penumbra nothing ", "penumbra nothing --", "penumbra render --spp=", "penumbra render --no="):
            self.assertEqual(self.completed(line), [], line)

    def test_other_shells_can_read_their_scripts(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.folder / shell
            script.write_text(self.succeed("completion", shell).stdout)
            if shutil.which(shell):
                subprocess.run([shell, "-n", script], check=True, timeout=60)


class Manual(cli_case.CliTest):
    def setUp(self):
        super().setUp()
        self.succeed("manual", ".", "--date", "2026-11-22")

    def test_every_command_has_a_page_with_every_option(self):
        commands = self.succeed("complete", "").stdout
        for command in re.findall(r"^(\w+)\t", commands, re.MULTILINE):
            page = (self.folder / f"penumbra-{command}.1").read_text().replace("\\-", "-")
            for option in re.findall(r"^(--[\w-]+)\t", self.succeed("complete", "--", command, "--").stdout, re.MULTILINE):
                self.assertIn(f"\\fB{option}\\fR", page)
            self.assertIn(".SH EXAMPLES\n", page)
            self.assertIn(f"penumbra-{command} (1)", (self.folder / "penumbra.1").read_text().replace("\\-", "-"))

    def test_no_text_is_taken_for_a_command_of_the_typesetter(self):
        for page in self.folder.glob("*.1"):
            for line in page.read_text().splitlines():
                self.assertNotRegex(line, r"^'|^\.(?!(TH|SH|SS|TP|PP|BR|nf|fi)\b)|[^\x20-\x7e]", page)

    @unittest.skipUnless(shutil.which("man"), "there is no man")
    def test_man_has_nothing_to_complain_of(self):
        for page in self.folder.glob("*.1"):
            result = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page], capture_output=True,
                                    text=True, timeout=60, check=True, env={"LC_ALL": "C.UTF-8", "PATH": os.environ["PATH"]})
            self.assertEqual(result.stderr, "")


if __name__ == "__main__":
    cli_case.main()
