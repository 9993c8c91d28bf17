#!/usr/bin/env python3
"""Files that a run may write: those of the experiment file inside the folder of --out, no existing file, no file that
it reads, no file twice."""

import os
import pathlib
import unittest

from program_world import BAD_INPUT, FINISHED, TABLE, ProgramTest


def table(name, id="table"):
    return f'<text_render id="{id}"><file>{name}</file></text_render>'


class ConfinementTest(ProgramTest):
    def test_what_the_experiment_file_names_is_in_the_folder_of_out(self):
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        self.out.mkdir()
        (self.out / "link").symlink_to(elsewhere)
        for name in (elsewhere / "table.txt", "../elsewhere/table.txt", "deep/../../elsewhere/table.txt", "link/table.txt",
                     "/dev/full", "..", "."):
            file = self.world(visualisations=table(name))
            done = self.call("run", file, "--quiet", "--out", "out")
            self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""), name)
            self.assertEqual(done.stderr, f"swarmanoid: {file}:15: text_render 'table': file: found '{name}', allowed: a file "
                             f"in {self.folder.resolve()}/out, or --write-anywhere\n")
        self.assertEqual(list(elsewhere.iterdir()), [])

    def test_one_option_lifts_it(self):
        for name in (self.folder / "table.txt", "../other.txt"):
            self.run_world("--write-anywhere", visualisations=table(name))
            self.assertEqual(len((self.out / name).read_text().splitlines()), 3 + 21 * 2)

    def test_a_folder_of_the_folder_is_in_it(self):
        (self.out / "deep").mkdir(parents=True)
        self.run_world(visualisations=table("deep/../deep/table.txt"))
        self.assertTrue((self.out / "deep/table.txt").exists())


class OverwriteTest(ProgramTest):
    def assert_kept(self, file, text, message, *arguments):
        """Expects this message, and an unchanged file."""
        file.write_text(text)
        done = self.call("run", *arguments, "--quiet")
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""), arguments)
        self.assertEqual(done.stderr, f"swarmanoid: {message}\n")
        self.assertEqual(file.read_text(), text)

    def test_no_file_is_replaced_unless_asked_for(self):
        world, mine = self.world(), self.folder / "mine"
        found = f"found '{mine}', which is there already, allowed: another name, or --force to replace it"
        for option in ("--bag", "--hashes"):
            self.assert_kept(mine, "mine", f"{option}: {found}", world, option, "mine", "--out", "out")
            self.assertFalse(self.out.exists(), "nothing is left of a run that has not begun")
        (self.folder / "table.txt").write_text("mine")
        self.assert_kept(self.folder / "table.txt", "mine", f"{world}:15: text_render 'table': file: found 'table.txt', which is "
                         "there already, allowed: another name, another folder (--out), or --force to replace it", world)

    def test_force_replaces(self):
        for name in ("table.txt", "hashes.txt", "run.bag"):
            (self.folder / name).write_text("old" * 100000)
        done = self.call("run", self.world(), "--quiet", "--force", "--bag", "run.bag", "--hashes", "hashes.txt")
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        self.assertEqual(len((self.folder / "table.txt").read_text().splitlines()), 3 + 21 * 2)
        self.assertEqual(len((self.folder / "hashes.txt").read_text().splitlines()), 21)
        self.assertEqual(self.ticks_in(self.folder / "run.bag"), list(range(21)))

    def test_force_replaces_nothing_for_a_run_that_does_not_begin(self):
        (self.folder / "hashes.txt").write_text("old")
        done = self.call("run", self.world(visualisations=""), "--quiet", "--force", "--hashes", "hashes.txt", "--bag",
                         "nowhere/run.bag")
        self.assertEqual(done.returncode, BAD_INPUT, done.stderr)
        self.assertEqual((self.folder / "hashes.txt").read_text(), "old")

    def test_what_the_run_reads_is_never_written(self):
        world = pathlib.Path(self.world(visualisations=""))
        text, hard = world.read_text(), self.folder / "hard"
        os.link(world, hard)
        for name in (world, hard, self.folder / ".." / self.folder.name / "world.xml"):
            for option in ("--hashes", "--bag"):
                self.assert_kept(world, text, f"{option}: found '{os.path.normpath(name)}', which this run reads, allowed: another name",
                                 world, option, name, "--force")

    def test_links_are_not_followed(self):
        world, victim, link = self.world(visualisations=""), self.folder / "victim", self.folder / "link"
        link.symlink_to(victim)
        for option in ("--hashes", "--bag"):
            found = f"{option}: found '{link}', which is a link, allowed: a name that is none"
            self.assert_kept(victim, "mine", found, world, option, link, "--force")
            self.assert_kept(victim, "mine", found, world, option, link)
        victim.unlink()
        self.assert_refused(found.replace(str(link), str(link)), "run", world, "--bag", "link")

    def test_one_file_has_one_writer(self):
        world = self.world()
        same = self.folder / "same"
        self.assert_refused(f"--bag: found '{same}', which --hashes writes, allowed: another name", "run", world, "--hashes",
                            "same", "--bag", "./same", "--quiet", "--out", "out")
        twice = self.world(visualisations=table("same", "first") + "\n" + table("./same", "second"))
        self.assert_refused(f"{twice}:16: text_render 'second': file: found './same', which text_render 'first' writes, allowed: "
                            "another name", "run", twice, "--quiet", "--force")

    def test_devices_and_pipes_hold_nothing_that_could_be_lost(self):
        summary = self.run_world("--hashes", "/dev/null", "--write-anywhere", visualisations=table("/dev/null"))
        done = self.call("run", self.world(visualisations=""), "--quiet", "--hashes", "/dev/stderr")
        self.assertEqual(done.stderr.splitlines()[-1], f"20 {summary['state_hash']}")

    def test_an_empty_name_is_refused(self):
        for option in ("--bag", "--hashes"):
            self.assert_refused(f"{option}: found '', allowed: a file", "run", self.world(visualisations=TABLE), option, "")

    def test_a_folder_is_no_file(self):
        self.assert_refused(f"--bag: found '{self.folder}', which is a folder, allowed: a file", "run",
                            self.world(visualisations=""), "--bag", self.folder, "--force")


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
