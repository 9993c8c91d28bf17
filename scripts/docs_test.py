#!/usr/bin/python3
"""docs_test.py BUILD_FOLDER: tests that the instructions of the pages work.

In the pages, a fence of the language sh has shell commands. All commands of a page are run one after the other, in one shell,
in an empty folder that has a clone of the repository. A comment before a fence gives it another meaning:
    <!-- file: NAME -->            the fence is written to that file
    <!-- same as: NAME, with A as B -->  the fence equals that file of the repository, with A replaced by B
    <!-- stays, until SERVICE is there -->  the fence is one command for a terminal of its own: later fences wait for that ROS service;
                                   the command runs until it ends by itself, or gets a Ctrl-C at the end of the page
A file is written in the page's initial folder, or below the clone: <!-- file: swarmanoid/docs/NAME -->.
A text fence must occur in the output of the command before it. Fences with whole experiments are validated.
"""

import concurrent.futures
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import yaml
from surroundings import REPOSITORY, bare, compiler_cache, run, sourced

# Pages whose shell commands are run; the page about workspaces takes minutes and is run by ./test --long
RUN_PAGES = ("docs/tutorial/first_experiment.md", "docs/tutorial/swarm_in_python.md", "docs/how-to/add_a_controller.md",
             "docs/how-to/add_a_device.md", "docs/how-to/add_a_robot.md", "docs/how-to/record_and_analyse.md",
             "docs/how-to/add_a_rule_or_visualisation.md",
             "docs/how-to/add_an_arena_object.md", "docs/how-to/add_an_engine.md",
             "docs/how-to/hand_over_between_engines.md", "docs/how-to/control_a_run.md", "docs/how-to/drive_by_topics.md",
             "docs/how-to/repeat_and_compare_runs.md", "docs/how-to/run_a_batch.md", "docs/how-to/evolve_a_controller.md",
             "docs/how-to/make_pictures.md",
             "docs/how-to/measure_a_run.md",
             "docs/how-to/run_a_controller_elsewhere.md",
             "docs/how-to/sample_a_sensor.md", "docs/how-to/simulate_in_python.md", "docs/how-to/train_in_python.md",
             "docs/how-to/walls_from_a_map.md",
             "docs/explanation/coming_from_argos.md",
             "docs/faq.md")
LONG_PAGES = ("docs/how-to/use_in_a_catkin_workspace.md",)
# Pages that add to the suite, and the maximum number of new files of each. They are run in a copy of the tree, which is built
# once; they must not change existing files
SUITE_PAGES = {"docs/how-to/add_a_device_to_the_suite.md": 4, "docs/how-to/add_an_implementation.md": 2,
               "docs/how-to/add_an_arena_object_to_the_suite.md": 8, "docs/how-to/add_to_the_suite.md": 3}
FENCE = re.compile(r"(?:^<!-- (?P<note>.*?) -->\n)?^```(?P<language>\w*)\n(?P<text>.*?)^```$", re.M | re.S)
BUILD_FOLDER = ""


def pages():
    yield "README.md"
    for folder, _, names in os.walk(os.path.join(REPOSITORY, "docs")):
        yield from (os.path.relpath(os.path.join(folder, name), REPOSITORY) for name in sorted(names)
                    if name.endswith(".md"))
    yield "examples/README.md"


def read(page):
    with open(os.path.join(REPOSITORY, page)) as file:
        return file.read()


