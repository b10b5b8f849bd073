#!/usr/bin/env python3
"""Makes the tables of docs/results.md again, and tells every number that changed.

Runs `opal bench` on the recorded sites, judges what it wrote, and fills the marked tables. Without names, all tables are made.
A name is a table (full, stages, calibration, damage, careful, strict, sites, seeds, ten-maps, kidnapping, cuts, large, large-cpu, drives, drives-models,
faults, integrity, integrity-careful, integrity-strict, mutants, fuzzing, redrawn, other-maps, sketched, furnished, lasers, learning, campus, storeys) or a kind of map (full, plan, thick, drop, shift, wall, false, mixed, union, copies): then
only the rows of that kind are made.
"""

import argparse
import concurrent.futures
import functools
import json
import operator
import os
import pathlib
import subprocess
import sys

import campus
import drives
import furnished
import judge
import lasers
import learning
import other_maps
import redrawn
import sketched
import tables

PLAN = ["--plan", "1.5"]
KINDS = {  # the row's label in docs/results.md, and what makes the map
    "full": ("full maps", []),
    "plan": ("plans", PLAN),
    "thick": ("thick=0.4", ["--damage", "thick=0.4"]),
    "drop": ("drop=0.3", [*PLAN, "--damage", "drop=0.3"]),
    "shift": ("shift=0.2", [*PLAN, "--damage", "shift=0.2"]),
    "wall": ("wall=0.6", [*PLAN, "--damage", "wall=0.6"]),
    "false": ("false=0.3", [*PLAN, "--damage", "false=0.3"]),
    "mixed": ("mixed", [*PLAN, "--damage", "drop=0.3,shift=0.1,wall=0.6,false=0.3"]),
}
DAMAGED = [kind for kind in KINDS if kind != "full"]
CAUTIOUS = {caution: {f"{caution}-{kind}": (KINDS[kind][0], [*KINDS[kind][1], "--config", caution]) for kind in ("full", "plan", "drop", "mixed")}
            for caution in ("careful", "strict")}
MADE = functools.reduce(operator.or_, CAUTIOUS.values(), KINDS)
JOINED = {"union": ("union of all sites", []), "copies": ("union and ten copies", ["--copies", "10"])}
SITES = ["acapulco", "csail", "freiburg-079", "seattle", "malaga-demo", "malaga", "belgioioso"]
STAGES = ("detect", "local_map", "track", "generate", "search", "retrospect", "grow")
SEEDED = ("drop", "mixed")  # which walls are damaged matters most there
DRIVEN = ("drives", "drives-models", "faults", "integrity", "integrity-careful", "integrity-strict", "mutants", "fuzzing", "redrawn", "other-maps", "sketched", "furnished", "lasers", "learning", "learning-walls", "campus", "storeys")  # make their runs themselves
BY_SEED = ("seeds", "ten-maps", "cuts")  # tables
MAP_SEEDS, CUT_SEEDS = range(1, 21), range(1, 5)
KIDNAPPING_OPTION, KIDNAPPING_FILE = "--kidnap", "kidnappings.csv"


def seeds_in(text):
    """`1-3,7` is 1, 2, 3 and 7."""
    seeds = []
    for part in text.split(","):
        first, _, last = part.partition("-")
        seeds += range(int(first), int(last or first) + 1)
    if not set(seeds) <= set(MAP_SEEDS):
        raise argparse.ArgumentTypeError(f"seeds {MAP_SEEDS[0]} to {MAP_SEEDS[-1]} have rows in the tables")
    return sorted(set(seeds))


def number(value, decimals):
    return "" if value is None else f"{value:.{decimals}f}"


