#!/usr/bin/env python3
"""Writes the descriptions of the suite's devices into the pages of docs/reference/devices/.

A page begins with the output of `swarmanoid describe` for the device and its default implementation, between two comments.
The sections below are written by hand: Law, which defines how readings are computed or commands executed, and Topics. A device
without a page gets one, with an empty law."""

import argparse
import difflib
import pathlib
import re
import subprocess
import sys
import tempfile

from surroundings import bare, sourced, succeed

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ROOT / "docs/reference/devices"
BEGIN = "<!-- from the code, by scripts/device_pages.py -->\n"
END = "<!-- by hand from here on -->\n"
IN_COMMON = ("\nFrames, units, time, noise and errors: [what holds for all devices](../devices.md). `swarmanoid describe {}` has "
             "the engines that execute it, and further implementations, if there are any.\n")
IMPLEMENTATION = re.compile(r"^## Implementation .*?(?=^## |\Z)", re.M | re.S)
DEFAULT = "- The default: an experiment that names none means this one\n"
ENGINES = re.compile(r"^- Engines: .*\n", re.M)
HEADER = re.compile(r"`((\w+)/\S+\.hpp)`$", re.M)
LAW = re.compile(r"^## Law\n(.*?)(?=^## |\Z)", re.M | re.S)


def described(build):
    """Descriptions of the devices by type, from the program of a build folder."""
    with tempfile.TemporaryDirectory(prefix="swarmanoid_pages_") as home:
        environment = sourced(bare(home), str(build / "devel/setup.bash"))
        return by_device(succeed(["swarmanoid", "describe"], environment))


def by_device(text):
    """@param text output of `swarmanoid describe`"""
    parts = re.split(r"^# (\w+)\n", text, flags=re.M)[1:]
    return {name: f"# {name}\n{part.rstrip()}\n" for name, part in zip(parts[::2], parts[1::2])}


def of_default(description):
    """A description without engines, and without implementations other than the default, so that adding one changes no page."""
    description = re.sub(r"\n{3,}", "\n\n", ENGINES.sub("", description))
    if len(IMPLEMENTATION.findall(description)) == 1:
        return description
    kept = IMPLEMENTATION.sub(lambda found: found[0].replace(DEFAULT, "") if DEFAULT in found[0] else "", description)
    return kept.rstrip() + "\n"


def generated(description):
    """The generated part of a page."""
    name = re.match(r"# (\w+)\n", description)[1]
    linked = HEADER.sub(r"[`\1`](../../../src/\2/include/\1)", of_default(description))
    return f"{BEGIN}\n{linked}{IN_COMMON.format(name)}\n{END}"


def parts_of(page):
    """@return the generated and the handwritten part; None if the comments are missing"""
    found = re.fullmatch(f"({re.escape(BEGIN)}.*?{re.escape(END)})(.*)", page, re.S)
    return found and found.groups()


def problems(descriptions, folder, command):
    """Messages about errors in the pages of a folder. @param command that writes the pages"""
    found = []
    for name in sorted({path.stem for path in folder.glob("*.md")} - set(descriptions)):
        found.append(f"{folder / name}.md: found no device '{name}' in the suite, allowed: pages of devices; delete it")
    for name, description in sorted(descriptions.items()):
        path = folder / f"{name}.md"
        if not path.exists():
            found.append(f"{path}: not there, allowed: a page for each device; made by {command}")
            continue
        parts = parts_of(path.read_text())
        if parts is None:
            found.append(f"{path}: found no part from the code, allowed: one between '{BEGIN.strip()}' in the first line and "
                         f"'{END.strip()}'; put both there and call {command}")
            continue
        difference = list(difflib.unified_diff(parts[0].splitlines(), generated(description).splitlines(), "the page",
                                               "the code", n=0, lineterm=""))
        if difference:
            found.append("\n".join([f"{path}: found other than what the code says; made anew by {command}", *difference]))
        law = LAW.search(parts[1])
        if law is None or not law[1].strip():
            found.append(f"{path}: found nothing under '## Law', allowed: by which law the simulator makes its readings or carries "
                         "out its commands, with formulas, or that it is exact; to be written by hand")
    return found


def rewrite(descriptions, folder):
    """Rewrites the generated parts. @return the pages that changed"""
    changed = []
    for name, description in sorted(descriptions.items()):
        path = folder / f"{name}.md"
        before = path.read_text() if path.exists() else f"{BEGIN}{END}\n## Law\n"
        parts = parts_of(before)
        after = parts and generated(description) + parts[1]
        if parts and (after != before or not path.exists()):
            path.write_text(after)
            changed.append(path)
    return changed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="build folder, whose devel space is sourced")
    parser.add_argument("--check", action="store_true", help="change nothing, only say what is wrong")
    arguments = parser.parse_args()
    try:
        descriptions = described(arguments.build.resolve())
    except (AssertionError, subprocess.CalledProcessError) as error:
        sys.exit(f"device_pages.py: {arguments.build}: found no build that works: {error}")
    for path in [] if arguments.check else rewrite(descriptions, PAGES):
        print(f"{path}: written")
    wrong = problems(descriptions, PAGES, f"scripts/device_pages.py --build {arguments.build}")
    print("\n".join(wrong) if wrong else f"pages: {len(descriptions)} devices, all as the code says")
    return 1 if wrong and arguments.check else 0  # a new page still needs its law


if __name__ == "__main__":
    sys.exit(main())
