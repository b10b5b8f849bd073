#!/usr/bin/env python3
"""Opal beside what its users have today: the same maps, recorded logs and queries, in one run.

For every kind of map and every site, Opal, exhaustive matching with a vote and a particle filter take their turns, so
that all three meet the same machine at its best and at its worst; several sites run at a time. What each found is judged
by the same program, and the table has CPU per update as a ratio to Opal's. Reasons in docs/results.md.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

KINDS = {
    "full": ("full maps", []),
    "plan": ("plans", ["--plan", "1.5"]),
    "mixed": ("mixed damage",
              ["--plan", "1.5", "--damage", "drop=0.3,shift=0.1,wall=0.6,false=0.3", "--seed", "1"]),
}
CONTENDERS = {"opal": "Opal", "bnb": "exhaustive", "mrpt_pf": "particle filter"}


def run(command, log):
    """Ends the whole comparison if a program fails: half a table would say something wrong."""
    with open(log, "w") as out:
        if subprocess.run([str(word) for word in command], stdout=out, stderr=subprocess.STDOUT).returncode != 0:
            raise SystemExit(f"{' '.join(map(str, command))}\nfailed; {log} ends with\n" + tail(log))


def tail(path, lines=15):
    return "".join(open(path, errors="replace").readlines()[-lines:])


class Comparison:
    def __init__(self, options):
        self.opal = options.opal
        self.yardsticks = options.yardsticks
        self.sites_folder = options.shared / "data/sites"
        self.eval_program = options.shared / "tools/eval.py"
        self.out = options.out
        self.kinds = options.kinds
        self.jobs = options.jobs
        known = sorted(path.name.split(".")[0] for path in self.sites_folder.glob("*.queries.json"))
        self.sites = options.sites or known
        for site in self.sites:
            if site not in known:
                raise SystemExit(f"{self.sites_folder}: no site '{site}'; there are {', '.join(known)}")

    def folder(self, kind, contender):
        folder = self.out / kind / contender
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    def baselines_map(self, kind, site):
        """The map that Opal gets, as a grid."""
        grid = self.sites_folder / f"{site}.map.yaml"
        damage = KINDS[kind][1]
        if not damage:
            return grid
        folder = self.folder(kind, "maps")
        run([self.opal, "map", "damage", grid, "-o", folder / f"{site}.jsonld", *damage], folder / f"{site}.damage.log")
        run([self.opal, "map", "raster", folder / f"{site}.jsonld", "-o", folder / f"{site}.map.yaml"],
            folder / f"{site}.raster.log")
        return folder / f"{site}.map.yaml"

    def run_opal(self, kind, site):
        folder = self.folder(kind, "opal")
        run([self.opal, "bench", self.sites_folder / site, "-o", folder / site, *KINDS[kind][1]], folder / f"{site}.log")
        shutil.copy(folder / site / "results.csv", folder / f"{site}.csv")

    def run_baseline(self, program, kind, site, grid):
        folder = self.folder(kind, program)
        laser = json.load(open(self.sites_folder / f"{site}.info.json"))["laser"]
        run([self.yardsticks / program, "--mode=vote" if program == "bnb" else "--pow=.1", f"--map={grid}",
             f"--log={self.sites_folder / site}.log.gz", f"--queries={self.sites_folder / site}.queries.json",
             f"--range_max={laser['no_return_at_or_above_m']}", f"--out={folder / site}.csv",
             f"--stats={folder / site}.stats.json"], folder / f"{site}.log")

    def take_turns(self, kind, site):
        grid = self.baselines_map(kind, site)
        self.run_opal(kind, site)
        for program in ("bnb", "mrpt_pf"):
            self.run_baseline(program, kind, site, grid)
        print(f"{kind}, {site}: done", file=sys.stderr, flush=True)

    def run_all(self):
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            turns = [pool.submit(self.take_turns, kind, site) for kind in self.kinds for site in self.sites]
            for turn in concurrent.futures.as_completed(turns):
                turn.result()

    def cpu(self, kind, contender, site):
        """Updates, and CPU of all of them in ms."""
        folder = self.folder(kind, contender)
        if contender == "opal":
            summary = json.load(open(folder / site / "summary.json"))
            return summary["updates"], summary["updates"] * summary["cpu_ms_mean"]
        queries = json.load(open(folder / f"{site}.stats.json"))["queries"]
        return sum(q["updates"] for q in queries), sum(q["updates"] * q["cpu_ms_per_update"] for q in queries)

    def judged(self, kind, contender):
        folder = self.folder(kind, contender)
        chosen = folder / "chosen"  # no results of earlier runs with other sites
        shutil.rmtree(chosen, ignore_errors=True)
        chosen.mkdir()
        for site in self.sites:
            shutil.copy(folder / f"{site}.csv", chosen)
        verdict = chosen / "eval.json"
        run([sys.executable, self.eval_program, "--sites", self.sites_folder, chosen, "--json", verdict, "-q"],
            folder / "eval.log")
        judged = json.load(open(verdict))
        if len(self.sites) == 1:  # there is no line for all then
            judged["ALL"] = judged[self.sites[0]]
        return judged

    def table(self):
        lines = ["| | success | strict | median distance m | localized and right | false positives: rows, queries "
                 "| CPU ms per update (ratio) |", "| --- | --- | --- | --- | --- | --- | --- |"]
        by_site = {name: {} for name in CONTENDERS}
        for kind in self.kinds:
            ms_of_opal = self.ms(kind, "opal", self.sites)
            for contender, name in CONTENDERS.items():
                judged = self.judged(kind, contender)
                total, ms = judged["ALL"]["totals"], self.ms(kind, contender, self.sites)
                distance = total["dist_median"]
                lines.append(
                    f"| {name}, {KINDS[kind][0]} | {total['success']} of {total['n']} | {total['strict']} "
                    f"| {'-' if distance is None else format(distance, '.1f')} | {total['flagged_ok']} "
                    f"| {total['false_conf_rows']} of {total['flagged_rows']}, {total['false_conf_queries']} "
                    f"| {ms:.2f} ({ms / ms_of_opal:.0f}) |")
                by_site[contender][kind] = judged
        return "\n".join(lines + [""] + self.table_by_site(by_site)) + "\n"

    def ms(self, kind, contender, sites):
        all_cpu = [self.cpu(kind, contender, site) for site in sites]
        return sum(ms for _, ms in all_cpu) / sum(updates for updates, _ in all_cpu)

    def table_by_site(self, judged):
        lines = [f"| success, {' / '.join(KINDS[kind][0] for kind in self.kinds)} | {' | '.join(self.sites)} |",
                 "| --- |" + " --- |" * len(self.sites)]
        first = self.kinds[0]
        for contender, name in CONTENDERS.items():
            found, cost = [], []
            for site in self.sites:
                found.append(" / ".join(str(judged[contender][kind][site]["totals"]["success"]) for kind in self.kinds)
                             + f" of {judged[contender][first][site]['totals']['n']}")
                ms = self.ms(first, contender, [site])
                cost.append(f"{ms:.2f} ({ms / self.ms(first, 'opal', [site]):.0f})")
            lines.append(f"| {name} | {' | '.join(found)} |")
            lines.append(f"| its ms per update, {KINDS[first][0]} (ratio) | {' | '.join(cost)} |")
        return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--opal", type=pathlib.Path, required=True, help="Opal's program")
    parser.add_argument("--yardsticks", type=pathlib.Path, required=True, help="folder of the baselines' programs")
    parser.add_argument("--shared", type=pathlib.Path, required=True, help="folder of data/sites and tools/eval.py")
    parser.add_argument("-o", "--out", type=pathlib.Path, required=True, help="folder for results and table.md")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS), help="of maps")
    parser.add_argument("--sites", nargs="+", help="all, if none is named")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="sites at a time")
    comparison = Comparison(parser.parse_args())
    comparison.run_all()
    table = comparison.table()
    (comparison.out / "table.md").write_text(table)
    print(table)


if __name__ == "__main__":
    main()
