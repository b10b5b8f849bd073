"""What a configured build compiles: its files, the sources of the tree in each, and its options for the preprocessor."""

import json
import pathlib
import re
import shlex

from source_tree import ROOT


def files(build):
    """Of every file that is compiled, with its first options: {file: (sources of the tree, options)}. A file that the build
    made as the unit of a folder has the sources that it includes."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        if file not in found:
            found[file] = sources_of(file), preprocessor_options(shlex.split(entry["command"]))
    return found


def options_of_sources(build):
    return {source: options for sources, options in files(build).values() for source in sources}


def sources_of(file):
    if file.parent.parent.name != "Unity":
        return [file]
    return [ROOT / name for name in re.findall(r'#include "(.+\.cpp)"', file.read_text()) if (ROOT / name).is_file()]


def preprocessor_options(words):
    """Options with their values: a list of tuples."""
    kept, words = [], iter(words)
    for word in words:
        if word in ("-isystem", "-I"):
            kept += [(word, next(words))]
        elif word.startswith(("-D", "-I")):
            kept += [(word,)]
    return kept
