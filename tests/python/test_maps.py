"""Maps as arrays and as a graph."""

import json
import unittest

import numpy as np
import opal
from recorded import MAP, ROOT, InFolder


class Maps(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.map = opal.read_map(str(ROOT / "maps" / "example_room.jsonld"))

    def test_every_feature_stands_in_the_array_of_its_shape(self):
        shapes = {"segment": self.map.segments(), "circle": self.map.circles(), "point": self.map.points(),
                  "oriented_point": self.map.corners()}
        columns = {"segment": 4, "circle": 3, "point": 2, "oriented_point": 4}
        for shape, array in shapes.items():
            rows = [feature.numbers for feature in self.map.features if feature.shape == shape]
            self.assertEqual(array.shape, (len(rows), columns[shape]))
            np.testing.assert_array_equal(array, np.reshape(rows, array.shape))
        self.assertGreater(len(shapes["segment"]), 3)

    def test_arrays_can_be_of_one_type_or_sensor(self):
        types = {feature.type for feature in self.map.features if feature.shape == "segment"}
        self.assertEqual(sum(len(self.map.segments(type=name)) for name in types), len(self.map.segments()))
        self.assertEqual(self.map.segments(sensor="no such sensor").shape, (0, 4))

    def test_objects_and_features_refer_to_each_other(self):
        for number, thing in enumerate(self.map.objects):
            for feature in thing.features:
                self.assertEqual(self.map.features[feature].object, number)

    def test_the_graph_has_every_object_feature_and_point_and_edges_between_them(self):
        nodes, edges = self.map.graph()
        kinds = [node["kind"] for node in nodes]
        self.assertEqual(kinds.count("object"), len(self.map.objects))
        self.assertEqual(kinds.count("feature"), len(self.map.features))
        ends = {"perceived_by": ("object", "feature"), "made_of": ("feature", "point"), "member": ("pattern", "feature"),
                "subpattern": ("pattern", "pattern")}
        for begin, end, kind in edges:
            self.assertEqual((kinds[begin], kinds[end]), ends[kind])
        self.assertEqual(sum(kind == "perceived_by" for _, _, kind in edges), len(self.map.features))

    def test_faces_that_meet_share_a_point_of_the_graph(self):
        nodes, edges = self.map.graph()
        uses = {}
        for begin, end, kind in edges:
            if kind == "made_of":
                uses.setdefault(end, []).append(begin)
        self.assertGreater(max(map(len, uses.values())), 1)

    def test_patterns_have_their_members(self):
        map_with_layer = ROOT / "maps" / "atlas.jsonld"
        self.opal("map", "patterns", map_with_layer, "-o", "layer.jsonld")
        layered = opal.read_map(str(self.folder / "layer.jsonld"))
        self.assertGreater(len(layered.patterns), 0)
        nodes, edges = layered.graph()
        members = sum(kind == "member" for _, _, kind in edges)
        self.assertEqual(members, sum(len(pattern.features) for pattern in layered.patterns))

    def test_a_grid_is_imported_as_the_program_does_it(self):
        self.opal("map", "import", MAP, "-o", "program.jsonld")
        opal.read_map(MAP).write(str(self.folder / "python.jsonld"))
        documents = [json.loads((self.folder / name).read_text()) for name in ("program.jsonld", "python.jsonld")]
        self.assertEqual(documents[0], documents[1])

    def test_overlays_change_a_map_as_in_the_program(self):
        room, overlays = ROOT / "maps" / "example_room.jsonld", sorted((ROOT / "maps" / "overlays").glob("*.jsonld"))
        fitting = [path for path in overlays if "example_room" in path.read_text() or "room" in path.name]
        for overlay in fitting or overlays[:1]:
            self.opal("map", "overlay", room, overlay, "-o", "program.jsonld")
            self.assertEqual(opal.read_map(str(room), overlays=[str(overlay)]).json_ld(),
                             json.loads((self.folder / "program.jsonld").read_text()))

    def test_options_reach_the_importer(self):
        with self.assertRaisesRegex(opal.PluginError, "no_such_option"):
            opal.read_map(MAP, options={"no_such_option": 1})

    def test_what_check_says_is_what_the_program_says(self):
        said = self.opal("map", "check", ROOT / "maps" / "example_room.jsonld")
        for sentence in self.map.check():
            self.assertIn(sentence, said)


if __name__ == "__main__":
    unittest.main()
