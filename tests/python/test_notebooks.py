"""The notebooks run from top to bottom, and keep outputs that say so."""

import importlib.util
import itertools
import unittest

from recorded import ROOT, InFolder

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


@unittest.skipUnless(importlib.util.find_spec("nbclient") and importlib.util.find_spec("ipykernel"),
                     "nbclient or ipykernel is not installed")
class Notebooks(InFolder):
    def test_every_cell_runs(self):
        import nbformat
        from nbclient import NotebookClient

        self.assertEqual([path.stem for path in NOTEBOOKS], ["a_building", "first_steps", "new_scorer", "why_a_query_fails"])
        for path in NOTEBOOKS:
            kept = nbformat.read(path, as_version=4)
            fresh = nbformat.read(path, as_version=4)
            NotebookClient(fresh, timeout=300, resources={"metadata": {"path": str(self.folder)}}).execute()
            for was, now in zip(kept.cells, fresh.cells):
                if was.cell_type == "code":
                    self.assertEqual(self.texts_of(was), self.texts_of(now), was.source)

    def test_outputs_are_kept_and_name_no_folder_of_their_maker(self):
        import nbformat

        for path in NOTEBOOKS:
            notebook = nbformat.read(path, as_version=4)
            cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
            self.assertGreater(sum(bool(cell.outputs) for cell in cells), len(cells) / 2)
            text = path.read_text()
            self.assertNotIn(str(ROOT), text)
            self.assertNotRegex(text, r"(?<![\w.:/+<=-])/[a-z]+/")

    @staticmethod
    def texts_of(cell):
        """What can be compared: no pictures, no addresses of objects, no axes. What is printed comes in pieces of any length."""
        texts = []
        for stream, outputs in itertools.groupby(cell.outputs, lambda output: output.get("name") if output.output_type == "stream" else None):
            if stream:
                texts.append("".join(output.text for output in outputs))
            else:
                texts += [output.get("data", {}).get("text/plain", "") for output in outputs]
        return [text for text in texts if text and not any(word in text for word in (" at 0x", "<Figure", "<Axes"))]


if __name__ == "__main__":
    unittest.main()
