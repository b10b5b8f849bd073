#!/usr/bin/env python3
"""Which small changes of the localization library its tests notice.

Draws mutants of the sources of some rooms, builds the library with all of them in a copy of the tree, and runs the tests with one
after the other. A mutant is noticed if a test fails, crashes or does not end. What nobody can notice is in explained.txt.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "tests/system/structure"))

import compile_commands  # noqa: E402
from source_tree import files_below  # noqa: E402

import mutants as finder  # noqa: E402

ROOMS = ("sensing", "patterns", "local_map", "sensor_health", "localization", "live")
# What is quick comes first: most mutants do not get further.
PROGRAMS = ("localization", "patterns", "sensing", "scorers", "scan_matching", "local_map", "detectors", "deployment", "replay",
            "sensor_health", "live_core")
FOLDERS = ("framework", "plugins", "patterns", "maps", "configs", "tests", "docs")
EXPLAINED = HERE / "explained.txt"


def all_mutants(build, rooms, jobs):
    options = compile_commands.options_of_sources(build)
    paths = [path for room in rooms for path in files_below(ROOT, f"framework/{room}") if path.suffix == ".cpp" and path in options]
    with concurrent.futures.ProcessPoolExecutor(jobs) as pool:
        return sum(pool.map(finder.mutants_of, paths, (options[path] for path in paths)), [])


def explained(path=EXPLAINED):
    """Mutants that change nothing: {(file, what it was, what it becomes): why}."""
    table = {}
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            file, was, becomes, why = (part.strip() for part in line.split("|"))
            table[file, was, becomes] = why
    return table


def key_of(mutant):
    """As explained.txt writes it: on one line, without the bars of `||`."""
    one_line = lambda text: " ".join(text.split()).replace("|", "/")
    return str(mutant.file.relative_to(ROOT)), one_line(mutant.was), one_line(mutant.becomes) or "left out"


def copy_tree(tree):
    """The sources, as they are, and no others. What has not changed since the last copy keeps its time, so that it is not built again."""
    for folder in FOLDERS:
        subprocess.run(["cp", "-a", "--update", str(ROOT / folder), str(tree)], check=True)
        for copied in sorted((tree / folder).rglob("*"), reverse=True):
            if not (ROOT / copied.relative_to(tree)).exists():
                copied.rmdir() if copied.is_dir() else copied.unlink()
    for name in ("CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "LICENSE"):
        shutil.copy2(ROOT / name, tree / name)


def write_mutants(tree, chosen):
    """What an earlier draw changed, and this one does not, becomes as it is again."""
    by_file = collections.defaultdict(dict)
    for number, mutant in enumerate(chosen, 1):
        by_file[mutant.file][number] = mutant
    for target in (tree / "framework").rglob("*.cpp"):
        source = ROOT / target.relative_to(tree)
        if source not in by_file and target.read_bytes().startswith(finder.HEAD.encode()):
            shutil.copy(source, target)
    for file, mutants in by_file.items():
        target, text = tree / file.relative_to(ROOT), finder.mutated(file.read_bytes(), mutants)
        if target.read_bytes() != text:  # else it need not be built again
            target.write_bytes(text)


def build(tree, jobs):
    environment = {**os.environ, "CCACHE_BASEDIR": str(tree), "CCACHE_NOHASHDIR": "1", "CCACHE_SLOPPINESS": "pch_defines,time_macros"}
    targets = [f"{name}_tests" for name in PROGRAMS]
    for command in (["cmake", "--preset", "release"], ["cmake", "--build", "--preset", "release", "--parallel", str(jobs), "--target", *targets]):
        done = subprocess.run(command, cwd=tree, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(done.stdout[-8000:])
    return tree / "build/release/bin"


def passes(program, number, limit_s):
    try:
        done = subprocess.run([str(program), "--abort"], cwd=program.parent, env={**os.environ, "OPAL_MUTANT": str(number)},
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=limit_s, check=False)
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def limits(programs):
    """Without a mutant all must pass. @return for each how long it may take [s]."""
    allowed = {}
    for program in programs:
        start = time.monotonic()
        if not passes(program, 0, 600):
            raise SystemExit(f"{program.name} fails without any mutant")
        allowed[program] = 20 + 10 * (time.monotonic() - start)
    return allowed


def own_first(allowed, room):
    """The tests of a room notice most of its mutants."""
    return sorted(allowed.items(), key=lambda item: not item[0].name.startswith(room))


def noticed_by(number, mutant, allowed):
    """The first program whose tests fail; None: no test does."""
    tried = own_first(allowed, room_of(mutant))
    by = next((program.name.removesuffix("_tests") for program, limit_s in tried if not passes(program, number, limit_s)), None)
    print(f"mutant {number}: " + (f"noticed by {by}" if by else "not noticed"), flush=True)
    return by


def room_of(mutant):
    return mutant.file.relative_to(ROOT / "framework").parts[0]


def summary(chosen, noticed, why):
    """Counts by room and of all, and what nobody noticed."""
    rooms, total, missed = {}, collections.Counter(), []
    for mutant, by in zip(chosen, noticed):
        row = rooms.setdefault(room_of(mutant), {"mutants": 0, "noticed": 0, "explained": 0})
        row["mutants"] += 1
        row["noticed"] += by is not None
        row["explained"] += by is None and key_of(mutant) in why
        if by is None and key_of(mutant) not in why:
            file, was, becomes = key_of(mutant)
            missed.append({"file": file, "line": mutant.line, "was": was, "becomes": becomes})
    for row in rooms.values():
        total.update(row)
    return {"rooms": {**rooms, "all": total}, "missed": missed}


def tell(result):
    print(f"{'room':16}{'mutants':>9}{'noticed':>9}{'explained':>11}{'noticed %':>11}")
    for room, row in result["rooms"].items():
        share = 100 * row["noticed"] / max(1, row["mutants"] - row["explained"])
        print(f"{room:16}{row['mutants']:9}{row['noticed']:9}{row['explained']:11}{share:11.1f}")
    for mutant in result["missed"]:
        print(f"not noticed: {mutant['file']}:{mutant['line']}: {mutant['was']}  ->  {mutant['becomes']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="folder of a configured build, for its options")
    parser.add_argument("-o", "--out", type=pathlib.Path, default=pathlib.Path("out/mutants"), help="folder for summary.json")
    parser.add_argument("--tree", type=pathlib.Path, default=pathlib.Path("build/mutants"), help="folder for the copy with all mutants")
    parser.add_argument("--mutants", type=int, default=120, help="how many are drawn")
    parser.add_argument("--seed", type=int, default=1, help="of the draw")
    parser.add_argument("--rooms", nargs="+", default=ROOMS, help="folders of framework/")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    found = all_mutants(options.build, options.rooms, options.jobs)
    random.Random(options.seed).shuffle(found)
    chosen = finder.without_overlap(found, options.mutants)
    print(f"{len(chosen)} of {len(found)} mutants are drawn", flush=True)
    tree = options.tree.resolve()
    tree.mkdir(parents=True, exist_ok=True)
    copy_tree(tree)
    write_mutants(tree, chosen)
    folder = build(tree, options.jobs)
    allowed = limits([folder / f"{name}_tests" for name in PROGRAMS])
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        noticed = list(pool.map(lambda item: noticed_by(*item, allowed), enumerate(chosen, 1)))
    result = summary(chosen, noticed, explained())
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "summary.json").write_text(json.dumps(result, indent=1) + "\n")
    tell(result)
    return 0


if __name__ == "__main__":
    sys.exit(main())
