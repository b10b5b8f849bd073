"""Tests of judge.py, tables.py and what make_results.py chooses, with small files of its own. Python's standard library only."""

import argparse
import json
import math
import pathlib
import tempfile
import unittest

import drives
import faults
import judge
import make_results
import other_maps
import tables

HEADER = "query_id,timestamp,x,y,theta,localized_flag,probability,none,status\n"


def straight_truth(metres=20):
    """A metre per second along x, a scan at every metre."""
    return judge.Truth([(float(k), (float(k), 0.0, 0.0), True) for k in range(metres + 1)])


def row(stamp_s, off_m=0.0, off_rad=0.0, localized=False):
    return judge.Row(float(stamp_s), (stamp_s + off_m, 0.0, off_rad), localized)


QUERY = {"id": "q1", "start_time": 0.0, "end_time": 20.0, "map_overlap": 0.0}


class JudgeQuery(unittest.TestCase):
    def judged(self, rows):
        return judge.judge_query(QUERY, rows, straight_truth())

    def test_right_from_the_first_scan_is_success_after_no_driving(self):
        verdict = self.judged([row(k, 0.2) for k in range(21)])
        self.assertTrue(verdict.success and verdict.strict and verdict.independent)
        self.assertEqual(verdict.distance_m, 0)
        self.assertAlmostEqual(verdict.error_m, 0.2)

    def test_distance_is_driven_until_the_last_wrong_scan_is_behind(self):
        verdict = self.judged([row(k, 5 if k < 7 else 0) for k in range(21)])
        self.assertEqual(verdict.distance_m, 7)

    def test_a_pose_that_is_wrong_at_the_end_is_no_success(self):
        self.assertFalse(self.judged([row(k, 5 if k == 20 else 0) for k in range(21)]).success)

    def test_a_lucky_last_scan_is_no_success(self):
        self.assertFalse(self.judged([row(k, 0 if k > 18 else 5) for k in range(21)]).success)
        self.assertTrue(self.judged([row(k, 0 if k > 17 else 5) for k in range(21)]).success)

    def test_the_last_row_may_lie_some_way_before_the_end_of_the_window(self):
        self.assertTrue(self.judged([row(k) for k in range(16)]).success, "5 m and 5 s before the end")
        self.assertFalse(self.judged([row(k) for k in range(15)]).success, "6 m and 6 s before the end")

    def test_headings_count_too(self):
        verdict = self.judged([row(k, 0, math.radians(7)) for k in range(21)])
        self.assertTrue(verdict.success)
        self.assertFalse(verdict.strict)
        self.assertFalse(self.judged([row(k, 0, math.radians(11)) for k in range(21)]).success)

    def test_headings_are_compared_across_half_a_turn(self):
        truth = judge.Truth([(float(k), (float(k), 0.0, math.pi - 0.01), True) for k in range(21)])
        rows = [judge.Row(float(k), (float(k), 0.0, -math.pi + 0.01), False) for k in range(21)]
        self.assertTrue(judge.judge_query(QUERY, rows, truth).strict)

    def test_false_positives_are_wrong_rows_that_are_localized(self):
        verdict = self.judged([row(k, 2 if k < 4 else 0, localized=k in (2, 3) or k > 9) for k in range(21)])
        self.assertEqual((verdict.localized_rows, verdict.false_rows), (13, 2))
        self.assertTrue(verdict.localized)

    def test_a_query_that_is_never_localized_is_not_localized(self):
        self.assertFalse(self.judged([row(k) for k in range(21)]).localized)

    def test_rows_outside_the_window_do_not_count(self):
        self.assertTrue(self.judged([row(k) for k in range(21)] + [row(20.5, 9, localized=True)]).success)

    def test_no_rows_are_no_success(self):
        verdict = self.judged([])
        self.assertFalse(verdict.success or verdict.strict or verdict.localized)


class Truth(unittest.TestCase):
    def test_poses_between_scans_are_interpolated(self):
        truth = judge.Truth([(0.0, (0.0, 0.0, 3.0), True), (2.0, (2.0, 4.0, -3.0), True)])
        x, y, heading_rad = truth.pose(1.0)
        self.assertAlmostEqual(x, 1)
        self.assertAlmostEqual(y, 2)
        self.assertAlmostEqual(abs(heading_rad), math.pi, places=6)
        self.assertAlmostEqual(truth.driven_m(1.0), math.hypot(2, 4) / 2)

    def test_driving_is_summed_along_scans_only(self):
        truth = judge.Truth([(0.0, (0.0, 0.0, 0.0), True), (1.0, (0.0, 9.0, 0.0), False), (2.0, (2.0, 0.0, 0.0), True)])
        self.assertEqual(truth.driven_m(2.0), 2)

    def test_the_pose_of_a_scan_replaces_another_one_of_the_same_time(self):
        truth = judge.Truth([(0.0, (0.0, 0.0, 0.0), False), (0.0, (1.0, 0.0, 0.0), True), (1.0, (2.0, 0.0, 0.0), True)])
        self.assertEqual(truth.pose(0.0)[0], 1)


class JudgeFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        lines = ["timestamp,x,y,theta,is_scan"] + [f"{k},{k},0,0,1" for k in range(21)]
        (self.folder / "site.gt.csv").write_text("\n".join(lines) + "\n")
        queries = [QUERY, {**QUERY, "id": "q2", "map_overlap": 0.5}]
        (self.folder / "site.queries.json").write_text(json.dumps({"site": "site", "queries": queries}))
        self.results = self.folder / "results.csv"

    def test_totals_of_a_site(self):
        rows = [f"q1,{k},{k},0.3,0,{int(k > 4)},0.9,0,localized\n" for k in range(21)]
        rows += [f"q2,{k},{k},4,0,1,0.9,0,localized\n" for k in range(21)]
        self.results.write_text(HEADER + "".join(rows))
        verdicts = judge.judge_site(self.folder / "site", self.results)
        self.assertEqual([verdict.independent for verdict in verdicts], [True, False])
        total = judge.totals(verdicts)
        self.assertEqual((total.queries, total.success, total.strict, total.localized), (2, 1, 1, 1))
        self.assertEqual((total.localized_rows, total.false_rows, total.false_queries), (37, 21, 1))
        self.assertAlmostEqual(total.error_m, 0.3)

    def test_a_site_without_success_has_no_distance(self):
        self.results.write_text(HEADER)
        total = judge.totals(judge.judge_site(self.folder / "site", self.results))
        self.assertEqual((total.success, total.median_distance_m, total.error_m), (0, None, None))

    def test_a_result_of_another_site_is_refused(self):
        self.results.write_text(HEADER + "q9,0,0,0,0,0,0.5,0,searching\n")
        with self.assertRaisesRegex(ValueError, "no query 'q9'"):
            judge.judge_site(self.folder / "site", self.results)

    def test_kidnappings_are_summed(self):
        self.results.write_text(
            "sequence,apart_m,driven_m,localized_before,recovered,right_after_m,noticed_after_m,lost_after_m,"
            "localized_after_m,rows,false_rows,false_rows_at_once,false_m\n"
            "s1,20,30,1,1,2.00,0,1.5,3.0,50,0,0,0\n"
            "s2,20,30,0,1,4.00,0,-1,5.0,50,3,3,1.2\n"
            "s3,20,30,1,0,-1,0,0,-1,50,0,0,0\n")
        sums = judge.read_kidnappings([self.results])
        self.assertEqual(sums, judge.Kidnappings(sequences=3, localized_before=2, recovered=2, median_m=4.0,
                                                 without_false_positive=2, said_lost=2, localized_again=2))


PAGE = """# Page

<!-- made by: ./run results sites -->
Words stay.
| success | acapulco | `csail` | CPU ms |
| --- | --- | --- | --- |
| **plans** | **25** | 10 | 1.11 |
| mixed | | 9 | |
<!-- end -->

| plans | 25 |
"""


class Rewriting(unittest.TestCase):
    def test_a_changed_cell_is_written_and_told(self):
        page, changes = tables.rewritten(PAGE, {"sites": {"plans": {"acapulco": "24", "csail": "10"}}})
        self.assertEqual([str(change) for change in changes], ["sites, plans, acapulco: 25 -> 24"])
        self.assertEqual(page, PAGE.replace("**25**", "24"))

    def test_the_same_numbers_leave_the_page_byte_for_byte(self):
        page, changes = tables.rewritten(PAGE, {"sites": {"plans": {"acapulco": "25", "CPU ms": "1.11"}}})
        self.assertEqual((page, changes), (PAGE, []))

    def test_a_cell_that_was_not_made_stays(self):
        page, changes = tables.rewritten(PAGE, {"sites": {"mixed": {"acapulco": None, "csail": "9"}}})
        self.assertEqual((page, changes), (PAGE, []))

    def test_an_empty_cell_is_filled(self):
        page, changes = tables.rewritten(PAGE, {"sites": {"mixed": {"acapulco": "25"}}})
        self.assertEqual(str(changes[0]), "sites, mixed, acapulco: (empty) -> 25")
        self.assertIn("| mixed | 25 | 9 | |\n", page)

    def test_cost_is_told_apart_and_can_be_kept(self):
        made = {"sites": {"plans": {"CPU ms": "1.20", "acapulco": "24"}}}
        page, changes = tables.rewritten(PAGE, made)
        self.assertEqual([change.is_cost for change in changes], [True, False])
        page, changes = tables.rewritten(PAGE, made, keep_cost=True)
        self.assertEqual([str(change) for change in changes], ["sites, plans, acapulco: 25 -> 24"])
        self.assertIn("1.11", page)

    def test_what_the_page_has_no_place_for_is_an_error(self):
        for made, message in (({"none": {}}, "no table is marked 'none'"),
                              ({"sites": {"drop": {"acapulco": "1"}}}, "no row 'drop'; there are plans, mixed"),
                              ({"sites": {"plans": {"lab": "1"}}}, "no column 'lab'")):
            with self.assertRaisesRegex(ValueError, message):
                tables.rewritten(PAGE, made)

    def test_a_table_without_end_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "'<!-- end -->' is missing"):
            tables.rewritten(PAGE.replace("<!-- end -->", ""), {})

    def test_a_table_can_be_read(self):
        self.assertEqual(len(tables.table_in(PAGE, "sites")), 4)


