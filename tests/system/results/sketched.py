"""Drives with a plan that was drawn by hand, or printed and scanned: `opal map sketch`, then `opal bench --maps`."""

import concurrent.futures
import pathlib

import judge
from redrawn import run, summed

SEEDS = (1, 2, 3)
BUILDINGS = [(kind, seed) for kind in ("office", "hall", "warehouse", "corridor") for seed in (1, 2, 3, 4, 5)]
HANDS = {"drawn by hand": [], "printed and scanned": ["--printed"]}  # the row's label in docs/results.md, and how
SITES, SIMULATED = "recorded sites", "generated buildings"
DRIVES = ("--drives", "5", "--distance", "40")


def verdicts(bench, hand, name, seed):
    """@param name  of a recorded site; or a kind of building, which the seed makes."""
    folder = pathlib.Path(bench.out) / "sketched" / f"{hand.replace(' ', '-')}-{name}-{seed}"
    place, results = bench.folder / name if name in bench.sites else folder / "place", folder / "bench" / "results.csv"
    if not (bench.reuse and results.exists()):
        building = f"{place}.map.yaml"
        if name not in bench.sites:
            building = folder / "place.jsonld"
            folder.mkdir(parents=True, exist_ok=True)
            run(bench.opal, "map", "generate", name, "--seed", seed, "-o", building)
            run(bench.opal, "simulate", building, "-o", place, *DRIVES)
        run(bench.opal, "map", "sketch", building, "-o", folder / "maps", "--seed", seed, *HANDS[hand])
        run(bench.opal, "bench", place, "--maps", folder / "maps", "-o", folder / "bench")
    return judge.judge_site(place, results)


def sketched_table(bench, cells_of):
    """Sums over all plans. @param cells_of  of a judge.Total."""
    if not bench.complete:
        return {}
    places = {SITES: [(site, seed) for seed in SEEDS for site in bench.sites], SIMULATED: BUILDINGS}
    with concurrent.futures.ThreadPoolExecutor(bench.jobs) as pool:
        turns = {f"{hand}: {where}": [pool.submit(verdicts, bench, hand, *place) for place in of]
                 for hand in HANDS for where, of in places.items()}
        return summed(turns, cells_of)
