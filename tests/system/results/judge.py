"""Judges what `opal bench` wrote against recorded truth. Python's standard library only.

Every query starts without a known pose. A row is one estimate: the laser's pose at one scan.

success         From some row on, every row has a position error below 1 m and a heading error below 10 degrees, up to the last row.
                The last row lies at most 3 m of driving or 5 s before the window ends. The right part covers at least 2 m of driving.
strict          The same with 0.5 m and 5 degrees.
distance        Metres driven from the start of the window until then.
localized       The same as success, but only rows count whose status is `localized`.
false positive  A row whose status is `localized` that is not within 1 m and 10 degrees.
"""

import bisect
import csv
import dataclasses
import json
import math
import pathlib
import statistics

LOOSE = (1.0, math.radians(10))
STRICT = (0.5, math.radians(5))
END_GAP_M = 3.0
END_GAP_S = 5.0
LEAST_KEPT_M = 2.0
WINDOW_SLACK_S = 0.05


def wrapped(angle_rad):
    return (angle_rad + math.pi) % (2 * math.pi) - math.pi


class Truth:
    """Recorded poses of the laser, and the distance driven along those that belong to scans."""

    def __init__(self, rows):
        self.stamps, self.poses = [], []
        self.scan_stamps, self.driven = [], []
        driven_m, last = 0.0, None
        for stamp_s, pose, is_scan in rows:
            if self.stamps and stamp_s <= self.stamps[-1]:
                if not is_scan:
                    continue
                self.poses[-1] = pose  # the scan's own pose wins
            else:
                self.stamps.append(stamp_s)
                self.poses.append(pose)
            if is_scan:
                driven_m += math.dist(last[:2], pose[:2]) if last else 0.0
                last = pose
                self.scan_stamps.append(stamp_s)
                self.driven.append(driven_m)

    @classmethod
    def read(cls, path):
        with open(path, newline="") as file:
            return cls([(float(row["timestamp"]), (float(row["x"]), float(row["y"]), float(row["theta"])),
                         row.get("is_scan", "1") == "1") for row in csv.DictReader(file)])

    @staticmethod
    def _between(stamps, stamp_s):
        """Two neighbours and how far the stamp is from the first to the second."""
        after = bisect.bisect_left(stamps, stamp_s)
        if after <= 0:
            return 0, 0, 0.0
        if after >= len(stamps):
            return len(stamps) - 1, len(stamps) - 1, 0.0
        span_s = max(1e-12, stamps[after] - stamps[after - 1])
        return after - 1, after, (stamp_s - stamps[after - 1]) / span_s

    def pose(self, stamp_s):
        first, second, share = self._between(self.stamps, stamp_s)
        a, b = self.poses[first], self.poses[second]
        return (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), wrapped(a[2] + share * wrapped(b[2] - a[2])))

    def driven_m(self, stamp_s):
        first, second, share = self._between(self.scan_stamps, stamp_s)
        return self.driven[first] + share * (self.driven[second] - self.driven[first])


@dataclasses.dataclass
class Row:
    stamp_s: float
    pose: tuple
    localized: bool


def read_rows(path):
    """Rows of results.csv by query, in the order of time."""
    queries = {}
    with open(path, newline="") as file:
        for line in csv.DictReader(file):
            pose = (float(line["x"]), float(line["y"]), float(line["theta"]))
            queries.setdefault(line["query_id"], []).append(
                Row(float(line["timestamp"]), pose, line["localized_flag"] == "1"))
    for rows in queries.values():
        rows.sort(key=lambda row: row.stamp_s)
    return queries


@dataclasses.dataclass
class Verdict:
    """What became of one query. Distances are None where the query did not succeed."""

    query: str
    independent: bool  # no scan of the query is in the map
    success: bool = False
    strict: bool = False
    distance_m: float = None
    error_m: float = None
    localized: bool = False
    localized_rows: int = 0
    false_rows: int = 0


def kept_from(stamps, right, truth, end_s):
    """Index of the first row of the right part that lasts to the end of the window, or None."""
    if not stamps or not right[-1]:
        return None
    if truth.driven_m(end_s) - truth.driven_m(stamps[-1]) > END_GAP_M and end_s - stamps[-1] > END_GAP_S:
        return None
    first = len(stamps) - 1
    while first > 0 and right[first - 1]:
        first -= 1
    if truth.driven_m(end_s) - truth.driven_m(stamps[first]) < LEAST_KEPT_M:
        return None
    return first


