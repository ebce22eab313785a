# SPDX-License-Identifier: MIT
"""bench_test.py PROGRAM [TEST...]: what `penumbra bench` measures and writes."""
import json
import os
import pty
import subprocess

from cli_case import CliTest, main

TINY = ["--size", "32x32", "--rounds", "2"]
FIELDS = ["scene", "method", "shadow_samples", "light_radius", "threads", "seconds_shadow", "seconds_render", "speedup",
          "speedup_over_stochastic", "ratio_to_hard", "lit", "umbra", "penumbra", "seconds_shadow_quartiles",
          "seconds_render_quartiles", "size", "seed", "seconds_build", "memory_bytes"]
BASELINES = ["embree", "embree_hard"]


class Bench(CliTest):
    def bench(self, *arguments):
        text = self.succeed("bench", *arguments, *TINY, "--json", "b.json").stdout
        return json.loads((self.folder / "b.json").read_text()), text

    def test_rows_hold_what_others_read(self):
        found, text = self.bench("cylinders", "small.nff", "--shadow-samples", "1,12", "--light-radius", "5%,0.1",
                                 "--methods", "shaft,hard")
        self.assertEqual(set(found), {"machine", "rows", "baselines"})
        for key in ["cpu", "cores", "instruction_set", "embree", "penumbra"]:
            self.assertTrue(found["machine"][key])
        methods = ["hard", "stochastic", "shaft", *BASELINES]
        cells = [(scene, radius, d, method) for scene in ["cylinders", "small.nff"] for radius in ["5%", "0.1"]
                 for d in [1, 12] for method in methods]
        rows = found["rows"]
        self.assertEqual([(r["scene"], r["light_radius"], r["shadow_samples"], r["method"]) for r in rows], cells)
        for row in rows:
            self.assertEqual(list(row), FIELDS)
            self.assertEqual(row["threads"], 1)
            for key in ["seconds_shadow", "seconds_render", "speedup", "speedup_over_stochastic", "ratio_to_hard",
                        "seconds_build", "memory_bytes"]:
                self.assertGreater(row[key], 0, key)
            self.assertAlmostEqual(row["lit"] + row["umbra"] + row["penumbra"], 1)
        for method in methods:
            self.assertRegex(text, rf"(?m)^  {method} ")

    def test_ratios_are_those_of_the_times(self):
        rows = {row["method"]: row for row in self.bench("balls:1")[0]["rows"]}
        self.assertEqual(list(rows)[-2:], BASELINES)
        for row in rows.values():
            took = row["seconds_shadow"]
            self.assertIsNone(row["light_radius"])
            self.assertAlmostEqual(row["speedup"], rows["embree"]["seconds_shadow"] / took)
            self.assertAlmostEqual(row["speedup_over_stochastic"], rows["stochastic"]["seconds_shadow"] / took)
            self.assertAlmostEqual(row["ratio_to_hard"], took / rows["embree_hard"]["seconds_shadow"])
        self.assertEqual(rows["embree"]["speedup"], 1)
        self.assertEqual(rows["embree_hard"]["ratio_to_hard"], 1)

    def test_embree_agrees_and_says_how_it_was_asked(self):
        for spheres in ["native", "user", "native|user"]:
            wanted = [] if "|" in spheres else ["--embree-spheres", spheres]
            found = self.bench("molecule", "--methods", "stochastic", *wanted)[0]
            self.assertEqual([b["method"] for b in found["baselines"]], BASELINES)
            for baseline in found["baselines"]:
                self.assertRegex(baseline["variant"], rf"^rtcOccluded(8|16|1M)(, coherent)?, ({spheres}) spheres$")
                self.assertLess(baseline["different_samples"], 1e-3)
            classes = {row["method"]: (row["lit"], row["umbra"], row["penumbra"]) for row in found["rows"]}
            for ours, theirs in zip(classes["stochastic"], classes["embree"]):
                self.assertAlmostEqual(ours, theirs, 3)

    def test_no_scene_means_the_built_in_ones(self):
        rows = self.bench("--methods", "stochastic")[0]["rows"]
        self.assertEqual([row["scene"] for row in rows[::3]], ["cylinders", "balls:4", "rings", "molecule", "bust"])

    def test_all_methods_unless_told_otherwise(self):
        rows = self.bench("balls:1", "--threads", "1,2")[0]["rows"]
        names = [row["method"] for row in rows]
        self.assertEqual(names[:len(names) // 2], names[len(names) // 2:])
        for name in ["hard", "stochastic", "offset", "reduced", "umbra", "shaft"]:
            self.assertIn(name, names)
        self.assertEqual({row["threads"] for row in rows}, {1, 2})

    def test_options_of_the_scene(self):
        light = ["--light", "sun", "0.3", "1", "0.2", "0.53"]
        rows = self.bench("small.nff", "--methods", "shaft", *light)[0]["rows"]
        self.assertGreater(rows[0]["lit"], 0.5)
        # Scenes that stand behind the words of a light.
        result = self.succeed("bench", *TINY, "--methods", "stochastic", *light, "small.nff", "rings")
        self.assertIn("small.nff, d = 32", result.stdout)
        self.assertIn("rings, d = 32", result.stdout)

    def test_clear_glass_is_no_occluder_for_embree_either(self):
        glass = "f 1 1 1 0 0 0 1 1\ns 0 0 3 0.5\n"
        (self.folder / "glass.nff").write_text((self.folder / "small.nff").read_text() + glass)
        for options in [[], ["--clear-glass"]]:
            found = self.bench("glass.nff", "--light-radius", "5%", "--methods", "shaft", *options)[0]
            for baseline in found["baselines"]:
                self.assertLess(baseline["different_samples"], 1e-3)

    def test_bad_usage(self):
        bad = {"--methods": ["magic", "", "shaft,"], "--shadow-samples": ["0", "8,", "x"], "--threads": ["-1", "1,x"],
               "--light-radius": ["0", "1%,", "-5%"], "--size": ["0x1"], "--rounds": ["0", "x"],
               "--embree-spheres": ["round"]}
        for option, values in bad.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    self.fail_with(2, "bench", "small.nff", option, value, says=f"{option} .*see 'penumbra bench --help'")

    def test_bad_input(self):
        self.fail_with(1, "bench", "nothing.nff", *TINY, says="^nothing.nff: .*built-in")
        self.fail_with(1, "bench", "small.nff", *TINY, "--from", "0,0,50", "--at", "0,0,99", says="^small.nff: .*--at")
        self.fail_with(1, "bench", "small.nff", *TINY, "--json", "none/b.json", says="^none/b.json")

    def test_progress_on_a_terminal_leaves_a_clean_line(self):
        ours, theirs = pty.openpty()
        with subprocess.Popen([self.program, "bench", "small.nff", *TINY], cwd=self.folder, stderr=theirs,
                              stdout=subprocess.DEVNULL) as process:
            process.wait(timeout=60)
        os.close(theirs)
        text = os.read(ours, 1 << 16).decode()
        os.close(ours)
        self.assertRegex(text, r"bench small\.nff, d = 32 \[[#.]+\] +\d+ %")
        self.assertTrue(text.endswith("\r\x1b[K"), repr(text[-40:]))


if __name__ == "__main__":
    main()
