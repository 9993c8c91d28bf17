"""Two hosts on one machine, for tests of what runs on several computers: two network namespaces, and between them a
link whose delay is known and that can be cut. Needs root and `ip`.

The link is a pair of devices from each host to a third namespace, and there a process that passes each frame on after
the delay, and drops all while the link is cut, as a radio link does that is lost: the kernel need not know how to delay.
That process is this file, run as a program. It makes the hosts and takes them away."""

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

ADDRESSES = ("10.77.0.1", "10.77.0.2")  # nobody else sees them
SOL_PACKET, PACKET_VNET_HDR = 263, 15  # <linux/if_packet.h>
ETH_P_ALL = 0x0003  # <linux/if_ether.h>
CLONE_NEWNET = 0x40000000  # <linux/sched.h>
LONGEST_FRAME = 1 << 17  # [bytes] kernels hand over segments that are cut later


def ip(*arguments):
    done = subprocess.run(["ip", *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"ip {' '.join(arguments)}: {done.stderr.strip()}")


def why_not():
    """@return why there cannot be two hosts here; "" if there can"""
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
    """Hosts `a` and `b`, joined. What still runs there when they are closed, or this process ends in any way, is killed.
    @param delay of a frame, each way [s]"""

    def __init__(self, delay):
        own = f"h{os.getpid()}"
        self.a, self.b = (Host(own + letter, address) for letter, address in zip("ab", ADDRESSES))
        self._link = subprocess.Popen([sys.executable, os.path.abspath(__file__), own, str(delay)], text=True,
                                      stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True)
        self.join()

    def cut(self):
        """From now on nothing comes through, in either direction; what is under way is lost."""
        self._tell("cut")

    def join(self):
        """The inverse."""
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
    """One of the two. Only it can reach its own localhost."""

    def __init__(self, namespace, address):
        self.namespace = namespace
        self.address = address

    def environment(self, master):
        """The variables of ROS there. @param master the host on which the master is"""
        kept = {name: value for name, value in os.environ.items() if name != "ROS_HOSTNAME"}
        return dict(kept, ROS_IP=self.address, ROS_MASTER_URI=f"http://{master.address}:11311")

    def command(self, *command):
        """That command, to be run there."""
        return ["ip", "netns", "exec", self.namespace, *map(str, command)]

    def enter(self):
        """From now on this thread, and all that it starts, are on this host."""
        with open(f"/run/netns/{self.namespace}") as namespace:
            if ctypes.CDLL(None, use_errno=True).setns(namespace.fileno(), CLONE_NEWNET) != 0:
                raise OSError(ctypes.get_errno(), f"cannot enter {self.namespace}")


# --- the program


def make(between, hosts):
    """In the namespace between the hosts, each of them has a device of its name."""
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
    """With all processes that run there, but those with these numbers."""
    for host in hosts:
        pids = subprocess.run(["ip", "netns", "pids", host.namespace], capture_output=True, text=True).stdout.split()
        for pid in map(int, pids):
            if pid not in keep:
                with contextlib.suppress(ProcessLookupError):  # it has just ended
                    os.kill(pid, signal.SIGKILL)
        subprocess.run(["ip", "netns", "del", host.namespace], stderr=subprocess.DEVNULL)  # its devices go with it


def open_device(name):
    """A socket for the frames of a device, each with a header that says which sums are still to be made and where it is
    to be cut: the kernel leaves both to hardware that is not there."""
    device = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, 0)
    device.setsockopt(SOL_PACKET, PACKET_VNET_HDR, 1)
    device.bind((name, ETH_P_ALL))
    return device


def relay(names, delay):
    """Until the input ends. Each word that it reads is obeyed, and repeated."""
    left, right = map(open_device, names)
    other = {left: right, right: left}
    under_way = collections.deque()  # when it is due, where it goes, the frame
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
