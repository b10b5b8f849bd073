"""Drives of a simulated robot to drawn goals: in synthetic buildings, and on every storey of the building models."""

import collections
import concurrent.futures
import json
import re
import statistics
import subprocess
import sys

import faults
import fuzzing
import integrity
import mutants
import storeys

KINDS = ("office", "hall", "warehouse", "corridor")
SEEDS = (1, 2, 3)  # of the buildings
DRIVES = 20
STOREY = re.compile(r"^'(?P<name>.*)' +level", re.MULTILINE)


def short(why):
    """A reason without what differs from drive to drive, and without folders of this machine."""
    return re.sub(r"(^|\s)(\.\.)?/\S*/", r"\1", re.sub(r"told \d+ places", "told several places", why)).replace("|", "/")


def drive_cells(runs):
    reached = [run for run in runs if run["reached"]]
    reasons = collections.Counter(short(run["why"]) for run in runs if not run["reached"])
    return {"drives": str(len(runs)), "reached": str(len(reached)),
            "localized": str(sum(run["localized_after_m"] is not None for run in runs)),
            "median m of the reached": f"{statistics.median(run['driven_m'] for run in reached):.1f}" if reached else "",
            "most m": f"{max(run['driven_m'] for run in runs):.0f}",
            "drives that touched something": str(sum(bool(run["collisions"]) for run in runs)),
            "why not reached": "; ".join(f"{count} x {why}" for why, count in reasons.most_common())}


def refused_cells(said):
    """Nothing was driven: the last line says why."""
    last = said.strip().splitlines()[-1] if said.strip() else "nothing was said"
    return {"drives": "0", "reached": "0", "localized": "", "median m of the reached": "", "most m": "",
            "drives that touched something": "", "why not reached": short(last.removeprefix("opal: "))}


class Drives:
    """Runs of `opal drive`, each made once."""

    def __init__(self, options):
        self.opal = options.opal.resolve()
        self.out = options.out / "drives"
        self.models = options.models_folder
        self.reuse = options.reuse
        self.jobs = options.jobs

        self.options = options

    def makers(self):
        """Of tables, by name."""
        return {"drives": self.buildings_table, "drives-models": self.models_table,
                "faults": lambda: faults.faults_table(self.options), "integrity": lambda: integrity.integrity_table(self.options),
                "integrity-careful": lambda: integrity.integrity_table(self.options, "integrity-careful"),
                "integrity-strict": lambda: integrity.integrity_table(self.options, "integrity-strict"),
                "mutants": lambda: mutants.mutants_table(self.options), "fuzzing": lambda: fuzzing.fuzzing_table(self.options),
                "storeys": lambda: storeys.storeys_table(self.options)}

    def _opal(self, *words):
        return subprocess.run([str(self.opal), *map(str, words)], capture_output=True, text=True, check=False)

    def _cells(self, label, make_map):
        folder = self.out / re.sub(r"[^\w.-]+", "-", label)
        kept = folder / "summary.json"
        if not (self.reuse and kept.exists()):
            kept.unlink(missing_ok=True)
            folder.mkdir(parents=True, exist_ok=True)
            made = make_map(folder / "map.jsonld")
            if made.returncode != 0:
                return refused_cells(made.stderr)
            drive = self._opal("drive", "configs/default.jsonld", folder / "map.jsonld", "--runs", DRIVES, "-o", folder)
            if not kept.exists():
                return refused_cells(drive.stderr)
        print(f"drives in {label}: done", file=sys.stderr, flush=True)
        return drive_cells(json.loads(kept.read_text())["runs"])

    def _table(self, makers):
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            turns = {label: pool.submit(self._cells, label, make_map) for label, make_map in makers.items()}
            return {label: turn.result() for label, turn in turns.items()}

    def buildings_table(self):
        def generator(kind, seed):
            return lambda path: self._opal("map", "generate", kind, "--seed", seed, "-o", path)
        return self._table({f"{kind}, seed {seed}": generator(kind, seed) for kind in KINDS for seed in SEEDS})

    def models_table(self):
        def importer(model, storey):
            return lambda path: self._opal("map", "import", model, "--storey", storey, "-o", path)
        makers = {}
        for model in sorted(self.models.glob("*.ifc")):
            for storey in STOREY.findall(self._opal("map", "storeys", model).stdout):
                makers[f"{model.stem}, {storey}"] = importer(model, storey)
        if not makers:
            print(f"no building models in {self.models}: drives-models skipped", file=sys.stderr)
        return self._table(makers)