def judge_query(query, rows, truth):
    start_s, end_s = query["start_time"], query["end_time"]
    rows = [row for row in rows if start_s - WINDOW_SLACK_S <= row.stamp_s <= end_s + WINDOW_SLACK_S]
    stamps = [row.stamp_s for row in rows]
    errors = []
    for row in rows:
        at = truth.pose(row.stamp_s)
        errors.append((math.dist(at[:2], row.pose[:2]), abs(wrapped(row.pose[2] - at[2]))))
    loose = [error[0] < LOOSE[0] and error[1] < LOOSE[1] for error in errors]
    strict = [error[0] < STRICT[0] and error[1] < STRICT[1] for error in errors]
    flagged = [index for index, row in enumerate(rows) if row.localized]

    verdict = Verdict(query["id"], query.get("map_overlap") == 0)
    first = kept_from(stamps, loose, truth, end_s)
    if first is not None:
        verdict.success = True
        verdict.distance_m = max(0.0, truth.driven_m(stamps[first]) - truth.driven_m(start_s))
        verdict.error_m = statistics.fmean(error[0] for error in errors[first:])
    verdict.strict = kept_from(stamps, strict, truth, end_s) is not None
    verdict.localized = kept_from([stamps[i] for i in flagged], [loose[i] for i in flagged], truth, end_s) is not None
    verdict.localized_rows = len(flagged)
    verdict.false_rows = sum(not loose[i] for i in flagged)
    return verdict


def judge_site(prefix, results):
    """@param prefix  PREFIX.gt.csv and PREFIX.queries.json are read. @param results  path of results.csv."""
    truth = Truth.read(f"{prefix}.gt.csv")
    queries = json.loads(pathlib.Path(f"{prefix}.queries.json").read_text())["queries"]
    rows = read_rows(results)
    unknown = sorted(set(rows) - {query["id"] for query in queries})
    if unknown:
        raise ValueError(f"{results}: no query '{unknown[0]}' in {prefix}.queries.json")
    return [judge_query(query, rows.get(query["id"], []), truth) for query in queries]


@dataclasses.dataclass
class Totals:
    queries: int
    success: int
    strict: int
    median_distance_m: float  # None: no success
    error_m: float            # None: no success
    localized: int
    localized_rows: int
    false_rows: int
    false_queries: int


def totals(verdicts):
    found = [verdict for verdict in verdicts if verdict.success]
    return Totals(
        queries=len(verdicts), success=len(found), strict=sum(verdict.strict for verdict in verdicts),
        median_distance_m=statistics.median(verdict.distance_m for verdict in found) if found else None,
        error_m=statistics.fmean(verdict.error_m for verdict in found) if found else None,
        localized=sum(verdict.localized for verdict in verdicts),
        localized_rows=sum(verdict.localized_rows for verdict in verdicts),
        false_rows=sum(verdict.false_rows for verdict in verdicts),
        false_queries=sum(verdict.false_rows > 0 for verdict in verdicts))


@dataclasses.dataclass
class Kidnappings:
    """Sums over kidnapping sequences, which Opal itself judges row by row."""

    sequences: int
    localized_before: int
    recovered: int
    median_m: float  # None: none recovered
    without_false_positive: int
    said_lost: int
    localized_again: int


def read_kidnappings(paths):
    rows = []
    for path in paths:
        with open(path, newline="") as file:
            rows += list(csv.DictReader(file))
    recovered = [float(row["right_after_m"]) for row in rows if row["recovered"] == "1"]
    return Kidnappings(
        sequences=len(rows), localized_before=sum(row["localized_before"] == "1" for row in rows),
        recovered=len(recovered), median_m=statistics.median_high(recovered) if recovered else None,
        without_false_positive=sum(int(row["false_rows"]) == 0 for row in rows),
        said_lost=sum(float(row["lost_after_m"]) >= 0 for row in rows),
        localized_again=sum(float(row["localized_after_m"]) >= 0 for row in rows))
