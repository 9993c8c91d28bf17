#!/usr/bin/env python3
"""Outputs of runs of the program `swarmanoid`: the table of thesis figure 3.11, complete files after Ctrl-C, and log lines
during the run."""

import json
import math
import os
import pathlib
import pty
import signal
import subprocess
import time
import unittest

import rosbag

from program_world import CONTROLLER_FAILED, FINISHED, HEADER, INTERRUPTED, TABLE, WORLD, ProgramTest, table_of

# as printed, except the empty column
FIGURE = (pathlib.Path(__file__).parent / "data" / "figure_3_11.txt").read_text().replace("\t\t", "\t")
WHEEL_RADIUS = 0.029  # m


class TextTableTest(ProgramTest):
    def test_figure_3_11_comes_out_as_it_is_printed(self):
        """The figure's entities are in no engine, so they keep the positions of the file, and tick 10 is the figure."""
        entities = ""
        for line in FIGURE.splitlines():
            _, kind, name, *numbers = line.split("\t")
            size = "<size>0.1, 0.1, 0.1</size>" if kind == "Block" else ""
            entities += (f'<{kind.lower()} id="{name}"><position>{", ".join(numbers[:3])}</position>'
                         f'<orientation>{", ".join(numbers[3:])}</orientation>{size}</{kind.lower()}>\n')
        table = '<text_render id="t"><file>t.txt</file><precision>3</precision><every>10</every></text_render>'
        file = self.folder / "figure.xml"
        file.write_text("<ahss-config><framework><clocktick>100</clocktick><maxclock>10</maxclock></framework>"
                        f'<arena size="10,10,4" optimization="3D">{entities}</arena>'
                        f"<visualisations>{table}</visualisations></ahss-config>")
        done = self.call("run", file, "--quiet")
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        start = "".join("0" + line[2:] + "\n" for line in FIGURE.splitlines())
        self.assertEqual(table_of(self.folder / "t.txt", self), HEADER + start + FIGURE)

    def test_lines_follow_the_robot(self):
        self.run_world(maxclock=3)
        wall = "\tBlock\twall\t5\t5\t0.25\t0\t0\t45\n"
        expected = HEADER
        for tick in range(4):
            y = f"{3.0 + tick * 0.1 * WHEEL_RADIUS:.6g}"
            expected += f"{tick}\tFootbot\tfb\t2\t{y}\t0\t0\t0\t90\n{tick}{wall}"
        self.assertEqual(table_of(self.out / "table.txt", self), expected)

    def test_tables_say_of_which_run_they_are(self):
        tables = ('<text_render id="t"><file>t.txt</file></text_render><debug_render id="d"><file>d.txt</file></debug_render>'
                  '<metrics_table id="m"><file>m.csv</file></metrics_table>')
        world = self.world(maxclock=3, visualisations=tables)
        done = self.call("run", world, "--quiet", "--seed", 9, "--set", "arena.size=11,10,3", "--set", "arena.wall.size=1, 0.2,\n0.5")
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        version = self.call("--version").stdout.split()[-1]
        for name in ("t.txt", "d.txt", "m.csv"):
            first, *_, last = (self.folder / name).read_text().splitlines()
            self.assertEqual(first, f"# world, seed 9, swarmanoid {version}, with arena.size=11,10,3, arena.wall.size=1, 0.2, 0.5")
            self.assertEqual(last, f"# ended after 3 ticks, state hash {json.loads(done.stdout)['state_hash']}")


