#!/usr/bin/env python3
"""Writes the small images of this folder: hills.png, a grey one of 3 x 3 pixels, and coloured.png."""
import os
import struct
import zlib


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def write_png(name, rows, channels):
    """rows: of bytes, `channels` of them a pixel."""
    header = struct.pack(">IIBBBBB", len(rows[0]) // channels, len(rows), 8, 0 if channels == 1 else 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows), 9)
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), name), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


write_png("hills.png", [[0, 0, 0], [0, 255, 0], [0, 0, 0]], 1)
write_png("coloured.png", [[255, 0, 0, 0, 255, 0], [0, 0, 255, 0, 0, 0]], 3)
