#!/usr/bin/env python3
"""Pictures of runs: `<opengl_render>` and `run --frames`."""

import json
import pathlib
import unittest

import matplotlib.image
import numpy
import swarmanoid

from program_world import BAD_INPUT, FINISHED, ProgramTest

# the wall of the small experiment from 3 m straight above, and the robot: it stands still
RENDER = """<opengl_render id="view">
  <window_size>121, 81</window_size>
  <camera_view_XYZ_0>5, 5, 3</camera_view_XYZ_0><camera_view_HPR_0>90, -90, 0</camera_view_HPR_0>
  <camera_view_XYZ_4>2, 3, 1</camera_view_XYZ_4><camera_view_HPR_4>90, -90, 0</camera_view_HPR_4>
  <write_frames>true</write_frames><every>8</every>
  {more}
</opengl_render>"""
FLOOR, WALL = (0.82, 0.83, 0.85), (0.55, 0.57, 0.6)
LEVEL = 0.5 + 0.5 / (0.4**2 + 0.55**2 + 1) ** 0.5  # of a colour: half of it is the sun's, by the sine of its height


def render(more="", text=RENDER):
    return text.format(more=more)


class FramesTest(ProgramTest):
    def frame(self, name):
        return matplotlib.image.imread(self.out / name)

    def names(self, folder="."):
        return sorted(file.name for file in (self.out / folder).glob("*.png"))

    def test_frames_show_the_arena_from_the_camera(self):
        self.run_world(visualisations=render())
        self.assertEqual(self.names(), [f"frame_00000{number}.png" for number in range(3)])
        picture = self.frame("frame_000002.png")
        self.assertEqual(picture.shape, (81, 121, 3))
        numpy.testing.assert_allclose(picture[40, 60], LEVEL * numpy.array(WALL), atol=0.005)
        # 1 m long and 0.1 m thick, from south-west to north-east, its top half a metre high: a pixel shows 2.4 cm of it
        scale = 2 * numpy.tan(numpy.radians(30)) * 2.5 / 121
        for along, expected in ((0.45, WALL), (-0.45, WALL)):
            row, column = round(40 - along * 0.5**0.5 / scale), round(60 + along * 0.5**0.5 / scale)
            numpy.testing.assert_allclose(picture[row, column], LEVEL * numpy.array(expected), atol=0.005)
        numpy.testing.assert_allclose(picture[60, 20], LEVEL * numpy.array(FLOOR), atol=0.005)

    def test_another_camera_another_folder_and_other_names(self):
        self.run_world(visualisations=render("<camera>4</camera><frame_directory>a/b</frame_directory>"
                                             "<frame_filename>above_</frame_filename>"))
        self.assertEqual(self.names("a/b"), [f"above_00000{number}.png" for number in range(3)])
        middle = self.frame("a/b/above_000000.png")[36:45, 56:65].reshape(-1, 3)
        self.assertGreater(numpy.abs(middle - LEVEL * numpy.array(FLOOR)).max(axis=1).min(), 0.05, "the robot is there")

    def test_nothing_is_written_unless_asked_for(self):
        self.run_world(visualisations=render().replace("<write_frames>true", "<write_frames>false"))
        self.assertEqual(list(self.out.iterdir()), [])

    def test_a_reset_goes_on_with_the_numbers(self):
        world = self.world(visualisations=render().replace("<every>8", "<every>2"))
        simulation = swarmanoid.Simulation(world, out=str(self.out))
        simulation.tick(4)
        simulation.reset()
        simulation.tick(2)
        simulation.close()
        self.assertEqual(self.names(), [f"frame_00000{number}.png" for number in range(5)])
        numpy.testing.assert_array_equal(self.frame("frame_000000.png"), self.frame("frame_000003.png"))

    def test_the_run_is_the_same_with_and_without(self):
        for experiment in ("rough_terrain", "object_retrieval"):
            arguments = (experiment, "--quiet", "--ticks", 40, "--threads", 2)
            without = json.loads(self.call("run", *arguments).stdout)
            done = self.call("run", *arguments, "--frames", self.out / experiment, "--frames-every", 20)
            self.assertEqual(done.returncode, FINISHED, done.stderr)
            self.assertEqual(json.loads(done.stdout)["state_hash"], without["state_hash"])
            self.assertEqual(len(self.names(experiment)), 3)
            corner = self.frame(f"{experiment}/frame_000000.png")[0, 0]
            numpy.testing.assert_allclose(corner, (0.91, 0.94, 0.97), atol=0.003, err_msg="the arena is seen as a whole")


class RefusedTest(ProgramTest):
    def assert_render_refused(self, message, more, text=RENDER):
        world = self.world(visualisations=render(more, text))
        before = sorted(self.folder.rglob("*"))
        done = self.call("run", world, "--quiet", "--out", "out")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (BAD_INPUT, "", f"swarmanoid: {world}:{message}\n"))
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_frames_are_in_the_folder_of_the_run(self):
        inside = f"allowed: a folder in {self.folder.resolve()}/out, or --write-anywhere"
        self.assert_render_refused(f"15: opengl_render 'view': frame_directory: found '../other', {inside}",
                                   "<frame_directory>../other</frame_directory>")
        self.assert_render_refused("15: opengl_render 'view': frame_filename: found '../x000000.png', "
                                   + inside.replace("a folder", "a file"), "<frame_filename>../x</frame_filename>")

    def test_frames_that_are_there_are_kept(self):
        self.out.mkdir()
        (self.out / "frame_000000.png").write_text("mine")
        self.assert_render_refused("15: opengl_render 'view': frame_filename: found 'frame_000000.png', which is there already, "
                                   "allowed: another name, another folder (--out), or --force to replace it", "")
        self.assertEqual((self.out / "frame_000000.png").read_text(), "mine")
        done = self.call("run", self.world(visualisations=""), "--quiet", "--frames", self.out)
        self.assertEqual((done.returncode, done.stderr), (BAD_INPUT, f"swarmanoid: --frames: found '{self.out}/frame_000000.png', "
                                                          "which is there already, allowed: another name, or --force to replace it\n"))

    def test_sizes_are_whole_pixels(self):
        self.assert_render_refused("16: window_size: found '100.5, 80', allowed: whole numbers", "",
                                   RENDER.replace("121, 81", "100.5, 80"))
        done = self.call("run", "gap", "--frames", "x", "--frames-every", 0)
        self.assertEqual((done.returncode, (self.folder / "x").exists()), (BAD_INPUT, False))
        self.assertIn("--frames-every: Value 0 not in range 1 to 1000000000", done.stderr)


class DeclaredTest(ProgramTest):
    def test_a_library_that_has_declared_a_label_is_loaded_for_it(self):
        declared = self.folder / "share/swarmanoid/plugins"
        declared.mkdir(parents=True)
        (declared / "gone").write_text("my_package\nvisualisation my_plotter\n")
        self.put_before_prefixes()
        world = self.world(visualisations='<my_plotter id="p"/>')
        done = self.call("validate", world)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertRegex(done.stderr, f"^swarmanoid: {world}:15: library 'gone': found no libgone.so in ")
        self.assert_refused(f"{world}:15: found visualisation 'my_ploter', allowed: debug_render, hash_recorder, "
                            "intervention_recorder, metrics_table, my_plotter, opengl_render, text_render; did you mean 'my_plotter'?",
                            "validate", self.world(visualisations='<my_ploter id="p"/>'))


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