class LogTest(ProgramTest):
    """Logs of robots: whole lines, one for each entry."""

    def test_lines_of_robots_that_step_in_several_threads(self):
        robots = 300
        done = self.call("run", self.crowd(robots), "--threads", 4)
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        lines = done.stderr.splitlines()
        talk = [line for line in lines if ": tick" in line]
        self.assertEqual(sorted(talk), sorted(f"fb_{i}: tick {tick}" for i in range(robots) for tick in range(5)))
        for line in set(lines) - set(talk):
            self.assertRegex(line, r"^world \[[#.]{40}\] \d of at most 5 ticks, [0-9.]+ s simulated, \d+ ticks/s(, about .* left)?$")

    def crowd(self, robots):
        """The small world with many robots that log, without other entities."""
        begin, end = WORLD.index("    <footbot"), WORLD.index("  </arena>")
        many = "".join(f'    <footbot id="fb_{i}"><position>{0.3 + i % 20 * 0.4:.1f}, {0.3 + i // 20 * 0.4:.1f}, 0</position>'
                       "<orientation>0, 0, 90</orientation><controller>fc</controller></footbot>\n" for i in range(robots))
        text = WORLD[:begin] + many + WORLD[end:]
        text = text.replace('<entity id="fb"/><entity id="wall"/>', "".join(f'<entity id="fb_{i}"/>' for i in range(robots)))
        return self.world(maxclock=5, visualisations="", text=text.replace("<fail_at>", "<talks>true</talks><fail_at>"))

    def test_on_a_terminal_the_bar_makes_room_for_lines(self):
        master, terminal = pty.openpty()
        with subprocess.Popen(["swarmanoid", "run", self.world(fail_at=3, visualisations="")], stderr=terminal,
                              stdout=subprocess.DEVNULL) as process:
            os.close(terminal)
            output = b""
            while True:
                try:
                    output += os.read(master, 1 << 16)
                except OSError:  # the program has closed its end
                    break
        os.close(master)
        self.assertEqual(process.returncode, CONTROLLER_FAILED)
        lines = output.decode(errors="replace").split("\r\n")
        self.assertEqual(lines.pop(), "", "the last line is ended")
        shown = [line.split("\r")[-1].replace("\x1b[K", "") for line in lines]  # final content of each row
        self.assertEqual(len(shown), 2, lines)
        self.assertRegex(shown[0], "^fb: controller failed in tick 3, the robot stops: told to, .$")
        self.assertIn("20 of at most 20 ticks", shown[1])


class InterruptTest(ProgramTest):
    def interrupted(self, number):
        """Runs for ever, and is interrupted after some progress. @return exit code and summary"""
        bag = self.folder / "run.bag"
        arguments = ["swarmanoid", "run", self.world(maxclock=10**9), "--quiet", "--out", str(self.out), "--bag", str(bag)]
        table = self.out / "table.txt"
        for file in (table, bag):
            file.unlink(missing_ok=True)
        with subprocess.Popen(arguments, stdout=subprocess.PIPE, encoding="utf-8") as process:
            deadline = time.monotonic() + 30
            while not (table.exists() and table.stat().st_size > 100000) and time.monotonic() < deadline:
                time.sleep(0.01)
            process.send_signal(number)
            output = process.communicate(timeout=30)[0]
        return process.returncode, json.loads(output)

    def test_results_are_kept_and_complete(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            code, summary = self.interrupted(number)
            self.assertEqual(code, INTERRUPTED)
            self.assertFalse(summary["finished"])
            ticks = summary["ticks"]
            lines = (self.out / "table.txt").read_text()
            self.assertTrue(lines.endswith("\n"))
            lines = lines.splitlines()
            self.assertEqual(len(lines), 2 + 2 * (ticks + 1) + 1)
            self.assertTrue(lines[-2].startswith(f"{ticks}\tBlock\twall\t"))
            self.assertEqual(lines[-1], f"# ended after {ticks} ticks, state hash {summary['state_hash']}")
            with rosbag.Bag(str(self.folder / "run.bag")) as bag:
                states = [message.tick for _, message, _ in bag.read_messages("/space/world_state")]
            self.assertEqual(states, list(range(ticks + 1)))

    def test_an_interrupted_run_is_the_beginning_of_the_whole_one(self):
        _, summary = self.interrupted(signal.SIGINT)
        again = self.run_world("--ticks", summary["ticks"], maxclock=10**9, visualisations=TABLE)
        self.assertEqual(again["state_hash"], summary["state_hash"])
        self.assertTrue(math.isfinite(again["wall_s"]))


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
