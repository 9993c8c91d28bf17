"""Two hosts on one machine, for tests of distributed runs: two network namespaces, and between them a link with a known
delay that can be cut. Needs root and `ip`.

The link consists of pairs of devices from each host to a third namespace, and a process there that forwards each frame
after the delay, and drops all frames while the link is cut, like a lost radio link; this needs no support for delays in the
kernel. That process is this file, run as a program. It creates the hosts and removes them."""

import collections
import contextlib
import ctypes
import os
import select
import shutil
import signal
import socket
import subprocess
import sys
import time

ADDRESSES = ("10.77.0.1", "10.77.0.2")  # visible in these namespaces only
SOL_PACKET, PACKET_VNET_HDR = 263, 15  # <linux/if_packet.h>
ETH_P_ALL = 0x0003  # <linux/if_ether.h>
CLONE_NEWNET = 0x40000000  # <linux/sched.h>
LONGEST_FRAME = 1 << 17  # [bytes] kernels pass on segments that are divided later


def ip(*arguments):
    done = subprocess.run(["ip", *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"ip {' '.join(arguments)}: {done.stderr.strip()}")


def why_not():
    """@return reason why two hosts are impossible here; "" if they are possible"""
    if os.geteuid() != 0:
        return "two hosts on one machine need root"
    if shutil.which("ip") is None:
        return "two hosts on one machine need the program ip (package iproute2)"
    probe = f"probe{os.getpid()}"
    try:
        ip("netns", "add", probe)
        ip("-n", probe, "link", "add", "wire", "type", "veth", "peer", "name", "other")
    except RuntimeError as error:
        return f"this machine does not allow two hosts: {error}"
    finally:
        subprocess.run(["ip", "netns", "del", probe], stderr=subprocess.DEVNULL)
    return ""


class TwoHosts:
    """Hosts `a` and `b`, connected. Processes still running there when they are closed, or when this process ends, are killed.
    @param delay of a frame, each way [s]"""

    def __init__(self, delay):
        own = f"h{os.getpid()}"
        self.a, self.b = (Host(own + letter, address) for letter, address in zip("ab", ADDRESSES))
        self._link = subprocess.Popen([sys.executable, os.path.abspath(__file__), own, str(delay)], text=True,
                                      stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True)
        self.join()

    def cut(self):
        """Drops all frames from now on, in both directions, including those in transit."""
        self._tell("cut")

    def join(self):
        """The inverse of cut."""
        self._tell("join")

    def close(self):
        self._link.stdin.close()
        self._link.wait()
        self._link.stdout.close()

    def _tell(self, word):
        self._link.stdin.write(word + "\n")
        self._link.stdin.flush()
        if self._link.stdout.readline() != word + "\n":
            raise RuntimeError("the link between the two hosts has ended")


class Host:
    """One of the two hosts. Only its own processes can reach its localhost."""

    def __init__(self, namespace, address):
        self.namespace = namespace
        self.address = address

    def environment(self, master):
        """Returns the ROS environment of the host. @param master host of the ROS master"""
        kept = {name: value for name, value in os.environ.items() if name != "ROS_HOSTNAME"}
        return dict(kept, ROS_IP=self.address, ROS_MASTER_URI=f"http://{master.address}:11311")

    def command(self, *command):
        """Returns a command line that runs the command on this host."""
        return ["ip", "netns", "exec", self.namespace, *map(str, command)]

    def enter(self):
        """Moves this thread, and all processes it starts later, to this host."""
        with open(f"/run/netns/{self.namespace}") as namespace:
            if ctypes.CDLL(None, use_errno=True).setns(namespace.fileno(), CLONE_NEWNET) != 0:
                raise OSError(ctypes.get_errno(), f"cannot enter {self.namespace}")


# --- the program


def make(between, hosts):
    """Creates a device for each host, with the host's name, in the namespace between the hosts."""
    for host in (between, *hosts):
        ip("netns", "add", host.namespace)
    for host in hosts:
        name = host.namespace
        ip("link", "add", "wire", "netns", name, "type", "veth", "peer", "name", name, "netns", between.namespace)
        ip("-n", between.namespace, "link", "set", name, "up")
        ip("-n", name, "addr", "add", host.address + "/24", "dev", "wire")
        ip("-n", name, "link", "set", "wire", "up")
        ip("-n", name, "link", "set", "lo", "up")


def take_away(hosts, keep):
    """Removes the hosts and kills all processes there, except those in `keep`."""
    for host in hosts:
        pids = subprocess.run(["ip", "netns", "pids", host.namespace], capture_output=True, text=True).stdout.split()
        for pid in map(int, pids):
            if pid not in keep:
                with contextlib.suppress(ProcessLookupError):  # it has just ended
                    os.kill(pid, signal.SIGKILL)
        subprocess.run(["ip", "netns", "del", host.namespace], stderr=subprocess.DEVNULL)  # removes its devices, too


def open_device(name):
    """Opens a socket for the frames of a device, each with a header that describes pending checksums and segmentation: the
    kernel leaves both to hardware, which is absent here."""
    device = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, 0)
    device.setsockopt(SOL_PACKET, PACKET_VNET_HDR, 1)
    device.bind((name, ETH_P_ALL))
    return device


def relay(names, delay):
    """Runs until the end of the input. Executes each word read, and repeats it on the output."""
    left, right = map(open_device, names)
    other = {left: right, right: left}
    under_way = collections.deque()  # due time, destination, frame
    is_cut = False
    while True:
        wait = max(0.0, under_way[0][0] - time.monotonic()) if under_way else None
        for source in select.select([sys.stdin, left, right], [], [], wait)[0]:
            if source is sys.stdin:
                word = sys.stdin.readline()
                if not word:
                    return
                is_cut = word == "cut\n"
                under_way.clear()
                print(word, end="", flush=True)
                continue
            frame, sender = source.recvfrom(LONGEST_FRAME)
            if sender[2] != socket.PACKET_OUTGOING and not is_cut:
                under_way.append((time.monotonic() + delay, other[source], frame))
        while under_way and under_way[0][0] <= time.monotonic():
            _, target, frame = under_way.popleft()
            target.send(frame)


def main(own, delay):
    parent = os.getppid()
    between = Host(own + "r", "")
    hosts = [Host(own + letter, address) for letter, address in zip("ab", ADDRESSES)]
    try:
        make(between, hosts)
        between.enter()
        relay([host.namespace for host in hosts], float(delay))
    finally:
        take_away([*hosts, between], keep=(parent, os.getpid()))


if __name__ == "__main__":
    main(*sys.argv[1:])
