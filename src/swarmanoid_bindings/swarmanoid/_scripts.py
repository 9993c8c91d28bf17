"""Loads the Python files that an experiment names for its controllers and rules (source="python")."""

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
_loading = threading.RLock()   # sys.path and sys.modules are shared by the process
_libraries = {os.path.realpath(folder) for folder in (os.path.dirname(__file__), *map(sysconfig.get_path, ("stdlib", "purelib", "platlib")),
                                                      *site.getsitepackages(), site.getusersitepackages())}
_known = weakref.WeakSet()     # scripts in use


class Script:
    """A file that is executed once, as `module`. At its top it may import modules from its folder; each script has its own copies
    of them, so that runs in one process share no state. No byte code is written, since a file may change within a second."""

    def __init__(self, path):
        self.module = types.ModuleType(f"swarmanoid_script_{next(_numbers)}")   # a unique name that no code imports
        self.module.__file__ = path
        self._beside = []
        with open(path, "rb") as file:
            code = compile(file.read(), path, "exec", dont_inherit=True)
        sys.modules[self.module.__name__] = self.module                         # dataclasses and pickle search sys.modules
        try:
            with _loading:
                self._execute(code, os.path.dirname(path))
        except BaseException:
            self.forget()
            raise
        _known.add(self)

    def _execute(self, code, folder):
        names = modules_in(folder)
        others = take_modules(names)   # modules of these names that other code imported
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
        """Names of the file's objects that may be parts of an experiment."""
        return [name for name, value in vars(self.module).items()
                if not name.startswith("_") and not isinstance(value, types.ModuleType)]

    def forget(self):
        """Ends the use of the script, and releases its objects, such as open files, at once."""
        sys.modules.pop(self.module.__name__, None)
        for module in (self.module, *self._beside):
            vars(module).clear()


def files_read():
    """Paths of all scripts in use, and of the modules that they imported from their folders."""
    modules = [module for script in list(_known) for module in (script.module, *script._beside)]
    return sorted({path for module in modules if (path := getattr(module, "__file__", None))})


def take_modules(names):
    """Removes modules of these names, and their submodules, from sys.modules. @return the removed modules by name"""
    found = {name: module for name, module in list(sys.modules.items()) if name.partition(".")[0] in names}
    for name in found:
        del sys.modules[name]
    return found


def modules_in(folder):
    """Names of the modules and packages in a folder, without this package."""
    with os.scandir(folder) as entries:
        names = {os.path.splitext(entry.name)[0] for entry in entries
                 if entry.name.endswith(".py") or os.path.exists(os.path.join(entry.path, "__init__.py"))}
    return names - {__package__}


def is_in_library(filename):
    """Whether a file belongs to this package, to Python or to an installed package, and not to the user."""
    is_file = not filename.startswith("<")    # names such as "<string>" and those of NumPy are no files
    return not is_file or any(os.path.realpath(filename).startswith(folder + os.sep) for folder in _libraries)


def describe(error, trace):
    """An exception in one line with its location: the innermost frame in the user's own code, if there is one."""
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
