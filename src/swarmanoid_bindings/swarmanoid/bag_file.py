"""Reads rosbags of the suite: their messages, and their runs as arrays."""

import functools
import pathlib
import re
from typing import Any, Dict, Iterator, List, Sequence, Tuple
from xml.etree import ElementTree

import numpy
import rosbag

from .recording import RecordedEvent, Recording, RecordingError

STATES, EVENTS = "/space/world_state", "/space/events"
ABOUT = ("/space/experiment", "/space/math_library", "/space/record", "/space/result")
EPOCH_NS = 1_000_000_000  # stamp of the start of a run in ROS
NUMBER = re.compile(r"[-+]?(inf|nan|([0-9]+(\.[0-9]*)?|\.[0-9]+)(e[-+]?[0-9]+)?)")


class BagError(RecordingError):
    """A bag that cannot be read; the message has its name and the reason."""


def open_bag(file: Any) -> rosbag.Bag:
    """Opens a bag, for use in a with statement. Raises BagError if the file is missing, is no bag, or is incomplete."""
    try:
        if not pathlib.Path(file).exists():
            raise BagError(f"{file}: no such file")
        return rosbag.Bag(str(file))
    except rosbag.ROSBagUnindexedException:
        raise BagError(f"{file}: is not complete, its index is missing: the recording or a copy was cut short; "
                       "'rosbag reindex' saves what is there") from None
    except (rosbag.ROSBagException, UnicodeDecodeError):
        raise BagError(f"{file}: found no bag, expected a file that begins with '#ROSBAG V2.0'") from None
    except OSError as problem:
        raise BagError(f"{file}: cannot be read: {problem.strerror}") from None


def messages(file: Any, topics: Sequence[str]) -> Iterator[Tuple[str, Any]]:
    """Yields topics and messages, in the order of their times. Raises BagError, also later for damaged data, and ImportError
    if a library that reads them is missing."""
    with open_bag(file) as bag:
        try:
            for topic, message, _ in bag.read_messages(topics=topics):
                yield topic, message
        except OSError as problem:
            raise BagError(f"{file}: cannot be read: {problem.strerror}") from None
        except ImportError:   # a library for decompression is missing
            raise
        except MemoryError as problem:
            raise BagError(f"{file}: does not fit into memory") from problem
        except Exception as problem:  # decompression and deserialisation raise many types
            raise BagError(f"{file}: is damaged: {problem}") from None


def kind_name(event: Any) -> Any:
    """The name of the event's kind, from the message definition in the bag; the number if it is unknown."""
    names = {value: name.lower() for name, value in vars(type(event)).items() if name.isupper()}
    return names.get(event.kind, event.kind)


class _Columns:
    """Assigns columns to entities."""

    def __init__(self) -> None:
        self.known: Dict[Tuple[str, str], int] = {}
        self.order = functools.lru_cache(maxsize=64)(self._order)

    def _order(self, entities: Tuple[Tuple[str, str], ...]) -> numpy.ndarray:
        return numpy.array([self.known.setdefault(entity, len(self.known)) for entity in entities], dtype=numpy.int64)


class _Rows:
    """Collects the content of state messages, row by row."""

    def __init__(self) -> None:
        self.runs: List[int] = []
        self.ticks: List[int] = []
        self.stamps: List[Any] = []
        self.orders: List[numpy.ndarray] = []
        self.poses: List[numpy.ndarray] = []
        self.engines: List[List[str]] = []
        self.gripped: List[List[str]] = []
        self.colors: List[numpy.ndarray] = []

    def add(self, run: int, state: Any, columns: _Columns) -> None:
        self.runs.append(run)
        self.ticks.append(state.tick)
        self.stamps.append(state.header.stamp)
        self.orders.append(columns.order(tuple(zip(state.names, state.types))))
        self.poses.append(numpy.array([(p.position.x, p.position.y, p.position.z, p.orientation.x, p.orientation.y,
                                        p.orientation.z, p.orientation.w) for p in state.poses]).reshape(-1, 7))
        self.engines.append(state.engines)
        self.gripped.append(state.gripped)
        self.colors.append(numpy.array([(c.r, c.g, c.b, c.a) for c in state.colors], dtype=numpy.float32).reshape(-1, 4))

    def table(self, values: List[Any], columns: int, blank: Any, dtype: Any, behind: Tuple[int, ...] = ()) -> numpy.ndarray:
        table = numpy.full((len(values), columns, *behind), blank, dtype=dtype)
        for row, (order, line) in enumerate(zip(self.orders, values)):
            table[row, order] = line
        return table


