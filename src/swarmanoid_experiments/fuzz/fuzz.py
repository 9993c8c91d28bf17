#!/usr/bin/python3
"""fuzz.py files|images|controllers|launched_controllers: runs the program on unusual inputs, and checks how it ends.

A run must not crash, hang or exceed the memory limit, its exit code must be documented, and it must give a reason. Inputs
follow from the seed and the case number, so that each can be reproduced; the folder keeps the files of failed cases."""

import argparse
import atexit
import concurrent.futures
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

import grammar
import images
import launched
import misbehaviour
import mutations
import program
import sandbox

PROCESSES = 2
EXPERIMENTS = pathlib.Path(__file__).resolve().parents[1] / "experiments"


class Files:
    """Experiment files, mutated according to their grammar."""

    def __init__(self):
        schema = subprocess.run(["swarmanoid", "schema", "--suite"], check=True, capture_output=True, text=True).stdout
        self._grammar = grammar.read_grammar(schema)
        self._sources = {file.stem: file.read_text() for file in EXPERIMENTS.glob("*.xml")}

    def run(self, numbers, folder, _):
        done, data = mutations.Mutator(self._grammar, self._sources, numbers).make()
        (folder / "case.xml").write_bytes(data)
        for image in EXPERIMENTS.glob("*.png"):
            shutil.copy(image, folder)
        arguments = ["run", "case.xml", "--quiet", "--ticks", "10", "--out", folder / "out"]
        ending = program.run(arguments, folder)
        return done, ending, ending.trouble()


class Images:
    """Images of heightfields."""

    def __init__(self):
        self._good = next(EXPERIMENTS.glob("*.png")).read_bytes()

    def run(self, numbers, folder, _):
        done, data = images.make(numbers, self._good)
        (folder / "image.png").write_bytes(data)
        (folder / "case.xml").write_text(images.EXPERIMENT)
        ending = program.run(["run", "case.xml", "--quiet", "--out", folder / "out"], folder)
        return done, ending, ending.trouble()


SUBJECTS = {"files": Files, "images": Images, "controllers": misbehaviour.Controllers,
            "launched_controllers": launched.LaunchedControllers}


def run_case(subject, seed, number, folder):
    """@return exit code, and the problem or nothing"""
    place = folder / f"case_{number}"
    place.mkdir()
    done, ending, trouble = subject.run(random.Random(f"{seed}/{number}"), place, number)
    if trouble:
        (place / "trouble.txt").write_text(f"{trouble}: {done}\n{ending.errors[-3000:]}\n")
    else:
        shutil.rmtree(place)
    return ending.code, trouble and f"case {number}: {trouble}: {done}; {ending.errors[-300:].strip()}"


def fuzz(subject, cases, seed, folder):
    """@return counts of exit codes, and problems"""
    codes, troubles = {}, []
    with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
        for count, (code, trouble) in enumerate(pool.map(lambda n: run_case(subject, seed, n, folder), cases), 1):
            codes[code] = codes.get(code, 0) + 1
            if trouble:
                troubles.append(trouble)
                print(trouble, file=sys.stderr)
            if sys.stderr.isatty():
                print(f"\r{count} of {len(cases)}", end="", file=sys.stderr)
    return codes, troubles


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("subject", choices=SUBJECTS)
    parser.add_argument("--cases", type=int, help="default: 300, or all where they are a list (controllers)")
    parser.add_argument("--first", type=int, default=0, help="number of the first case: to see one again")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--folder", type=pathlib.Path, help="for what is written, and for cases that went wrong; default: a new one")
    arguments = parser.parse_args()
    folder = (arguments.folder or pathlib.Path(tempfile.mkdtemp(prefix="swarmanoid_fuzz_"))).resolve()
    sandbox.confine(folder)
    subject = SUBJECTS[arguments.subject]()
    count = arguments.cases or getattr(subject, "count", 300)
    numbers = range(arguments.first, arguments.first + count)
    kept = ["until it is known that nothing went wrong"]
    # to run after the handlers of others, which remove their own files in it
    atexit.register(lambda: kept or shutil.rmtree(folder, ignore_errors=True))
    codes, troubles = fuzz(subject, numbers, arguments.seed, folder)
    kept = troubles
    counted = ", ".join(f"{code}: {count}" for code, count in sorted(codes.items()))
    print(f"{count} {arguments.subject}, seed {arguments.seed}, exit codes {counted}; {len(troubles)} went wrong"
          + (f", kept in {folder}" if troubles else ""))
    return 1 if troubles else 0


if __name__ == "__main__":
    sys.exit(main())
