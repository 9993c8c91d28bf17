#!/usr/bin/env python3
"""Counts words in comments and pages that stand for a clause or a person where a noun should stand ("whoever", "what is near").

The limits below hold the counts, which may only fall. With paths, it lists the places in them instead."""

import collections
import io
import pathlib
import re
import subprocess
import sys
import tokenize

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMITS = {
    "whoever": 0,
    "nobody": 9,
    "somebody": 1,
    "everybody": 0,
    "likewise": 0,
    "told": 0,
    "what is": 5,
    "what has": 0,
    "who is": 1,
    "who has": 0,
}
STRING = r'"(?:\\.|[^"\\\n])*"' + r"|'(?:\\.|[^'\\\n])*'"
C_TOKEN = re.compile(STRING + r"|(?P<comment>//[^\n]*(?:\n\s*//[^\n]*)*|/\*.*?\*/)", re.S)
SHELL_COMMENT = re.compile(r"^[ \t]*(?P<comment>#.*(?:\n[ \t]*#.*)*)$", re.M)
CODE_BLOCK = re.compile(r"^```.*?^```|^    .*?$|`[^`\n]*`", re.M | re.S)
WORD = re.compile(r"\b(" + "|".join(word.replace(" ", r"(?:\s|///?|#)+") for word in LIMITS) + r")\b", re.I)


def python_prose(text):
    """@return comments and documentation strings with their lines"""
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT or (token.type == tokenize.STRING and token.string.startswith('"""')):
            yield token.start[0], token.string


def prose_of(path, text):
    """@return parts of a file that people read, with their lines"""
    if path.suffix == ".md":
        yield 1, CODE_BLOCK.sub(lambda block: "\n" * block.group().count("\n"), text)
    elif path.suffix == ".py":
        yield from python_prose(text)
    else:
        pattern = C_TOKEN if path.suffix in (".cpp", ".hpp") else SHELL_COMMENT
        for found in pattern.finditer(text):
            if found["comment"]:
                yield text.count("\n", 0, found.start("comment")) + 1, found["comment"]


def places(paths):
    """@return (path, line, word) of each place"""
    for path in paths:
        for line, prose in prose_of(path, (ROOT / path).read_text()):
            for found in WORD.finditer(prose):
                word = re.sub(r"[\s/#]+", " ", found.group().lower())
                yield path, line + prose.count("\n", 0, found.start()), word


def sources():
    """@return all files with prose, without this one"""
    patterns = ("*.cpp", "*.hpp", "*.py", "*.md", "*.sh", "*.cmake", "*CMakeLists.txt")
    listed = subprocess.run(["git", "ls-files", *patterns], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return [pathlib.Path(name) for name in listed.split() if (ROOT / name).exists() and name != "scripts/check_prose.py"]


def main():
    paths = sources()
    wanted = [pathlib.Path(name).resolve().relative_to(ROOT) for name in sys.argv[1:]]
    if wanted:
        for path, line, word in places([path for path in paths if any(path.is_relative_to(start) for start in wanted)]):
            print(f"{path}:{line}: {word}")
        return
    counts = collections.Counter(word for _, _, word in places(paths))
    for word, limit in LIMITS.items():
        if counts[word] > limit:
            sys.exit(f"'{word}' in comments and pages: found {counts[word]}, allowed: {limit}. Write a noun instead; "
                     "scripts/check_prose.py PATH lists the places.")
        if counts[word] < limit:
            print(f"'{word}': the limit can fall from {limit} to {counts[word]}")


if __name__ == "__main__":
    main()
