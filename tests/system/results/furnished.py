"""Drives past what stands along all walls and is on no map: `opal simulate --along-walls`, then `opal bench`."""

import concurrent.futures
import pathlib
import re
import statistics

import judge
from redrawn import run

BUILDINGS = (1, 2, 3, 4, 5)  # seeds, of each kind
KINDS = ("office", "hall", "warehouse", "corridor")
SITES = "plans of the recorded sites"  # the row's label in docs/results.md
WORLD = ("--along-walls", "0.95", "--clutter", "3", "--drives", "5", "--distance", "40")
PLAN = ("--plan", "1.5")
EARLY = re.compile(r"^(\d+) % of the beams end before", re.MULTILINE)


def drives(bench, label, which):
    """Verdicts of one building's drives, and the share of beams [%] that never reach what is mapped.

    @param which  the seed of a generated building, or the name of a recorded site.
    """
    folder = pathlib.Path(bench.out) / "furnished" / f"{label.replace(' ', '-')}-{which}"
    told, results, building = folder / "simulated.txt", folder / "bench" / "results.csv", folder / "map.jsonld"
    if not (bench.reuse and results.exists()):
        folder.mkdir(parents=True, exist_ok=True)
        if label == SITES:
            run(bench.opal, "map", "import", f"{bench.folder / which}.map.yaml", "-o", building)
        else:
            run(bench.opal, "map", "generate", label, "--seed", which, "-o", building)
        told.write_text(run(bench.opal, "simulate", building, "-o", folder / "place", *WORLD))
        run(bench.opal, "bench", folder / "place", "-o", folder / "bench", *(PLAN if label == SITES else ()))
    return judge.judge_site(folder / "place", results), int(EARLY.search(told.read_text()).group(1))


def furnished_table(bench, cells_of):
    """@param cells_of  of a judge.Total."""
    if not bench.complete:
        return {}
    with concurrent.futures.ThreadPoolExecutor(bench.jobs) as pool:
        turns = {kind: [pool.submit(drives, bench, kind, seed) for seed in BUILDINGS] for kind in KINDS}
        turns[SITES] = [pool.submit(drives, bench, SITES, site) for site in bench.sites]
        made = {}
        for label, of in turns.items():
            done = [turn.result() for turn in of]
            total = judge.totals([verdict for verdicts, _ in done for verdict in verdicts])
            made[label] = {"queries": str(total.queries), "beams that end early %": f"{statistics.mean(early for _, early in done):.0f}",
                           **cells_of(total)}
    return made
