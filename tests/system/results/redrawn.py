"""The recorded sites on maps as another team draws them: `opal map redraw`, then `opal bench --maps`."""

import concurrent.futures
import pathlib
import subprocess

import judge

SEEDS = (1, 2, 3)
TEAMS = {  # the row's label in docs/results.md, and how they draw
    "15 degrees, noise 0.1 m, drift 0.1 m": [],
    "20 degrees, noise 0.15 m, drift 0.15 m, blur 0.2 m": ["--cone", "0.349", "--noise", "0.15", "--drift", "0.15", "--blur", "0.2"],
    "15 degrees, noise 0.3 m, drift 0.1 m, blur 0.15 m": ["--noise", "0.3", "--blur", "0.15"],
}


def run(*words, allowed=(0,)):
    """@param allowed  exit codes. @return what the program printed."""
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode not in allowed:
        raise SystemExit(f"{' '.join(map(str, words))}\nfailed and said\n{done.stderr.strip()}")
    return done.stdout


def verdicts(bench, label, seed, site):
    folder = pathlib.Path(bench.out) / "redrawn" / f"{list(TEAMS).index(label)}-{seed}"
    results = folder / site / "results.csv"
    if not (bench.reuse and results.exists()):
        run(bench.opal, "map", "redraw", bench.folder / site, "-o", folder / "maps", "--seed", seed, *TEAMS[label])
        run(bench.opal, "bench", bench.folder / site, "--maps", folder / "maps", "-o", folder / site)
    return judge.judge_site(bench.folder / site, results)


def summed(turns, cells_of):
    """Cells by label. @param turns  by label: futures of verdicts. @param cells_of  of a judge.Total."""
    totals = {label: judge.totals([verdict for turn in of for verdict in turn.result()]) for label, of in turns.items()}
    return {label: {"queries": str(total.queries), **cells_of(total)} for label, total in totals.items()}


def redrawn_table(bench, cells_of):
    """Sums over the maps of all seeds. @param cells_of  of a judge.Total."""
    if not bench.complete:
        return {}
    with concurrent.futures.ThreadPoolExecutor(bench.jobs) as pool:
        turns = {label: [pool.submit(verdicts, bench, label, seed, site) for seed in SEEDS for site in bench.sites]
                 for label in TEAMS}
        made = summed(turns, cells_of)
    for cells in made.values():
        cells.pop("median distance m")
    return made
