"""Maps that learn: `opal learn` on mixed damage from the parts of a log outside of the judged windows, then `opal bench`.

Each site's queries are split into four folds by time. For each fold, the drives are the log without the fold's windows. What was
learned from them is laid over the damaged map, and the fold's queries run on it. Faces count if the recorded truth says that the
learning drives had four beams on them (a face that does not exist: through them) from five places 0.25 m apart.
"""

import collections
import concurrent.futures
import gzip
import json
import math
import pathlib
import statistics

import judge
from redrawn import run

FOLDS = 4
PLAN = ("--plan", "1.5")
DAMAGE = "drop=0.3,shift=0.1,wall=0.6,false=0.3"
LINKED = ("map.pgm", "map.yaml", "info.json", "gt.csv", "log.gz")
SHORTEST_S, FEWEST_PLACES, FEWEST_BEAMS = 5, 5, 4
MOVED_M, FOUND_M, UNCHANGED_M, BESIDE_M = 0.1, 0.05, 0.02, 0.15


class Face:
    """A straight face of a map; its visible side is on the left."""

    def __init__(self, begin, end):
        self.begin, self.length = begin, math.dist(begin, end)
        self.along = tuple((b - a) / self.length for a, b in zip(begin, end))
        self.ends = (begin, end)

    def local(self, point):
        """(along the face, across it) [m]."""
        x, y = point[0] - self.begin[0], point[1] - self.begin[1]
        return x * self.along[0] + y * self.along[1], y * self.along[0] - x * self.along[1]

    def offset_m(self, other):
        """How far the middle of another face is from this one."""
        return self.local([sum(pair) / 2 for pair in zip(*other.ends)])[1]

    def covered_m(self, other):
        first, last = sorted(self.local(end)[0] for end in other.ends)
        return max(0.0, min(self.length, last) - max(0.0, first))

    def is_beside(self, other):
        same_way = sum(a * b for a, b in zip(self.along, other.along)) > 0.97
        return same_way and abs(self.offset_m(other)) < BESIDE_M


def faces_of(path):
    """Perceivable faces of a map document, by id."""
    graph = json.loads(pathlib.Path(path).read_text())["@graph"]
    points, faces = {}, {}

    def note_points(node):
        if isinstance(node, dict):
            if "x" in node and "@id" in node:
                points[node["@id"]] = (node["x"], node["y"])
            for value in node.values():
                note_points(value)
        elif isinstance(node, list):
            for value in node:
                note_points(value)

    def as_list(value):
        return value if isinstance(value, list) else [value] if value else []

    note_points(graph)
    for thing in graph:
        for representation in as_list(thing.get("represented_by")):
            for face in as_list(representation.get("represented_by")):
                if face.get("@type") == "LineSegment" and representation.get("perceivable_by"):
                    faces[face["@id"]] = Face(*(points[face[end]["@id"]] for end in ("begin", "end")))
    return faces


