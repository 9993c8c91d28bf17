"""Reads files of `swarmanoid run --trajectories`; docs/reference/trajectory_file.md has their layout."""

import pathlib
from typing import Any, Dict, Iterator, Tuple

import h5py
import numpy

from .recording import RecordedReadings, Recording, RecordingError

FORMAT = "swarmanoid trajectories"
VERSION = 1
ATTRIBUTES = ("complete", "math_library", "seed", "version")                          # required in each file
ARRAYS = ("entities/name", "entities/type", "pose", "run", "tick", "time")


def _open(file: pathlib.Path) -> h5py.File:
    try:
        return h5py.File(file, "r")
    except OSError:
        pass
    try:  # the run is active or was killed, so the file is still marked as open for writing
        return h5py.File(file, "r", swmr=True)
    except OSError as problem:
        raise RecordingError(f"{file}: cannot be read: {problem}") from None


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)


def _value(value: Any) -> Any:
    return value.item() if isinstance(value, numpy.generic) else _text(value)


def _texts(values: Any) -> Tuple[str, ...]:
    return tuple(_text(value) for value in values)


def _is_list(group: h5py.Group) -> bool:
    return "counts" in group and "is_count" in group["counts"].attrs


def _datasets(group: h5py.Group) -> Iterator[h5py.Dataset]:
    for item in group.values():
        if isinstance(item, h5py.Dataset):
            yield item
        else:
            yield from _datasets(item)


def _rows_of(group: h5py.Group) -> Iterator[int]:
    """Yields the number of rows of each array."""
    if _is_list(group):
        counts = group["counts"]
        yield len(counts)
        elements = min((len(item) for item in _datasets(group) if item != counts), default=0)
        sums = numpy.cumsum(counts[()].sum(axis=1, dtype=numpy.int64))
        yield int(numpy.searchsorted(sums, elements, side="right"))
        return
    for name, item in group.items():
        if not isinstance(item, h5py.Dataset):
            yield from _rows_of(item)
        elif name != "robots":
            yield len(item)


def _whole_rows(file: h5py.File) -> int:
    """Number of rows that all arrays have: in an incomplete file some arrays are longer than others."""
    lengths = [len(file[name]) for name in ("time", "tick", "run", "pose")]
    for group in ("readings", "metrics"):
        if group in file:
            lengths.extend(_rows_of(file[group]))
    return min(lengths)


def _fields(group: h5py.Group, rows: int) -> RecordedReadings:
    fields: Dict[str, Any] = {}
    if _is_list(group):
        fields["counts"] = group["counts"][:rows]
        rows = int(fields["counts"].sum(dtype=numpy.int64))
    for name, item in group.items():
        if name == "robots":
            fields[name] = item[()]
        elif name not in fields:
            fields[name] = item[:rows] if isinstance(item, h5py.Dataset) else _fields(item, rows)
    return RecordedReadings(fields)


def _metrics(group: h5py.Group, rows: int) -> Dict[str, numpy.ndarray]:
    found: Dict[str, numpy.ndarray] = {}
    group.visititems(lambda name, item: found.update({name: item[:rows]} if isinstance(item, h5py.Dataset) else {}))
    return found


def load_trajectories(file: pathlib.Path) -> Recording:
    """@raise RecordingError"""
    with _open(file) as opened:
        found = _text(opened.attrs.get("format", "no format"))
        if found != FORMAT:
            raise RecordingError(f"{file}: found an HDF5 file with {found!r}, allowed: {FORMAT!r}")
        version = opened.attrs.get("format_version", "no format_version")
        if version != VERSION:
            raise RecordingError(f"{file}: found format {version}, allowed: {VERSION}")
        missing = [name for name in ATTRIBUTES if name not in opened.attrs] + [name for name in ARRAYS if name not in opened]
        if missing:
            raise RecordingError(f"{file}: found no '{missing[0]}', allowed: a file as `swarmanoid run --trajectories` writes it")
        return _recording(file, opened)


def _recording(file: pathlib.Path, opened: h5py.File) -> Recording:
    attributes = opened.attrs
    rows = _whole_rows(opened)
    poses = opened["pose"][:rows]
    names = _texts(opened["entities/name"][:poses.shape[1]])
    poses = poses[:, :len(names)]  # an incomplete file may have fewer names
    runs = opened["run"][:rows]
    return Recording(
        file=str(file), complete=bool(attributes["complete"]), experiment=_text(attributes.get("experiment", "")),
        experiment_text=_text(attributes.get("experiment_text", "")), overrides=_texts(attributes.get("overrides", ())),
        seed=int(attributes["seed"]), version=_text(attributes["version"]), math_library=_text(attributes["math_library"]),
        state_hash=_text(attributes["state_hash"]) if "state_hash" in attributes else None,
        finished=bool(attributes["finished"]) if "finished" in attributes else None,
        result={name: _value(value) for name, value in opened["result"].attrs.items()} if "result" in opened else {},
        runs=(runs - runs[0] if rows else runs).astype(numpy.int64), ticks=opened["tick"][:rows].astype(numpy.int64),
        times=opened["time"][:rows], names=names, types=_texts(opened["entities/type"][:len(names)]), poses=poses,
        present=~numpy.isnan(poses[..., 0]),
        readings={name: _fields(group, rows) for name, group in opened.get("readings", {}).items()},
        metrics=_metrics(opened["metrics"], rows) if "metrics" in opened else {})
