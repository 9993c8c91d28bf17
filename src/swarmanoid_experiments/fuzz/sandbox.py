"""Sandbox for fuzzed programs: only one folder is writable.

As root, the process enters its own mount namespace, in which all file systems except the folder are read-only; /tmp, which its
children use, and /dev/shm are replaced by empty ones in memory. If that is impossible, root is rejected. Other users are
restricted by their file permissions."""

import ctypes
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile

MARK = "SWARMANOID_FUZZ_SANDBOX"
CLONE_NEWNS = 0x00020000
MEMORY = 3 * 2**30  # [bytes] limit of one process; protects the machine


def _mounts():
    """Returns the mount points, deepest first."""
    lines = pathlib.Path("/proc/self/mountinfo").read_text().splitlines()
    places = [line.split()[4].encode().decode("unicode_escape") for line in lines]
    return sorted(set(places), key=lambda place: place.count("/"), reverse=True)


def _run(*command):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)


def confine(folder):
    """Makes only `folder` writable for this process and its children. @raise SystemExit if that fails"""
    folder = pathlib.Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    tempfile.tempdir = str(folder)
    if os.geteuid() != 0:
        return
    if os.environ.get(MARK):
        return
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(CLONE_NEWNS) != 0 or _run("mount", "--make-rprivate", "/").returncode != 0:
        sys.exit("fuzz: refused as root: found no way to make a mount namespace, allowed: another user, or a container that "
                 "lets root make one")
    results = _run("mount", "--bind", folder, folder)
    for place in _mounts():
        if place != str(folder) and not place.startswith(("/proc", "/sys", "/dev")):
            _run("mount", "-o", "remount,bind,ro", place)
    for place in ("/dev/shm", "/tmp"):
        if not str(folder).startswith(place + "/"):
            _run("mount", "-t", "tmpfs", "-o", "size=256m", "tmpfs", place)
    if results.returncode != 0 or _can_write("/") or _can_write(pathlib.Path.home()) or not _can_write(folder):
        sys.exit("fuzz: refused as root: the file systems cannot be made read-only here")
    os.environ[MARK] = "1"


def _can_write(folder):
    probe = pathlib.Path(folder) / f"fuzz_probe_{os.getpid()}"
    try:
        probe.touch()
        probe.unlink()
        return True
    except OSError:
        return False


def prepare():
    """Called in the child, before the program starts: limits its memory, and enables Ctrl-C independently of the parent."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
