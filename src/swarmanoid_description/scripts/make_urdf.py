#!/usr/bin/env python3
"""Writes urdf/<robot>.urdf for each robot. With --check it only says whether the files are up to date (exit 0 or 1)."""
import pathlib
import sys

import eyebot
import footbot
import handbot

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "urdf"


def main(arguments):
    if arguments not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    outdated = 0
    for robot in (footbot.make(), eyebot.make(), handbot.make()):
        file = FOLDER / f"{robot.name}.urdf"
        if not arguments:
            file.write_text(robot.text(), encoding="utf-8")
        elif not file.is_file() or file.read_text(encoding="utf-8") != robot.text():
            print(f"{file} is not what scripts/make_urdf.py writes: run it", file=sys.stderr)
            outdated = 1
    return outdated


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
