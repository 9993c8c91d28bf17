#!/usr/bin/python3
"""tidy.py BUILD_FOLDER [--since DATE]: runs clang-tidy over the sources of all packages built there, without tests.

Unity builds are checked per unit. A unit is skipped if its preprocessed text, its checks and the version of clang-tidy are those
of its last pass, which BUILD_FOLDER/tidy_passed stores. --since restricts the check to units with a source that commits after that
date have changed; the date has the format of `git log --since`."""

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


def changed_since(date):
    """Paths changed by commits since a date; in a clone without history, the only commit has changed all paths. None without a
    repository."""
    log = subprocess.run(["git", "log", f"--since={date}", "--name-only", "--format="], cwd=ROOT, stdout=subprocess.PIPE, text=True,
                         check=False)
    return set(log.stdout.split()) if log.returncode == 0 else None


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