class Choosing(unittest.TestCase):
    def test_a_kind_chooses_its_rows_in_every_table(self):
        self.assertEqual(make_results.Selection(["plan"]).kinds, {"damage": ["plan"], "sites": ["plan"]})

    def test_a_table_chooses_all_its_kinds(self):
        self.assertEqual(make_results.Selection(["large"]).kinds, {"large": ["union", "copies"]})

    def test_no_name_chooses_all(self):
        self.assertEqual(make_results.Selection([]).kinds, make_results.Selection.TABLES)

    def test_an_unknown_name_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "'plans'"):
            make_results.Selection(["plans"])

    def test_a_run_is_made_once_for_all_tables(self):
        single, joined = make_results.Selection(["full", "large-cpu"]).runs([1], ["csail"], complete=True)
        self.assertEqual((single, joined), ([("full", 1, "csail")], ["copies"]))

    def test_sums_are_not_run_for_while_a_site_is_absent(self):
        single, joined = make_results.Selection(["drop", "union"]).runs([1, 2], ["csail"], complete=False)
        self.assertEqual((single, joined), ([("drop", 1, "csail")], []))

    def test_seeds(self):
        self.assertEqual(make_results.seeds_in("1-3,7"), [1, 2, 3, 7])
        with self.assertRaises(argparse.ArgumentTypeError):
            make_results.seeds_in("21")

    def test_a_mean_is_told_once_all_seeds_have_a_number(self):
        table = ["| map | drop=0.3: success |", "| --- | --- |", "| seed 1 | 90 |", "| seed 2 | |", "| mean | |"]
        made = {"seed 2": {"drop=0.3: success": "95"}}
        self.assertEqual(make_results.with_means(made, table)["mean"], {"drop=0.3: success": "92.5"})
        self.assertEqual(make_results.with_means({"seed 1": {"drop=0.3: success": "91"}}, table)["mean"], {})


class Drives(unittest.TestCase):
    def test_a_drive_that_is_never_right_again_counts_as_the_slowest(self):
        def row(recovered, before="1"):
            return {"localized_before": before, "recovered_after_s": recovered, "longest_wrong_s": "1.5", "named": "0"}
        cells = faults.cells_of([row("1.0"), row(""), row("9.0"), row("0.0", before="0")])
        self.assertEqual((cells["drives"], cells["localized before"]), ("4", "3"))
        self.assertEqual((cells["median s until right again"], cells["right again within 5 s"]), ("9.0", "1"))
        self.assertEqual(cells["localized elsewhere for more than 1 s"], "4")

    def test_on_another_map_the_longest_time_without_a_break_counts(self):
        rows = [{"timestamp": str(at), "status": status} for at, status in
                enumerate(["searching", "localized", "localized", "lost", "localized", "localized", "localized", "localized", "searching"])]
        self.assertEqual(other_maps.longest_localized_s(rows), 3)
        self.assertEqual(other_maps.longest_localized_s(rows[:1]), 0)

    def test_drives_that_fail_for_one_reason_are_counted_together(self):
        def run(why, driven_m):
            return {"reached": why is None, "why": why, "driven_m": driven_m, "localized_after_m": 0.5, "collisions": []}
        cells = drives.drive_cells([run(None, 4.0), run("nothing told 2 places apart", 50.0),
                                    run("nothing told 3 places apart", 60.0), run(None, 6.0)])
        self.assertEqual(cells["reached"], "2")
        self.assertEqual(cells["median m of the reached"], "5.0")
        self.assertEqual(cells["most m"], "60")
        self.assertEqual(cells["why not reached"], "2 x nothing told several places apart")

    def test_a_map_without_floor_is_told_in_its_own_words_without_its_folder(self):
        cells = drives.refused_cells("warning\nopal: /models/of/roof: has no floor\n")
        self.assertEqual((cells["drives"], cells["why not reached"]), ("0", "roof: has no floor"))


if __name__ == "__main__":
    unittest.main()
