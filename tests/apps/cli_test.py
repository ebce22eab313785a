# SPDX-License-Identifier: MIT
"""cli_test.py PROGRAM [TEST...]: the command line's contract: exit codes, messages, files, sameness."""
import json
import os
import pty
import re
import shutil
import signal
import subprocess
import time

from cli_case import NFF, SMALL, CliTest, exr, main

COMMANDS = ["render", "bake", "info", "generate", "compare", "bench", "visibility"]
BUILT_IN = ["cylinders", "balls", "rings", "molecule", "bust"]


class Help(CliTest):
    def test_program_and_commands_explain_themselves(self):
        self.assertRegex(self.succeed("--help").stdout, "Examples:\n  penumbra render")
        for command in COMMANDS:
            self.assertRegex(self.succeed(command, "--help").stdout, f"Examples?:\n  penumbra {command} ")

    def test_generate_lists_the_built_in_scenes(self):
        text = self.succeed("generate", "--help").stdout
        for name in BUILT_IN:
            self.assertIn(name, text)

    def test_version(self):
        self.assertRegex(self.succeed("--version").stdout, r"^penumbra \d+\.\d+\.\d+\n$")


class BadUsage(CliTest):
    """Exit code 2, the option's name, the way to the help, no file."""

    def bad_render(self, *options, says=""):
        self.fail_with(2, "render", "small.nff", "-o", "x.png", *options, says=says)

    def test_values_of_render(self):
        bad = {
            "--size": ["0x0", "0x5", "5x0", "1000000x1000000", "65537x1", "65536x65536", "-1x5", "5", "5x", "x", "",
                       "5x5x5", "nanx5", "5.5x5", "99999999999999999999x1"],
            "--shadow-samples": ["0", "-1", "nan", "1e3", "70000", "x", "4294967296"],
            "--threads": ["-1", "x", "1.5"],
            "--tile": ["0", "-4"],
            "--spp": ["0", "-1"],
            "--depth": ["0", "-1"],
            "--method": ["magic", "", "Hard"],
            "--light-radius": ["nan", "nan%", "inf", "-1", "0", "%", "abc", "1e300", "1e-300"],
            "--fov": ["0", "180", "nan", "-5"],
            "--from": ["1,2", "1,2,3,4", "1,2,nan", "1,2,inf", "a,b,c", "", "1e30,0,0"],
            "--up": ["0,0,0"],
            "--background": ["-1,0,0", "1,1"],
            "--ground": ["nan", "floor", "inf"],
            "--exposure": ["nan", "inf", "1000"],
            "--seed": ["-1", "x"],
            "--pixel": ["1", "-1,0", "24,0", "0,24", "x,y"],
            "--style": ["sticks"],
            "-o": ["x.jpg", "x", ""],
        }
        for option, values in bad.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    self.bad_render(option, value, says="see 'penumbra render --help'")

    def test_the_message_names_the_option(self):
        self.bad_render("--size", "0x5", says="--size 0x5: .*at least one pixel")
        self.bad_render("--method", "magic", says="--method magic: .*hard, stochastic")

    def test_lights(self):
        for words in [["lamp", "0", "0", "1"], ["sphere", "0", "0", "1"], ["sphere", "0", "0", "1", "nan"],
                      ["sphere", "0", "0", "1", "-2"], ["sun", "0", "0", "0", "1"], ["0", "0", "1"],
                      ["rect", "0", "0", "5", "1", "0", "0", "2", "0", "0"]]:
            with self.subTest(words=words):
                self.bad_render("--light", *words, says="--light")

    def test_camera_at_its_target(self):
        self.bad_render("--from", "1,2,3", "--at", "1,2,3", says="--from and --at")

    def test_layers_need_exr(self):
        self.bad_render("--aov", "class", says="exr")
        self.fail_with(2, "render", "small.nff", "-o", "x.exr", "--aov", "colour", says="class, visibility")

    def test_words(self):
        self.fail_with(2, says="penumbra --help")
        self.fail_with(2, "paint", says="paint")
        self.fail_with(2, "render", says="SCENE")
        self.fail_with(2, "render", "small.nff", says="-o FILE is missing")
        self.fail_with(2, "render", "small.nff", "other.nff", "-o", "x.png", says="other.nff")
        self.fail_with(2, "render", "small.nff", "-o", "x.png", "--nonsense", says="--nonsense")
        self.fail_with(2, "render", "small.nff", "-o", "x.png", "--size", says="--size")
        self.fail_with(2, "info", says="SCENE")
        self.fail_with(2, "generate", "rings", says="-o")
        self.fail_with(2, "generate", "rings", "-o", "x.png", says=r"\.nff or \.ply")
        self.fail_with(2, "compare", "a.png", says="B")
        self.fail_with(2, "compare", "a.png", "b.png", "--tolerance", "-1", says="--tolerance -1")
        self.fail_with(2, "compare", "a.png", "b.png", "--tolerance", "nan", says="--tolerance nan")


