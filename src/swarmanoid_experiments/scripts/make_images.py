#!/usr/bin/env python3
"""Writes the images of the heightfields in experiments and tests. Only needed to change them."""
import math
import pathlib
import struct
import zlib

PACKAGE = pathlib.Path(__file__).resolve().parent.parent
GREY = 0
COLOURED = 2

# rough_terrain.xml: 4 m x 3 m, a pixel per 0.05 m; black is 0.25 m below the floor, a grey value is 0.01 mm
LEVEL = 25000
PER_METRE = 100000
# centre x, y [m], height [m], radius [m]
HILLS = [(0.9, 2.1, 0.16, 0.55), (2.0, 0.8, 0.12, 0.45), (3.2, 2.2, 0.2, 0.5), (3.2, 0.8, 0.09, 0.35), (1.0, 0.7, 0.06, 0.3),
         (1.75, 2.55, 0.05, 0.25)]
HOLE = (2.15, 1.85, -0.22, 0.3)


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def write_png(file, rows, bits=8, kind=GREY):
    """rows: lists of values, top row first; three values per pixel if COLOURED."""
    width = len(rows[0]) // (3 if kind == COLOURED else 1)
    header = struct.pack(">IIBBBBB", width, len(rows), bits, kind, 0, 0, 0)
    lines = b"".join(b"\0" + struct.pack(f">{len(row)}{'H' if bits == 16 else 'B'}", *row) for row in rows)
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) +
                     chunk(b"IEND", b""))


def bump(distance):
    """Smooth bump: 1 in the centre, 0 from distance 1 on."""
    return 0.5 + 0.5 * math.cos(math.pi * distance) if distance < 1.0 else 0.0


def rough_height(x, y):
    height = sum(h * bump(math.hypot(x - at_x, y - at_y) / radius) for at_x, at_y, h, radius in HILLS)
    at_x, at_y, depth, radius = HOLE
    distance = math.hypot(x - at_x, y - at_y) / radius
    # flat bottom, steep sides
    hole = depth * bump(max(0.0, (distance - 0.65) / 0.35))
    # ripples that end before the rim
    middle = max(0.0, 1.0 - (abs(x - 2.0) / 1.9) ** 6) * max(0.0, 1.0 - (abs(y - 1.5) / 1.4) ** 6)
    return height + hole + 0.006 * middle * math.sin(11.0 * x + 3.0 * y) * math.sin(9.0 * y - 2.0 * x)


def main():
    write_png(PACKAGE / "experiments/rough_terrain.png",
              [[round(LEVEL + PER_METRE * rough_height(0.05 * column, 0.05 * row)) for column in range(81)]
               for row in reversed(range(61))], 16)
    write_png(PACKAGE / "test/data/hills.png", [[0, 0, 0], [0, 255, 0], [0, 0, 0]])
    write_png(PACKAGE / "test/data/coloured.png", [[255, 0, 0, 0, 255, 0], [0, 0, 255, 0, 0, 0]], 8, COLOURED)


if __name__ == "__main__":
    main()
