#!/usr/bin/env python3
"""Checks whether a recorded bag can be read: prints its absolute path, or the problem in one line.

    check_bag.py RUN.bag

Exit code: 0 readable, 2 not readable. launch/play_bag.launch calls it before it starts any node."""

import argparse
import pathlib
import sys

from swarmanoid.bag_file import BagError, open_bag

BAD_INPUT = 2


def main():
    parser = argparse.ArgumentParser(prog="check_bag", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bag", type=pathlib.Path)
    file = parser.parse_args().bag.absolute()
    try:
        open_bag(file).close()
    except BagError as problem:
        print(f"check_bag: {problem}", file=sys.stderr)
        return BAD_INPUT
    print(file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
