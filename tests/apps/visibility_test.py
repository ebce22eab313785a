# SPDX-License-Identifier: MIT
"""visibility_test.py PROGRAM [TEST...]: `visibility` answers points, whatever file or pipe they come by."""
import array
import json
import os
import random
import signal
import struct
import subprocess
import time

from cli_case import CliTest, main

SUN = ["--light", "sun", "0.2", "-0.1", "1", "8"]
NPY_HEADER = 256


def floor_points(count, seed=1):
    """Points on the floor under the ball of small.nff, with normals: rows of six floats."""
    dice = random.Random(seed)
    return [[dice.uniform(-3, 3), dice.uniform(-3, 3), 0, 0, 0, 1] for _ in range(count)]


def as_text(points):
    return "".join(" ".join(f"{number:.9g}" for number in point) + "\n" for point in points)


def as_floats(points, kind="f"):
    return array.array(kind, [number for point in points for number in point]).tobytes()


def as_npy(points, kind="f"):
    head = f"{{'descr': '<{kind}{4 if kind == 'f' else 8}', 'fortran_order': False, 'shape': ({len(points)}, 6), }}\n"
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(head)) + head.replace("<d8", "<f8").encode() + as_floats(points, kind)


def as_ply(points):
    names = "".join(f"property float {name}\n" for name in ["x", "y", "z", "nx", "ny", "nz"])
    return (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{names}end_header\n".encode()
            + as_floats(points))