class Bench:
    """Runs of `opal bench`, each made once."""

    def __init__(self, options):
        self.opal = options.opal.resolve()
        self.folder = options.sites_folder
        self.out = options.out
        self.reuse = options.reuse
        self.jobs = options.jobs
        wanted = options.sites or SITES
        self.sites = [site for site in wanted if (self.folder / f"{site}.queries.json").exists()]
        for site in (site for site in wanted if site not in self.sites):
            print(f"{site}: no {self.folder / site}.queries.json, skipped", file=sys.stderr)
        self.complete = self.sites == SITES  # sums over fewer sites stand in no table

    def run_bench(self, folder, prefixes, arguments):
        done = folder / "done"
        if self.reuse and done.exists():
            return
        folder.mkdir(parents=True, exist_ok=True)
        done.unlink(missing_ok=True)
        command = [self.opal, "bench", *prefixes, "-o", folder, *arguments]
        with open(folder / "log.txt", "w") as log:
            if subprocess.run([str(word) for word in command], stdout=log, stderr=subprocess.STDOUT).returncode != 0:
                last = "".join(open(folder / "log.txt", errors="replace").readlines()[-15:])
                raise SystemExit(f"{' '.join(map(str, command))}\nfailed and said\n{last}")
        done.touch()
        print(f"{folder.relative_to(self.out)}: done", file=sys.stderr, flush=True)

    def site_folder(self, kind, seed, site):
        return self.out / f"{kind}-{seed}" / site

    def joined_folder(self, kind):
        return self.out / kind

    def run_site(self, kind, seed, site):
        arguments = [KIDNAPPING_OPTION, str(seed)] if kind == "kidnapping" else [*MADE[kind][1], "--seed", str(seed)]
        self.run_bench(self.site_folder(kind, seed, site), [self.folder / site], arguments)

    def run_joined(self, kind):
        self.run_bench(self.joined_folder(kind), [self.folder / site for site in self.sites], ["--join", *JOINED[kind][1]])

    def verdicts(self, kind, seed, site):
        return judge.judge_site(self.folder / site, self.site_folder(kind, seed, site) / "results.csv")

    def all_verdicts(self, kind, seed):
        return [verdict for site in self.sites for verdict in self.verdicts(kind, seed, site)]

    def summary(self, kind, seed, site):
        return json.loads((self.site_folder(kind, seed, site) / "summary.json").read_text())

    def joined_verdicts(self, kind):
        return self.verdicts_in(self.joined_folder(kind))

    def verdicts_in(self, folder):
        return [verdict for site in self.sites for verdict in judge.judge_site(self.folder / site, folder / f"{site}.csv")]

    def joined_summary(self, kind, site):
        return json.loads((self.joined_folder(kind) / site / "summary.json").read_text())

    def kidnappings(self, seed):
        """@return sums by site."""
        return {site: judge.read_kidnappings([self.site_folder("kidnapping", seed, site) / KIDNAPPING_FILE])
                for site in self.sites}

    def all_kidnappings(self, seeds):
        return judge.read_kidnappings([self.site_folder("kidnapping", seed, site) / KIDNAPPING_FILE
                                       for seed in seeds for site in self.sites])


def judged_cells(total):
    return {"success": str(total.success), "strict": str(total.strict),
            "median distance m": number(total.median_distance_m, 1), "localized": str(total.localized),
            "localized rows": str(total.localized_rows), "false positives": str(total.false_rows),
            "queries with a false positive": str(total.false_queries)}


def full_table(bench):
    made, everything = {}, []
    for site in bench.sites:
        verdicts, summary = bench.verdicts("full", 1, site), bench.summary("full", 1, site)
        everything += verdicts
        total = judge.totals(verdicts)
        made[site] = {"queries": str(total.queries), "independent": str(sum(v.independent for v in verdicts)), **judged_cells(total),
                      "error after m": number(total.error_m, 2), "CPU ms median": number(summary["cpu_ms_median"], 2),
                      "CPU ms mean": number(summary["cpu_ms_mean"], 2), "CPU ms p99": number(summary["cpu_ms_p99"], 1),
                      "hypotheses": number(summary["hypotheses_mean"], 1), "peak MB": number(summary["peak_rss_mb"], 0),
                      "localizer MB": number(summary["localizer_mb"], 0), "import s": number(summary["import_s"], 2)}
    if bench.complete:
        for label, independent in (("all independent", True), ("all map overlaps", False)):
            part = [verdict for verdict in everything if verdict.independent == independent]
            made[label] = {"queries": str(len(part)), **judged_cells(judge.totals(part))}
    return made


