#!/usr/bin/env python3
"""Writes urdf/<robot>.urdf for each robot: each file beside this one that has a function `make`. With --check it only says whether the
files are up to date (exit 0 or 1)."""
import importlib
import pathlib
import sys

SCRIPTS = pathlib.Path(__file__).resolve().parent
FOLDER = SCRIPTS.parent / "urdf"


def robots():
    for file in sorted(SCRIPTS.glob("*.py")):
        if "\ndef make(" in file.read_text(encoding="utf-8"):
            yield importlib.import_module(file.stem).make()


def main(arguments):
    if arguments not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    outdated = 0
    for robot in robots():
        file = FOLDER / f"{robot.name}.urdf"
        if not arguments:
            file.write_text(robot.text(), encoding="utf-8")
        elif not file.is_file() or file.read_text(encoding="utf-8") != robot.text():
            print(f"{file} is not what scripts/make_urdf.py writes: run it", file=sys.stderr)
            outdated = 1
    return outdated


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
