# SPDX-License-Identifier: MIT
"""reproduce_test.py PROGRAM [TEST...]: what `penumbra reproduce` leaves in its folder."""
import csv
import os
import shutil
import tempfile

import page_rules
from cli_case import CliTest, main

PYRAMID = "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 0.5 1 0.5\nf 1 2 4 3\nf 1 5 2\nf 2 5 4\nf 4 5 3\nf 3 5 1\n"
PROVENANCE = ["run", "program", "version", "compiler", "flags", "cpu", "cores", "instruction_set", "embree", "date"]


class Reproduce(CliTest):
    """One smoke run for all; each test works in a copy of what it left."""
    finished = None

    def setUp(self):
        super().setUp()
        (self.folder / "pyramid <&>.obj").write_text(PYRAMID)
        self.arguments = ["reproduce", "-o", "r", "--smoke", "--molecule", "small.nff", "--bust", "pyramid <&>.obj"]
        for name in ["small.nff", "pyramid <&>.obj"]:
            os.utime(self.folder / name, (1e9, 1e9))  # files of the same time are the same files
        if not Reproduce.finished:
            self.succeed(*self.arguments)
            Reproduce.finished = tempfile.TemporaryDirectory(prefix="penumbra-")
            shutil.copytree(self.folder / "r", Reproduce.finished.name, dirs_exist_ok=True)
        shutil.copytree(Reproduce.finished.name, self.folder / "r", dirs_exist_ok=True)

    def rows(self):
        with open(self.folder / "r" / "measurements.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def table(self, name):
        with open(self.folder / "r" / f"{name}.csv", newline="", encoding="utf-8") as file:
            lines = list(csv.reader(file))
        return {line[0]: dict(zip(lines[0][1:], line[1:])) for line in lines[1:]}

    def test_folder_holds_page_tables_plots_and_pictures(self):
        page = self.folder / "r" / "index.html"
        self.assertEqual(page_rules.faults(page), [])
        text = page.read_text()
        for part in ["Table 1", "Table 2", "Table 3", "Table 4", "Figure 6", "Figure 9", "Figure 13",
                     "pyramid &lt;&amp;&gt;.obj", "Where we differ"]:
            self.assertIn(part, text)
        for figure in range(9, 14):
            for view in ["", "-stochastic", "-umbra", "-shaft"]:
                self.assertEqual((self.folder / "r" / f"figure{figure}{view}.png").read_bytes()[:4], b"\x89PNG")

        rows = self.rows()
        for row in rows:
            self.assertTrue(all(row[column] for column in PROVENANCE), row)
            self.assertGreater(float(row["seconds_shadow"]), 0)
            self.assertLessEqual(float(row["seconds_render_low"]), float(row["seconds_render"]))
            self.assertLessEqual(float(row["seconds_render"]), float(row["seconds_render_high"]))
        self.assertEqual({row["experiment"] for row in rows}, {"tables", "table 4", "samples", "light", "size", "growth"})

        objects = self.table("table2")["objects"]
        self.assertEqual([objects[scene] for scene in ["Cylinders", "Balls4", "Rings"]], ["11", "7,383", "62"])
        self.assertEqual([objects[f"{scene}, paper"] for scene in ["Cylinders", "Balls4", "Rings"]],
                         ["11", "7,383", "62"])
        self.assertNotIn("small.nff, paper", objects)  # the paper has no figure of it
        self.assertEqual({row["objects"] for row in rows if row["experiment"] == "table 4"}, {"822"})
        self.assertEqual([row["light_radius"] for row in rows if row["experiment"] == "table 4"][::10],
                         ["0.0185185", "0.0555556", "0.166667", "0.5"])

    def test_interrupted_run_goes_on(self):
        """Settings that lack a row, or have a damaged one, are measured anew, and whole; all else is kept."""
        rows, page = self.rows(), self.folder / "r" / "index.html"
        path = self.folder / "r" / "measurements.csv"
        lines = path.read_text().splitlines(keepends=True)
        damaged = lines[60].replace(",32,", ",many,", 1)
        path.write_text("".join([*lines[:30], *lines[31:60], damaged, *lines[61:-12], lines[-3][:90]]))
        page.unlink()
        self.succeed(*self.arguments)
        again = path.read_text().splitlines(keepends=True)
        self.assertEqual(len(again), len(lines))
        self.assertGreater(len(set(again) & set(lines)), len(lines) - 12 - 2 * 10 - 4)
        key = ["experiment", "scene", "light_radius", "size", "shadow_samples", "method", "rays_shadow", "lit"]
        self.assertEqual({tuple(r[k] for k in key) for r in self.rows()}, {tuple(r[k] for k in key) for r in rows})
        self.assertTrue(page.exists())

    def test_what_cannot_work_is_said_at_once(self):
        (self.folder / "taken").write_text("")
        self.fail_with(1, "reproduce", "-o", "taken", says="taken.*choose another")
        self.fail_with(2, "reproduce", "--quick", "--smoke", says="exclude")
        self.fail_with(1, "reproduce", "-o", "m", "--bust", "missing.ply", says="missing.ply")
        without = self.run_program("reproduce", "-o", "m", env={**os.environ, "PATH": "/nowhere"})
        self.assertEqual(without.returncode, 1)
        self.assertRegex(without.stderr, "gnuplot.*gnuplot-nox")
        self.assertFalse((self.folder / "m").exists())

    def test_measurements_of_another_run_are_left_alone(self):
        path = self.folder / "r" / "measurements.csv"
        whole = path.read_text()
        self.assertIn("reproduce --smoke --molecule small.nff", self.rows()[0]["run"])
        self.fail_with(1, *self.arguments[:3], "--quick", says="another run.*another folder")
        self.assertEqual(path.read_text(), whole)
        path.write_text("experiment,scene\ntables,other\n")
        self.fail_with(1, *self.arguments, says="measurements.csv.*another folder")
        self.assertEqual(path.read_text(), "experiment,scene\ntables,other\n")


if __name__ == "__main__":
    main()
