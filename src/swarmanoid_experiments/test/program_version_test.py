#!/usr/bin/env python3
"""The version that the program prints: that of the package, and the commit at the last build."""

import pathlib
import re
import shutil
import subprocess
import unittest

from program_world import FINISHED, ProgramTest

PACKAGE = pathlib.Path(__file__).resolve().parents[1]
AUTHOR = ["-c", "user.name=nobody", "-c", "user.email=nobody@localhost"]


class VersionTest(ProgramTest):
    def test_it_is_that_of_the_package(self):
        version = re.search("<version>(.*)</version>", (PACKAGE / "package.xml").read_text()).group(1)
        done = self.call("--version")
        self.assertEqual((done.returncode, done.stderr), (FINISHED, ""))
        self.assertRegex(done.stdout, rf"^swarmanoid {re.escape(version)}\+([0-9a-f]{{12}}(\.dirty)?|unknown)\n$")

    def git(self, *arguments):
        return subprocess.run(["git", *AUTHOR, *arguments], cwd=self.folder, stdout=subprocess.PIPE, check=True,
                              encoding="utf-8").stdout.strip()

    def written(self, source=None, git=shutil.which("git")):
        """Writes the version file as a build does. @return the commit in it"""
        file = self.folder / "out.cpp"
        subprocess.run(["cmake", f"-DSOURCE={source or self.folder}", "-DVERSION=1.2.3", f"-DGIT={git}",
                        f"-DOUTPUT={file}", "-P", PACKAGE.parent / "swarmanoid_space/cmake/write_version.cmake"], check=True)
        return re.search(r'return "1\.2\.3\+(.*)"; ', file.read_text()).group(1)

    def test_the_commit_follows_the_clone(self):
        (self.folder / "package.xml").write_text("one")
        self.assertEqual(self.written(), "unknown")
        self.git("init", "-q")
        self.git("add", "package.xml")
        self.git("commit", "-qm", "first")
        first = self.git("rev-parse", "--short=12", "HEAD")
        self.assertEqual(self.written(), first)
        written = (self.folder / "out.cpp").stat().st_mtime_ns
        self.assertEqual(self.written(), first)
        self.assertEqual((self.folder / "out.cpp").stat().st_mtime_ns, written, "so nothing is compiled")
        (self.folder / "package.xml").write_text("two")
        self.assertEqual(self.written(), first + ".dirty")
        self.git("commit", "-qam", "second")
        self.git("tag", "-a", "-m", "", "v1")
        second = self.git("rev-parse", "--short=12", "HEAD")
        self.assertNotEqual(second, first)
        self.assertEqual(self.written(), second)
        self.assertEqual(self.written(git="GIT_EXECUTABLE-NOTFOUND"), "unknown")
        # a copy inside another repository
        (self.folder / "copy").mkdir()
        (self.folder / "copy/package.xml").write_text("one")
        self.assertEqual(self.written(self.folder / "copy"), "unknown")


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
