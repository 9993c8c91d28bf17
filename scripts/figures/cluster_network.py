"""Emulates the computers of a cluster on one machine: network namespaces on one bridge. Needs root and `ip`."""

import os
import signal
import subprocess


def _ip(*arguments):
    done = subprocess.run(["ip", *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"ip {' '.join(arguments)}: {done.stderr.strip()}")
    return done.stdout


class ClusterNetwork:
    """Hosts 0, 1, ... with the addresses 10.0.0.1, 10.0.0.2, ...; processes that still run there at the end are killed."""

    def __init__(self, hosts):
        """@raise RuntimeError if this machine does not permit namespaces"""
        own = f"cluster{os.getpid()}"
        self._switch = f"{own}s"
        self._hosts = [f"{own}h{number}" for number in range(hosts)]

    def __enter__(self):
        try:
            self._make()
        except BaseException:
            self.__exit__()
            raise
        return self

    def _make(self):
        for namespace in (self._switch, *self._hosts):
            _ip("netns", "add", namespace)
        _ip("-n", self._switch, "link", "add", "name", "bridge0", "type", "bridge")
        _ip("-n", self._switch, "link", "set", "bridge0", "up")
        for number, namespace in enumerate(self._hosts):
            port = f"port{number}"
            _ip("-n", namespace, "link", "add", "name", "wire", "type", "veth", "peer", "name", port, "netns", self._switch)
            _ip("-n", self._switch, "link", "set", port, "master", "bridge0", "up")
            _ip("-n", namespace, "addr", "add", f"10.0.0.{number + 1}/24", "dev", "wire")
            for device in ("wire", "lo"):
                _ip("-n", namespace, "link", "set", device, "up")

    def command(self, host, command):
        """@param command list of words @return the words of a command that runs it on that host"""
        return ["ip", "netns", "exec", self._hosts[host], *command]

    def __exit__(self, *_):
        for namespace in (*self._hosts, self._switch):
            for pid in subprocess.run(["ip", "netns", "pids", namespace], capture_output=True, text=True).stdout.split():
                os.kill(int(pid), signal.SIGKILL)
            subprocess.run(["ip", "netns", "del", namespace], stderr=subprocess.DEVNULL)
