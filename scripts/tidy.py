#!/usr/bin/python3
"""tidy.py BUILD_FOLDER [--since DATE]: runs clang-tidy over the sources of all packages built there, without tests.

Unity builds are checked per unit. A unit is skipped if its preprocessed text, its checks and the version of clang-tidy are those
of its last pass, which BUILD_FOLDER/tidy_passed stores. --since restricts the check to units with a source whose code has
changed since the last commit before that date; comments, includes and a new place of a file do not count. The date has the format of
`git log --since`."""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

from check_prose import C_TOKEN

ROOT = pathlib.Path(__file__).resolve().parent.parent
CHECKS = ROOT / ".clang-tidy"
INCLUDE = re.compile(r'^#include "(/[^"]+)"$', re.M)
OURS = re.compile(r"src/\w+/src/.*\.cpp")


def sources(unit):
    """The project's sources in a compilation unit; empty for tests and generated files."""
    path = pathlib.Path(unit["file"])
    paths = INCLUDE.findall(path.read_text()) if path.parent.name == "Unity" else [unit["file"]]
    inside = [os.path.relpath(path, ROOT) for path in paths]
    return inside if all(OURS.fullmatch(path) for path in inside) else []


def fingerprint(unit, checks):
    """Hash of all inputs of clang-tidy, including comments, which may disable checks."""
    command = shlex.split(unit["command"])
    command = command[:command.index("-o")] + command[command.index("-o") + 2:]
    text = subprocess.run([*command, "-E", "-C", "-P"], cwd=unit["directory"], stdout=subprocess.PIPE, check=True).stdout
    return hashlib.sha256(checks + shlex.join(command).encode() + text).hexdigest()


def code_of(text):
    """@return a C++ file without layout, includes, and comments, except those that disable checks"""
    text = re.sub(r'^ *#include [<"].*', "", text, flags=re.M)
    without = C_TOKEN.sub(lambda token: " " if token["comment"] and "NOLINT" not in token.group() else token.group(), text)
    return without.split()


def changed_since(date):
    """@return sources whose code differs from that of the last commit before a date; None if there is no such commit, as in a clone
    without history"""
    def git(*arguments):
        return subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=False).stdout

    before = git("rev-list", "-1", f"--before={date}", "HEAD").strip()
    if not before:
        return None
    rows = [row.split("\t") for row in git("diff", "--name-status", "-M40%", "-l0", before, "--", "*.cpp").splitlines()]
    return {row[-1] for row in rows if (ROOT / row[-1]).exists()
            and code_of(git("show", f"{before}:{row[1]}")) != code_of((ROOT / row[-1]).read_text())}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--since", metavar="DATE", help="such as '2 days ago'")
    arguments = parser.parse_args()
    version = subprocess.run(["clang-tidy", "--version"], stdout=subprocess.PIPE, check=True).stdout
    checks = CHECKS.read_bytes() + version
    passed = arguments.build / "tidy_passed"
    known = set(passed.read_text().split()) if passed.exists() else set()
    commands = json.loads((arguments.build / "compile_commands.json").read_text())
    units = [unit for unit in commands if sources(unit)]
    if arguments.since:
        changed = changed_since(arguments.since)
        units = [unit for unit in units if changed is None or changed.intersection(sources(unit))]

    def look(unit):
        """@return fingerprint of the unit, or None if it has findings; output of clang-tidy; whether the unit had passed before"""
        mark = fingerprint(unit, checks)
        if mark in known:
            return mark, "", True
        done = subprocess.run(["clang-tidy", "-p", arguments.build, "--config-file", CHECKS, "--quiet", unit["file"]],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        return (mark if done.returncode == 0 else None), done.stdout, False

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(look, units))
    marks = {mark for mark, _, _ in results if mark}
    passed.write_text("".join(f"{mark}\n" for mark in sorted(marks | known if arguments.since else marks)))
    findings = [text for mark, text, _ in results if mark is None]
    for text in findings:
        print(text)
    skipped = sum(was_known for _, _, was_known in results)
    files = sum(len(sources(unit)) for unit in units)
    print(f"clang-tidy: {files} files in {len(units)} units, {skipped} of them as when they passed, {len(findings)} with findings",
          file=sys.stderr)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
