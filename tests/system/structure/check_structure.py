#!/usr/bin/env python3
"""Checks the rules of the tree and prints FILE:LINE with a sentence for each break. Python's standard library only.

rooms.txt is the order of the rooms, exceptions.txt what may be large, words.txt which words are gone.
"""

import argparse
import pathlib
import sys

import rules_of_comments
import rules_of_rooms
import rules_of_size
import rules_of_types
import rules_of_words
from source_tree import HERE, ROOT, Rooms, WrongTable


def all_breaks(root, tables):
    rooms = Rooms(tables / "rooms.txt")
    return [*rules_of_rooms.breaks(root, rooms),
            *rules_of_size.breaks(root, tables / "exceptions.txt"),
            *rules_of_types.breaks(root),
            *rules_of_comments.breaks(root),
            *rules_of_words.breaks(root, tables / "words.txt")]


def told(root, problem):
    path, line, sentence = problem
    path = pathlib.Path(path)
    return f"{path.relative_to(root) if path.is_relative_to(root) else path}:{line}: {sentence}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="tree to check (default: this one)")
    options = parser.parse_args()
    try:
        problems = all_breaks(options.root.resolve(), HERE)
    except WrongTable as error:
        problems = None
        print(error)
    for problem in problems or []:
        print(told(options.root.resolve(), problem))
    if problems:
        print(f"{len(problems)} breaks of the rules; CONTRIBUTING.md says what they are")
    return 0 if problems == [] else 1


if __name__ == "__main__":
    sys.exit(main())
