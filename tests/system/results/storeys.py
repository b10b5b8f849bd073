"""Robots on storeys that they are not told, and in lifts: `opal experiment storeys` on buildings of several storeys."""

import csv
import json
import statistics
import sys

from redrawn import run

DRIVES, RIDES = 100, 70
ALIKE = 0.03  # share of beams: with fewer that end elsewhere, a storey can hardly be told from another one
SOON_M = 10
ROBOT = ["--robot-radius", 0.25]
RIDE = ["--before", 20, "--after", 14, "--people", 2, "--clutter", 0.5, "--shafts-mapped"]
LIFT = {"@id": "lift-1", "@type": "StoreyConnection", "connection_type": "Lift", "radius_m": 0.9}
BUILDINGS = {  # the row's label in docs/results.md: plans, and a lift that they do not show and that robots reach
    "four storeys, 89 to 96 % alike": ("gdc_storey_*.geojson", (-18.2, 19.8)),
    "seven storeys, two alike": ("westport_floor_*.geojson", None),
}


def plans_of(options):
    return options.models_folder.parent / "plans"


def connections(plans, place):
    landings = [{"@type": "Landing", "on_storey": plan.stem, "x": place[0], "y": place[1]} for plan in plans]
    return {"@context": "urn:opal:v1", "@graph": [{**LIFT, "landings": landings}]}


def stacked(options, folder, pattern, lift):
    """The storeys as one map; nothing if the plans are not there."""
    plans = sorted(plans_of(options).glob(pattern))
    if not plans:
        return None
    folder.mkdir(parents=True, exist_ok=True)
    words = []
    if lift:
        (folder / "lifts.jsonld").write_text(json.dumps(connections(plans, lift)))
        words = ["--connections", folder / "lifts.jsonld"]
    run(options.opal.resolve(), "map", "stack", *plans, *words, "-o", folder / "map.jsonld")
    return folder / "map.jsonld"


def rows_of(options, folder, *words):
    kept = folder / "drives.csv"
    if not (options.reuse and kept.exists()):
        run(options.opal.resolve(), "experiment", "storeys", folder.parent / "map.jsonld", "-o", folder, "--jobs", options.jobs, *ROBOT, *words)
    with kept.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def soon(rows, column):
    return str(sum(row[column] != "" and float(row[column]) <= SOON_M for row in rows))


def cells_of(rows):
    after = [float(row["localized_from_m"]) for row in rows if row["localized_from_m"]]
    return {"drives": str(len(rows)),
            "right storey and place at the end, localized": str(sum(row["right"] == "1" for row in rows)),
            "with a false positive": str(sum(int(row["wrong"]) > 0 for row in rows)),
            "best hypothesis right within 10 m": soon(rows, "right_from_m"),
            "localized within 10 m": soon(rows, "localized_from_m"),
            "median m until localized": f"{statistics.median(after):.1f}" if after else ""}


def by_likeness(label, rows):
    """All of them; those who drove where another storey looks the same; the others."""
    alike = [row for row in rows if float(row["difference"]) < ALIKE]
    told = [row for row in rows if float(row["difference"]) >= ALIKE]
    return {label: cells_of(rows), f"{label}: another storey looks the same": cells_of(alike), f"{label}: it does not": cells_of(told)}


def storeys_table(options):
    made = {}
    for label, (pattern, lift) in BUILDINGS.items():
        folder = (options.out / "storeys" / pattern.split("_")[0]).resolve()
        if stacked(options, folder, pattern, lift) is None:
            print(f"no plans {pattern} in {plans_of(options)}: storeys skipped", file=sys.stderr)
            continue
        made.update(by_likeness(label, rows_of(options, folder / "drives", "--drives", DRIVES, "--distance", 60, "--rides", 0)))
        if lift:
            rides = rows_of(options, folder / "rides", "--drives", 0, "--rides", RIDES, "--seed", 21, *RIDE)
            made.update(by_likeness(f"rides, {label}", rides))
        print(f"{label}: done", file=sys.stderr, flush=True)
    return made
