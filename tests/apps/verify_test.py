# SPDX-License-Identifier: MIT
"""verify_test.py PROGRAM [TEST...]: `render --verify` asks the judge again."""
import json

from cli_case import SMALL, CliTest, main


class Verify(CliTest):
    def test_right_answers_are_counted(self):
        for method in ["stochastic", "offset", "reduced", "umbra", "shaft"]:
            with self.subTest(method=method):
                result = self.succeed("render", "small.nff", *SMALL, "--light-radius", "10%", "--method", method,
                                      "--verify", "200", "-o", "x.exr", "--stats", "s.json")
                self.assertRegex(result.stderr, f"verified 200 answers of {method}\n")
                self.assertEqual(json.loads((self.folder / "s.json").read_text())["verified"], 200)

    def test_the_picture_is_the_same(self):
        self.succeed("render", "bust", *SMALL, "--method", "shaft", "-o", "a.exr", "--stats", "s.json")
        self.assertEqual(json.loads((self.folder / "s.json").read_text())["verified"], 0)
        self.succeed("render", "bust", *SMALL, "--method", "shaft", "--verify", "1000000", "-o", "b.exr")
        self.succeed("compare", "a.exr", "b.exr")

    def test_bad_usage(self):
        render = ["render", "small.nff", *SMALL, "-o", "x.png"]
        self.fail_with(2, *render, "--verify", "10", "--method", "hard", says="--verify: hard")
        self.fail_with(2, *render, "--verify", "10", "--pixel", "1,1", says="--verify")
        for count in ["0", "-1", "x"]:
            self.fail_with(2, *render, "--verify", count, says=f"--verify {count}")


if __name__ == "__main__":
    main()
