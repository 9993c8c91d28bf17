"""Valid and invalid values for experiment files."""

NUMBERS = ["0", "-0", "1", "-1", "1e40", "-1e40", "1e308", "1e309", "1e-40", "1e-9", "5e-324", "nan", "-nan", "inf", "-inf",
           "infinity", "1e9", "1e12", "9007199254740993", "2147483648", "4294967296", "18446744073709551616",
           "-9223372036854775809", "0x10", "1,5", "1.2.3", "--1", "+1", "1e", "e5", ".", "1 2", "1_000", "9" * 400,
           "0." + "0" * 400 + "1", "0.1f", "１", "1\u00a0"]
TEXTS = ["", " ", "\t\n", "a", "a" * 100000, "\u0000", "%s%n%x", "../../etc/passwd", "/etc/passwd", "/dev/full", "/dev/zero",
         "$(id)", "`id`", "&amp;", "&#0;", "&#x110000;", "&#" + "9" * 3000 + ";", "<", "]]>", "\ufeff", "\ud7ff", "é", "\U0001f916",
         "true", "false", "TRUE", "yes", "-", "id", "ground", "fb", "fb_1", "a.b", "a/b", "a b", ";", "'", '"', "\\", "*", "."]
COLORS = ["red", "256,0,0", "-1,0,0", "1,2", "1,2,3,4", "0.5,0,0", "#ff0000", "Red"]


def good(kind, random):
    """Returns a value that this kind most likely allows."""
    if kind is None:
        return ""
    if kind.words:
        return random.choice(kind.words)
    if kind.base == "boolean":
        return random.choice(["true", "false"])
    if kind.base in ("number", "integer"):
        low = float(kind.low) if kind.low is not None else -10.0
        high = float(kind.high) if kind.high is not None else 10.0
        value = random.choice([low, high, random.uniform(low, high), random.uniform(low, min(high, low + 10.0))])
        return str(int(value)) if kind.base == "integer" else repr(value)
    if kind.base in ("two_numbers", "three_numbers"):
        count = 2 if kind.base == "two_numbers" else 3
        return ", ".join(repr(random.uniform(-1.0, 10.0)) for _ in range(count))
    if kind.base == "color":
        return random.choice(["red", "1, 2, 3"])
    return random.choice(["a", "fb", "eb", "ground", "wall", "dc", "x_1"])


def extreme(kind, random):
    """Returns a value at a bound of the grammar, or an extreme one if it has no bounds."""
    base = kind.base if kind is not None else "text"
    if base in ("number", "integer"):
        ends = [end for end in (kind.low, kind.high) if end is not None]
        return random.choice(ends or ["0", "1e-6", "1e6", "-1e6"])
    if base in ("two_numbers", "three_numbers"):
        count = 2 if base == "two_numbers" else 3
        return ", ".join(random.choice(["0", "1e-3", "1e-6", "0.1", "1", "9.99", "100", "1e4", "1e6", "-1", "90", "1e9"])
                         for _ in range(count))
    return good(kind, random)


def bad(kind, random):
    """Returns a value that may be rejected, or cause trouble."""
    base = kind.base if kind is not None else "text"
    if base in ("number", "integer"):
        return random.choice(NUMBERS)
    if base in ("two_numbers", "three_numbers"):
        count = random.choice([1, 2, 3, 3, 3, 4])
        return ",".join(random.choice(NUMBERS if random.random() < 0.5 else ["1", "2.5", "-3"]) for _ in range(count))
    if base == "color":
        return random.choice(COLORS)
    return random.choice(TEXTS)


def escaped(text):
    """Escapes text for XML, but keeps entities and angle brackets, so that it may be malformed."""
    return text.replace('"', "&quot;") if "&" in text or "<" in text else text
