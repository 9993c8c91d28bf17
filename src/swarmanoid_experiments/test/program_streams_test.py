#!/usr/bin/env python3
"""The program `swarmanoid` and its standard streams: lost output is an error, and no file gets the number of a closed
stream."""

import contextlib
import json
import os
import pathlib
import pty
import subprocess
import unittest

import misbehaving_world
from program_world import BAD_INPUT, FINISHED, STOPPED, ProgramTest

FULL = "swarmanoid: standard output cannot be written: No space left on device\n"
CLOSED = "swarmanoid: standard output: found it closed, allowed: a file, a pipe or /dev/null\n"


def read_all(terminal):
    """Reads all data from a terminal, in pieces of any size."""
    data = b""
    with contextlib.suppress(OSError):  # no more data, and the other side is closed
        while piece := os.read(terminal, 65536):
            data += piece
    return data


class StreamsTest(ProgramTest):
    def shell(self, *arguments, redirection):
        """Starts the program by a shell. @return exit code and error stream"""
        done = subprocess.run(["sh", "-c", f'exec swarmanoid "$@" {redirection}', "sh", *map(str, arguments)],
                              cwd=self.folder, timeout=60, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              encoding="utf-8", errors="replace", check=False)
        return done.returncode, done.stderr

    def test_a_full_device_is_an_error(self):
        world = self.world()
        for arguments in (["run", world, "--quiet"], ["validate", world], ["validate", world, "--path"], ["list"],
                          ["list", "engine"], ["describe"], ["schema"], ["--version"], ["--help"], ["run", "--help"]):
            self.assertEqual(self.shell(*arguments, redirection="> /dev/full"), (STOPPED, FULL), arguments)
        table = (self.folder / "table.txt").read_text()
        self.assertEqual(len(table.splitlines()), 3 + 21 * 2, "the files of the run are complete")

    def test_a_closed_output_is_refused_before_anything_runs(self):
        world = self.world()
        for arguments in (["run", world, "--quiet", "--hashes", "hashes.txt"], ["list"], ["schema"], ["validate", world]):
            self.assertEqual(self.shell(*arguments, redirection=">&-"), (BAD_INPUT, CLOSED), arguments)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["world.xml"])

    def test_no_file_takes_the_place_of_other_closed_streams(self):
        arguments = ["run", self.world(fail_at=3), "--force", "--hashes", "hashes.txt"]
        self.shell(*arguments, redirection="> summary.txt")
        expected = (self.folder / "hashes.txt").read_text()
        for redirection in ("<&- 2>&- > summary.txt", "2>&- > summary.txt", "<&- > summary.txt 2> errors.txt"):
            self.shell(*arguments, redirection=redirection)
            self.assertEqual((self.folder / "hashes.txt").read_text(), expected, redirection)
            self.assertEqual((self.folder / "summary.txt").read_text().count("\n"), 1, redirection)

    def test_what_users_code_closes_and_prints_goes_into_no_file(self):
        for phase in ("load", "init", "step", "destroy"):
            with self.subTest(phase=phase):
                by_environment = phase == "load"
                (self.folder / "closing.xml").write_text(misbehaving_world.world("never" if by_environment else phase,
                                                                                 "close_output"))
                done = subprocess.run(["swarmanoid", "run", "closing.xml", "--quiet", "--force", "--bag", "run.bag",
                                       "--hashes", "hashes.txt"], cwd=self.folder, timeout=60, stdout=subprocess.PIPE,
                                      encoding="utf-8", check=False,
                                      env=dict(os.environ, MISBEHAVING="load close_output" if by_environment else ""))
                self.assertEqual(done.returncode, FINISHED)
                self.assertEqual(json.loads(done.stdout)["ticks"], 20)
                self.assertEqual((self.folder / "table.txt").read_text().count("\n"), 3 + 21 * len(misbehaving_world.ROBOTS))
                self.assertEqual((self.folder / "hashes.txt").read_text().count("\n"), 21)
                self.assertEqual(self.ticks_in(self.folder / "run.bag"), list(range(21)))

    def test_a_terminal_has_one_line_that_is_redrawn(self):
        master, slave = pty.openpty()
        self.addCleanup(os.close, master)
        done = subprocess.run(["swarmanoid", "run", self.world(visualisations="")], cwd=self.folder, timeout=60,
                              stdout=subprocess.PIPE, stderr=slave, check=False)
        os.close(slave)
        self.assertEqual(done.returncode, FINISHED)
        drawn = read_all(master).decode()
        self.assertRegex(drawn, r"\rworld \[#{40}\] 20 of at most 20 ticks, 2\.0 s simulated, \d+ ticks/s\x1b\[K\r\n$")


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
