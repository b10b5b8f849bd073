"""`opal map review` on the recording that ships, and a map of it that was made wrong. OPAL_PROGRAM is the program."""

import json
import re

from test_learn import LOG, DamagedMap


class Review(DamagedMap):
    def setUp(self):
        super().setUp()
        self.opal("learn", "damaged.jsonld", LOG, "--config", "malaga", "-o", "learned.jsonld", "--evidence", "evidence.json")

    def review(self, *words, evidence="evidence.json", **how):
        return self.opal("map", "review", "damaged.jsonld", evidence, "--config", "malaga", *words, **how)

    def data(self):
        """What the page is given."""
        page = (self.folder / "review.html").read_text()
        return json.loads(re.search(r'<script type="application/json" id="opal-review">(.*?)</script>', page)[1])

    def decide(self, answer_to, file="decisions.json"):
        """Decisions as the page saves them."""
        data = self.data()
        said = [{"about": p["about"], "answer": answer_to(p)} for p in data["proposals"]]
        document = {**data["document"], "decisions": said}
        (self.folder / file).write_text(json.dumps(document))
        return document

    def test_who_accepts_what_is_proposed_gets_what_was_learned(self):
        self.opal("learn", "damaged.jsonld", "evidence.json", "--config", "malaga", "--least", "0.5", "-o", "learned.jsonld")
        self.assertRegex(self.review("--least", "0.5", "--html", "review.html"), r"0 of \d+ decided, 0 accepted; written: review.html")
        self.decide(lambda p: "accepted" if p["proposed"] and not p["objection"] else "refused")
        self.assertRegex(self.review("--decisions", "decisions.json", "-o", "reviewed.jsonld"), r"(\d+) of \1 decided, [1-9]\d* accepted")
        self.assertEqual((self.folder / "reviewed.jsonld").read_bytes(), (self.folder / "learned.jsonld").read_bytes())
        self.opal("map", "overlay", "damaged.jsonld", "reviewed.jsonld", "-o", "built.jsonld")

    def test_a_page_goes_on_with_decisions(self):
        self.review("--html", "review.html")
        self.decide(lambda p: "refused")
        self.review("--decisions", "decisions.json", "--html", "review.html")
        self.assertEqual({answer["answer"] for answer in self.data()["answers"]}, {"refused"})
        self.assertEqual(self.data()["notes"], [])

    def test_a_page_leaves_the_overlay_until_somebody_decides(self):
        overlay = self.folder / "reviewed.jsonld"
        self.review("--html", "review.html", "-o", "reviewed.jsonld")
        self.assertFalse(overlay.exists())
        self.decide(lambda p: "accepted" if not p["objection"] else "refused")
        self.review("--decisions", "decisions.json", "-o", "reviewed.jsonld")
        kept = overlay.read_bytes()
        self.review("--html", "review.html", "-o", "reviewed.jsonld")
        self.assertEqual(overlay.read_bytes(), kept)

    def test_decisions_about_what_has_changed_are_asked_again(self):
        self.review("--html", "review.html")
        document = self.decide(lambda p: "accepted" if not p["objection"] else "refused")
        drives = json.loads((self.folder / "evidence.json").read_text())
        for visit in drives[0]["visits"]:
            visit["unmapped"] = [{**face, "begin_x_m": face["begin_x_m"] + 0.2, "end_x_m": face["end_x_m"] + 0.2}
                                 for face in visit["unmapped"]]
        (self.folder / "other.json").write_text(json.dumps(drives))
        told = self.review("--decisions", "decisions.json", "-o", "reviewed.jsonld", evidence="other.json")
        added = sum(decision["about"]["change"] == "added" for decision in document["decisions"])
        self.assertIn(f"since then the evidence has changed; {len(document['decisions']) - added} of "
                      f"{len(document['decisions'])} decisions hold as they are", told)
        self.assertRegex(told, r"added learned-1 was (accepted|refused); this is not what drives say of this map now, so look again")

    def test_mistakes_are_told_by_name(self):
        self.assertIn("expected an overlay to write", self.review(exit_code=2))
        self.review("--html", "review.html")
        document = self.decide(lambda p: "refused")
        (self.folder / "wrong.json").write_text(json.dumps({**document, "map": "elsewhere"}))
        self.assertIn('wrong.json: /map: "elsewhere", expected "', self.review("--decisions", "wrong.json", "-o", "r.jsonld", exit_code=3))
        document["decisions"][0]["answer"] = "perhaps"
        (self.folder / "wrong.json").write_text(json.dumps(document))
        self.assertIn('wrong.json: /decisions/0/answer: "perhaps", expected one of: undecided, accepted, refused',
                      self.review("--decisions", "wrong.json", "-o", "r.jsonld", exit_code=3))
        self.assertIn("nowhere.json", self.review("--decisions", "nowhere.json", "-o", "r.jsonld", exit_code=3))
        self.assertFalse((self.folder / "r.jsonld").exists())


if __name__ == "__main__":
    import unittest
    unittest.main()
