"""How often each reader met mangled input, and how much of it that reached: `./run fuzz`, by reader."""

import json
import pathlib
import re
import sys

from redrawn import run

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = ROOT / "build/asan"
SECONDS = 120  # of each reader
MORE = 300  # seconds of each of the faster half, again and again, until all readers together made WANTED runs
WANTED = 100_000_000
RUNS = re.compile(r"^stat::number_of_executed_units: *(\d+)$", re.MULTILINE)
RATE = re.compile(r"^stat::average_exec_per_sec: *(\d+)$", re.MULTILINE)
REACHED = re.compile(r"^#\d+.* cov: (\d+) .*corp: (\d+)/", re.MULTILINE)  # the last line of libFuzzer tells how far it got


def cells_of(rounds):
    """Sums over readers, of which each has the logs of its rounds. A later round starts from the inputs that the earlier ones kept."""
    reached = [REACHED.findall(logs[-1])[-1] for logs in rounds]
    return {"runs": str(runs_of(rounds)), "branches reached": str(sum(int(edges) for edges, _ in reached)),
            "inputs kept": str(sum(int(kept) for _, kept in reached))}


def runs_of(rounds):
    return sum(int(RUNS.search(log)[1]) for logs in rounds for log in logs)


def fuzz(seconds, readers):
    """A round: each reader's log."""
    run(ROOT / "run", "fuzz", seconds, *readers)
    return {reader: (BUILD / f"{reader}.log").read_text(errors="replace") for reader in readers or (BUILD / "fuzz_targets.txt").read_text().split()}


def faster_half(rounds):
    return sorted(rounds, key=lambda reader: int(RATE.search(rounds[reader][0])[1]))[len(rounds) // 2:]


def fuzz_on(rounds, file):
    """One more round, kept in a file: who stops the command goes on with --reuse."""
    logs = fuzz(MORE, faster_half(rounds)) if rounds else fuzz(SECONDS, [])
    for reader, log in logs.items():
        rounds.setdefault(reader, []).append(log)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(rounds))
    print(f"fuzzing: {runs_of(rounds.values())} of {WANTED} runs", file=sys.stderr, flush=True)


def fuzzing_table(options):
    kept = options.out / "fuzzing.json"
    rounds = json.loads(kept.read_text()) if options.reuse and kept.exists() else {}
    while runs_of(rounds.values()) < WANTED:
        fuzz_on(rounds, kept)
    return {**{reader: cells_of([logs]) for reader, logs in rounds.items()}, "all": cells_of(list(rounds.values()))}
