"""Opens files that other programs or users may have damaged, and formats their content for messages.

Each format has one reader: study_file (XML), checkpoint (JSON), results_rows (CSV)."""

import os
import re
import stat
from typing import BinaryIO

from .mistakes import BadInput

MOST_SHOWN = 80   # characters of a quoted value in messages
NUMBER = re.compile(r"[-+]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?")   # a finite number, in all file formats


def open_file(path: str) -> BinaryIO:
    """Opens a regular file; rejects pipes and devices, which could be endless. @raise BadInput"""
    try:
        file = os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb")
    except (OSError, ValueError) as error:  # ValueError: an invalid file name
        raise BadInput(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        file.close()
        raise BadInput(f"{path}: cannot be read: it is no regular file")
    return file


def read_file(path: str, most: int) -> bytes:
    """@param most maximum size [bytes] @raise BadInput"""
    with open_file(path) as file:
        size = os.fstat(file.fileno()).st_size
        if size > most:
            raise BadInput(f"{path}: found {size} bytes, allowed: up to {most}")
        try:
            return file.read(most)
        except OSError as error:
            raise BadInput(f"{path}: cannot be read: {error.strerror}") from None


def shown(value: object) -> str:
    """A value for messages: on one line, and shortened."""
    text = str(value)
    kept = "".join(character if character.isprintable() else repr(character)[1:-1] for character in text[:MOST_SHOWN])
    return kept if len(text) <= MOST_SHOWN else f"{kept}... ({len(text)} characters)"
