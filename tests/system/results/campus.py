"""All recorded sites on one map of growing size, side by side with look-alikes: `opal map join`, then `opal bench --join`."""

import json
import math
import os
import pathlib
import subprocess

import judge
from redrawn import run

COPIES = {"10 thousand": 2, "100 thousand": 28, "a million": 287}  # the row's label in docs/results.md; each adds 3,473 features
EXPONENT = "growth exponent"  # the label of the last row: 1 is a cost that grows as the map does
GROWING = {"read CPU s": 1, "read MB": 0, "localizer MB": 0, "mean CPU ms": 2, "p99 CPU ms": 1}  # decimals
JUDGED = ("success", "localized", "localized rows", "false positives", "queries with a false positive")


def read_cost(bench, folder, copies):
    """Processor time [s] and peak memory [MB] of `opal map check` of the document."""
    document, done = folder / "campus.jsonld", folder / "read.json"
    if not (bench.reuse and done.exists()):
        run(bench.opal, "map", "join", *[bench.folder / f"{site}.map.yaml" for site in bench.sites], "--copies", copies, "-o", document)
        process = subprocess.Popen([bench.opal, "map", "check", document], stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        if status != 0:
            raise SystemExit(f"opal map check {document} failed")
        done.write_text(json.dumps([used.ru_utime + used.ru_stime, used.ru_maxrss / 1024]))
        document.unlink()  # a million features take 600 MB
    return json.loads(done.read_text())


def costs(bench, folder):
    summaries = [json.loads((folder / site / "summary.json").read_text()) for site in bench.sites]
    updates = sum(summary["updates"] for summary in summaries)
    return {"localizer MB": max(summary["localizer_mb"] for summary in summaries),
            "mean CPU ms": sum(summary["updates"] * summary["cpu_ms_mean"] for summary in summaries) / updates,
            "p99 CPU ms": max(summary["cpu_ms_p99"] for summary in summaries)}


def row_of(bench, copies):
    """Numbers that grow, and the verdicts of all queries."""
    folder = pathlib.Path(bench.out) / "campus" / str(copies)
    folder.mkdir(parents=True, exist_ok=True)
    cpu_s, peak_mb = read_cost(bench, folder, copies)
    bench.run_bench(folder, [bench.folder / site for site in bench.sites], ["--join", "--copies", copies])
    return {"read CPU s": cpu_s, "read MB": peak_mb, **costs(bench, folder)}, judge.totals(bench.verdicts_in(folder))


def campus_table(bench, cells_of):
    """One size after the other: a million features take some gigabytes. @param cells_of  of a judge.Total."""
    if not bench.complete:
        return {}
    made, numbers = {}, []
    for label, copies in COPIES.items():
        grown, total = row_of(bench, copies)
        numbers.append(grown)
        judged = cells_of(total)
        made[label] = {**{name: f"{grown[name]:.{decimals}f}" for name, decimals in GROWING.items()}, **{name: judged[name] for name in JUDGED}}
    first, *_, last = COPIES.values()
    growth = math.log((last + 1) / (first + 1))
    made[EXPONENT] = {name: f"{math.log(numbers[-1][name] / numbers[0][name]) / growth:.2f}" for name in GROWING}
    return made