def anchors(text):
    """Anchors of headings, as used in links."""
    headings = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def contents(folder):
    """Files of a copy of the tree, without build folders."""
    found = {}
    for where, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name != "__pycache__" and (where != folder or not name.startswith("build"))]
        for name in names:
            path = os.path.join(where, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


class Newcomer:
    """A shell that keeps its folder and environment from one fence to the next."""

    def __init__(self, folder, environment):
        self.folder = folder
        self.environment = environment
        self.beside = []  # programs in terminals of their own, with the files of their output

    def do(self, commands, timeout=300):
        """@return exit code and all output"""
        state = os.path.join(self.environment["HOME"], "state")
        script = f"set -e\ntrap 'code=$?; {{ pwd; env -0; }} > {state}; exit $code' EXIT\n{commands}"
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, env=self.environment, timeout=timeout, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        with open(state) as file:
            self.folder, variables = file.read().split("\n", 1)
        os.remove(state)
        self.environment = dict(item.split("=", 1) for item in variables.split("\0") if item)
        return done.returncode, done.stdout

    def start_beside(self, command, service, timeout=60):
        printed = tempfile.TemporaryFile("w+")
        program = subprocess.Popen(["bash", "-c", "exec " + command], cwd=self.folder, env=self.environment, text=True,
                                   stdin=subprocess.DEVNULL, stdout=printed, stderr=subprocess.STDOUT)
        self.beside.append((program, printed))
        end = time.monotonic() + timeout
        while not self.offers(service):
            if program.poll() is not None or time.monotonic() > end:
                raise AssertionError(f"{command}: there is no {service}\n{self.end_beside()}")
            time.sleep(0.5)

    def offers(self, service):
        found = subprocess.run(["rosservice", "type", service], env=self.environment, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        return found.returncode == 0

    def end_beside(self):
        """Ends the programs in other terminals. @return their output"""
        texts = []
        for program, printed in reversed(self.beside):
            if program.poll() is None:
                program.send_signal(signal.SIGINT)
            program.wait(60)
            printed.seek(0)
            texts.append(printed.read())
            printed.close()
        self.beside = []
        return "\n".join(texts)

    def watch(self, command, until, timeout=120):
        """Starts a program that keeps running, waits for a text in its output, and sends Ctrl-C. @return its output"""
        program = subprocess.Popen(["bash", "-c", "exec " + command], cwd=self.folder, env=self.environment, text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        lines = []
        reader = threading.Thread(target=lambda: lines.extend(iter(program.stdout.readline, "")))
        reader.start()
        end = time.monotonic() + timeout
        while program.poll() is None and time.monotonic() < end and not any(until in line for line in list(lines)):
            time.sleep(0.1)
        if program.poll() is None:
            program.send_signal(signal.SIGINT)
        program.wait(60)
        reader.join()
        program.stdout.close()
        return "".join(lines)


class Display:
    """A virtual screen for rviz."""

    def __enter__(self):
        reader, writer = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1024x768x24", "-nolisten",
                                        "tcp"], pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as answer:
            self.name = ":" + answer.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait(10)


class LinksTest(unittest.TestCase):
    def test_links_lead_somewhere(self):
        for page in pages():
            for link in re.findall(r"\]\(([^)\s]+)\)", FENCE.sub("", read(page))):  # a listing may quote another page
                if re.match(r"[a-z]+:", link):
                    continue
                with self.subTest(page=page, link=link):
                    name, _, anchor = link.partition("#")
                    target = os.path.normpath(os.path.join(os.path.dirname(page), name)) if name else page
                    self.assertTrue(os.path.exists(os.path.join(REPOSITORY, target)), "there is no such file")
                    if anchor and target.endswith(".md"):
                        self.assertIn(anchor, anchors(read(target)))

    def test_every_page_can_be_reached_from_the_readme(self):
        reached = {"README.md"}
        new = ["README.md"]
        while new:
            page = new.pop()
            for link in re.findall(r"\]\(([^)\s#]+)", read(page)):
                target = os.path.normpath(os.path.join(os.path.dirname(page), link))
                absolute = os.path.join(REPOSITORY, target)
                found = [os.path.join(target, n) for n in os.listdir(absolute)] if os.path.isdir(absolute) else [target]
                for name in found:
                    if name.endswith(".md") and name not in reached and os.path.exists(os.path.join(REPOSITORY, name)):
                        reached.add(name)
                        new.append(name)
        self.assertEqual([], [page for page in pages() if page not in reached])


class ProgramsTest(unittest.TestCase):
    """Programs in commands of pages are in packages that the suite installs for its users, on every Debian system, or in a package that
    the page names. LAWS lists folders whose formulas and tables look like commands."""

    LAWS = ("docs/reference/devices/", "docs/reference/rules/", "docs/reference/models.md")

    @staticmethod
    def commands(text):
        """The program names in all commands of a page."""
        lines = [line for fence in FENCE.finditer(text) if fence["language"] == "sh" for line in fence["text"].splitlines()]
        lines += [line[4:] for line in FENCE.sub("", text).splitlines() if re.match(r"    \S", line)]
        for line in lines:
            for part in re.split(r"\||&&|;|\$\(", line):
                found = re.match(r"(?:\w+=\S+ +)*(?:sudo +)?([\w./+-]+)(?! *=)(?:\s|$)", part.strip())
                if found:
                    yield found[1]

    @staticmethod
    def packages_of(programs):
        """@return by program, its package and the package's priority; programs without a package are left out"""
        paths = {name: shutil.which(name, path="/usr/bin:/bin:/usr/sbin:/sbin") for name in programs}
        files = {file for path in paths.values() if path for file in (path, re.sub("^/usr(?=/s?bin/)", "", path))}
        owners = subprocess.run(["dpkg", "-S", *files], text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
        package_of = {file: owner.split(":")[0] for owner, file in re.findall(r"^(\S+): (/.*)$", owners.stdout, re.M)}
        listed = subprocess.run(["dpkg-query", "-W", "-f=${Package} ${Priority}\n", *set(package_of.values())], text=True,
                                stdout=subprocess.PIPE, check=True)
        priorities = dict(line.split() for line in listed.stdout.splitlines())
        found = {name: package_of.get(path, package_of.get((path or "").removeprefix("/usr"))) for name, path in paths.items()}
        return {name: (package, priorities[package]) for name, package in found.items() if package}

    @staticmethod
    def installed_for_users():
        """Packages installed for users, and their direct dependencies."""
        rows = [line.split() for line in read("packages.txt").splitlines() if line and not line.startswith("#")]
        installed = {row[1] for row in rows if row[0] in ("base", "viewer")}
        needed = subprocess.run(["dpkg-query", "-W", "-f=${Depends}, ${Pre-Depends}, ", *installed], text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False).stdout
        return installed | set(re.findall(r"[\w.+-]+(?=[ ,:])", needed))

    def test_programs_of_pages_are_installed_for_users(self):
        programs = {page: set(self.commands(read(page))) for page in pages() if not page.startswith(self.LAWS)}
        everything = set().union(*programs.values())
        self.assertLessEqual({"/usr/lib/dynamic_reconfigure/dynparam", "rostopic", "swarmanoid", "gdb", "cmake"}, everything)
        installed = self.installed_for_users() | {"git"}  # needed to clone the repository
        packages = self.packages_of(everything)
        self.assertEqual("cmake", packages["cmake"][0])
        for page, named in programs.items():
            for program in sorted(named & set(packages)):
                package, priority = packages[program]
                if package not in installed and priority not in ("required", "important"):
                    with self.subTest(page=page, program=program):
                        self.assertIn(f"`{package}`", read(page), "its package is not named")


class CitationTest(unittest.TestCase):
    def test_the_citation_is_of_this_version(self):
        """It has the keys that version 1.2.0 of the format requires, for the suite and for the reference."""
        citation = yaml.safe_load(read("CITATION.cff"))
        self.assertEqual(citation["cff-version"], "1.2.0")
        for item, required in ((citation, ("message", "title", "authors")), (citation["references"][0], ("type", "title", "authors"))):
            self.assertEqual([key for key in required if not item.get(key)], [])
        package = read("src/swarmanoid_experiments/package.xml")
        self.assertIn(f"<version>{citation['version']}</version>", package)
        self.assertIn(f"<license>{citation['license']}</license>", package)


class ListingsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.mkdtemp(prefix="swarmanoid_docs_")
        cls.addClassCleanup(shutil.rmtree, cls.work, ignore_errors=True)
        cls.bare = cls.new_shell("nobody")
        # same as a clone after a first ./run
        cls.clone = os.path.join(cls.work, "swarmanoid")
        os.mkdir(cls.clone)
        for name in os.listdir(REPOSITORY):
            if not name.startswith("build"):
                os.symlink(os.path.join(REPOSITORY, name), os.path.join(cls.clone, name))
        os.symlink(BUILD_FOLDER, os.path.join(cls.clone, "build"))

    @classmethod
    def new_shell(cls, name):
        environment = bare(os.path.join(cls.work, "home", name))
        environment.update({"CMAKE_CXX_COMPILER_LAUNCHER": "ccache"} if compiler_cache() else {})
        return environment

    def newcomer(self, page, clone):
        name = os.path.basename(page).removesuffix(".md")
        folder = os.path.join(self.work, name)
        os.mkdir(folder)
        os.symlink(clone, os.path.join(folder, "swarmanoid"))
        return Newcomer(folder, self.new_shell(name))

    def test_experiments_are_valid(self):
        environment = sourced(self.bare, os.path.join(BUILD_FOLDER, "devel/setup.bash"))
        for page in pages():
            for fence in FENCE.finditer(read(page)):
                if "<ahss-config>" in fence["text"] and page not in {*RUN_PAGES, *SUITE_PAGES}:  # those need files that the page creates
                    with self.subTest(page=page):
                        path = os.path.join(self.work, "listing.xml")
                        with open(path, "w") as file:
                            file.write(fence["text"])
                        code, _, errors = run(["swarmanoid", "validate", path], environment)
                        self.assertEqual(0, code, errors)

    def test_listings_are_the_files_they_are_said_to_be(self):
        for page in pages():
            for fence in FENCE.finditer(read(page)):
                same = re.match(r"same as: (\S+)(?:, with (\S+) as (\S+))?$", fence["note"] or "")
                if same:
                    with self.subTest(page=page, file=same[1]):
                        content = read(same[1])
                        self.assertEqual(content.replace(same[2] or "", same[3] or ""), fence["text"])

    def test_pages_can_be_followed(self):
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            followed = [(page, pool.submit(self.follow, page)) for page in RUN_PAGES]
        for page, result in followed:
            with self.subTest(page=page):
                result.result()

    @unittest.skipUnless("DOCS_TEST_LONG" in os.environ, "takes minutes: it builds a copy of the suite")
    def test_pages_that_add_to_the_suite_can_be_followed(self):
        copy = os.path.join(self.work, "copy")
        shutil.copytree(REPOSITORY, copy, symlinks=True, ignore=lambda folder, names: {
            name for name in names if name in (".git", "__pycache__") or folder == REPOSITORY and name.startswith("build")})
        before = contents(copy)
        for page, most in SUITE_PAGES.items():
            with self.subTest(page=page):
                self.follow(page, copy)
                after = contents(copy)
                self.assertEqual([], [name for name in before if after.get(name) != before[name]], "files that changed")
                added = sorted(set(after) - set(before))
                self.assertTrue(0 < len(added) <= most, f"{len(added)} files, allowed: at most {most}: {added}")
                print(f"{page}: {len(added)} new files, no other is edited", file=sys.stderr)
                before = after

    @unittest.skipUnless("DOCS_TEST_LONG" in os.environ, "takes minutes: it builds the suite anew")
    def test_long_pages_can_be_followed(self):
        for page in LONG_PAGES:
            with self.subTest(page=page):
                self.follow(page)

    def launch(self, newcomer, command):
        """Runs a launch command with rviz. It gets a second trial, since rviz crashes on a virtual display about once in ten times
        while it creates its first window."""
        for last_trial in (False, True):
            with Display() as display:
                newcomer.environment.update(DISPLAY=display.name, LIBGL_ALWAYS_SOFTWARE="1", QT_X11_NO_MITSHM="1")
                printed = newcomer.watch(command + (" force:=true" if last_trial else ""), ": finished after")
            self.assertIn(": finished after", printed)
            dead = re.findall(r"\[(\S+)\] process has died", printed)
            if last_trial or not dead or not all(name.startswith("rviz") for name in dead):
                self.assertEqual([], dead, printed)
                return printed

    def follow(self, page, clone=None):
        newcomer = self.newcomer(page, clone or self.clone)
        try:
            self.follow_as(newcomer, page)
        finally:
            newcomer.end_beside()

    def follow_as(self, newcomer, page):
        start = newcomer.folder
        code, printed = 0, ""
        commands = ""
        for fence in FENCE.finditer(read(page)):
            text = fence["text"]
            if fence["language"] == "text" and not (fence["note"] or "").startswith("file: "):
                for line in text.splitlines():
                    self.assertIn(line, printed)
                code = 0  # an error that the page explains
                continue
            self.assertEqual(0, code, f"{commands}\n{printed}")
            stays = re.match(r"stays, until (\S+) is there$", fence["note"] or "")
            if stays:
                newcomer.start_beside(text.strip(), stays[1])
            elif (fence["note"] or "").startswith("file: "):
                with open(os.path.join(start, fence["note"][6:]), "w") as file:
                    file.write(text)
            elif fence["language"] == "sh" and text.startswith("roslaunch"):
                printed = self.launch(newcomer, text.strip())
            elif fence["language"] == "sh":
                commands = text
                code, printed = newcomer.do(text, timeout=1800)
        self.assertEqual(0, code, f"{commands}\n{printed}")


if __name__ == "__main__":
    BUILD_FOLDER = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