def stages_table(bench):
    spent = {site: bench.summary("full", 1, site)["stage_ms_mean"] for site in bench.sites}
    return {site: {f"{stage.replace('_', ' ')}, CPU ms": number(spent[site][stage], 2) for stage in STAGES} for site in bench.sites}


def calibration_table(bench):
    if not bench.complete:
        return {}
    out = bench.out / "calibration"
    runs = [bench.site_folder("full", 1, site) for site in bench.sites]
    subprocess.run([bench.opal, "calibration", *runs, "-o", out, "--truth", bench.folder], check=True,
                   stdout=subprocess.DEVNULL)
    best = json.loads((out / "calibration.json").read_text())["best"]["per_row"]
    return {label: {"value": number(best[key], 3), "95 % interval": " to ".join(number(end, 3) for end in best[key + "_95"])}
            for label, key in (("Brier score", "brier"), ("expected calibration error", "expected_error"))}


def damage_table(bench, kinds):
    if not bench.complete:
        return {}
    return {MADE[kind][0]: judged_cells(judge.totals(bench.all_verdicts(kind, 1))) for kind in kinds}


def sites_table(bench, kinds):
    return {KINDS[kind][0]: {site: str(judge.totals(bench.verdicts(kind, 1, site)).success) for site in bench.sites}
            for kind in kinds}


def seeds_table(bench, kinds, seeds):
    if not bench.complete:
        return {}
    return {f"seed {seed}": {f"{KINDS[kind][0]}: success": str(judge.totals(bench.all_verdicts(kind, seed)).success)
                             for kind in kinds} for seed in seeds}


def with_means(made, page_table):
    """Means over all seeds of the table, if each has a number now."""
    if not made:
        return {}
    header = [tables.plain(cell) for cell in tables.cells_of(page_table[0])]
    known = {tables.plain(row[0]): dict(zip(header, map(tables.plain, row)))
             for row in map(tables.cells_of, page_table[2:])}
    for label, values in made.items():
        known[label].update(values)
    means = {}
    for column in header[1:]:
        cells = [row[column] for label, row in known.items() if label.startswith("seed ")]
        if all(cells):
            means[column] = number(sum(map(float, cells)) / len(cells), 1)
    return {**made, "mean": means}


def ten_maps_table(bench, kinds, seeds):
    """Ten maps of a kind together, where all ten were made; a hundred queries each, so a mean is a percentage."""
    if not bench.complete:
        return {}
    made = {}
    for first, last in ((1, 10), (11, 20)):
        ten = list(range(first, last + 1))
        if not set(ten) <= set(seeds):
            continue
        for kind in kinds:
            total = judge.totals([verdict for seed in ten for verdict in bench.all_verdicts(kind, seed)])
            cells = judged_cells(total)
            cells.pop("median distance m")
            shares = {key: number(100 * int(cells[key]) / total.queries, 1) for key in ("success", "strict", "localized")}
            made[f"{KINDS[kind][0]}, seeds {first} to {last}"] = {**cells, **shares}
    return made


def kidnapping_cells(sums):
    return {"sequences": str(sums.sequences), "localized before the cut": str(sums.localized_before),
            "recovered within 15 m": str(sums.recovered), "median m until recovered": number(sums.median_m, 1),
            "no false positive after the cut": str(sums.without_false_positive), "said lost": str(sums.said_lost),
            "localized again": str(sums.localized_again)}


def kidnapping_table(bench):
    made = {site: kidnapping_cells(sums) for site, sums in bench.kidnappings(1).items()}
    if bench.complete:
        made["all"] = kidnapping_cells(bench.all_kidnappings([1]))
    return made


def cuts_table(bench, seeds):
    if not bench.complete:
        return {}
    sums = {f"seed {seed}": bench.all_kidnappings([seed]) for seed in seeds if seed in CUT_SEEDS}
    if set(CUT_SEEDS) <= set(seeds):
        sums["all"] = bench.all_kidnappings(CUT_SEEDS)
    return {label: {key: kidnapping_cells(sums)[key] for key in
                    ("sequences", "recovered within 15 m", "no false positive after the cut")} for label, sums in sums.items()}


