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

import tidy_units
from source_tree import ROOT, files_below

FOLDERS = ("framework", "plugins", "patterns", "tests")
PROGRAM = "clang-tidy-14"
SKIPPED = 77
CATCH = "run_tests.cpp"  # makes all of Catch2 of its header, so it comes before those that only use it
# The text may have several lines.
FINDING = re.compile(r"^(\S+?):(\d+):\d+: (?:error|warning): ((?:.|\n(?!\S+:\d+:\d+: ))*?) \[([^\],\s]+)[^\]\n]*\]$", re.MULTILINE)


def sources_to_read(build):
    """With their options. The others are in no folder of ours: CMake wrote them."""
    commands = tidy_units.commands(build)
    ours = [path for folder in FOLDERS for path in files_below(ROOT, folder) if path.suffix == ".cpp"]
    ours.sort(key=lambda path: path.name != CATCH)
    return {path: commands[path] for path in ours if path in commands}, [path for path in ours if path not in commands]


def run(command):
    """What it says, whether it failed, and the processor time [s] that it took."""
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        said = process.stdout.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return said, process.returncode != 0, used.ru_utime + used.ru_stime


def findings_of(unit, path, more):
    path.write_text(unit.text())
    options = [word for option in unit.options for word in option]
    said, failed, spent_s = run([PROGRAM, "--quiet", *more, str(path), "--", "-std=c++20", "-w", *options])
    everything = FINDING.findall(said)
    found = {finding for finding in everything if is_ours(finding[0])}
    if failed and not everything:
        found.add((str(path), "0", said, "clang-tidy failed"))
    print(f"{path.name}: {len(unit.sources)} sources, {spent_s:.0f} s of processor", *map(line_of, sorted(found)),
          sep="\n  ", flush=True)  # at once: whoever is stopped halfway has seen something
    return found


def is_ours(file):
    """Some checks tell of the headers of libraries, too."""
    return pathlib.Path(os.path.abspath(file)).is_relative_to(ROOT)


def line_of(finding):
    file, line, text, check = finding
    return f"{os.path.relpath(file, ROOT)}:{line}: {' '.join(text.split())} [{check}]"


def findings_apart(unit, path, more):
    """Sources that do not go together, though they seemed to, are read apart."""
    found = findings_of(unit, path, more)
    wrong = {file for file, _, _, check in found if check == "clang-diagnostic-error"}
    if not wrong or len(unit.sources) == 1:
        return found
    print(f"{path.name} is read in parts: {', '.join(sorted(wrong))} cannot be read with its neighbours", flush=True)
    return set().union(*(findings_apart(part, path.with_name(f"{path.stem}_{number}.cpp"), more)
                         for number, part in enumerate(unit.parts(wrong))))


def all_findings(units, folder, more):
    folder.mkdir(exist_ok=True)
    paths = [folder / f"unit_{number}.cpp" for number in range(len(units))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return set().union(*pool.map(findings_apart, units, paths, [more] * len(units)))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path, help="folder of a configured build")
    build, more = parser.parse_known_args()
    if not shutil.which(PROGRAM):
        print(f"no {PROGRAM}: skipped")
        return SKIPPED
    options, unread = sources_to_read(build.build)
    units = tidy_units.units_of(options)
    print(f"clang-tidy reads {len(options)} sources in {len(units)} units", flush=True)
    for path in unread:
        print(f"{path.relative_to(ROOT)}: not read, this build does not compile it")
    found = all_findings(units, build.build / "tidy", more)
    print(f"findings: {len(found)}", *map(line_of, sorted(found)), sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
