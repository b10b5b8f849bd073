"""Drives that a seed draws, and how many of them call a wrong pose localized: `opal experiment integrity`, by stratum."""

import json
import pathlib
import sys

from redrawn import run

DRIVES = {"integrity": 500, "integrity-careful": 2357}  # drives that were made: a campaign may grow
ROBOTS = {"integrity": (), "integrity-careful": ("--one-laser", "careful", "--two-lasers", "careful_two_lasers")}


SHOWN = {"integrity": None, "integrity-careful": ("all", "alike", "storeys", "map", "event")}  # aspects; None: all of them


def label_of(stratum):
    return f"{stratum['aspect']}: {stratum['value']}" if stratum["value"] else "all drives"


def length(value_m):
    """A drive that never was localized counts as the longest way."""
    return "never" if value_m is None else f"{value_m:.1f}"


def cells_of(stratum):
    after = stratum["localized_after_m"]
    return {"drives": str(stratum["drives"]), "false": str(stratum["false_drives"]),
            "of 1,000, at most": f"{1000 * stratum['false_share_95'][1]:.1f}",
            "localized %": f"{100 * stratum['localized_drives'] / stratum['drives']:.1f}",
            "median m until localized": length(after["median"]), "95 % within m": length(after["95 %"])}


def integrity_table(options, name="integrity"):
    folder = pathlib.Path(options.out) / name
    summary = folder / "summary.json"
    if not (options.reuse and summary.exists()):
        run(options.opal.resolve(), "experiment", "integrity", "-o", folder, "--drives", DRIVES[name], "--jobs", options.jobs, *ROBOTS[name])
        print(f"{name}: done", file=sys.stderr, flush=True)
    shown = SHOWN[name]
    return {label_of(stratum): cells_of(stratum) for stratum in json.loads(summary.read_text())["strata"]
            if shown is None or stratum["aspect"] in shown}