def _starts(runs: Sequence[int], ticks: Sequence[int], stamps: Sequence[Any]) -> Dict[int, int]:
    """Stamp of the start of each run [ns], extrapolated if the bag begins later."""
    first: Dict[int, int] = {}
    for row, run in enumerate(runs):
        first.setdefault(run, row)
    start: Dict[int, int] = {}
    for run, row in first.items():
        later = next((other for other in range(row + 1, len(runs)) if runs[other] == run and ticks[other] > ticks[row]), None)
        now = stamps[row].to_nsec()
        if ticks[row] == 0:
            start[run] = now
        elif later is not None:
            start[run] = now - ticks[row] * (stamps[later].to_nsec() - now) // (ticks[later] - ticks[row])
        else:
            start[run] = EPOCH_NS
    return start


def _since(start: int, stamp: Any) -> float:
    """Time since the start [s]."""
    return (stamp.to_nsec() - start) / 1e9  # a division rounds only once


class _About:
    """Content of the latched topics about the run; bags of other programs may lack all of them."""

    def __init__(self) -> None:
        self.last: Dict[str, Any] = {}
        self.record: Any = None  # of the first run

    def add(self, topic: str, message: Any) -> None:
        self.last[topic] = message
        if topic == "/space/record" and self.record is None:
            contents = {file.name: bytes(file.content) for file in message.files}
            self.record = ElementTree.fromstring(contents["record.xml"])

    def text(self, topic: str) -> str:
        return self.last[topic].data if topic in self.last else ""

    def attribute(self, name: str) -> str:
        return "" if self.record is None else self.record.get(name, "")

    def overrides(self) -> Tuple[str, ...]:
        found = [] if self.record is None else self.record.findall("override")
        return tuple(f"{one.get('path')}={one.get('value')}" for one in found)


def _value(text: str) -> Any:
    """Converts the value of a metric, which is a string in messages."""
    if text in ("true", "false"):
        return text == "true"
    return float(text) if NUMBER.fullmatch(text) else text


def load_bag(file: Any) -> Recording:
    """@raise BagError"""
    columns, rows, about = _Columns(), _Rows(), _About()
    events: List[Tuple[int, Any]] = []
    numbers: Dict[int, int] = {}  # number of a run in the space -> number in the recording: a bag may begin after a reset
    for topic, message in messages(file, [STATES, EVENTS, *ABOUT]):
        if topic in ABOUT:
            about.add(topic, message)
            continue
        run = numbers.setdefault(message.run, len(numbers))
        if topic == EVENTS:
            events.append((run, message))
        else:
            rows.add(run, message, columns)
    if not rows.runs and not events:
        raise BagError(f"{file}: found neither {STATES} nor {EVENTS}, expected a bag of `swarmanoid run --bag`")
    return _recording(str(file), columns, rows, about, events)


def _recording(file: str, columns: _Columns, rows: _Rows, about: _About, events: List[Tuple[int, Any]]) -> Recording:
    starts = _starts(rows.runs, rows.ticks, rows.stamps)
    count = len(columns.known)
    result = about.last.get("/space/result")
    seed = about.attribute("seed")
    return Recording(
        file=file, complete=True, experiment=about.attribute("experiment"), experiment_text=about.text("/space/experiment"),
        overrides=about.overrides(), seed=int(seed) if seed else None, version=about.attribute("version"),
        math_library=about.text("/space/math_library"),
        state_hash=f"{result.state_hash:016x}" if result is not None and result.state_hash else None,
        finished=result.finished if result is not None else None,
        result={metric.name: _value(metric.value) for metric in result.metrics} if result is not None else {},
        runs=numpy.array(rows.runs, dtype=numpy.int64), ticks=numpy.array(rows.ticks, dtype=numpy.int64),
        times=numpy.array([_since(starts[run], stamp) for run, stamp in zip(rows.runs, rows.stamps)], dtype=float),
        names=tuple(name for name, _ in columns.known), types=tuple(kind for _, kind in columns.known),
        poses=rows.table(rows.poses, count, numpy.nan, float, (7,)),
        present=rows.table([True] * len(rows.runs), count, False, bool),
        stamps=numpy.array([stamp.to_sec() for stamp in rows.stamps]),
        engines=rows.table(rows.engines, count, "", object), gripped=rows.table(rows.gripped, count, "", object),
        colors=rows.table(rows.colors, count, 0, numpy.float32, (4,)), orders=rows.orders,
        events=[RecordedEvent(run, event.tick, _since(starts.get(run, EPOCH_NS), event.header.stamp), kind_name(event),
                              event.entity, event.other, event.text) for run, event in events])
