"""Every block of docs/python.md runs, from top to bottom, in one folder."""

import os
import pathlib
import re
import subprocess
import unittest

from recorded import DEMO, ROOT, InFolder

PAGE = ROOT / "docs" / "python.md"
BLOCK = re.compile(r"(?:<!-- file: (\S+) -->\n)?```(\w+)\n(.*?)```", re.DOTALL)


class Page(InFolder):
    def run_shell(self, text):
        program = pathlib.Path(os.environ["OPAL_PROGRAM"])
        environment = {**os.environ, "MALAGA": DEMO, "PATH": f"{program.parent}:{os.environ['PATH']}"}
        done = subprocess.run(["bash", "-euc", text], cwd=self.folder, text=True, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, 0, f"{text}\n{done.stdout}")
        return done.stdout

    def test_every_block_runs(self):
        before, names, said = os.getcwd(), {}, []
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        names["print"] = lambda *words: said.append(" ".join(map(str, words)))
        blocks = BLOCK.findall(PAGE.read_text())
        for file, language, text in blocks:
            if file:
                (self.folder / file).write_text(text)
            elif language == "python":
                exec(compile(text, f"a block of {PAGE.name}", "exec"), names)
            else:
                self.assertEqual(language, "sh")
                said.append(self.run_shell(text))
        self.assertGreater(len(blocks), 12)
        self.check_what_was_said(names, said)

    def check_what_was_said(self, names, said):
        """What the page says comes out does."""
        page = PAGE.read_text()
        self.assertTrue(said[0].startswith("<opal.Estimate localized: x "), said[0])
        self.assertIn(said[0], page)
        self.assertTrue(names["estimate"].is_localized)
        self.assertGreater(len(names["spawned"]), 0)
        self.assertIn("estimate", names["kinds"])
        self.assertEqual("\n".join(said).count("success in 5 of 5 queries"), 3)
        self.assertIn("likelihood.py:Likelihood: keeps the contract of its kind", "\n".join(said))
        self.assertIn("[]", said)
        self.assertIn("[] []", said)
        self.assertTrue((self.folder / "answer.png").stat().st_size > 10000)


if __name__ == "__main__":
    unittest.main()