class VisibilityTest(CliTest):
    def put(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def pipe(self, content, *arguments):
        result = subprocess.run([self.program, "visibility", *arguments], cwd=self.folder, input=content,
                                capture_output=True, timeout=300, check=False)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        return result.stdout

    def rows(self, text):
        lines = text.splitlines()
        return [dict(zip(lines[0].split(","), line.split(","))) for line in lines[1:]]


class Answers(VisibilityTest):
    def test_a_point_below_the_ball_is_dark_and_one_far_away_is_not(self):
        self.put("p.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n4,4,0,0,0,1\n-3,0,0,0,0,-1\n")
        result = self.succeed("visibility", "small.nff", "--points", "p.csv", "--light", "sphere", "0", "0", "9", ".5")
        rows = self.rows(result.stdout)
        self.assertEqual(list(rows[0]), ["x", "y", "z", "nx", "ny", "nz", "class_light0", "visibility_light0"])
        self.assertEqual([row["class_light0"] for row in rows[:2]], ["umbra", "lit"])
        self.assertEqual([row["visibility_light0"] for row in rows], ["0", "1", "0"])
        self.assertRegex(result.stderr, "light0: sphere 0 0 9 0.5")
        self.assertRegex(result.stderr, r"3 points, 1 light, .* lit 50 %, penumbra 0 %, umbra 50 %")

    def test_points_without_normals_look_around(self):
        self.put("p.csv", "0 0 3\n0 0 -1\n")
        result = self.succeed("visibility", "small.nff", "--points", "p.csv", *SUN)
        self.assertEqual([row["visibility_light0"] for row in self.rows(result.stdout)], ["1", "0"])

    def test_points_on_a_surface_are_not_blocked_by_it(self):
        dice = random.Random(3)
        points = []
        for _ in range(2000):
            n = [dice.gauss(0, 1) for _ in range(3)]
            size = sum(c * c for c in n) ** 0.5
            n = [c / size for c in n]
            if n[2] > 0.1:
                points.append([n[0], n[1], n[2] + 1] + n)
        self.put("p.txt", as_text(points))
        rows = self.rows(self.succeed("visibility", "small.nff", "--points", "p.txt", "--light", "sun", "0", "0", "1",
                                      "1").stdout)
        self.assertEqual({row["visibility_light0"] for row in rows}, {"1"})

    def test_methods_threads_and_blocks_change_nothing(self):
        self.put("p.npy", as_npy(floor_points(3000)))
        command = ["visibility", "small.nff", "--points", "p.npy", *SUN, "--light", "sphere", "3", "0", "4", "1"]
        first = self.succeed(*command, "--fractions").stdout
        self.assertIn("0.5", first)
        for more in [["--method", "stochastic"], ["--threads", "1"], ["--threads", "3", "--block", "1000"],
                     ["--block", "7"]]:
            with self.subTest(more=more):
                self.assertEqual(self.succeed(*command, "--fractions", *more).stdout, first)
        self.assertNotEqual(self.succeed(*command, "--fractions", "--seed", "5").stdout, first)

    def test_classes_alone_take_no_samples(self):
        self.put("p.npy", as_npy(floor_points(3000)))
        command = ["visibility", "small.nff", "--points", "p.npy", *SUN, "--classes", "--stats", "s.json"]
        first = self.succeed(*command).stdout
        self.assertIn("umbra", first)
        self.assertIn("penumbra", first)
        self.assertEqual(json.loads((self.folder / "s.json").read_text())["rays"]["shadow"], 0)
        self.assertEqual(self.succeed(*command, "--shadow-samples", "1", "--seed", "4").stdout, first)
        self.succeed(*command, "-o", "seen.ply")

    def test_each_point_has_its_own_samples_and_each_light_too(self):
        self.put("p.csv", "1.1 0 0 0 0 1\n" * 50)
        rows = self.rows(self.succeed("visibility", "small.nff", "--points", "p.csv", "--shadow-samples", "8",
                                      *["--light", "sphere", "2", "0", "6", "2"] * 2).stdout)
        self.assertGreater(len({row["visibility_light0"] for row in rows}), 2)
        self.assertTrue(any(row["visibility_light0"] != row["visibility_light1"] for row in rows))

    def test_numbers_that_are_none_are_penumbra(self):
        self.put("p.csv", "nan 0 0 0 0 1\n0 inf 0 0 0 1\n1e999 0 0 0 0 1\n0 0 5 0 0 1\n0 0 5 nan 0 -1\n")
        rows = self.rows(self.succeed("visibility", "small.nff", "--points", "p.csv", *SUN).stdout)
        self.assertEqual([row["class_light0"] for row in rows], ["penumbra"] * 3 + ["lit", "penumbra"])

    def test_no_ground_is_added(self):
        self.put("p.csv", "0 0 -100\n")
        self.put("far.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                             "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                             "9 9 9\n10 9 9\n9 10 9\n3 0 1 2\n")
        far = ["visibility", "far.ply", "--points", "p.csv", "--light", "sun", "0", "0", "1", ".5", "--up", "0,0,1"]
        self.assertEqual(self.rows(self.succeed(*far).stdout)[0]["visibility_light0"], "1")
        self.assertEqual(self.rows(self.succeed(*far, "--ground", "-50").stdout)[0]["visibility_light0"], "0")


class Files(VisibilityTest):
    def test_all_inputs_give_the_same_answers(self):
        points = floor_points(500)
        command = ["small.nff", *SUN, "--fractions", "--output-format", "ascii"]
        text = as_text(points).encode()
        whole = self.pipe(text, *command, "--points", "-")
        self.assertGreater(len(set(whole.split())), 10)
        for name, content in {"p.csv": text, "p.npy": as_npy(points), "q.npy": as_npy(points, "d"),
                              "p.ply": as_ply(points), "header.csv": b"x y z nx ny nz\n" + text}.items():
            with self.subTest(name=name):
                self.put(name, content)
                self.assertEqual(self.pipe(b"", *command, "--points", name), whole)
                self.assertEqual(self.pipe(content, *command, "--points", "-"), whole)
                subprocess.run(["gzip", "-k", name], cwd=self.folder, check=True)
                self.assertEqual(self.pipe(b"", *command, "--points", name + ".gz"), whole)
        for name, kind in {"float": "f", "double": "d"}.items():
            self.assertEqual(self.pipe(as_floats(points, kind), *command, "--points", "-", "--input-format", name), whole)

    def test_all_outputs_hold_the_same_answers(self):
        points = floor_points(300)
        self.put("p.npy", as_npy(points))
        command = ["visibility", "small.nff", "--points", "p.npy", *SUN, "--light", "sphere", "0", "0", "9", "1"]
        rows = self.rows(self.succeed(*command).stdout)
        fractions = [float(row[f"visibility_light{light}"]) for row in rows for light in [0, 1]]
        classes = [["lit", "penumbra", "umbra"].index(row[f"class_light{light}"]) for row in rows for light in [0, 1]]
        self.assertEqual(array.array("f", [float(row["x"]) for row in rows]), array.array("f", [p[0] for p in points]))

        def read(name, kind, skip, *more):
            self.succeed(*command, "-o", name, *more)
            return list(array.array(kind, (self.folder / name).read_bytes()[skip:]))

        self.assertEqual(read("a.npy", "f", NPY_HEADER), fractions)
        both = (self.folder / "both.npy")
        self.succeed(*command, "-o", both.name, "--classes", "--fractions")
        self.assertEqual([row[:2] for row in struct.iter_unpack("<BBff", both.read_bytes()[NPY_HEADER:])],
                         list(zip(classes[::2], classes[1::2])))
        alone = read("b.npy", "B", NPY_HEADER, "--classes")
        for in_passing, looked_for in zip(classes, alone):
            self.assertIn(in_passing, [looked_for, 1])
        self.assertEqual(read("c.dat", "f", 0, "--output-format", "float"), fractions)
        self.assertEqual(read("d.dat", "d", 0, "--output-format", "double"), fractions)
        self.assertEqual(read("e.dat", "f", 0, "--output-format", "float", "--classes"), alone)
        self.succeed(*command, "-o", "f.csv")
        self.assertEqual((self.folder / "f.csv").read_text(), self.succeed(*command, "-o", "-").stdout)
        self.succeed(*command, "-o", "g.ply")
        again = ["visibility", "small.nff", "--points", "g.ply", *command[4:]]
        self.assertEqual(self.rows(self.succeed(*again).stdout), rows)

    def test_stats(self):
        self.put("p.npy", as_npy(floor_points(100)))
        self.succeed("visibility", "small.nff", "--points", "p.npy", *SUN, "-o", "a.npy", "--stats", "s.json")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual((stats["points"], stats["lights"], stats["method"]), (100, 1, "shaft"))
        self.assertEqual(sum(stats["shadow_queries"].values()), 100)
        self.assertEqual(set(stats["seconds"]), {"load", "build", "read", "answer", "write"})

    def test_progress_is_a_share_or_a_count(self):
        self.put("p.npy", as_npy(floor_points(20000)))
        command = ["visibility", "small.nff", *SUN, "-o", "a.npy", "--progress", "--shadow-samples", "64"]
        self.assertRegex(self.succeed(*command, "--points", "p.npy").stderr, "visibility of p.npy 100 %")

    def test_a_point_at_a_time_is_answered_as_it_comes(self):
        process = subprocess.Popen([self.program, "visibility", "small.nff", "--points", "-", *SUN, "--block", "1",
                                    "--output-format", "ascii"], cwd=self.folder, stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for point, answer in [(b"0 0 3 0 0 1\n", b"1\n"), (b"0 0 0 0 0 1\n", b"0\n")] * 3:
            process.stdin.write(point)
            process.stdin.flush()
            self.assertEqual(process.stdout.readline(), answer)
        process.stdin.close()
        self.assertEqual(process.wait(), 0)
        process.stdout.close()


class Trouble(VisibilityTest):
    def setUp(self):
        super().setUp()
        self.put("p.csv", "0 0 0\n")

    def test_bad_usage(self):
        command = ["visibility", "small.nff", "--points", "p.csv"]
        self.fail_with(2, "visibility", "small.nff", says="--points")
        self.fail_with(2, "visibility", "--points", "p.csv", says="SCENE")
        self.fail_with(2, *command, "-o", "x.png", says="output-format")
        self.fail_with(2, *command, "--input-format", "xls", says="--input-format xls: expected one of csv")
        self.fail_with(2, *command, "--output-format", "float", "--classes", "--fractions", says="one kind")
        self.fail_with(2, *command, "--method", "umbra", says="--method umbra: expected one of shaft, stochastic")
        self.fail_with(2, *command, "-o", "p.csv", says="same file")
        for option, value in {"--offset": "-1", "--shadow-samples": "0", "--block": "0", "--seed": "x"}.items():
            self.fail_with(2, *command, option, value, says=f"{option} {value}: expected")

    def test_a_scene_without_lights_says_how_to_give_one(self):
        self.put("t.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                          "0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n")
        self.fail_with(1, "visibility", "t.ply", "--points", "p.csv", says=r"^t\.ply: has no lights; .*--light sun")

    def test_bad_points_name_the_line_and_leave_no_file(self):
        self.put("bad.csv", "0 0 0\n" * 200000 + "1 2\n")
        for output in ["x.csv", "x.npy", "x.ply"]:
            self.fail_with(1, "visibility", "small.nff", "--points", "bad.csv", *SUN, "-o", output,
                           says=r"\nbad\.csv:200001: has 2 columns, but line 1 has 3")
        self.fail_with(1, "visibility", "small.nff", "--points", "none.csv", *SUN, says="none.csv: there is no such")
        self.put("huge.npy", as_npy([]).replace(b"(0, 6)", b"(9000000000000000000, 6)".ljust(6)))
        self.fail_with(1, "visibility", "small.nff", "--points", "huge.npy", *SUN, says="huge.npy: ")

    def test_arrays_need_a_file(self):
        for kind in ["npy", "ply"]:
            self.fail_with(1, "visibility", "small.nff", "--points", "p.csv", *SUN, "--output-format", kind, says="-o")

    def test_a_full_disk_and_a_closed_pipe_are_errors(self):
        self.put("many.npy", as_npy(floor_points(20000)))
        command = [self.program, "visibility", "small.nff", "--points", "many.npy", *SUN]
        with open("/dev/full", "wb") as full:
            result = subprocess.run(command, cwd=self.folder, stdout=full, stderr=subprocess.PIPE, check=False)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"cannot write to the standard output: No space left", result.stderr)
        read_end, write_end = os.pipe()
        os.close(read_end)
        result = subprocess.run(command, cwd=self.folder, stdout=write_end, stderr=subprocess.PIPE, check=False)
        os.close(write_end)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"Broken pipe", result.stderr)

    def test_pipes_of_a_shell_are_files_of_their_own(self):
        script = ('"$0" visibility small.nff --points <(echo 0 0 3) --light sun 0 0 1 1 --output-format ascii '
                  '-o >(cat > seen.txt) --stats >(cat > stats.json); wait; sleep 0.2')
        result = subprocess.run(["bash", "-c", script, self.program], cwd=self.folder, capture_output=True, text=True,
                                timeout=60, check=False)
        self.assertRegex(result.stderr, "1 points, 1 light")
        self.assertEqual((self.folder / "seen.txt").read_text(), "1\n")
        self.assertEqual(json.loads((self.folder / "stats.json").read_text())["points"], 1)

    def test_ctrl_c_leaves_no_file(self):
        before = self.files()
        process = subprocess.Popen([self.program, "visibility", "small.nff", "--points", "-", *SUN, "-o", "x.csv"],
                                   cwd=self.folder, stdin=subprocess.PIPE, stderr=subprocess.DEVNULL)
        process.stdin.write(b"0 0 0\n")
        process.stdin.flush()
        deadline = time.monotonic() + 30
        while self.files() == before and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertRegex(" ".join(self.files()), r"\.part")
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=30), -signal.SIGINT)
        process.stdin.close()
        self.assertEqual(self.files(), before)

    def test_memory_does_not_grow_with_the_stream(self):
        count = 2_000_000
        self.put("p.dat", b"\0" * 24 * count)
        command = [self.program, "visibility", "small.nff", "--points", "p.dat", "--input-format", "float", "--light",
                   "point", "0", "0", "9", "--output-format", "float", "-o", "x.dat", "--stats", "s.json",
                   "--shadow-samples", "1"]
        subprocess.run(command, cwd=self.folder, stderr=subprocess.DEVNULL, check=True)
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(stats["points"], count)
        self.assertEqual((self.folder / "x.dat").stat().st_size, 4 * count)
        self.assertLess(stats["peak_rss_bytes"], 200e6)


if __name__ == "__main__":
    main()
