#!/usr/bin/python3
"""Documentation of the package: examples in docstrings run, and all public names have docstrings and types."""

import ast
import doctest
import importlib
import inspect
import os
import re
import unittest

import swarmanoid
import swarmanoid.environments

MODULES = ("swarmanoid", "swarmanoid.environments", "swarmanoid._single")
HIDDEN = {"metadata", "render_mode", "spec"}   # required by Gymnasium and PettingZoo


def public_members(kind):
    """Functions and properties that the class itself defines."""
    for name, member in vars(kind).items():
        if not name.startswith("_") and (callable(member) or isinstance(member, (property, staticmethod))):
            yield name, member


def classes_of(name):
    module = importlib.import_module(name)
    for each in getattr(module, "__all__", vars(module)):
        value = getattr(module, each)
        if inspect.isclass(value) and value.__module__ == name and not each.startswith("_"):
            yield value


def texts():
    """Pairs of name and docstring for all public names of the package."""
    for name in MODULES:
        module = importlib.import_module(name)
        yield name, module.__doc__
        for kind in classes_of(name):
            yield f"{name}.{kind.__name__}", kind.__doc__
            for member_name, member in public_members(kind):
                yield f"{name}.{kind.__name__}.{member_name}", getattr(member, "__doc__", None)


def stub_of(name):
    """Names by class in the stub file of a module, or in the module itself if it has no stub."""
    folder = os.path.dirname(swarmanoid.__file__)
    file = os.path.join(folder, "__init__" if name == "swarmanoid" else name.rpartition(".")[2])
    with open(file + (".pyi" if os.path.exists(file + ".pyi") else ".py")) as opened:
        tree = ast.parse(opened.read())
    stub = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            stub[node.name] = {each.name if isinstance(each, ast.FunctionDef) else each.target.id for each in node.body
                               if isinstance(each, (ast.FunctionDef, ast.AnnAssign))}
        elif isinstance(node, ast.FunctionDef):
            stub[node.name] = set()
        elif isinstance(node, ast.ImportFrom):   # re-exported names belong to this module, too
            stub.update(stub_of(f"swarmanoid.{node.module}") if node.level == 1 and node.module else {})
    return stub


class DocumentationTest(unittest.TestCase):
    def test_examples_do_what_they_say(self):
        run = 0
        runner = doctest.DocTestRunner(verbose=False)
        for name, text in texts():
            environment = dict(vars(swarmanoid.environments)) if "environments" in name else {}
            example = doctest.DocTestParser().get_doctest(text or "", environment, name, None, None)
            run += len(example.examples)
            printed = []
            runner.run(example, out=printed.append)
            self.assertEqual("".join(printed), "", name)
        self.assertGreater(run, 15)

    def test_all_has_a_text(self):
        known = {name: text for name, text in texts() if not name.startswith("swarmanoid._single.P")}
        self.assertEqual([name for name, text in known.items() if not text and name.rpartition(".")[2] not in HIDDEN
                          and not re.search(r"\.(Spawn|Delete|Move|HandOver|Set\w+|Disc|Paint|ErrorModel|Box|Part|Devices|"
                                            r"ParallelEnv|Env)\.", name)], [])

    def test_texts_say_shapes_and_units(self):
        for name, wanted in (("poses", r"\(robots, 7\).*\[m\]"), ("twists", r"\(robots, 6\).*\[m/s\].*\[rad/s\]"),
                             ("property", r"\(robots,\)"), ("numbers", r"\(robots,\)")):
            self.assertRegex(getattr(swarmanoid.Robots, name).__doc__, wanted)
        for kind in ("Move", "Spawn", "Disc"):
            self.assertIn("[m]", getattr(swarmanoid, kind).__doc__)

    def test_all_has_types(self):
        for name in MODULES:
            stub = stub_of(name)
            for kind in classes_of(name):
                if issubclass(kind, BaseException) or kind.__name__ == "Fields":
                    continue
                with self.subTest(kind):
                    self.assertIn(kind.__name__, stub)
                    missing = {member for member, _ in public_members(kind)} - stub[kind.__name__]
                    self.assertEqual(missing - {"fromkeys"}, set())
        self.assertLessEqual(set(swarmanoid.__all__), set(stub_of("swarmanoid")))


if __name__ == "__main__":
    unittest.main()
