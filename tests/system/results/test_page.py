"""docs/results.md has a place for everything that make_results.py makes."""

import collections
import pathlib
import types
import unittest
import unittest.mock

import campus
import drives
import faults
import fuzzing
import integrity
import judge
import make_results
import mutants
import storeys
import tables

FUZZED = """#2      INITED cov: 900 ft: 905 corp: 3/12b exec/s: 0 rss: 60Mb
#4096   NEW    cov: 1012 ft: 1190 corp: 41/2Kb lim: 11 exec/s: 0 rss: 66Mb L: 3/11 MS: 1 EraseBytes-
#81920  DONE   cov: 1203 ft: 4411 corp: 318/23Kb lim: 589 exec/s: 4096 rss: 412Mb
Done 81920 runs in 20 second(s)
stat::number_of_executed_units: 81920
stat::average_exec_per_sec:     4096
"""


class Page(unittest.TestCase):
    """docs/results.md has a row and a column for everything that the command makes."""

    def test_every_table_is_marked_and_takes_its_cells(self):
        page = (pathlib.Path(__file__).resolve().parents[3] / "docs/results.md").read_text()
        sums = judge.Kidnappings(1, 1, 1, 0.0, 1, 1, 1)
        summary = {**dict.fromkeys(("cpu_ms_median", "cpu_ms_mean", "cpu_ms_p99", "hypotheses_mean", "peak_rss_mb",
                                    "localizer_mb", "import_s", "updates"), 1.0),
                   "stage_ms_mean": dict.fromkeys(make_results.STAGES, 1.0)}
        verdict = judge.Verdict("q", True, True, True, 0.0, 0.0, True, 1, 0)
        bench = types.SimpleNamespace(
            sites=make_results.SITES, complete=True, verdicts=lambda *_: [verdict], all_verdicts=lambda *_: [verdict],
            jobs=1, summary=lambda *_: summary, joined_verdicts=lambda *_: [verdict], joined_summary=lambda *_: summary,
            kidnappings=lambda *_: dict.fromkeys(make_results.SITES, sums), all_kidnappings=lambda *_: sums)
        (selection := make_results.Selection([])).kinds.pop("calibration")  # runs a program
        cells = drives.drive_cells([{"reached": True, "driven_m": 2.0, "localized_after_m": 1.0, "collisions": [], "why": None}])
        fault_rows = [{"localized_before": "1", "recovered_after_s": "2.5", "longest_wrong_s": "0", "named": "1"}]
        stratum = {"aspect": "map", "value": "redrawn", "drives": 3, "false_drives": 1, "false_share_95": [0, 0.7], "localized_drives": 2,
                   "localized_after_m": {"median": 4.5, "95 %": None}}
        storey = {"right": "1", "wrong": "0", "right_from_m": "3.0", "localized_from_m": "", "difference": "0.2"}
        driven = types.SimpleNamespace(makers=lambda: {
            "drives": lambda: {f"{kind}, seed {seed}": cells for kind in drives.KINDS for seed in drives.SEEDS},
            "drives-models": lambda: {"Duplex, Level 1": cells}, "faults": lambda: {"doubled": faults.cells_of(fault_rows)},
            **dict.fromkeys(integrity.CAMPAIGNS, lambda: {integrity.label_of(stratum): integrity.cells_of(stratum)}),
            "storeys": lambda: storeys.by_likeness(next(iter(storeys.BUILDINGS)), [storey]),
            "fuzzing": lambda: {"all": fuzzing.cells_of([[FUZZED]])},
            "mutants": lambda: {"all": mutants.cells_of({"mutants": 10, "noticed": 8, "explained": 1})}})
        for what, made in {"campus.row_of": (dict.fromkeys(campus.GROWING, 1.0), judge.totals([verdict])), "furnished.drives": ([verdict], 60),
                           "lasers.verdicts": [verdict], "other_maps.runs_by_label": {"recorded, strict": ([0.0, 2.0], [False, True])}, "learning.learn_site": ([verdict], [verdict], collections.Counter(moved=1)), "redrawn.verdicts": [verdict], "sketched.verdicts": [verdict]}.items():
            self.enterContext(unittest.mock.patch(what, return_value=made))
        for seeds in ([1], [1, 2, 3, 4], list(make_results.MAP_SEEDS)):
            tables.rewritten(page, make_results.make_tables(bench, driven, selection, seeds, page))
        self.assertTrue(tables.table_in(page, "calibration"))

    def test_the_last_line_of_a_fuzzer_tells_how_far_it_got(self):
        self.assertEqual(fuzzing.cells_of([[FUZZED]]), {"runs": "81920", "branches reached": "1203", "inputs kept": "318"})
        self.assertEqual(fuzzing.cells_of([[FUZZED], [FUZZED, FUZZED]]), {"runs": "245760", "branches reached": "2406", "inputs kept": "636"})


if __name__ == "__main__":
    unittest.main()
