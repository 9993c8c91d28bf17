"""Environments for tests that must not depend on the shell that started them."""

import os
import shutil
import subprocess
import sys
import tempfile

REPOSITORY = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.append(os.path.join(REPOSITORY, "src/swarmanoid_experiments/rostest"))
from roslaunch_process import free_port  # noqa: E402  pylint: disable=wrong-import-position


def bare(home):
    """An environment without any workspace. @param home folder for files of programs"""
    os.makedirs(home, exist_ok=True)
    kept = {name: os.environ[name] for name in ("USER", "LOGNAME", "CCACHE_DIR") if name in os.environ}
    kept.setdefault("CCACHE_DIR", os.path.join(os.path.expanduser("~"), ".cache/ccache"))
    # temporary folders have new names each time
    kept.update(CCACHE_BASEDIR=tempfile.gettempdir(), CCACHE_NOHASHDIR="1")
    return {**kept, "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8", "HOME": home,
            "ROS_HOME": os.path.join(home, ".ros"), "ROS_MASTER_URI": f"http://localhost:{free_port()}",
            "ROS_HOSTNAME": "localhost", "ROSCONSOLE_STDOUT_LINE_BUFFERED": "1"}


def with_another_python(environment, folder):
    """An environment whose first Python in PATH lacks the modules of ROS, as with pyenv or conda."""
    os.makedirs(folder, exist_ok=True)
    for name in ("python", "python3"):
        program = os.path.join(folder, name)
        with open(program, "w") as file:
            # a fake that only prints a version
            file.write('#!/bin/sh\nif [ "$1" = --version ]; then echo Python 3.11.2; exit; fi\n'
                       'echo "a Python without the modules of ROS" >&2; exit 1\n')
        os.chmod(program, 0o755)
    return {**environment, "PATH": f"{folder}:{environment['PATH']}"}


def outside_of_workspaces():
    """This environment without the variables of devel and install spaces, which would hide the packages under test."""
    ours = ("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "PKG_CONFIG_PATH", "PYTHONPATH", "ROS_PACKAGE_PATH")
    return {name: value for name, value in os.environ.items() if name not in ours}


def sourced(environment, *setups):
    """The environment after sourcing these setup files, each extending the previous one."""
    commands = [f"source '{setup}'" + (" --extend" if i > 0 else "") for i, setup in enumerate(setups)]
    output = subprocess.run(["bash", "-c", " && ".join(commands) + " && env -0"], env=environment, check=True,
                            cwd=environment["HOME"], stdout=subprocess.PIPE, timeout=60).stdout
    return dict(item.split("=", 1) for item in output.decode().split("\0") if item)


def compiler_cache():
    """CMake options for a compiler cache, if it is installed."""
    return ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []


def run(command, environment, folder=None, timeout=120):
    """Runs a program to its end, by default in the home folder. @return exit code, standard output, standard error"""
    done = subprocess.run(command, env=environment, cwd=folder or environment["HOME"], timeout=timeout, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    return done.returncode, done.stdout, done.stderr


def succeed(command, environment, folder=None, timeout=120):
    """Same as `run` for a program that must succeed. @return standard output @raise AssertionError with its output"""
    code, output, errors = run(command, environment, folder, timeout)
    if code != 0:
        raise AssertionError(f"{' '.join(command)} ends with {code}\n{output[-3000:]}\n{errors[-3000:]}")
    return output


def read(name):
    """@return the text of a file"""
    with open(name) as file:
        return file.read()
