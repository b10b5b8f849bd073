#!/usr/bin/env python3
"""Draws docs/structure.svg: the rooms of framework/ and their includes. Needs graphviz (dot)."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

import drawing
from source_tree import HERE, ROOT, Rooms


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--out", type=pathlib.Path, default=ROOT / "docs" / "structure.svg")
    parser.add_argument("--dot", action="store_true", help="print the graph instead")
    options = parser.parse_args()
    graph = drawing.graph(ROOT, Rooms(HERE / "rooms.txt"))
    if options.dot:
        print(graph, end="")
        return 0
    if not shutil.which("dot"):
        print("no dot: apt-get install graphviz", file=sys.stderr)
        return 1
    svg = subprocess.run(["dot", "-Tsvg"], input=graph, capture_output=True, text=True, check=True).stdout
    svg = re.sub(r"<!--.*?-->\n?", "", svg, flags=re.DOTALL)
    options.out.write_text(svg.rstrip() + "\n" + drawing.mark(graph) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
