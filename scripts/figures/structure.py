"""Figures of the structure: sizes of packages and folders, libraries of the space, code that must not compile, pages."""

import collections
import re
import subprocess
import sys

from table import ROOT

TESTS = re.compile(r"/(test|rostest|testing|benchmark|fuzz)/")
SOURCE = re.compile(r"\.(cpp|hpp|py)$")
FOREIGN = ("xml2", "hdf5", "png", "roscpp", "urdf")
DIALECT_BEFORE = 1264  # words that check_prose.py counted before pages and comments were rewritten


def files(*patterns):
    listed = subprocess.run(["git", "ls-files", *patterns], capture_output=True, text=True, cwd=ROOT, check=True).stdout
    return [name for name in listed.splitlines() if (ROOT / name).exists()]


def lines_of(package):
    """Number of lines of C++ and Python, comments included, without tests. @param package "*" for all"""
    names = [name for name in files(f"src/{package}/*") if SOURCE.search(name) and not TESTS.search(f"/{name}")]
    return sum(len((ROOT / name).read_text().splitlines()) for name in names)


def sizes(table):
    space = lines_of("swarmanoid_space")
    table.add("lines of swarmanoid_space, without tests", "at most 16,000", f"{space:,}", space <= 16000)
    whole = lines_of("*")
    table.add("lines of all packages, without tests", "at most 80,000", f"{whole:,}", whole <= 80000)
    count = collections.Counter(name.rpartition("/")[0] for name in files())
    large = sorted((folder for folder, number in count.items() if number > 20), key=count.get, reverse=True)
    sources = [f"{folder} {count[folder]}" for folder in large
               if count[folder] > 30 and folder.startswith("src/") and not TESTS.search(f"/{folder}/") and not folder.endswith("/msg")]
    table.add("folders with more than 20 files", "at most 8, none of sources over 30",
              f"{len(large)}; of sources over 30: {', '.join(sources) or 'none'}", len(large) <= 8 and not sources)
    pages = len(files("docs/*.md"))
    table.add("pages below docs/", "at most 120", str(pages), pages <= 120)


def libraries_of_space(table, build):
    done = subprocess.run(["ldd", build / "devel/lib/libswarmanoid_space.so"], capture_output=True, text=True, check=True)
    found = [line.split()[0] for line in done.stdout.splitlines() if any(name in line.split()[0] for name in FOREIGN)]
    table.add("libraries that the space loads, directly and indirectly", f"none of {', '.join(FOREIGN)}", ", ".join(found) or "none",
              not found)


def must_not_compile(table, build):
    test = ROOT / "src/swarmanoid_space/test/must_not_compile_test.py"
    includes = [f"-I{ROOT}/src/swarmanoid_{package}/include" for package in ("space", "interface")]
    done = subprocess.run([sys.executable, test, "g++", "-std=c++17", *includes, "-isystem", "/usr/include/eigen3"], capture_output=True,
                          text=True, check=False)
    lines = sum(" error: " in line and "//" in line for name in files("src/swarmanoid_space/test/must_not_compile/*.cpp")
                for line in (ROOT / name).read_text().splitlines()[3:])
    table.add("lines with which plugins write what their phase must not write", "at least 8, none compiles",
              f"{lines}; {done.stderr.splitlines()[-1]}", done.returncode == 0 and lines >= 8)


def engine_functions(table):
    text = (ROOT / "src/swarmanoid_space/include/swarmanoid_space/engine.hpp").read_text()
    count = len(re.findall(r"^  virtual ", text, re.M))
    table.add("virtual functions of the class Engine, without those of its limits and of rays", "at most 14", str(count), count <= 14)


def prose(table):
    sys.path.insert(0, str(ROOT / "scripts"))
    import check_prose  # pylint: disable=import-outside-toplevel
    count = len(list(check_prose.places(check_prose.sources())))
    table.add("words of the dialect in comments and pages (check_prose.py)", f"at most a tenth of {DIALECT_BEFORE:,}", str(count),
              10 * count <= DIALECT_BEFORE)


def structure(table, build):
    sizes(table)
    libraries_of_space(table, build)
    must_not_compile(table, build)
    engine_functions(table)
    prose(table)
