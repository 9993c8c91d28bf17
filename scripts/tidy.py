#!/usr/bin/python3
"""tidy.py BUILD_FOLDER [--since DATE]: clang-tidy over the sources of all packages that are built there, tests left out.

What is compiled as one is looked at as one. A unit is skipped if its text after the preprocessor, its checks and the
version of clang-tidy are those with which it passed before; BUILD_FOLDER/tidy_passed holds them. With --since, only those units
are looked at of which commits after that date have changed a source, as `git log --since` takes it."""

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
    """The sources of the project that a unit of the compilation is made of; empty for tests and generated files."""
    path = pathlib.Path(unit["file"])
    paths = INCLUDE.findall(path.read_text()) if path.parent.name == "Unity" else [unit["file"]]
    inside = [os.path.relpath(path, ROOT) for path in paths]
    return inside if all(OURS.fullmatch(path) for path in inside) else []


def fingerprint(unit, checks):
    """Of all that clang-tidy looks at: comments too, which may switch checks off."""
    command = shlex.split(unit["command"])
    command = command[:command.index("-o")] + command[command.index("-o") + 2:]
    text = subprocess.run([*command, "-E", "-C", "-P"], cwd=unit["directory"], stdout=subprocess.PIPE, check=True).stdout
    return hashlib.sha256(checks + shlex.join(command).encode() + text).hexdigest()


def changed_since(date):
    """Paths that commits have changed since then; of a clone without history its only commit has changed all. Nothing where there is
    no repository."""
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
        """@return what is to be remembered, and what clang-tidy says: nothing if the unit was known"""
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
