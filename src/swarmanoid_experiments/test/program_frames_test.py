#!/usr/bin/env python3
"""Pictures of runs: `<opengl_render>` and `run --frames`."""

import json
import pathlib
import subprocess
import sys
import unittest

import matplotlib.image
import numpy
import swarmanoid

from program_world import BAD_INPUT, FINISHED, STOPPED, ProgramTest

# the wall of the small experiment from 3 m straight above, and the robot at rest
RENDER = """<opengl_render id="view">
  <window_size>121, 81</window_size>
  <camera_view_XYZ_0>5, 5, 3</camera_view_XYZ_0><camera_view_HPR_0>90, -90, 0</camera_view_HPR_0>
  <camera_view_XYZ_4>2, 3, 1</camera_view_XYZ_4><camera_view_HPR_4>90, -90, 0</camera_view_HPR_4>
  <write_frames>true</write_frames><every>8</every>
  {more}
</opengl_render>"""
MOVING = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>20</maxclock></framework>
  <controllers>
    <diffusion id="dc" library="diffusion">
      <actuators><footbot_wheels/></actuators><sensors><footbot_proximity/></sensors><parameters><speed>0.3</speed></parameters>
    </diffusion>
  </controllers>
  <arena size="10,10,3" optimization="2D">
    <distribute quantity="{quantity}" layout="grid">
      <minimum>4, 4, 0</minimum><maximum>6, 6, 0</maximum><random_heading>false</random_heading>
      <footbot id="fb"><orientation>0, 0, 20</orientation><controller>dc</controller></footbot>
    </distribute>
    <block id="wall"><position>6.5, 5, 0.25</position><orientation>0, 0, 45</orientation><size>1, 0.1, 0.5</size></block>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/><entity id="wall"/></engine></arena_physics>
  <visualisations>{render}</visualisations>
</ahss-config>
"""
BETWEEN = """<interventions>
  <spawn tick="1" engines="ground"><footbot id="late"><position>4.2, 5, 0</position><orientation>0, 0, 0</orientation></footbot></spawn>
  <move tick="2" entity="wall"><position>6.5, 4, 0.25</position><orientation>0, 0, 10</orientation></move>
