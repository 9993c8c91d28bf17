#!/usr/bin/python3
"""The view shows the whole arena, in a window that fits a small display and has the usual panels."""

import importlib.util
import itertools
import math
import os
import pathlib
import tempfile
import types
import unittest
import unittest.mock

import yaml

FOLDER = pathlib.Path(__file__).resolve().parent.parent
SMALL_DISPLAY = (1280, 800)  # [pixels]


def load_view():
    specification = importlib.util.spec_from_file_location("view", FOLDER / "scripts/view.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


view = load_view()


def layout():
    return yaml.safe_load((FOLDER / "rviz/space.rviz").read_text())


def vector(x, y, z, **more):
    return types.SimpleNamespace(x=x, y=y, z=z, **more)


def marker(ns, position, scale, points=(), orientation=(0.0, 0.0, 0.0, 1.0), frame="world", action=0):
    x, y, z, w = orientation
    return types.SimpleNamespace(ns=ns, action=action, header=types.SimpleNamespace(frame_id=frame), scale=vector(*scale),
                                 pose=types.SimpleNamespace(position=vector(*position), orientation=vector(x, y, z, w=w)),
                                 points=[vector(*point) for point in points])


class ViewTest(unittest.TestCase):
    def fitted(self, low, high):
        fitted = layout()
        view.fit(fitted, low, high)
        return fitted["Visualization Manager"]["Views"]["Current"]

    def picture(self, camera, low, high, aspect):
        """Positions of the box's corners in the picture, whose borders are at -1 and 1, for rviz's orbit camera as rviz
        documents it."""
        focus = [camera["Focal Point"][axis] for axis in "XYZ"]
        pitch, yaw = camera["Pitch"], camera["Yaw"]
        direction = [math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)]
        eye = [a + camera["Distance"] * b for a, b in zip(focus, direction)]
        right = [-math.sin(yaw), math.cos(yaw), 0.0]
        up = [direction[1] * right[2] - direction[2] * right[1], direction[2] * right[0] - direction[0] * right[2],
              direction[0] * right[1] - direction[1] * right[0]]
        slope = math.tan(0.5 * camera["Field of View"])
        for corner in itertools.product(*zip(low, high)):
            offset = [a - b for a, b in zip(corner, eye)]
            depth = -sum(a * b for a, b in zip(offset, direction))
            self.assertGreater(depth, camera["Near Clip Distance"])
            yield (sum(a * b for a, b in zip(offset, right)) / (depth * slope * aspect),
                   sum(a * b for a, b in zip(offset, up)) / (depth * slope))

    def test_the_whole_arena_is_in_sight_and_fills_the_picture(self):
        sizes = ((5, 5, 0.2), (5, 5, 2.6), (12.65, 12.65, 0.2), (4, 3, 2.6), (4, 2, 1), (12, 4, 3), (2, 9, 1), (1, 1, 5))
        for size in sizes:
            with self.subTest(size=size):
                low, high = (0.0, 0.0, 0.0), size
                places = list(self.picture(self.fitted(low, high), low, high, view.ASPECT))
                left, right = min(x for x, _ in places), max(x for x, _ in places)
                bottom, top = min(y for _, y in places), max(y for _, y in places)
                self.assertGreater(min(left, bottom), -0.97)
                self.assertLess(right, 0.97)
                self.assertLess(top, 0.85)  # labels need space above
                self.assertTrue(right > 0.9 or (bottom < -0.9 and top > 0.8))

    def test_the_camera_turns_about_a_point_of_the_floor(self):
        focus = self.fitted((0.0, 0.0, 0.0), (5.0, 4.0, 2.5))["Focal Point"]
        self.assertAlmostEqual(0.0, focus["Z"])
        self.assertAlmostEqual(2.5, focus["X"], places=2)
        self.assertTrue(0.0 < focus["Y"] < 4.0)

    def test_a_larger_arena_is_seen_from_further_away(self):
        near = self.fitted((0.0, 0.0, 0.0), (5.0, 5.0, 0.2))
        far = self.fitted((0.0, 0.0, 0.0), (50.0, 50.0, 2.0))
        self.assertAlmostEqual(far["Distance"], 10.0 * near["Distance"])

    def test_floor_terrain_and_everything_above_count(self):
        floor = [marker("floor", (1.0, 2.0, 0.0), (2.0, 4.0, 0.01)), marker("floor", (2.5, 0.5, 0.0), (5.0, 1.0, 0.01))]
        low, high = view.extent(floor)
        for expected, found in zip((0.0, 0.0, -0.005, 5.0, 4.0, 0.005), low + high):
            self.assertAlmostEqual(expected, found)
        terrain = marker("terrain", (0.0, 0.0, 0.0), (1.0, 1.0, 1.0), [(0.0, 1.0, -0.3), (6.0, 3.0, 0.4)])
        self.assertEqual(([0.0, 1.0, -0.3], [6.0, 3.0, 0.4]), view.extent([terrain]))
        ceiling = marker("obstacles", (2.0, 1.5, 2.55), (4.0, 3.0, 0.1))
        self.assertAlmostEqual(2.6, view.extent(floor + [ceiling])[1][2])
        half = math.sqrt(0.5)
        pole = marker("obstacles", (1.0, 1.0, 1.0), (3.0, 0.1, 0.1), orientation=(0.0, half, 0.0, half))  # stands upright
        self.assertAlmostEqual(2.5, view.extent(floor + [pole])[1][2])

    def test_robots_count_and_their_labels_do_not(self):
        floor = marker("floor", (1.0, 2.0, 0.0), (2.0, 4.0, 0.0))
        label = marker("labels", (1.0, 1.0, 9.0), (0.0, 0.0, 0.1))
        lines = marker("label_lines", (0.0, 0.0, 0.0), (0.01, 0.0, 0.0), [(1.0, 1.0, 0.3), (1.0, 1.0, 8.9), (1.0, 2.0, 2.2),
                                                                          (1.0, 2.0, 2.4)])
        self.assertAlmostEqual(2.2, view.extent([floor, label, lines])[1][2])

    def test_what_is_deleted_and_what_moves_with_another_frame_do_not_count(self):
        floor = marker("floor", (1.0, 2.0, 0.0), (2.0, 4.0, 0.0))
        others = [marker("obstacles", (9.0, 9.0, 9.0), (1.0, 1.0, 1.0), action=2),
                  marker("robots", (0.0, 0.0, 9.0), (1.0, 1.0, 1.0), frame="fb/base_link")]
        self.assertEqual(view.extent([floor]), view.extent([floor] + others))
        self.assertIsNone(view.extent([]))
        self.assertIsNone(view.extent(others))


