#!/usr/bin/env python3
"""What clang-tidy finds in the C++ sources, by .clang-tidy. Reads the compile commands of a configured build; nothing of it
need be built. Options that this program does not know go to clang-tidy."""

import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

import compile_commands
from source_tree import ROOT, files_below

FOLDERS = ("framework", "plugins", "patterns", "tests")
PROGRAM = "clang-tidy-22"  # from version 22 on, it leaves out the headers of libraries: a quarter of the time
SKIPPED = 77
# The text may have several lines.
FINDING = re.compile(r"^(\S+?):(\d+):\d+: (?:error|warning): ((?:.|\n(?!\S+:\d+:\d+: ))*?) \[([^\],\s]+)[^\]\n]*\]$", re.MULTILINE)


def files_to_read(build):
    """Of every file with sources of ours: how many these are, and its options. And the sources that are in none."""
    ours = {path for folder in FOLDERS for path in files_below(ROOT, folder) if path.suffix == ".cpp"}
    files = {file: (len(ours.intersection(sources)), options) for file, (sources, options) in compile_commands.files(build).items()
             if ours.intersection(sources)}
    return files, ours.difference(compile_commands.options_of_sources(build))


def run(command):
    """What it says, whether it failed, and the processor time [s] that it took."""
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        said = process.stdout.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return said, process.returncode != 0, used.ru_utime + used.ru_stime


def findings_of(file, sources, options, more):
    words = [word for option in options for word in option]
    said, failed, spent_s = run([PROGRAM, "--quiet", *more, str(file), "--", "-std=c++20", "-w", *words])
    everything = FINDING.findall(said)
    found = {finding for finding in everything if is_ours(finding[0])}
    if failed and not everything:
        found.add((str(file), "0", said, "clang-tidy failed"))
    print(f"{file.name}: {sources} sources, {spent_s:.0f} s of processor", *map(line_of, sorted(found)),
          sep="\n  ", flush=True)  # at once: whoever is stopped halfway has seen something
    return found


def is_ours(file):
    """Some headers of libraries are older than this clang, which takes a few of their lines for errors."""
    return pathlib.Path(os.path.abspath(file)).is_relative_to(ROOT)


def line_of(finding):
    file, line, text, check = finding
    return f"{os.path.relpath(file, ROOT)}:{line}: {' '.join(text.split())} [{check}]"


def all_findings(files, more):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return set().union(*pool.map(lambda file: findings_of(file, *files[file], more), files))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path, help="folder of a configured build")
    build, more = parser.parse_known_args()
    if not shutil.which(PROGRAM):
        print(f"no {PROGRAM}: skipped")
        return SKIPPED
    files, unread = files_to_read(build.build)
    print(f"clang-tidy reads {sum(sources for sources, _ in files.values())} sources in {len(files)} files", flush=True)
    for path in sorted(unread):
        print(f"{path.relative_to(ROOT)}: not read, this build does not compile it")
    found = all_findings(files, more)
    print(f"findings: {len(found)}", *map(line_of, sorted(found)), sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