def large_table(bench, kinds):
    if not bench.complete:
        return {}
    made = {}
    for kind in kinds:
        cells = judged_cells(judge.totals(bench.joined_verdicts(kind)))
        cells.pop("median distance m")
        peak_mb = max(bench.joined_summary(kind, site)["peak_rss_mb"] for site in bench.sites)
        made[JOINED[kind][0]] = {**cells, "peak MB": number(peak_mb, 0)}
    return made


def large_cpu_table(bench):
    if not bench.complete:
        return {}
    made, spent_ms = {}, {"alone": 0.0, "copies": 0.0}
    for site in bench.sites:
        alone, copies = bench.summary("full", 1, site), bench.joined_summary("copies", site)
        for name, summary in (("alone", alone), ("copies", copies)):
            spent_ms[name] += summary["updates"] * summary["cpu_ms_mean"]
        made[site] = {"CPU ms, own map": number(alone["cpu_ms_mean"], 2),
                      "CPU ms, ten copies": number(copies["cpu_ms_mean"], 2),
                      "CPU, times the own map": number(copies["cpu_ms_mean"] / alone["cpu_ms_mean"], 1)}
    made["all updates"] = {"CPU, times the own map": number(spent_ms["copies"] / spent_ms["alone"], 1)}
    return made


class Selection:
    """Which tables, and which kinds of map in them."""

    TABLES = {"full": ["full"], "stages": ["full"], "calibration": ["full"], "damage": DAMAGED, **{caution: list(kinds) for caution, kinds in CAUTIOUS.items()}, "sites": list(KINDS),
              "seeds": list(SEEDED), "ten-maps": list(SEEDED), "kidnapping": ["kidnapping"], "cuts": ["kidnapping"], "large": list(JOINED),
              "large-cpu": ["copies"], **{table: ["driven"] for table in DRIVEN}}

    def __init__(self, names):
        known = {*self.TABLES, *MADE, *JOINED, "kidnapping"}
        for name in names:
            if name not in known:
                raise SystemExit(f"no table or kind of map '{name}'; there are {', '.join(sorted(known))}")
        self.kinds = {table: [kind for kind in kinds if not names or table in names or kind in names]
                      for table, kinds in self.TABLES.items()}
        self.kinds = {table: kinds for table, kinds in self.kinds.items() if kinds}

    def runs(self, seeds, sites, complete):
        """What has to run: (kind, seed, site) on a site's own map, and kinds of joined maps."""
        single, joined = set(), set()
        for table, kinds in self.kinds.items():
            if table in DRIVEN:
                continue
            if table in ("large", "large-cpu"):
                joined |= set(kinds) if complete else set()
                single |= {("full", 1, site) for site in sites if table == "large-cpu" and complete}
                continue
            if table in BY_SEED and not complete:
                continue
            of = seeds if table in BY_SEED else [1]
            single |= {(kind, seed, site) for kind in kinds for seed in of for site in sites
                       if table != "cuts" or seed in CUT_SEEDS}
        return sorted(single), sorted(joined)


def run_all(bench, selection, seeds, jobs):
    single, joined = selection.runs(seeds, bench.sites, bench.complete)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        turns = [pool.submit(bench.run_joined, kind) for kind in joined]
        turns += [pool.submit(bench.run_site, *run) for run in single]
        try:
            for turn in concurrent.futures.as_completed(turns):
                turn.result()
        except SystemExit:
            pool.shutdown(cancel_futures=True)
            raise


