#!/usr/bin/python3
"""The view fits the arena: all of it in sight, a grid of few cells that begins at its corner."""

import importlib.util
import pathlib
import types
import unittest

import yaml

FOLDER = pathlib.Path(__file__).resolve().parent.parent


def load_view():
    specification = importlib.util.spec_from_file_location("view", FOLDER / "scripts/view.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


view = load_view()


class ViewTest(unittest.TestCase):
    def fitted(self, *size):
        layout = yaml.safe_load((FOLDER / "rviz/space.rviz").read_text())
        view.fit(layout, *size)
        manager = layout["Visualization Manager"]
        grid = next(display for display in manager["Displays"] if display["Class"] == "rviz/Grid")
        return manager["Views"]["Current"], grid

    def test_cells_have_round_lengths(self):
        for side, length in ((1.0, 0.1), (5.0, 0.5), (12.65, 1.0), (126.5, 10.0)):
            self.assertAlmostEqual(length, view.cell_length(side))

    def test_the_grid_begins_at_the_corner(self):
        _, grid = self.fitted(12.65, 12.65, 0.2)
        self.assertEqual(12, grid["Plane Cell Count"])
        self.assertAlmostEqual(6.0, grid["Offset"]["X"])

    def test_a_larger_arena_is_seen_from_further_away(self):
        near, _ = self.fitted(5.0, 5.0, 0.2)
        far, _ = self.fitted(50.0, 50.0, 0.2)
        self.assertGreater(far["Distance"], 9.0 * near["Distance"])

    def test_the_floor_may_have_a_terrain_in_the_place_of_its_parts(self):
        def part(ns, x, y, width, depth, points=()):
            position = types.SimpleNamespace(x=x, y=y)
            return types.SimpleNamespace(ns=ns, pose=types.SimpleNamespace(position=position), points=points,
                                         scale=types.SimpleNamespace(x=width, y=depth))

        floor = [part("floor", 1.0, 2.0, 2.0, 4.0), part("floor", 2.5, 0.5, 5.0, 1.0)]
        self.assertEqual((5.0, 4.0), view.extent(floor + [part("obstacles", 9.0, 9.0, 1.0, 1.0)]))
        corner = types.SimpleNamespace(x=6.0, y=3.0)
        self.assertEqual((6.0, 3.0), view.extent([part("terrain", 0.0, 0.0, 1.0, 1.0, [corner])]))
        self.assertIsNone(view.extent([]))

    def test_there_is_room_for_those_who_fly(self):
        flat, _ = self.fitted(5.0, 5.0, 0.2)
        high, _ = self.fitted(5.0, 5.0, 2.4)
        self.assertGreater(high["Distance"], flat["Distance"])
        self.assertGreater(high["Focal Point"]["Y"], flat["Focal Point"]["Y"])


if __name__ == "__main__":
    unittest.main()
