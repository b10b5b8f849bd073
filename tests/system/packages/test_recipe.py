"""The recipe of the packages, without making any: OPAL_PROGRAM is the program. Manual pages, completion, licences, versions."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
RECIPE = ROOT / "docs" / "packaging"
PROGRAM = os.environ["OPAL_PROGRAM"]
sys.path.insert(0, str(RECIPE))
import package_licences  # noqa: E402


def made(script, *words):
    subprocess.run([sys.executable, "-B", RECIPE / script, PROGRAM, *words], check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})


def help_of(*words):
    return subprocess.run([PROGRAM, *words, "--help"], capture_output=True, text=True, check=True).stdout


class Recipe(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        place = pathlib.Path(cls.folder.name)
        made("manual_pages.py", "1.2.3", place / "man")
        made("completion.py", place / "completion")
        cls.pages = {page.stem: page.read_text().replace("\\-", "-") for page in (place / "man").iterdir()}
        cls.completion = place / "completion"

    def test_every_command_has_a_page_with_all_that_its_help_lists(self):
        commands = re.findall(r"^  (\w+) {2,}", help_of().partition("Subcommands:")[2], re.MULTILINE)
        self.assertGreater(len(commands), 10)
        for command in commands:
            page = self.pages[f"opal-{command}"]
            self.assertIn(f"opal-{command}(1)", self.pages["opal"])
            for option in re.findall(r"(?<=[ ,])--[\w-]+", help_of(command).partition("Options:")[2]):
                self.assertIn(option, page, f"the page of opal {command}")

    def test_pages_of_commands_have_the_commands_below_them(self):
        self.assertIn('"opal map import"', self.pages["opal-map"])
        self.assertIn("--storey", self.pages["opal-map"])

    def test_a_page_says_its_version_and_the_date_of_the_sources(self):
        self.assertIn('"2023-11-14" "opal 1.2.3"', self.pages["opal"])

    def completed(self, *words):
        line = f"source {self.completion}; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _opal; echo \"${{COMPREPLY[@]}}\""
        return subprocess.run(["bash", "-c", line, "_", *words], capture_output=True, text=True, check=True).stdout.split()

    def test_the_shell_completes_commands_and_options_of_the_place(self):
        self.assertEqual(self.completed("opal", "local"), ["localize"])
        self.assertEqual(self.completed("opal", "map", "imp"), ["import"])
        self.assertEqual(self.completed("opal", "map", "import", "hall.yaml", "--sto"), ["--storey"])
        self.assertIn("--queries", self.completed("opal", "localize", "default", "drive.mcap", "-"))

    def test_files_are_left_to_the_shell(self):
        self.assertEqual(self.completed("opal", "localize", "imp"), [])

    def test_names_of_licences_become_those_of_spdx_or_stay_untold(self):
        for name, expected in {"Expat": "MIT", "GPL-2+ or Expat": "(GPL-2.0-or-later OR MIT)", "Jam and MIT": None}.items():
            self.assertEqual(package_licences.spdx_expression(name), expected, name)

    def test_a_file_of_debian_has_its_package(self):
        shell = "/usr/bin/dpkg"
        self.assertEqual(package_licences.owners([shell, "/nowhere/at/all"]), {shell: "dpkg"})

    def test_packages_and_program_have_one_version(self):
        changelog = (RECIPE / "debian" / "changelog").read_text()
        self.assertEqual(subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout.strip(),
                         "opal " + re.match(r"opal \((.+)\)", changelog)[1])

    def test_every_package_of_the_recipe_is_on_the_page(self):
        page = (ROOT / "docs" / "install.md").read_text()
        for name in re.findall(r"^Package: (\S+)$", (RECIPE / "debian" / "control").read_text(), re.MULTILINE):
            self.assertIn(f"`{name}`", page)


if __name__ == "__main__":
    unittest.main()