def make_tables(bench, driven, selection, seeds, page):
    kinds = selection.kinds
    learned = functools.cache(lambda: learning.learning_tables(bench))
    makers = {
        "full": lambda: full_table(bench),
        "stages": lambda: stages_table(bench),
        "calibration": lambda: calibration_table(bench),
        "damage": lambda: damage_table(bench, kinds["damage"]),
        **{caution: lambda caution=caution: damage_table(bench, kinds[caution]) for caution in CAUTIOUS},
        "sites": lambda: sites_table(bench, kinds["sites"]),
        "seeds": lambda: with_means(seeds_table(bench, kinds["seeds"], seeds), tables.table_in(page, "seeds")),
        "ten-maps": lambda: ten_maps_table(bench, kinds["ten-maps"], seeds),
        "kidnapping": lambda: kidnapping_table(bench),
        "cuts": lambda: cuts_table(bench, seeds),
        "large": lambda: large_table(bench, kinds["large"]),
        "large-cpu": lambda: large_cpu_table(bench),
        **driven.makers(),
        "other-maps": lambda: other_maps.other_maps_table(bench),
        "redrawn": lambda: redrawn.redrawn_table(bench, judged_cells),
        "sketched": lambda: sketched.sketched_table(bench, judged_cells),
        "furnished": lambda: furnished.furnished_table(bench, judged_cells),
        "lasers": lambda: lasers.laser_table(bench, judged_cells),
        "learning": lambda: learned()[0], "learning-walls": lambda: learned()[1],
        "campus": lambda: campus.campus_table(bench, judged_cells),
    }
    return {table: makers[table]() for table in kinds}


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="of tables or kinds of map; all, if none is given")
    parser.add_argument("--opal", type=pathlib.Path, default=pathlib.Path("build/release/bin/opal"), help="Opal's program")
    parser.add_argument("--sites-folder", type=pathlib.Path, default=pathlib.Path("../shared/data/sites"),
                        help="folder of SITE.queries.json, SITE.gt.csv and the recordings")
    parser.add_argument("--models-folder", type=pathlib.Path, default=pathlib.Path("../shared/data/ifc"),
                        help="folder of building models, *.ifc; plans of several storeys are in plans beside it")
    parser.add_argument("--sites", nargs="+", choices=SITES, help="only these; sums over all sites then stay as they are")
    parser.add_argument("--page", type=pathlib.Path, default=pathlib.Path("docs/results.md"))
    parser.add_argument("-o", "--out", type=pathlib.Path, default=pathlib.Path("out/results"), help="folder for the runs")
    parser.add_argument("--seeds", type=seeds_in, default=[1], help="of damage and cuts, in the tables by seed: 1-3 or 1,4")
    parser.add_argument("--jobs", type=int, default=2, help="sites at a time; CPU is best measured with 1")
    parser.add_argument("--reuse", action="store_true", help="do not repeat runs that are complete in the folder of --out")
    parser.add_argument("--keep-cost", action="store_true", help="leave CPU, memory and import times as they are")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if anything but CPU, memory or time changed")
    parser.add_argument("--tolerance", type=float, metavar="SHARE",
                        help="with --check: numbers that differ by this share, or by 2, have not changed")
    return parser.parse_args(arguments)


def main(arguments=None):
    options = parse(arguments)
    selection = Selection(options.names)
    bench = Bench(options)
    if not bench.sites and not set(selection.kinds) <= set(DRIVEN):
        print(f"no recorded sites in {options.sites_folder}: nothing to do")
        return 0
    if not os.access(bench.opal, os.X_OK):
        raise SystemExit(f"{bench.opal}: no such program; ./run build makes it")
    page = options.page.read_text()
    for table in selection.kinds:
        tables.table_in(page, table)  # better refused before hours of runs than after
    run_all(bench, selection, options.seeds, options.jobs)
    new, changes = tables.rewritten(page, make_tables(bench, drives.Drives(options), selection, options.seeds, page), options.keep_cost)
    for change in changes:
        print(change)
    results = [change for change in changes if not change.is_cost
               and not (options.tolerance is not None and change.is_within(options.tolerance))]
    print(f"{len(results)} results changed, and {len(changes) - len(results)} numbers of CPU, memory or time")
    if options.check:
        return 1 if results else 0
    options.page.write_text(new)
    return 0


if __name__ == "__main__":
    sys.exit(main())