def folds_of(prefix):
    queries = json.loads(pathlib.Path(f"{prefix}.queries.json").read_text())["queries"]
    queries.sort(key=lambda query: (query["start_time"], query["end_time"]))
    return [queries[k * len(queries) // FOLDS:(k + 1) * len(queries) // FOLDS] for k in range(FOLDS)]


def outside(queries, first_s, last_s):
    """The parts of a log that no query touches."""
    parts, at_s = [], first_s
    for start_s, end_s in sorted((query["start_time"], query["end_time"]) for query in queries) + [(last_s, last_s)]:
        if start_s - at_s > SHORTEST_S:
            parts.append((at_s, start_s - 0.01))
        at_s = max(at_s, end_s + 0.01)
    return parts


def scans_of(prefix, truth):
    """(stamp, pose of the laser, where some beams ended), 0.25 m or 0.25 rad apart; frame of the map."""
    laser = json.loads(pathlib.Path(f"{prefix}.info.json").read_text())["laser"]
    first_rad, step_rad = math.radians(laser["angle_min_deg"]), math.radians(laser["angle_increment_deg"])
    farthest_m, last = min(25, laser["no_return_at_or_above_m"]), None
    for line in gzip.open(f"{prefix}.log.gz", "rt"):
        words = line.split()
        if not words or words[0] != "FLASER":
            continue
        count = int(words[1])
        stamp_s = float(words[count + 8])
        if not truth.stamps[0] <= stamp_s <= truth.stamps[-1]:
            continue
        x, y, heading = pose = truth.pose(stamp_s)
        if last and math.dist(pose[:2], last[:2]) < 0.25 and abs(judge.wrapped(heading - last[2])) < 0.25:
            continue
        last, ends = pose, []
        for k in range(0, count, max(1, count // 120)):
            range_m, way = float(words[2 + k]), heading + first_rad + k * step_rad
            if 0.1 < range_m < farthest_m:
                ends.append((x + range_m * math.cos(way), y + range_m * math.sin(way)))
        yield stamp_s, pose, ends


def beams_at(face, pose, ends, through):
    """Beams that end on a face; or that pass through it, and go on for 0.3 m."""
    eye_along, eye_across = face.local(pose)
    if not 0.1 < eye_across < 20:
        return 0
    count = 0
    for end in ends:
        along, across = face.local(end)
        if through and across < -0.3:
            met = eye_along + (along - eye_along) * eye_across / (eye_across - across)
            count += 0.1 < met < face.length - 0.1
        elif not through:
            count += abs(across) < 0.1 and 0 <= along <= face.length
    return count


def places_by_face(prefix, real, damaged, truth):
    """Stamps of the places that see each face."""
    faces = {**real, **{name: face for name, face in damaged.items() if name.startswith("false-")}}
    seen = collections.defaultdict(list)
    for stamp_s, pose, ends in scans_of(prefix, truth):
        for name, face in faces.items():
            if beams_at(face, pose, ends, name not in real) >= FEWEST_BEAMS:
                seen[name].append(stamp_s)
    return seen


def compared(real, damaged, learned, is_seen):
    """How many faces there were of each kind, and of how many of them learning was right (of sound ones: wrong)."""
    counts = collections.Counter()
    for name, face in damaged.items():
        if not is_seen(name):
            continue
        if name not in real:
            counts["false"] += 1
            counts["false found"] += name not in learned
            continue
        before_m = real[name].offset_m(face)
        after_m = real[name].offset_m(learned[name]) if name in learned else None
        if abs(before_m) >= MOVED_M:
            counts["moved"] += 1
            counts["moved found"] += after_m is not None and abs(after_m) <= FOUND_M
        elif abs(before_m) < FOUND_M:
            counts["sound"] += 1
            counts["sound changed"] += after_m is None or abs(after_m - before_m) > UNCHANGED_M
    added = [face for name, face in learned.items() if name.startswith("learned-")]
    for name, face in real.items():
        if name in damaged or not is_seen(name):
            continue
        counts["missing"] += 1
        counts["missing found"] += sum(face.covered_m(each) for each in added if face.is_beside(each)) >= face.length / 2
    return counts


def bench_fold(bench, site, queries, maps, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name in LINKED:
        link = folder / f"{site}.{name}"
        if not link.exists():
            link.symlink_to((bench.folder / f"{site}.{name}").resolve())
    document = json.loads((bench.folder / f"{site}.queries.json").read_text())
    (folder / f"{site}.queries.json").write_text(json.dumps({**document, "queries": queries}))
    run(bench.opal, "bench", folder / site, "--maps", maps, "-o", folder / "bench")
    return judge.judge_site(folder / site, folder / "bench" / "results.csv")


def learn_site(bench, site):
    """@return (verdicts on the damaged map, verdicts on the learned ones, counts of faces)."""
    prefix, folder = bench.folder / site, pathlib.Path(bench.out) / "learning" / site
    folder.mkdir(parents=True, exist_ok=True)
    real_map, damaged_map = folder / "real.jsonld", folder / f"{site}.map.jsonld"
    run(bench.opal, "map", "damage", f"{prefix}.map.yaml", *PLAN, "-o", real_map)
    run(bench.opal, "map", "damage", f"{prefix}.map.yaml", *PLAN, "--damage", DAMAGE, "-o", damaged_map)
    real, damaged, truth = faces_of(real_map), faces_of(damaged_map), judge.Truth.read(f"{prefix}.gt.csv")
    places = places_by_face(prefix, real, damaged, truth)
    before, after, counts = [], [], collections.Counter()
    for number, queries in enumerate(folds_of(prefix)):
        fold, parts = folder / str(number), outside(queries, truth.stamps[0], truth.stamps[-1])
        built = fold / "built" / f"{site}.map.jsonld"
        built.parent.mkdir(parents=True, exist_ok=True)
        if parts:
            windows = [{"id": f"part-{k}", "start_time": start, "end_time": end} for k, (start, end) in enumerate(parts)]
            (fold / "drives.json").write_text(json.dumps({"site": site, "queries": windows}))
            run(bench.opal, "learn", damaged_map, f"{prefix}.log.gz", "--info", f"{prefix}.info.json", "--queries",
                fold / "drives.json", "-o", fold / "learned.jsonld", "--evidence", fold / "evidence.json", allowed=(0, 1))
            run(bench.opal, "map", "overlay", damaged_map, fold / "learned.jsonld", "-o", built)
        else:
            built.write_bytes(damaged_map.read_bytes())
        is_driven = lambda stamp_s: any(start <= stamp_s <= end for start, end in parts)  # noqa: E731
        counts += compared(real, damaged, faces_of(built), lambda name: sum(map(is_driven, places[name])) >= FEWEST_PLACES)
        before += bench_fold(bench, site, queries, folder, fold / "before")
        after += bench_fold(bench, site, queries, built.parent, fold / "after")
    return before, after, counts


def row_of(verdicts):
    total = judge.totals(verdicts)
    errors = [verdict.error_m for verdict in verdicts if verdict.error_m is not None]
    return {"queries": str(total.queries), "success": str(total.success), "strict": str(total.strict),
            "localized": str(total.localized), "false positives": str(total.false_rows),
            "median distance m": f"{total.median_distance_m:.1f}", "median error m": f"{statistics.median(errors):.3f}",
            "mean error m": f"{total.error_m:.3f}"}


def learning_tables(bench):
    """@return the table of queries, and that of faces."""
    if not bench.complete:
        return {}, {}
    with concurrent.futures.ThreadPoolExecutor(bench.jobs) as pool:
        done = list(pool.map(lambda site: learn_site(bench, site), bench.sites))
    counts = sum((counts for _, _, counts in done), collections.Counter())
    rows = {"damaged": row_of([v for before, _, _ in done for v in before]),
            "learned": row_of([v for _, after, _ in done for v in after])}
    kinds = (("moved", "moved found"), ("missing", "missing found"), ("false", "false found"), ("sound", "sound changed"))
    return rows, {kind: {"seen": str(counts[kind]), "%": f"{100 * counts[right] / max(1, counts[kind]):.0f}"} for kind, right in kinds}
