#!/usr/bin/env python3
"""Says whether a recorded bag can be read: prints its full name, or in one line what is wrong with it.

    check_bag.py RUN.bag

Exit code: 0 it can be read, 2 it cannot. launch/play_bag.launch asks before it starts anything, and bag_to_csv.py reads
bags with the functions of this file."""

import argparse
import pathlib
import sys

import rosbag

BAD_INPUT = 2


class BagError(Exception):
    """A bag that cannot be read: its name, and why."""


def open_bag(file):
    """The bag, to be used in a with statement. Raises BagError for a file that is not there, is no bag or not complete."""
    if not pathlib.Path(file).exists():
        raise BagError(f"{file}: no such file")
    try:
        return rosbag.Bag(str(file))
    except rosbag.ROSBagUnindexedException:
        raise BagError(f"{file}: is not complete, its index is missing: the recording or a copy was cut short; "
                       "'rosbag reindex' saves what is there") from None
    except (rosbag.ROSBagException, UnicodeDecodeError):
        raise BagError(f"{file}: found no bag, expected a file that begins with '#ROSBAG V2.0'") from None
    except OSError as problem:
        raise BagError(f"{file}: cannot be read: {problem.strerror}") from None


def messages(file, topics):
    """Topic and message, in the order of their times. Raises BagError, also for data that turn out to be damaged."""
    with open_bag(file) as bag:
        try:
            for topic, message, _ in bag.read_messages(topics=topics):
                yield topic, message
        except OSError as problem:
            raise BagError(f"{file}: cannot be read: {problem.strerror}") from None
        except Exception as problem:  # the reader passes on whatever decompression and deserialisation throw
            raise BagError(f"{file}: is damaged: {problem}") from None


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
