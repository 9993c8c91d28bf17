"""The files in Python that an experiment names for its controllers and rules (source="python")."""

import importlib
import itertools
import os
import site
import sys
import sysconfig
import threading
import traceback
import types
import weakref

_numbers = itertools.count(1)
_loading = threading.RLock()   # what is found by `import` is the whole process's
_libraries = {os.path.realpath(folder) for folder in (os.path.dirname(__file__), *map(sysconfig.get_path, ("stdlib", "purelib", "platlib")),
                                                      *site.getsitepackages(), site.getusersitepackages())}
_known = weakref.WeakSet()     # scripts that are in use


class Script:
    """A file, executed once: `module` is what is in it. It may import, at its top, what is beside it: that is its own, too, so
    that runs in one process share nothing by their files. No byte code is kept, for a file may change within a second."""

    def __init__(self, path):
        self.module = types.ModuleType(f"swarmanoid_script_{next(_numbers)}")   # a name that no code imports
        self.module.__file__ = path
        self._beside = []
        with open(path, "rb") as file:
            code = compile(file.read(), path, "exec", dont_inherit=True)
        sys.modules[self.module.__name__] = self.module                         # dataclasses and pickle look there
        try:
            with _loading:
                self._execute(code, os.path.dirname(path))
        except BaseException:
            self.forget()
            raise
        _known.add(self)

    def _execute(self, code, folder):
        names = modules_in(folder)
        others = take_modules(names)   # of other code
        keeps_byte_code, sys.dont_write_bytecode = sys.dont_write_bytecode, True
        sys.path.insert(0, folder)
        importlib.invalidate_caches()
        try:
            exec(code, vars(self.module))
        finally:
            sys.path.remove(folder)
            sys.dont_write_bytecode = keeps_byte_code
            self._beside += take_modules(names).values()
            sys.modules.update(others)

    def names(self):
        """What may be a part of an experiment."""
        return [name for name, value in vars(self.module).items()
                if not name.startswith("_") and not isinstance(value, types.ModuleType)]

    def forget(self):
        """It is not used any more. What it holds, such as open files, is given back at once."""
        sys.modules.pop(self.module.__name__, None)
        for module in (self.module, *self._beside):
            vars(module).clear()


def files_read():
    """The files of all scripts that are in use, and of what these have imported from beside them."""
    modules = [module for script in list(_known) for module in (script.module, *script._beside)]
    return sorted({path for module in modules if (path := getattr(module, "__file__", None))})


def take_modules(names):
    """Modules of such names, with what is in them, that were imported, and are so no longer."""
    found = {name: module for name, module in list(sys.modules.items()) if name.partition(".")[0] in names}
    for name in found:
        del sys.modules[name]
    return found


def modules_in(folder):
    """The names of modules and packages that are beside a file. Ours is never one of them."""
    with os.scandir(folder) as entries:
        names = {os.path.splitext(entry.name)[0] for entry in entries
                 if entry.name.endswith(".py") or os.path.exists(os.path.join(entry.path, "__init__.py"))}
    return names - {__package__}


def is_in_library(filename):
    """Whether a file is one of this package, of Python or of an installed package, where users look for no mistake of theirs."""
    is_file = not filename.startswith("<")    # as NumPy has them, too
    return not is_file or any(os.path.realpath(filename).startswith(folder + os.sep) for folder in _libraries)


def describe(error, trace):
    """An exception in one line, with the place of the mistake: where users' own code was, if a library has thrown it."""
    try:
        text = str(error)
    except Exception:
        text = "(an error without a text)"
    text = " ".join(f"{type(error).__name__}: {text}".split())
    frames = [] if isinstance(error, SyntaxError) else traceback.extract_tb(trace)
    frames = [frame for frame in frames if not frame.filename.startswith("<frozen")]
    frames = [frame for frame in frames if not is_in_library(frame.filename)] or frames
    place = f" ({frames[-1].filename}:{frames[-1].lineno})" if frames else ""
    return (text + place).encode("utf-8", "backslashreplace").decode()
