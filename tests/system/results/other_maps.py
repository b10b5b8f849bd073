"""Robots whose map is another building's: what is called localized is wrong. Each recorded site on the maps of all others, and the
simulated drives of `opal experiment faults`."""

import concurrent.futures
import csv
import itertools
import pathlib
import sys

from faults import DRIVES, WRONG_FOR_S
from redrawn import run

CAUTIONS = {"usual": ("default", "two_lasers"), "careful": ("careful", "careful_two_lasers"), "strict": ("strict", "strict_two_lasers")}
FAULT = "another building's map"


def longest_localized_s(rows):
    """Of the rows of one query. @param rows  in the order of time."""
    spells = (list(spell) for is_localized, spell in itertools.groupby(rows, lambda row: row["status"] == "localized") if is_localized)
    return max((float(spell[-1]["timestamp"]) - float(spell[0]["timestamp"]) for spell in spells), default=0)


def cells_of(wrong_s, were_localized):
    return {"runs": str(len(wrong_s)), "ever localized": str(sum(were_localized)),
            "for more than 1 s": str(sum(time_s > WRONG_FOR_S for time_s in wrong_s)), "longest s": f"{max(wrong_s):.1f}"}


def recorded(results):
    """Of each query. @param results  files of `opal bench`."""
    wrong_s, were_localized = [], []
    for file in results:
        with file.open(newline="", encoding="utf-8") as text:
            for _, of_query in itertools.groupby(csv.DictReader(text), lambda row: row["query_id"]):
                rows = list(of_query)
                wrong_s.append(longest_localized_s(rows))
                were_localized.append(any(row["status"] == "localized" for row in rows))
    return wrong_s, were_localized


def simulated(file):
    """Of each drive. @param file  of `opal experiment faults`."""
    with file.open(newline="", encoding="utf-8") as text:
        wrong_s = [float(row["longest_wrong_s"]) for row in csv.DictReader(text)]
    return wrong_s, [time_s > 0 for time_s in wrong_s]


def folder_of(bench):
    return pathlib.Path(bench.out) / "other-maps"


def import_maps(bench):
    """A folder per site, in which every other site has its map."""
    for site in bench.sites:
        folder = folder_of(bench) / "maps" / site
        own = folder / "own.jsonld"
        folder.mkdir(parents=True, exist_ok=True)
        if not own.exists():
            run(bench.opal, "map", "import", bench.folder / f"{site}.map.yaml", "-o", own)
        for link in (folder / f"{other}.map.jsonld" for other in bench.sites):
            if not link.is_symlink():
                link.symlink_to(own.name)


def drive_on(bench, config, site, other):
    folder = folder_of(bench) / config / f"{site}-on-{other}"
    results = folder / "results.csv"
    if not (bench.reuse and results.exists()):
        run(bench.opal, "bench", bench.folder / site, "--maps", folder_of(bench) / "maps" / other, "--config", config, "-o", folder)
    return results


def drive_simulated(bench, config):
    folder = folder_of(bench) / config
    kept = folder / "drives.csv"
    if not (bench.reuse and kept.exists()):
        run(bench.opal, "experiment", "faults", "--only", FAULT, "--drives", DRIVES, "--config", config, "-o", folder, "--jobs", bench.jobs)
        print(f"other maps, {config}: done", file=sys.stderr, flush=True)
    return kept


def runs_by_label(bench):
    """For how long [s] each run was localized without a break, and whether it ever was."""
    import_maps(bench)
    pairs = list(itertools.permutations(bench.sites, 2))
    made = {}
    for caution, (one_laser, two_lasers) in CAUTIONS.items():
        with concurrent.futures.ThreadPoolExecutor(bench.jobs) as pool:
            made[f"recorded, {caution}"] = recorded(list(pool.map(lambda pair, config=one_laser: drive_on(bench, config, *pair), pairs)))
        made[f"simulated, {caution}"] = simulated(drive_simulated(bench, two_lasers))
    return made


def other_maps_table(bench):
    return {label: cells_of(*runs) for label, runs in runs_by_label(bench).items()} if bench.complete else {}
