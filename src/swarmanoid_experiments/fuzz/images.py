"""Makes valid, nearly valid and invalid images for heightfields."""

import struct
import zlib

MAGIC = b"\x89PNG\r\n\x1a\n"
EXPERIMENT = """<ahss-config>
  <framework><clocktick>10</clocktick><maxclock>3</maxclock></framework>
  <arena size="10,10,3" optimization="3D">
    <heightfield><file>image.png</file><position>2.5, 2, -0.25</position><size>4, 3</size><height>0.6</height></heightfield>
    <cylindric_prey id="prey"><radius>0.1</radius><height>0.1</height><position>4.1, 3.2, 1</position>
      <orientation>0, 0, 0</orientation></cylindric_prey>
  </arena>
  <engines><dynamics3d id="engine"/></engines>
  <arena_physics><engine id="engine"><entity id="prey"/></engine></arena_physics>
</ahss-config>
"""


def _chunk(kind, data, checksum=None):
    checksum = zlib.crc32(kind + data) if checksum is None else checksum
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)


def _header(random, is_sound):
    """@return its bytes, length of a line [bytes], number of lines"""
    depth = random.choice([8, 16] if is_sound else [1, 2, 4, 8, 16, 3, 0])
    color = 0 if is_sound else random.choice([0, 2, 3, 4, 6, 5])
    width, height = (random.choice([2, 3, 7, 64] if is_sound else [0, 1, 2, 64, 4097, 2**31 - 1]) for _ in range(2))
    methods = [0, 0, 0] if is_sound else [random.choice([0, 0, 1]) for _ in range(3)]
    samples = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}.get(color, 1)
    line = 1 + (min(width, 4000) * samples * max(depth, 1) + 7) // 8
    return struct.pack(">IIBBBBB", width, height, depth, color, *methods), line, min(height, 64)


def _picture(random):
    """Returns a PNG with an arbitrary header, and lines that may or may not match it."""
    is_sound = random.random() < 0.6
    header, line, lines = _header(random, is_sound)
    lines += 0 if is_sound else random.choice([0, 0, -1, 1])
    filters = [0, 1, 2, 3, 4] if is_sound else [0, 1, 2, 3, 4, 9]
    data = b"".join(bytes([random.choice(filters)]) + random.randbytes(line - 1) for _ in range(lines))
    pieces = [_chunk(b"IHDR", header)]
    if random.random() < 0.2:
        kind = random.choice([b"tEXt", b"zTXt", b"iCCP", b"abcd", b"ABCD", b"tRNS", b"PLTE"])
        pieces.append(_chunk(kind, random.randbytes(random.choice([3, 48, 768, 769]))))
    pieces.append(_chunk(b"IDAT", zlib.compress(data), None if random.random() < 0.95 else 1))
    if is_sound or random.random() < 0.7:
        pieces.append(_chunk(b"IEND", b""))
    if not is_sound and random.random() < 0.2:
        random.shuffle(pieces)
    return MAGIC + b"".join(pieces)


def make(random, good):
    """@param good bytes of a valid image @return description of the change, and bytes of an image"""
    if random.random() < 0.5:
        return "made up", _picture(random)
    data = bytearray(good)
    way = random.choice(["flip", "cut", "noise", "length"])
    if way == "flip":
        for _ in range(random.choice([1, 4, 40])):
            data[random.randrange(len(data))] ^= 1 << random.randrange(8)
    elif way == "cut":
        del data[random.randrange(len(data)):]
    elif way == "noise":
        place = random.randrange(len(data))
        data[place:place] = random.randbytes(random.choice([1, 100]))
    else:
        data[8:12] = struct.pack(">I", random.choice([0, 12, 14, 2**31 - 1, 2**32 - 1]))
    return way, bytes(data)
