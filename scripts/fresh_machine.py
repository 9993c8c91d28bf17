#!/usr/bin/python3
"""fresh_machine.py [--releases 12,13] COMMAND...: runs a command of the README on systems without ROS.

For each release of Debian it makes a minimal system in a temporary folder (mmdebstrap: essential packages, git and
certificates), clones the last commit into it and runs the command there as root. Only packages that the project's own files
install are available. If the command ends with the summary of a run, the state hashes of all releases are compared.

The exit code is 1 if a command failed or hashes differ. Without root or mmdebstrap a release is reported and counted as
skipped."""

import argparse
import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SUITES = {"12": "bookworm", "13": "trixie"}
TAIL = 60  # shown lines of a failed command
# mounts and processes of the system end with this process
ENTER = """mount -t proc proc "$1/proc" && mount --rbind /sys "$1/sys" && mount --rbind /dev "$1/dev" &&
root=$1 && shift && exec chroot "$root" sh -c 'cd /root/swarmanoid && exec "$@"' sh "$@" """


def obstacle():
    """@return the reason why no system can be made here, or an empty string"""
    if os.geteuid() != 0:
        return "it needs root"
    return next((f"{name} is not installed" for name in ("mmdebstrap", "unshare") if not shutil.which(name)), "")


class FreshMachine:
    """A minimal Debian with a clone of the last commit, during a `with` block."""

    def __init__(self, release):
        self._suite = SUITES[release]

    def __enter__(self):
        self._folder = tempfile.mkdtemp(prefix="swarmanoid_debian_")
        try:
            self._make()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        shutil.rmtree(self._folder)

    def _make(self):
        self.root = pathlib.Path(self._folder) / "root"
        subprocess.run(["mmdebstrap", "--quiet", "--variant=minbase", "--include=ca-certificates,git", self._suite, self.root],
                       check=True)
        shutil.copy("/etc/resolv.conf", self.root / "etc/resolv.conf")
        (self.root / "etc/hosts").write_text("127.0.0.1 localhost\n")
        subprocess.run(["git", "clone", "--quiet", "--no-hardlinks", ROOT, self.root / "root/swarmanoid"], check=True)

    def run(self, command, errors):
        """@param errors file for standard error @return exit code, standard output"""
        proxies = [f"{name}={value}" for name, value in os.environ.items() if name.lower().endswith("_proxy")]
        environment = ["env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/root", "TERM=dumb", *proxies]
        done = subprocess.run([*environment, "unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-c", ENTER, "sh",
                               self.root, *command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors,
                              text=True, check=False)
        return done.returncode, done.stdout


def state_hash(output):
    """@return the state hash in a run's summary, or an empty string"""
    with contextlib.suppress(ValueError, IndexError):
        return json.loads(output.splitlines()[-1]).get("state_hash", "")
    return ""


def try_release(release, command):
    """@return whether the command succeeded, its standard output"""
    start = time.monotonic()
    with FreshMachine(release) as machine, tempfile.TemporaryFile("w+") as errors:
        made = time.monotonic()
        code, output = machine.run(command, errors)
        took = f"made in {made - start:.0f} s, {' '.join(command)} took {(time.monotonic() - made) / 60:.1f} minutes"
        if code != 0:
            errors.seek(0)
            print(*(output + errors.read()).splitlines()[-TAIL:], sep="\n")
        print(f"Debian {release}: {'passed' if code == 0 else f'failed with {code}'}; {took}", flush=True)
    return code == 0, output


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--releases", type=lambda text: text.split(","), default=list(SUITES), help="of Debian")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()
    unknown = [release for release in arguments.releases if release not in SUITES]
    if unknown or not arguments.command:
        parser.error(f"Debian {', '.join(unknown)}: allowed are {', '.join(SUITES)}" if unknown else "a command is missing")
    if obstacle():
        print(f"fresh machines are not tried: {obstacle()}\n0 passed, 0 failed, {len(arguments.releases)} skipped")
        return 0
    passed, hashes = 0, {}
    for release in arguments.releases:
        is_good, output = try_release(release, arguments.command)
        passed += is_good
        if state_hash(output):
            hashes[release] = state_hash(output)
    are_equal = len(set(hashes.values())) <= 1
    if hashes:
        print("state hashes:", ", ".join(f"Debian {release} {value}" for release, value in hashes.items()),
              "(equal)" if are_equal else "(they differ)")
    failed = len(arguments.releases) - passed
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 0 if failed == 0 and are_equal else 1


if __name__ == "__main__":
    sys.exit(main())
