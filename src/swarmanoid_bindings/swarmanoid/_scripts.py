"""The files in Python that an experiment names for its controllers and rules (source="python")."""

import importlib.util
import pathlib
import sys
import traceback
import types


def load(file):
    """The module that a file is, executed anew: runs share nothing by it. It may import what is beside it."""
    path = pathlib.Path(file).resolve()
    if str(path.parent) not in sys.path:
        sys.path.append(str(path.parent))
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def names(module):
    """What may be a part of an experiment."""
    return [name for name, value in vars(module).items() if not name.startswith("_") and not isinstance(value, types.ModuleType)]


def describe(error, trace):
    """An exception in one line, with the place in a file that has thrown it."""
    text = f"{type(error).__name__}: {error}"
    frames = [] if isinstance(error, SyntaxError) else traceback.extract_tb(trace)
    frames = [frame for frame in frames if not frame.filename.startswith("<frozen")]
    return text if not frames else f"{text} ({frames[-1].filename}:{frames[-1].lineno})"
