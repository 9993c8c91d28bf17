"""A recorded run of any file format, as arrays with a row per recorded tick and a column per entity."""

import dataclasses
import pathlib
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy


class RecordingError(ValueError):
    """A file that cannot be read; the message has its name and the reason."""


class RecordedEvent(NamedTuple):
    run: int          # number of resets in the recording, from 0
    tick: int
    time: float       # simulated time since the start of the run [s]
    kind: Any         # name of the constant in Event.msg, in lower case; the number if the file does not name it
    entity: str
    other: str
    text: str


@dataclasses.dataclass
class Recording:
    """Rows are recorded ticks of all runs, one after the other; columns are entities. Units: SI; frame W, z up."""

    file: str
    complete: bool                 # False: the writer was killed, or the disk was full; the data are valid up to there
    experiment: str
    experiment_text: str           # the experiment file, before overrides
    overrides: Tuple[str, ...]     # "path=value"
    seed: Optional[int]            # of the first run
    version: str                   # of the suite, with the commit
    math_library: str
    state_hash: Optional[str]      # of the last state; None: not in the file
    finished: Optional[bool]       # whether the run came to its end; None: not in the file
    result: Dict[str, Any]         # metrics at the end

    runs: numpy.ndarray            # (rows,): number of resets in the recording, from 0
    ticks: numpy.ndarray           # (rows,)
    times: numpy.ndarray           # (rows,): simulated time since the start of the run [s]
    names: Tuple[str, ...]         # (columns,)
    types: Tuple[str, ...]         # (columns,)
    poses: numpy.ndarray           # (rows, columns, 7): x, y, z, and the quaternion x, y, z, w; NaN: entity absent
    present: numpy.ndarray         # (rows, columns): whether the entity exists
    readings: Dict[str, "RecordedReadings"] = dataclasses.field(default_factory=dict)
    metrics: Dict[str, numpy.ndarray] = dataclasses.field(default_factory=dict)  # (rows,) each

    # Only from bags.
    stamps: Optional[numpy.ndarray] = None     # (rows,): of the messages [s]
    engines: Optional[numpy.ndarray] = None    # (rows, columns): id of the engine that moves it
    gripped: Optional[numpy.ndarray] = None    # (rows, columns): name of the gripped entity
    colors: Optional[numpy.ndarray] = None     # (rows, columns, 4): red, green, blue, alpha
    events: Optional[List[RecordedEvent]] = None
    orders: Optional[List[numpy.ndarray]] = None  # (rows,): columns of the present entities, in the order of entity numbers

    def column(self, name: str) -> int:
        """@raise KeyError"""
        if name not in self.names:
            raise KeyError(f"found the entity '{name}', allowed: {', '.join(self.names)}")
        return self.names.index(name)

    def headings(self) -> numpy.ndarray:
        """Angles about W's z axis, from -pi to pi [rad]: (rows, columns)."""
        x, y, z, w = numpy.moveaxis(self.poses[..., 3:], -1, 0)
        return numpy.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


class RecordedReadings:
    """The readings of one type of sensor: each field is an attribute, an array (rows, robots, ...). Nested fields are
    attributes of their field. A list such as `blobs` has `counts` (rows, robots), and its fields have the elements of all
    rows and robots, concatenated."""

    def __init__(self, fields: Dict[str, Any]) -> None:
        self.__dict__.update(fields)

    def __repr__(self) -> str:
        return f"<readings: {', '.join(self.__dict__)}>"


def load(path: Any) -> Recording:
    """Reads a rosbag of the suite, or a trajectory file. @raise RecordingError, or ImportError if a library that reads it is
    missing"""
    try:
        return _load(pathlib.Path(path))
    except (RecordingError, ImportError):
        raise
    except MemoryError as problem:
        raise RecordingError(f"{path}: does not fit into memory: {problem}") from problem
    except Exception as problem:  # libraries raise many types of errors for damaged files
        if isinstance(problem, OSError) and problem.errno:   # an error of the system
            text = f"cannot be read: {problem.strerror}"
        else:
            text = f"is damaged: {type(problem).__name__}: {problem}"
        raise RecordingError(f"{path}: {' '.join(text.split())}") from problem


def _load(path: pathlib.Path) -> Recording:
    if not path.exists():
        raise RecordingError(f"{path}: no such file")
    if not path.is_file() and not path.is_dir():
        raise RecordingError(f"{path}: cannot be read: it is no regular file")
    try:
        with open(path, "rb") as opened:
            first = opened.read(8)
    except OSError as problem:
        raise RecordingError(f"{path}: cannot be read: {problem.strerror}") from None
    if first == b"\x89HDF\r\n\x1a\n":
        from .trajectory_file import load_trajectories
        return load_trajectories(path)
    if first.startswith(b"#ROSBAG"):
        from .bag_file import load_bag
        return load_bag(path)
    raise RecordingError(f"{path}: found neither a bag nor trajectories, allowed: a file of `swarmanoid run --bag` or --trajectories")