</interventions>
"""
FLOOR, WALL = (0.82, 0.83, 0.85), (0.55, 0.57, 0.6)
# of a colour on a level surface: half of it comes from the sun, scaled by the sine of its elevation
LEVEL = 0.5 + 0.5 / (0.4**2 + 0.55**2 + 1) ** 0.5


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
        # 1 m long and 0.1 m thick, from south-west to north-east, its top at half a metre: a pixel covers 2.4 cm of it
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
        simulation = swarmanoid.Simulation(self.moving_world("<every>4</every>"), out=str(self.out))
        simulation.tick(8)
        simulation.reset()
        simulation.tick(4)
        simulation.close()
        self.assertEqual(self.names(), [f"frame_00000{number}.png" for number in range(5)])
        first, after, _, again, and_after = (self.frame(name) for name in self.names())
        self.assertGreater(numpy.abs(first - after).max(), 0.1, "the robot moves")
        numpy.testing.assert_array_equal(first, again)
        numpy.testing.assert_array_equal(after, and_after)

    def moving_world(self, more, quantity=1):
        """Driving footbots seen from above, with one in the middle."""
        file = self.folder / "moving.xml"
        render = RENDER.replace("<every>8</every>", "").format(more=more).replace("5, 5, 3<", "5, 5, 6<")
        file.write_text(MOVING.format(quantity=quantity, render=render))
        return str(file)

    def test_what_is_done_between_two_frames_is_seen_in_the_next(self):
        (self.folder / "what.xml").write_text(BETWEEN)
        frames = []
        for every in (1, 3):
            done = self.call("run", self.moving_world(f"<every>{every}</every><frame_directory>{every}</frame_directory>"), "--quiet",
                             "--out", "out", "--ticks", 6, "--interventions", "what.xml")
            self.assertEqual(done.returncode, FINISHED, done.stderr)
            frames.append([self.frame(f"{every}/{name}") for name in self.names(str(every))])
        for tick in (0, 3, 6):
            numpy.testing.assert_array_equal(frames[0][tick], frames[1][tick // 3], f"tick {tick}")
        changes = [numpy.abs(frames[1][k] - frames[1][k + 1]).max(axis=2) > 0.05 for k in (0, 1)]
        self.assertGreater(changes[0].sum(), 300, "the wall has moved, and a robot has come")
        self.assertLess(changes[1].sum(), 0.5 * changes[0].sum(), "and then robots drive")

    def test_many_robots_are_balls(self):
        done = self.call("run", self.moving_world("", 30),
                         "--quiet", "--out", "out", "--ticks", 1)
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        picture = self.frame("frame_000001.png")
        blue = (picture[..., 2] > 1.2 * picture[..., 0]) & (picture[..., 2] > 0.3)
        self.assertGreater(blue.sum(), 30 * 4, "a ball of a footbot is three pixels wide, a line ahead lies on it")

    def test_without_a_folder_python_and_batches_write_none(self):
        mine = self.folder / "frame_000000.png"
        mine.write_text("mine")
        program = ("import swarmanoid, sys; run = swarmanoid.Simulation(sys.argv[1]); run.tick(2); run.close()")
        for command in ((sys.executable, "-c", program, self.world(visualisations=render())),
                        ("swarmanoid", "batch", self.world(visualisations=render()), "--seeds", "1", "--ticks", "2", "--quiet",
                         "--no-report")):
            subprocess.run(command, cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
            self.assertEqual(sorted(file.name for file in self.folder.glob("*.png")), [mine.name])
            self.assertEqual(mine.read_text(), "mine")

    def test_what_becomes_of_frames_and_of_the_current_folder_is_no_matter(self):
        program = ("import glob, os, swarmanoid, sys\n"
                   "run = swarmanoid.Simulation(sys.argv[1], out='out')\n"
                   "os.mkdir('elsewhere'); os.chdir('elsewhere')\n"
                   "for tick in range(24):\n"
                   "    run.tick(1)\n"
                   "    for file in glob.glob('../out/frame_*'): os.remove(file)\n"
                   "run.tick(1)\n")
        world = self.world(maxclock=30, visualisations=render().replace("<every>8</every>", ""))
        subprocess.run((sys.executable, "-c", program, world), cwd=self.folder, check=True)
        self.assertEqual(self.names(), ["frame_000025.png"])
        self.assertEqual(list((self.folder / "elsewhere").iterdir()), [])

    def test_a_full_disk_leaves_whole_pictures_alone(self):
        done = subprocess.run(("bash", "-c", 'ulimit -f 1; exec swarmanoid run "$0" --quiet --out out',
                               self.world(visualisations=render().replace("121, 81", "400, 300"))), cwd=self.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, STOPPED, done.stderr)
        self.assertIn("opengl_render 'view'", done.stderr)
        self.assertIn("out/frame_000000.png", done.stderr)
        self.assertEqual(list(self.out.iterdir()), [])

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
        self.assert_render_refused("15: opengl_render 'view': frame_filename: found '../x0.png', "
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

    def test_a_later_frame_that_is_there_is_found_before_the_run(self):
        self.out.mkdir()
        (self.out / "frame_000002.png").write_text("mine")
        (self.out / "frame_2.png.txt").write_text("another's")
        self.assert_render_refused("15: opengl_render 'view': frame_filename: found 'frame_000002.png', which is there already, "
                                   "allowed: another name, another folder (--out), or --force to replace it", "")
        done = self.call("run", self.world(visualisations=render()), "--quiet", "--out", "out", "--force")
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        self.assertEqual((self.out / "frame_000002.png").read_bytes()[:4], b"\x89PNG")

    def test_two_have_names_of_their_own(self):
        self.assert_render_refused("21: opengl_render 'other': frame_filename: found 'frame_', as opengl_render 'view' names its "
                                   "files, allowed: another name", "", RENDER + RENDER.replace('"view"', '"other"'))

    def test_what_is_said_of_a_camera_without_a_place_is_refused(self):
        self.assert_render_refused("20: camera: found '3', allowed: with camera_view_XYZ_3", "<camera>3</camera>")
        self.assert_render_refused("17: camera_view_HPR_0: found '90, -90, 0', allowed: with camera_view_XYZ_0", "",
                                   RENDER.replace("XYZ_0>5, 5, 3</camera_view_XYZ_0", "XYZ_7>5, 5, 3</camera_view_XYZ_7"))

    def test_sizes_are_whole_pixels(self):
        self.assert_render_refused("16: window_size: found '100.5, 80', allowed: whole numbers", "",
                                   RENDER.replace("121, 81", "100.5, 80"))
        self.assert_refused("--frames: found '', allowed: a folder", "run", "gap", "--quiet", "--frames", "")
        done = self.call("run", "gap", "--frames", "x", "--frames-every", 0)
        self.assertEqual((done.returncode, (self.folder / "x").exists()), (BAD_INPUT, False))
        self.assertIn("--frames-every: Value 0 not in range 1 to 1000000000", done.stderr)


class DeclaredTest(ProgramTest):
    def declare(self, library, label):
        """Declares the library like an installed package."""
        declared = self.folder / "share/swarmanoid/plugins"
        declared.mkdir(parents=True)
        (declared / library).write_text(f"my_package\nvisualisation {label}\n")
        self.put_before_prefixes()

    def test_a_label_that_two_libraries_have_declared_needs_the_library(self):
        self.declare("another", "opengl_render")
        world = self.world(visualisations='<opengl_render id="r"/>')
        self.assert_refused(f"{world}:15: found no library, though several have declared 'opengl_render', allowed: library=\"...\", "
                            "one of another, swarmanoid_rendering", "validate", world)
        world = self.world(visualisations='<opengl_render id="r" library="swarmanoid_rendering"/>')
        self.assertEqual(self.call("validate", world).returncode, FINISHED)

    def test_a_library_that_has_declared_a_label_is_loaded_for_it(self):
        self.declare("gone", "my_plotter")
        world = self.world(visualisations='<my_plotter id="p"/>')
        done = self.call("validate", world)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertRegex(done.stderr, f"^swarmanoid: {world}:15: library 'gone': found no libgone.so in ")
        self.assert_refused(f"{world}:15: found visualisation 'my_ploter', allowed: debug_render, hash_recorder, "
                            "intervention_recorder, metrics_table, my_plotter, opengl_render, text_render; did you mean 'my_plotter'?",
                            "validate", self.world(visualisations='<my_ploter id="p"/>'))


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