class BadInput(CliTest):
    """Exit code 1 and no file."""

    def test_unknown_scene_names_the_built_in_ones(self):
        for command in [["render", "nothing.nff", "-o", "x.png"], ["info", "nothing.nff"],
                        ["generate", "nothing", "-o", "x.nff"]]:
            message = self.fail_with(1, *command, says="^nothing").stderr
            for name in BUILT_IN:
                self.assertIn(name, message)

    def test_count_out_of_range(self):
        for name in ["balls:0", "balls:99", "balls:-1", "balls:x", "balls:99999999999999999999"]:
            self.fail_with(1, "render", name, "-o", "x.png", says="balls")

    def test_broken_scene_is_named_with_its_line(self):
        (self.folder / "bad.nff").write_text(NFF.replace("s 0 0 1 1", "s 0 0 one 1"))
        self.fail_with(1, "render", "bad.nff", "-o", "x.png", says=r"^bad\.nff:11: ")
        (self.folder / "empty.nff").write_text("")
        self.fail_with(1, "render", "empty.nff", "-o", "x.png", says=r"^empty\.nff")
        self.fail_with(1, "info", "empty.nff", says=r"^empty\.nff")

    def test_folder_as_scene(self):
        (self.folder / "folder.nff").mkdir()
        self.fail_with(1, "render", "folder.nff", "-o", "x.png", says=r"^folder\.nff")

    def test_output_that_cannot_be_written_fails_before_the_scene_is_read(self):
        self.fail_with(1, "render", "nothing.nff", "-o", "none/x.png", says="^none/x.png: cannot be written")
        (self.folder / "folder.png").mkdir()
        self.fail_with(1, "render", "small.nff", "-o", "folder.png", says="folder")
        self.fail_with(1, "render", "small.nff", *SMALL, "-o", "x.png", "--stats", "none/s.json", says="^none/s.json")
        self.fail_with(1, "generate", "rings", "-o", "none/x.nff", says="^none/x.nff")

    def test_full_standard_output(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            result = subprocess.run([self.program, "info", "small.nff"], cwd=self.folder, stdout=full,
                                    stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        self.assertEqual(result.returncode, 1, result.stderr)


class Render(CliTest):
    def test_png_tells_how_it_was_made(self):
        (self.folder / "sub").mkdir()
        shutil.copy(self.folder / "small.nff", self.folder / "sub")
        result = self.succeed("render", self.folder / "sub" / "small.nff", *SMALL, "-o", "x.png")
        self.assertRegex(result.stderr, r"^wrote x\.png: 24x24, .* 576 primary, .*lit \d+ %, penumbra \d+ %, umbra \d+ %")
        self.assertNotIn("\x1b", result.stderr, "no bar where there is no terminal")
        picture = (self.folder / "x.png").read_bytes()
        self.assertTrue(picture.startswith(b"\x89PNG\r\n\x1a\n"))
        self.assertIn(b"tEXtSoftware\0penumbra ", picture)
        self.assertRegex(picture, rb"tEXtCommand\0penumbra render small\.nff --size 24x24")
        self.assertNotIn(str(self.folder).encode(), picture, "folders are private")

    def test_size_comes_from_the_file(self):
        result = self.succeed("render", "small.nff", "--shadow-samples", "1", "-o", "x.png")
        self.assertIn("24x24", result.stderr)

    def test_stats_have_all_keys(self):
        self.succeed("render", "small.nff", *SMALL, "-o", "x.exr", "--stats", "s.json", "--threads", "2")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(stats["method"], "shaft")
        self.assertEqual(stats["threads"], 2)
        self.assertEqual(set(stats["seconds"]), {"load", "build", "render", "shadow"})
        self.assertEqual(set(stats["rays"]), {"primary", "reflected", "refracted", "shadow", "shadow_set"})
        self.assertEqual(set(stats["shadow_queries"]), {"lit", "penumbra", "umbra"})
        self.assertEqual(set(stats["tests_per_ray"]), {"geometry", "shadow"})
        self.assertEqual(set(stats["memory_bytes"]), {"geometry", "shadow"})
        self.assertEqual(stats["rays"]["primary"], 24 * 24)
        self.assertGreaterEqual(stats["cache_decided"], 0)
        self.assertGreater(sum(stats["shadow_queries"].values()), 0)
        self.assertGreater(stats["rays"]["shadow"], 0)
        self.assertGreater(stats["memory_bytes"]["geometry"], 0)
        self.assertGreater(stats["peak_rss_bytes"], 1 << 20)

    def test_all_methods_draw_the_same_picture_with_fewer_rays(self):
        rays = {}
        for method in ["stochastic", "offset", "reduced", "umbra", "shaft"]:
            self.succeed("render", "rings", "--size", "48x48", "--method", method, "-o", f"{method}.exr", "--stats", "s.json")
            self.succeed("compare", "stochastic.exr", f"{method}.exr")
            stats = json.loads((self.folder / "s.json").read_text())
            self.assertEqual(stats["method"], method)
            self.assertEqual(stats["rays"]["shadow_set"] > 0, method != "stochastic")
            self.assertEqual(stats["memory_bytes"]["shadow"] > 0, method != "stochastic")
            rays[method] = stats["rays"]["shadow"]
        self.assertGreater(rays["stochastic"], rays["offset"])
        self.assertGreaterEqual(rays["offset"], rays["reduced"])
        self.assertGreaterEqual(rays["reduced"], rays["umbra"])
        self.assertGreater(rays["stochastic"], 4 * rays["shaft"])

    def test_colours_are_the_same_for_any_threads_and_tiles(self):
        scenes = ["balls:2", "cylinders"]
        for scene in scenes:
            base = ["render", scene, "--size", "45x37", "--shadow-samples", "6", "--spp", "2"]
            self.succeed(*base, "--threads", "1", "-o", "one.exr", "--stats", "one.json")
            first = json.loads((self.folder / "one.json").read_text())
            for options in [["--threads", "2"], ["--threads", "7"], ["--tile", "1"], ["--tile", "8"],
                            ["--tile", "64", "--threads", "7"]]:
                with self.subTest(scene=scene, options=options):
                    self.succeed(*base, *options, "-o", "other.exr", "--stats", "other.json")
                    self.succeed("compare", "one.exr", "other.exr")
                    other = json.loads((self.folder / "other.json").read_text())
                    for counters in ["rays", "shadow_queries", "tests_per_ray"]:
                        self.assertEqual(first[counters], other[counters])

    def test_seed_changes_the_noise(self):
        for seed in ["1", "2", "18446744073709551615"]:
            self.succeed("render", "small.nff", *SMALL, "--light-radius", "20%", "--seed", seed, "-o", f"{seed}.exr")
        self.fail_with(1, "compare", "1.exr", "2.exr")

    def test_hard_and_stochastic_differ_under_an_area_light(self):
        for method in ["hard", "stochastic"]:
            self.succeed("render", "small.nff", *SMALL, "--light-radius", "1", "--method", method, "-o", f"{method}.exr")
        self.fail_with(1, "compare", "hard.exr", "stochastic.exr")

    def test_lights_replace_those_of_the_file(self):
        lights = ["--light", "sphere", "-3", "-2", "5", "-.5e-1", "--light"]
        self.fail_with(2, "render", "small.nff", *SMALL, *lights[:-1], "-o", "x.exr", says="radius")
        words = ["--light", "point", "3", "-2", "5", ".5", ".5", ".5"]  # NFF's single light has 1/2
        self.succeed("render", "small.nff", *SMALL, "-o", "file.exr")
        self.succeed("render", "small.nff", *SMALL, *words, "-o", "same.exr")
        self.succeed("compare", "file.exr", "same.exr")
        self.succeed("render", *words, *words[:5], "1", ".5", "0.25", "-o", "two.exr", *SMALL, "small.nff")
        self.fail_with(1, "compare", "file.exr", "two.exr")
        self.succeed("render", *SMALL, "-o", "last.exr", "--light", "point 3 -2 5 0.5 5e-1 .5", "small.nff")
        self.succeed("compare", "file.exr", "last.exr")

    def test_camera_options(self):
        self.succeed("render", "small.nff", *SMALL, "-o", "a.exr", "--from", "0,-6,3", "--at", "0,0,.5", "--fov", "40")
        self.succeed("render", "small.nff", *SMALL, "-o", "b.exr")
        self.succeed("compare", "a.exr", "b.exr")
        self.succeed("render", "small.nff", *SMALL, "-o", "c.exr", "--from", "-.5,-6,3", "--up", "1,0,0")
        self.fail_with(1, "compare", "a.exr", "c.exr")

    def test_exposure_brightens_png_and_leaves_exr(self):
        for name, options in [("a.exr", []), ("b.exr", ["--exposure", "-2"]), ("a.png", []),
                              ("b.png", ["--exposure", "-2"])]:
            self.succeed("render", "small.nff", *SMALL, *options, "-o", name)
        self.succeed("compare", "a.exr", "b.exr")
        self.fail_with(1, "compare", "a.png", "b.png")

    def test_layers(self):
        self.succeed("render", "small.nff", *SMALL, "-o", "x.exr", "--aov", "class,visibility,depth,normal,samples")
        picture = (self.folder / "x.exr").read_bytes()
        for name in [b"class", b"visibility", b"depth", b"normal", b"samples"]:
            self.assertRegex(picture[:4000], rb"\0" + name + rb"[.\w]*\0")

    def test_pixel_tells_all_and_writes_nothing(self):
        before = self.files()
        result = self.succeed("render", "small.nff", *SMALL, "--pixel", "12,20", "-o", "x.png")
        self.assertIn("12", result.stdout)
        self.assertGreater(len(result.stdout.splitlines()), 3)
        self.assertEqual(self.files(), before)


class Progress(CliTest):
    def test_lines_where_there_is_no_terminal(self):
        result = self.succeed("render", "small.nff", *SMALL, "-o", "x.png", "--progress")
        self.assertRegex(result.stderr, r"rendering small\.nff 100 %\n")
        self.assertNotIn("\r", result.stderr)

    def test_bar_on_a_terminal_leaves_a_clean_line(self):
        ours, theirs = pty.openpty()
        with subprocess.Popen([self.program, "render", "small.nff", *SMALL, "-o", "x.png"], cwd=self.folder,
                              stderr=theirs) as process:
            process.wait(timeout=60)
        os.close(theirs)
        text = os.read(ours, 1 << 16).decode()
        os.close(ours)
        self.assertRegex(text, r"rendering small\.nff \[[#.]+\] +\d+ %")
        self.assertRegex(text, r"\r\x1b\[Kwrote x\.png")

    def test_interrupt_leaves_no_file(self):
        before = self.files()
        with subprocess.Popen([self.program, "render", "small.nff", "--size", "512x512", "--shadow-samples", "4096",
                               "--light-radius", "1", "--spp", "64", "-o", "x.png"], cwd=self.folder) as process:
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            process.wait(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertEqual(self.files(), before)


class Generate(CliTest):
    def test_file_and_built_in_scene_give_the_same_picture(self):
        for scene in ["balls:2", "rings", "cylinders", "molecule", "bust"]:
            with self.subTest(scene=scene):
                self.succeed("generate", scene, "-o", "scene.nff")
                for source in [scene, "scene.nff"]:
                    self.succeed("render", source, "--size", "40x40", "--shadow-samples", "4",
                                 "-o", source.replace(":", "") + ".exr")
                self.succeed("compare", scene.replace(":", "") + ".exr", "scene.nff.exr")

    def test_bust_as_ply(self):
        self.succeed("generate", "bust", "-o", "bust.ply")
        info = json.loads(self.succeed("info", "bust.ply", "--json").stdout)
        self.assertEqual(info["all_meshes"]["boundary_edges"], 0)

    def test_what_ply_cannot_hold_is_an_error(self):
        self.fail_with(1, "generate", "balls:1", "-o", "x.ply", says=r"x\.ply")


class Info(CliTest):
    def test_text(self):
        text = self.succeed("info", "small.nff").stdout
        for word in ["1 spheres", "2 triangles", "camera", "light", "extent", "memory", "1 open"]:
            self.assertIn(word, text)

    def test_json(self):
        info = json.loads(self.succeed("info", "small.nff", "--json").stdout)
        self.assertEqual(info["primitives"], {"spheres": 1, "cylinders": 0, "cones": 0, "rings": 0, "triangles": 2,
                                              "total": 3})
        self.assertEqual(info["all_meshes"]["boundary_edges"], 4)
        self.assertEqual(info["all_meshes"]["open_components"], 1)
        self.assertEqual(info["lights"][0]["shape"], "point")
        self.assertEqual(info["camera"]["size"], [24, 24])
        self.assertEqual(info["bounds"]["hi"], [5, 5, 2])
        self.assertGreater(info["memory_bytes"]["geometry"], 0)

    def test_built_in(self):
        for name in ["balls:1", "rings", "cylinders", "molecule"]:
            self.assertGreater(json.loads(self.succeed("info", name, "--json").stdout)["primitives"]["total"], 8)

    def test_a_file_wins_over_a_built_in_scene(self):
        shutil.copy(self.folder / "small.nff", self.folder / "rings.nff")
        self.assertEqual(json.loads(self.succeed("info", "rings.nff", "--json").stdout)["primitives"]["total"], 3)
        (self.folder / "rings").mkdir()
        self.assertGreater(json.loads(self.succeed("info", "rings", "--json").stdout)["primitives"]["total"], 8)


class Compare(CliTest):
    def write(self, name, *rows):
        (self.folder / name).write_bytes(exr(rows))

    def compare(self, code, *arguments):
        result = self.run_program("compare", *arguments, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads(result.stdout)

    def test_equal_bits_and_nan(self):
        nan = float("nan")
        for name in ["a.exr", "b.exr"]:
            self.write(name, [nan, 1], [0, float("inf")], [0, 0])
        found = self.compare(0, "a.exr", "b.exr")
        self.assertEqual((found["rmse"], found["psnr"], found["max_difference"], found["differing_pixels"]),
                         (0, None, 0, 0))
        self.assertEqual(found["size"], [2, 1])

    def test_signed_zero_differs_in_bits_but_not_with_a_tolerance(self):
        self.write("a.exr", [0.0], [0], [0])
        self.write("b.exr", [-0.0], [0], [0])
        self.assertEqual(self.compare(1, "a.exr", "b.exr")["differing_pixels"], 1)
        self.compare(0, "a.exr", "b.exr", "--tolerance", "0")

    def test_numbers(self):
        self.write("a.exr", [0, 0], [0, 0], [0, 0])
        self.write("b.exr", [0.5, 0], [0, 0], [0.25, 0])
        found = self.compare(1, "a.exr", "b.exr")
        self.assertAlmostEqual(found["rmse"], ((0.25 + 0.0625) / 6) ** 0.5)
        self.assertAlmostEqual(found["psnr"], 12.833, 3)
        self.assertEqual(found["max_difference"], 0.5)
        self.assertEqual(found["differing_pixels"], 1)
        self.compare(1, "a.exr", "b.exr", "--tolerance", "0.4999")
        self.compare(0, "a.exr", "b.exr", "--tolerance", "0.5")

    def test_nan_against_a_number_differs_at_any_tolerance(self):
        self.write("a.exr", [float("nan")], [0], [0])
        self.write("b.exr", [0], [0], [0])
        self.compare(1, "a.exr", "b.exr")
        self.compare(1, "a.exr", "b.exr", "--tolerance", "1e30")

    def test_sizes(self):
        self.write("a.exr", [0], [0], [0])
        self.write("b.exr", [0, 0], [0, 0], [0, 0])
        self.assertEqual(self.compare(1, "a.exr", "b.exr")["rmse"], None)
        self.assertIn("1x1 pixels and 2x1", self.run_program("compare", "a.exr", "b.exr").stdout)

    def test_files_without_colours_by_the_channels_that_both_have(self):
        for name, channels in {"a": {"coverage": [1, 1], "visibility.light0": [0.5, 1]},
                               "b": {"visibility.light0": [0.5, 1], "visibility.light1": [0, 0]},
                               "c": {"visibility.light0": [0.25, 1]}, "d": {"Y": [0.5, 1]}}.items():
            (self.folder / f"{name}.exr").write_bytes(exr(list(channels.values()), tuple(channels)))
        self.assertEqual(self.compare(0, "a.exr", "b.exr")["channels"], ["visibility.light0"])
        found = self.compare(1, "b.exr", "c.exr")
        self.assertEqual((found["max_difference"], found["differing_pixels"]), (0.25, 1))
        self.assertAlmostEqual(found["rmse"], (0.0625 / 2) ** 0.5)
        self.fail_with(2, "compare", "a.exr", "d.exr", says=r"^d\.exr: has no channel that a\.exr has")

    def test_what_cannot_be_read_exits_with_2(self):
        self.write("a.exr", [0], [0], [0])
        (self.folder / "no_red.exr").write_bytes(exr([[0], [0]], names=("B", "G")))
        (self.folder / "bad.exr").write_bytes(b"garbage")
        (self.folder / "bad.png").write_bytes(b"garbage")
        (self.folder / "cut.exr").write_bytes((self.folder / "a.exr").read_bytes()[:-3])
        for other in ["missing.exr", "missing.png", "bad.exr", "bad.png", "cut.exr", "no_red.exr", "small.nff"]:
            self.fail_with(2, "compare", "a.exr", other, says=f"^{re.escape(other)}")
            self.fail_with(2, "compare", other, "a.exr", says=f"^{re.escape(other)}")


if __name__ == "__main__":
    main()
