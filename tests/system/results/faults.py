"""Drives of simulated robots whose sensor streams fail: `opal experiment faults`, by fault."""

import csv
import pathlib
import statistics
import sys

from redrawn import run

DRIVES = 200
WRONG_FOR_S = 1


def cells_of(rows):
    before = [row for row in rows if row["localized_before"] == "1"]
    after = sorted(float(row["recovered_after_s"] or "inf") for row in before)
    cells = {"drives": str(len(rows)), "localized before": str(len(before)),
             "localized elsewhere for more than 1 s": str(sum(float(row["longest_wrong_s"]) > WRONG_FOR_S for row in rows)),
             "named": str(sum(row["named"] == "1" for row in rows))}
    if after:
        cells["median s until right again"] = f"{statistics.median_low(after):.1f}"
        cells["right again within 5 s"] = str(sum(time_s <= 5 for time_s in after))
    return cells


def faults_table(options):
    folder = pathlib.Path(options.out) / "faults"
    kept = folder / "drives.csv"
    if not (options.reuse and kept.exists()):
        run(options.opal.resolve(), "experiment", "faults", "-o", folder, "--drives", DRIVES, "--jobs", options.jobs)
        print("faults: done", file=sys.stderr, flush=True)
    by_fault = {}
    with kept.open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            by_fault.setdefault(row["fault"], []).append(row)
    return {fault: cells_of(rows) for fault, rows in by_fault.items()}
