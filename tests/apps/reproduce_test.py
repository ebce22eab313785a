# SPDX-License-Identifier: MIT
"""reproduce_test.py PROGRAM [TEST...]: what `penumbra reproduce` leaves in its folder."""
import csv
import os

import page_rules
from cli_case import CliTest, main

PYRAMID = "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 0.5 1 0.5\nf 1 2 4 3\nf 1 5 2\nf 2 5 4\nf 4 5 3\nf 3 5 1\n"
PROVENANCE = ["run", "program", "version", "compiler", "flags", "cpu", "cores", "instruction_set", "embree", "date"]


class Reproduce(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "pyramid <&>.obj").write_text(PYRAMID)
        self.arguments = ["reproduce", "-o", "r", "--smoke", "--molecule", "small.nff", "--bust", "pyramid <&>.obj"]

    def rows(self):
        with open(self.folder / "r" / "measurements.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def table(self, name):
        with open(self.folder / "r" / f"{name}.csv", newline="", encoding="utf-8") as file:
            lines = list(csv.reader(file))
        return {line[0]: dict(zip(lines[0][1:], line[1:])) for line in lines[1:]}

    def test_folder_holds_page_tables_plots_and_pictures(self):
        self.succeed(*self.arguments)
        page = self.folder / "r" / "index.html"
        self.assertEqual(page_rules.faults(page), [])
        text = page.read_text()
        for part in ["Table 1", "Table 2", "Table 3", "Table 4", "Figure 6", "Figure 9", "Figure 13",
                     "pyramid &lt;&amp;&gt;.obj", "Where we differ"]:
            self.assertIn(part, text)
        for figure in range(9, 14):
            for view in ["", "-stochastic", "-umbra", "-shaft"]:
                self.succeed("compare", f"r/figure{figure}{view}.png", f"r/figure{figure}{view}.png")

        rows = self.rows()
        for row in rows:
            self.assertTrue(all(row[column] for column in PROVENANCE), row)
            self.assertGreater(float(row["seconds_shadow"]), 0)
            self.assertLessEqual(float(row["seconds_render_low"]), float(row["seconds_render"]))
            self.assertLessEqual(float(row["seconds_render"]), float(row["seconds_render_high"]))
        self.assertEqual({row["experiment"] for row in rows}, {"tables", "table 4", "samples", "light", "size", "growth"})

        objects = self.table("table2")["objects"]
        self.assertEqual([objects[scene] for scene in ["Cylinders", "Balls4", "Rings"]], ["11", "7,383", "62"])
        self.assertEqual([objects[f"{scene}, paper"] for scene in ["Cylinders", "Balls4", "Rings"]], ["11", "7,383", "62"])
        self.assertNotIn("small.nff, paper", objects)  # the paper has no figure of it
        self.assertEqual({row["objects"] for row in rows if row["experiment"] == "table 4"}, {"822"})
        self.assertEqual([row["light_radius"] for row in rows if row["experiment"] == "table 4"][::10],
                         ["0.0185185", "0.0555556", "0.166667", "0.5"])

        # What is measured is kept; what is missing, and that alone, is measured anew.
        path = self.folder / "r" / "measurements.csv"
        lines = path.read_text().splitlines(keepends=True)
        path.write_text("".join(lines[:-12]))
        page.unlink()
        self.succeed(*self.arguments)
        self.assertEqual(path.read_text().splitlines(keepends=True)[:len(lines) - 12], lines[:-12])
        again = self.rows()
        key = ["experiment", "scene", "light_radius", "size", "shadow_samples", "method", "rays_shadow", "lit"]
        self.assertEqual({tuple(r[k] for k in key) for r in again}, {tuple(r[k] for k in key) for r in rows})
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

    def test_measurements_of_another_run_are_kept(self):
        (self.folder / "r").mkdir()
        path = self.folder / "r" / "measurements.csv"
        path.write_text("experiment,scene\ntables,other\n")
        self.fail_with(1, *self.arguments, says="measurements.csv.*another folder")
        path.unlink()
        self.succeed(*self.arguments)
        whole = path.read_text()
        self.fail_with(1, *self.arguments[:3], "--quick", says="another run.*another folder")
        self.assertEqual(path.read_text(), whole)

        path.write_text(whole[:-150])  # a line is cut in the middle
        self.succeed(*self.arguments)
        self.assertEqual(len(self.rows()), whole.count("\n") - 1)


if __name__ == "__main__":
    main()
