# SPDX-License-Identifier: MIT
"""Type hints say what the module has, and everything public is documented."""
import ast
import inspect
import pathlib
import re
import typing
import unittest

import penumbra
from penumbra import _penumbra

STUB = pathlib.Path(penumbra.__file__).with_name("_penumbra.pyi")


def hinted(body):
    """Names of a module's or class's hints; of functions, with their arguments."""
    names = {}
    for node in body:
        if isinstance(node, ast.FunctionDef):
            arguments = [a.arg for a in node.args.args if a.arg != "self"]
            is_property = any(getattr(d, "id", "") == "property" for d in node.decorator_list)
            names[node.name] = None if is_property or node.args.vararg else arguments
        elif isinstance(node, ast.ClassDef):
            names[node.name] = hinted(node.body)
        elif isinstance(node, ast.AnnAssign):
            names[node.target.id] = None
    return names


def argument_count(function):
    """Of a compiled function, by the signature that heads its documentation."""
    head = re.match(r"\w+\((.*)\) ->", function.__doc__)
    parts = re.sub(r"\[[^]]*\]|\([^)]*\)", "", head[1])
    return sum(1 for part in parts.split(",") if part.strip() and not part.startswith("self"))


class Hints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.hints = hinted(ast.parse(STUB.read_text(encoding="utf-8")).body)

    def test_the_stub_names_what_the_module_has_and_no_more(self):
        made = {name for name in vars(_penumbra) if not name.startswith("__")}
        self.assertEqual(set(self.hints), made)

    def test_classes_have_the_members_that_are_hinted_and_no_more(self):
        for name, members in self.hints.items():
            made = getattr(_penumbra, name)
            if not inspect.isclass(made) or issubclass(made, Exception):
                continue
            public = {member for member in vars(made) if not member.startswith("_")}
            self.assertEqual(set(members) - {"__init__"}, public, name)

    def test_functions_take_as_many_arguments_as_are_hinted(self):
        checked = 0
        for name, hints in self.hints.items():
            place, functions = _penumbra, {name: hints}
            if isinstance(hints, dict):
                place, functions = getattr(_penumbra, name), hints
            for function, arguments in functions.items():
                if arguments is None or function == "remove":  # which has three signatures
                    continue
                self.assertEqual(argument_count(getattr(place, function)), len(arguments),
                                 f"{name}.{function}")
                checked += 1
        self.assertGreater(checked, 30)

    def test_everything_public_is_documented_and_hinted(self):
        for name in penumbra.__all__:
            made = getattr(penumbra, name)
            if inspect.isclass(made) or inspect.isfunction(made):
                self.assertTrue(made.__doc__, name)
            if inspect.isfunction(made):
                self.assertIn("return", typing.get_type_hints(made), name)
        for made in (penumbra.Occluders, penumbra.Scene):
            for name, member in vars(made).items():
                if name.startswith("_"):
                    continue
                function = member.fget if isinstance(member, property) else member
                self.assertTrue(function.__doc__, name)
                hints = typing.get_type_hints(function)
                wanted = set(inspect.signature(function).parameters) - {"self"} | {"return"}
                self.assertEqual(set(hints), wanted, name)

    def test_the_version_is_that_of_the_library(self):
        self.assertRegex(penumbra.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
