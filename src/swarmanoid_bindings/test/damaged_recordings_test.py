#!/usr/bin/python3
"""Damaged recordings, random and by hand: each is read, or rejected by a RecordingError with its name."""

import errno
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import h5py
import rosbag
import swarmanoid

CASES = 300   # of each format


class DamagedRecordingsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.damaged = cls.folder / "damaged"
        subprocess.run(["swarmanoid", "run", "phototaxis", "--ticks", "5", "--quiet", "--bag", "run.bag", "--trajectories", "run.h5"],
                       cwd=cls.folder, stdout=subprocess.DEVNULL, check=True)

    def damage(self, content, chance):
        changed = bytearray(content)
        place = chance.randrange(len(changed))
        kind = chance.randrange(3)
        if kind == 0:
            for _ in range(chance.choice((1, 3, 30))):
                changed[chance.randrange(len(changed))] = chance.randrange(256)
        elif kind == 1:
            size = chance.choice((8, 64, 512))
            changed[place:place + size] = bytes([chance.choice((0, 255))]) * size
        else:
            del changed[place:]
        return bytes(changed)

    def refusal(self):
        """@return the error message, or None if the file is read"""
        try:
            swarmanoid.load(self.damaged)
            return None
        except swarmanoid.RecordingError as error:
            self.assertRegex(str(error), rf"\A{re.escape(str(self.damaged))}: [^\n]+\Z")
            return str(error)[len(str(self.damaged)) + 2:]

    def test_at_random(self):
        for name in ("run.h5", "run.bag"):
            content = (self.folder / name).read_bytes()
            chance = random.Random(3)
            refused = 0
            for case in range(CASES):
                with self.subTest(name, case=case):
                    self.damaged.write_bytes(self.damage(content, chance))
                    refused += self.refusal() is not None
            self.assertGreater(refused, CASES // 4)

    def assert_refused(self, message, change):
        """@param change function that damages the HDF5 file"""
        shutil.copy(self.folder / "run.h5", self.damaged)
        with h5py.File(self.damaged, "r+") as file:
            change(file)
        self.assertEqual(self.refusal(), message)

    def test_what_an_hdf5_file_lacks_or_has_as_something_else_is_named(self):
        def replace(file, name, data):
            del file[name]
            file[name] = data

        self.assert_refused("found format no format_version, allowed: 1", lambda file: file.attrs.pop("format_version"))
        self.assert_refused("found format two, allowed: 1", lambda file: file.attrs.create("format_version", "two"))
        self.assert_refused("found no 'seed', allowed: a file as `swarmanoid run --trajectories` writes it",
                            lambda file: file.attrs.pop("seed"))
        self.assert_refused("found no 'pose', allowed: a file as `swarmanoid run --trajectories` writes it",
                            lambda file: file.pop("pose"))
        self.assert_refused("is damaged: IndexError: tuple index out of range", lambda file: replace(file, "pose", [1.0, 2.0]))
        self.assert_refused("is damaged: ValueError: Illegal slicing argument for scalar dataspace",
                            lambda file: replace(file, "entities/name", 3))

    def test_a_pipe_is_not_waited_for(self):
        self.damaged.unlink(missing_ok=True)
        os.mkfifo(self.damaged)
        self.addCleanup(self.damaged.unlink)
        self.assertEqual(self.refusal(), "cannot be read: it is no regular file")

    def test_what_is_not_damaged_is_not_said_to_be(self):
        shutil.copy(self.folder / "run.h5", self.damaged)
        with mock.patch.object(pathlib.Path, "exists", side_effect=PermissionError(errno.EACCES, "Permission denied")):
            self.assertEqual(self.refusal(), "cannot be read: Permission denied")
        with mock.patch.object(h5py.Dataset, "__getitem__", side_effect=OSError(errno.EIO, "Input/output error")):
            self.assertEqual(self.refusal(), "cannot be read: Input/output error")
        with mock.patch.object(h5py.Dataset, "__getitem__", side_effect=MemoryError("9 GB")):
            self.assertEqual(self.refusal(), "does not fit into memory: 9 GB")
        with mock.patch.dict(sys.modules, {"swarmanoid.trajectory_file": None}), self.assertRaises(ImportError):
            swarmanoid.load(self.damaged)
        shutil.copy(self.folder / "run.bag", self.damaged)
        with mock.patch.object(rosbag.Bag, "read_messages", side_effect=MemoryError):
            self.assertEqual(self.refusal(), "does not fit into memory")
        with mock.patch.object(rosbag.Bag, "read_messages", side_effect=ImportError("no roslz4")), self.assertRaises(ImportError):
            swarmanoid.load(self.damaged)


if __name__ == "__main__":
    unittest.main()
