"""Drives with the lasers that robots have: `opal simulate` in generated buildings, then `opal bench`."""

import concurrent.futures
import pathlib

import judge
from redrawn import run, summed

BUILDINGS = [(kind, seed) for kind in ("office", "hall", "warehouse", "corridor") for seed in (1, 2, 3)]
DRIVES = ("--drives", "5", "--distance", "40")
LASERS = {  # the row's label in docs/results.md, and the numbers of its maker's data sheet
    "safety scanner: 270 degrees, 30 m": ("--fov", "270", "--beams", "541", "--range", "30", "--range-sigma", "0.01"),
    "small scanner: 240 degrees, 5.6 m": ("--fov", "240", "--beams", "683", "--range", "5.6", "--range-sigma", "0.03",
                                          "--scan-every", "0.1", "--sweep", "0.067"),
    "vacuum cleaner's: 360 degrees, 12 m": ("--fov", "360", "--beams", "360", "--range", "12", "--range-sigma", "0.03",
                                            "--scan-every", "0.18", "--sweep", "0.18"),
    "toy's: 360 degrees, 3.5 m": ("--fov", "360", "--beams", "360", "--range", "3.5", "--range-sigma", "0.02",
                                  "--scan-every", "0.2", "--sweep", "0.2"),
    "depth camera: 58 degrees, 5 m": ("--fov", "58", "--beams", "640", "--range", "5", "--range-sigma", "0.03", "--scan-every", "0.1"),
    "slice of a 3D lidar: 360 degrees, 100 m": ("--fov", "360", "--beams", "1024", "--range", "100", "--range-sigma", "0.02",
                                                "--scan-every", "0.1", "--sweep", "0.1"),
}


def verdicts(bench, laser, kind, seed):
    """Of the drives in one building."""
    folder = pathlib.Path(bench.out) / "lasers" / f"{laser.split(':')[0].replace(' ', '-')}-{kind}-{seed}"
    place, results = folder / "place", folder / "bench" / "results.csv"
    if not (bench.reuse and results.exists()):
        folder.mkdir(parents=True, exist_ok=True)
        run(bench.opal, "map", "generate", kind, "--seed", seed, "-o", folder / "map.jsonld")
        run(bench.opal, "simulate", folder / "map.jsonld", "-o", place, *DRIVES, *LASERS[laser])
        run(bench.opal, "bench", place, "-o", folder / "bench")
    return judge.judge_site(place, results)


def laser_table(bench, cells_of):
    """Sums over all buildings. @param cells_of  of a judge.Total."""
    with concurrent.futures.ThreadPoolExecutor(bench.jobs) as pool:
        return summed({laser: [pool.submit(verdicts, bench, laser, *building) for building in BUILDINGS] for laser in LASERS}, cells_of)
