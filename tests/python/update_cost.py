"""What an update costs through Python beside the same loop in C++: CPU time per keyframe. Run by hand; asserts nothing.

PYTHONPATH=build/release/python /usr/bin/python3 tests/python/update_cost.py [REPEATS]
"""

import statistics
import sys
import time

import opal
from recorded import ROOT


PLACE = str(ROOT / "maps" / "malaga" / "malaga")


def in_cpp(localizer, log, lasers):
    run = localizer.run(log.samples(lasers))
    return len(run.cpu_ms)


def in_python(localizer, log, lasers):
    """Every scan: sample, update, estimate, its pose and covariance as arrays."""
    localizer.reset()
    keyframes = 0
    for sample in log.samples(lasers):
        keyframes += localizer.update(sample) is not None
        estimate = localizer.estimate_at(sample.stamp_s, sample.odometry)
        estimate.pose, estimate.covariance, estimate.status, estimate.probability
    return keyframes


def of_arrays(localizer, log, lasers):
    """The same, with scans of arrays."""
    localizer.reset()
    keyframes = 0
    for scan in log.raw_scans():
        estimate = localizer.update(scan.ranges_m, scan.odometry, scan.stamp_s)
        if estimate is not None:
            keyframes += 1
            estimate.pose, estimate.covariance, estimate.status, estimate.probability
    return keyframes


def main():
    repeats = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    lasers = [opal.read_laser(f"{PLACE}.info.json")]
    log = opal.read_log(f"{PLACE}.log.gz")
    localizer = opal.Localizer(opal.read_deployment("default").with_lasers(lasers), opal.read_map(f"{PLACE}.map.yaml"))
    ways = {"in C++": in_cpp, "in Python": in_python, "in Python, of arrays": of_arrays}
    costs = {name: [] for name in ways}
    for _ in range(repeats):  # in turns, so that a busy machine disturbs all of them
        for name, way in ways.items():
            start = time.thread_time()
            keyframes = way(localizer, log, lasers)
            costs[name].append(1e3 * (time.thread_time() - start) / keyframes)
    least = min(costs["in C++"])
    for name, values in costs.items():
        print(f"{name}: {min(values):.4f} ms at least, {statistics.median(values):.4f} ms median, "
              f"{100 * (min(values) / least - 1):+.1f} %")


if __name__ == "__main__":
    main()