class CameraPlacesTest(unittest.TestCase):
    def test_those_of_the_experiment_file_are_saved_views(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "cameras.xml"
            file.write_text("""<ahss-config><visualisations><text_render id="t"/><opengl_render id="w">
                <camera_view_XYZ_1>3.3, 3.4, 1.9</camera_view_XYZ_1><camera_view_HPR_1>39, -34, 5</camera_view_HPR_1>
                <camera_view_XYZ_7>1, 2, 3</camera_view_XYZ_7><camera_view_XYZ_8>here</camera_view_XYZ_8><camera_view_XYZ_9>0, 0, 0</camera_view_XYZ_9>
                </opengl_render></visualisations></ahss-config>""")
            one, seven = view.camera_places(str(file))
            self.assertEqual(("camera 1", {"X": 3.3, "Y": 3.4, "Z": 1.9}), (one["Name"], one["Position"]))
            # rviz's first-person view looks down for a positive pitch, from -x to x at yaw 0
            self.assertAlmostEqual(math.radians(39), one["Yaw"])
            self.assertAlmostEqual(math.radians(34), one["Pitch"])
            self.assertAlmostEqual(math.radians(5), one["Roll"])
            self.assertEqual(("camera 7", 0.0, 0.0, 0.0), (seven["Name"], seven["Yaw"], seven["Pitch"], seven["Roll"]))
            kept = layout()
            kept["Visualization Manager"]["Views"]["Saved"] = [{"Class": "rviz/Orbit", "Name": "camera 7"}]
            view.save_views(kept, [one, seven])
            self.assertEqual([{"Class": "rviz/Orbit", "Name": "camera 7"}, one], kept["Visualization Manager"]["Views"]["Saved"])
            file.write_text("<ahss-config>")
            self.assertEqual([], view.camera_places(str(file)))
            self.assertEqual([], view.camera_places(folder + "/not_there.xml"))


class LayoutTest(unittest.TestCase):
    def test_the_window_fits_a_small_display_beside_the_bars_of_a_desktop(self):
        window = layout()["Window Geometry"]
        self.assertLessEqual(window["X"] + window["Width"], SMALL_DISPLAY[0])
        self.assertLessEqual(window["Y"] + window["Height"], SMALL_DISPLAY[1] - 64)

    def test_the_usual_panels_are_there(self):
        names = ["Run", "Displays", "Views", "Selection", "Time"]
        self.assertEqual(sorted(names), sorted(panel["Name"] for panel in layout()["Panels"]))
        window = layout()["Window Geometry"]
        docks = bytes.fromhex(window["QMainWindow State"])
        for name in names:
            self.assertEqual({"collapsed": False}, window[name])  # rviz hides a panel without it
            self.assertIn(name.encode("utf-16-be"), docks)

    def test_what_is_ours_speaks_to_the_space_and_is_left_out_where_it_is_not_built(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(os.environ, CMAKE_PREFIX_PATH="/nowhere:" + folder):
            without = layout()
            view.address(without, "/other")
            self.assertEqual(layout()["Panels"][1:], without["Panels"])
            self.assertEqual(layout()["Visualization Manager"]["Tools"][:-1], without["Visualization Manager"]["Tools"])
            (pathlib.Path(folder) / "lib").mkdir()
            (pathlib.Path(folder) / "lib/libswarmanoid_rviz.so").touch()
            with_them = layout()
            view.address(with_them, "/other")
            self.assertEqual({"Class": "swarmanoid_rviz/Run", "Name": "Run", "Space": "/other"}, with_them["Panels"][0])
            self.assertEqual({"Class": "swarmanoid_rviz/Move", "Space": "/other"}, with_them["Visualization Manager"]["Tools"][-1])
            view.address(with_them, "/third")
            self.assertEqual("/other", with_them["Panels"][0]["Space"], "the layout's own counts")
            view.address({"Visualization Manager": {}}, "/third")

    def test_the_picture_is_not_squeezed_by_the_docks(self):
        docks = bytes.fromhex(layout()["Window Geometry"]["QMainWindow State"])
        # Qt: a marker and the version, a marker and the number of docks, then of each its side (0: left), width and height
        self.assertEqual((2, 0), (int.from_bytes(docks[9:13], "big"), int.from_bytes(docks[13:17], "big")))
        self.assertLess(int.from_bytes(docks[17:21], "big"), 0.3 * SMALL_DISPLAY[0])

    def test_the_grid_is_the_arenas_own(self):
        """rviz's own grid is always square."""
        self.assertNotIn("rviz/Grid", [display["Class"] for display in layout()["Visualization Manager"]["Displays"]])


if __name__ == "__main__":
    unittest.main()
