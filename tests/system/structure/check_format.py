#!/usr/bin/env python3
"""Checks that every C++ source looks as .clang-format says (--fix: makes it so). Ends with 77 without clang-format 14."""

import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys

from source_tree import ROOT, sources_below

FOLDERS = ("framework", "plugins", "patterns", "tests", "docs/examples")
VERSION = "14"  # others lay out the same source in another way
SKIPPED = 77
BATCH = 20


def formatter():
    for name in (f"clang-format-{VERSION}", "clang-format"):
        program = shutil.which(name)
        if program:
            said = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
            if re.search(rf"version {VERSION}\.", said):
                return program
    return None


def run(program, options, sources):
    """The program's words about the sources, batch by batch, on all cores."""
    batches = [sources[k:k + BATCH] for k in range(0, len(sources), BATCH)]

    def of_batch(batch):
        done = subprocess.run([program, *options, *batch], cwd=ROOT, capture_output=True, text=True, check=False)
        return done.stderr or (f"{program} ended with {done.returncode}\n" if done.returncode else "")

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return "".join(pool.map(of_batch, batches))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fix", action="store_true", help="format the sources instead")
    options = parser.parse_args()
    program = formatter()
    if not program:
        print(f"no clang-format {VERSION}: skipped")
        return SKIPPED
    sources = [str(path.relative_to(ROOT)) for path in sources_below(ROOT, *FOLDERS)]
    if options.fix:
        said = run(program, ["-i"], sources)
        print(said, end="")
        return 1 if said else 0
    said = run(program, ["--dry-run", "-Werror", "--ferror-limit=1"], sources)
    wrong = re.findall(r"^(\S+?:\d+):\d+: error: code should be clang-formatted", said, re.MULTILINE)
    print("".join(f"{place}: is not as .clang-format says\n" for place in wrong) if wrong else said, end="")
    if wrong:
        print(f"{len(wrong)} of {len(sources)} sources; to format them: python3 -B tests/system/structure/check_format.py --fix")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
