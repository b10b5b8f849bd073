"""Drives that a seed draws, and how many of them call a wrong pose localized: `opal experiment integrity`, by stratum."""

import dataclasses
import json
import pathlib
import sys

from redrawn import run


@dataclasses.dataclass(frozen=True)
class Campaign:
    drives: int  # that were made: a campaign may grow
    seed: int = 1
    robots: tuple = ()
    aspects: tuple = ()  # that the table shows; none: all of them


def cautious(caution, drives, seed):
    robots = ("--one-laser", caution, "--two-lasers", f"{caution}_two_lasers")
    return Campaign(drives, seed, robots, ("all", "alike", "storeys", "map", "event"))


CAMPAIGNS = {"integrity": Campaign(500), "integrity-careful": cautious("careful", 2000, 2), "integrity-strict": cautious("strict", 8000, 6)}


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
    campaign, folder = CAMPAIGNS[name], pathlib.Path(options.out) / name
    summary = folder / "summary.json"
    if not (options.reuse and summary.exists()):
        run(options.opal.resolve(), "experiment", "integrity", "-o", folder, "--drives", campaign.drives, "--seed", campaign.seed,
            "--jobs", options.jobs, *campaign.robots)
        print(f"{name}: done", file=sys.stderr, flush=True)
    return {label_of(stratum): cells_of(stratum) for stratum in json.loads(summary.read_text())["strata"]
            if not campaign.aspects or stratum["aspect"] in campaign.aspects}
