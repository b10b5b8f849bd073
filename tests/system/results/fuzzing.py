"""How often each reader met mangled input, and how much of it that reached: `./run fuzz`, by reader."""

import pathlib
import re
import sys

from redrawn import run

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = ROOT / "build/asan"
SECONDS = 30  # of each reader
RUNS = re.compile(r"^stat::number_of_executed_units: *(\d+)$", re.MULTILINE)
REACHED = re.compile(r"^#\d+.* cov: (\d+) .*corp: (\d+)/", re.MULTILINE)  # the last line of libFuzzer tells how far it got


def cells_of(logs):
    """Sums over the logs of libFuzzer."""
    reached = [REACHED.findall(log)[-1] for log in logs]
    return {"runs": str(sum(int(RUNS.search(log)[1]) for log in logs)), "branches reached": str(sum(int(edges) for edges, _ in reached)),
            "inputs kept": str(sum(int(kept) for _, kept in reached))}


def fuzzing_table(options):
    readers = BUILD / "fuzz_targets.txt"
    logs = {}
    if not (options.reuse and readers.exists()):
        run(ROOT / "run", "fuzz", SECONDS)
        print("fuzzing: done", file=sys.stderr, flush=True)
    for reader in readers.read_text().split():
        logs[reader] = (BUILD / f"{reader}.log").read_text(errors="replace")
    return {**{reader: cells_of([log]) for reader, log in logs.items()}, "all": cells_of(list(logs.values()))}
