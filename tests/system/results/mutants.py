"""Small changes of the library that its tests notice: `./run mutants`, by room."""

import collections
import json
import pathlib
import subprocess
import sys

RUN = pathlib.Path(__file__).resolve().parents[1] / "mutation/run_mutants.py"


def cells_of(row):
    judged = row["mutants"] - row["explained"]
    return {"mutants": str(row["mutants"]), "noticed": str(row["noticed"]), "explained": str(row["explained"]),
            "noticed %": f"{100 * row['noticed'] / max(1, judged):.0f}"}


def mutants_table(options):
    folder = pathlib.Path(options.out) / "mutants"
    summary = folder / "summary.json"
    if not (options.reuse and summary.exists()):
        build = options.opal.resolve().parents[1]
        done = subprocess.run(["/usr/bin/python3", "-B", str(RUN), str(build), "-o", str(folder), "--jobs", str(options.jobs)],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(f"run_mutants.py: {done.stderr.strip()[-2000:] or done.stdout.strip()[-2000:]}")
        print("mutants: done", file=sys.stderr, flush=True)
    rooms = json.loads(summary.read_text())["rooms"]
    total = collections.Counter()
    for row in rooms.values():
        total.update(row)
    return {room: cells_of(row) for room, row in [*rooms.items(), ("all", total)]}
