#!/usr/bin/env python3
"""Writes the descriptions of the suite's devices into the pages of docs/reference/devices/.

A page has the devices of one kind, each in a section. A section begins with the output of `swarmanoid describe` for the device and its
default implementation, with headings one level lower, between two comments. The rest of the section is written by hand: Law, which
defines how readings are computed or commands executed, and Topics. A device without a section gets one, with an empty law, in a page of
its own."""

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
NEW_PAGE = ("# {}\n\nFrames, units, time, noise and errors: [properties of all devices](../devices.md). `swarmanoid describe` also prints "
            "the engines that\nexecute a device, and further implementations.\n")
START = f"^(?:{re.escape(BEGIN)}\n*)?## "
SECTION = re.compile(rf"{START}([^\n]+)\n.*?(?={START}|\Z)", re.M | re.S)
IMPLEMENTATION = re.compile(r"^## Implementation .*?(?=^## |\Z)", re.M | re.S)
DEFAULT = "- The default: an experiment that names none means this one\n"
ENGINES = re.compile(r"^- Engines: .*\n", re.M)
HEADER = re.compile(r"`((\w+)/\S+\.hpp)`$", re.M)
HEADING = re.compile(r"^#", re.M)
LAW = re.compile(r"^### Law\n(.*?)(?=^### |\Z)", re.M | re.S)


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
    description = ENGINES.sub("", description)
    if len(IMPLEMENTATION.findall(description)) > 1:
        description = IMPLEMENTATION.sub(lambda found: found[0].replace(DEFAULT, "") if DEFAULT in found[0] else "", description)
    return re.sub(r"\n{3,}", "\n\n", description).rstrip() + "\n"


def generated(description):
    """The generated part of a section."""
    linked = HEADER.sub(r"[`\1`](../../../src/\2/include/\1)", of_default(description))
    return f"{BEGIN}\n" + HEADING.sub("##", linked) + f"\n{END}"


def sections_of(folder):
    """@return page, device and text of each section in the pages of a folder"""
    return [(path, found[1], found[0]) for path in sorted(folder.glob("*.md")) for found in SECTION.finditer(path.read_text())]


def parts_of(section):
    """@return the generated and the handwritten part; None if the comments are missing"""
    found = re.fullmatch(f"({re.escape(BEGIN)}.*?{re.escape(END)})(.*)", section, re.S)
    return found and found.groups()


def section_problems(place, section, description, command):
    """Messages about errors in the section of a device."""
    parts = parts_of(section)
    if parts is None:
        return [f"{place}: found no part from the code, allowed: one between '{BEGIN.strip()}' before the heading and "
                f"'{END.strip()}'; put both there and call {command}"]
    found = []
    difference = list(difflib.unified_diff(parts[0].splitlines(), generated(description).splitlines(), "the page", "the code",
                                           n=0, lineterm=""))
    if difference:
        found.append("\n".join([f"{place}: found other than what the code says; made anew by {command}", *difference]))
    law = LAW.search(parts[1])
    if law is None or not law[1].strip():
        found.append(f"{place}: found nothing under '### Law', allowed: by which law the simulator makes its readings or carries "
                     "out its commands, with formulas, or that it is exact; to be written by hand")
    return found


def problems(descriptions, folder, command):
    """Messages about errors in the pages of a folder. @param command that writes the pages"""
    found = []
    pages = {}
    sections = sections_of(folder)
    for path, name, section in sections:
        place = f"{path}, section '{name}'"
        if name not in descriptions:
            found.append(f"{place}: found no device '{name}' in the suite, allowed: sections of devices; delete it")
        elif name in pages:
            found.append(f"{place}: found another one in {pages[name]}, allowed: one for each device; delete one of them")
        else:
            found += section_problems(place, section, descriptions[name], command)
        pages.setdefault(name, path)
    for path in sorted(set(folder.glob("*.md")) - {path for path, _, _ in sections}):
        found.append(f"{path}: found no section of a device, allowed: pages of devices; delete it")
    for name in sorted(set(descriptions) - set(pages)):
        found.append(f"{folder}: found no section '{name}', allowed: one for each device; made in {name}.md by {command}")
    return found


def rewrite(descriptions, folder):
    """Rewrites the generated parts. @return the pages that changed"""
    def renewed(section):
        parts = parts_of(section[0])
        return generated(descriptions[section[1]]) + parts[1] if parts and section[1] in descriptions else section[0]

    before = {path: path.read_text() for path in folder.glob("*.md")}
    after = {path: SECTION.sub(renewed, text) for path, text in before.items()}
    for name in set(descriptions) - {name for _, name, _ in sections_of(folder)}:
        path = folder / f"{name}.md"
        after[path] = after.get(path, NEW_PAGE.format(name)).rstrip() + f"\n\n{generated(descriptions[name])}\n### Law\n"
    changed = sorted(path for path, text in after.items() if text != before.get(path))
    for path in changed:
        path.write_text(after[path])
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
    return 1 if wrong and arguments.check else 0  # a new section still needs its law


if __name__ == "__main__":
    sys.exit(main())
