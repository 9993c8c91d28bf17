#!/usr/bin/env python3
"""What runs of the program `swarmanoid` leave behind: the table of thesis figure 3.11, and complete files after Ctrl-C."""

import json
import math
import pathlib
import signal
import subprocess
import time
import unittest

import rosbag

from program_world import FINISHED, HEADER, INTERRUPTED, TABLE, ProgramTest

FIGURE = (pathlib.Path(__file__).parent / "data" / "figure_3_11.txt").read_text()
WHEEL_RADIUS = 0.029  # m


class TextTableTest(ProgramTest):
    def test_figure_3_11_comes_out_as_it_is_printed(self):
        """The figure's entities, in no engine: they stay where the file puts them, so tick 10 is the figure."""
        entities = ""
        for line in FIGURE.splitlines():
            _, _, kind, name, *numbers = line.split("\t")
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
        self.assertEqual((self.folder / "t.txt").read_text(), HEADER + start + FIGURE)

    def test_lines_follow_the_robot(self):
        self.run_world(maxclock=3)
        wall = "\t\tBlock\twall\t5\t5\t0.25\t0\t0\t45\n"
        expected = HEADER
        for tick in range(4):
            y = f"{3.0 + tick * 0.1 * WHEEL_RADIUS:.6g}"
            expected += f"{tick}\t\tFootbot\tfb\t2\t{y}\t0\t0\t0\t90\n{tick}{wall}"
        self.assertEqual((self.out / "table.txt").read_text(), expected)


class InterruptTest(ProgramTest):
    def interrupted(self, number):
        """A run that would take for ever, interrupted once it has got somewhere. @return exit code and summary"""
        bag = self.folder / "run.bag"
        arguments = ["swarmanoid", "run", self.world(maxclock=10**9), "--quiet", "--out", str(self.out), "--bag", str(bag)]
        table = self.out / "table.txt"
        table.unlink(missing_ok=True)
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
            self.assertEqual(len(lines), 1 + 2 * (ticks + 1))
            self.assertTrue(lines[-1].startswith(f"{ticks}\t\tBlock\twall\t"))
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
