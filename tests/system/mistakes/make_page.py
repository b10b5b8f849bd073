"""Writes docs/mistakes.md from the table; with --check, says whether it is as it should be."""

import sys

from mistake import TREE
from not_yet import NOT_YET
from table import GROUPS

PAGE = TREE / "docs" / "mistakes.md"
HEAD = """# Mistakes, and what Opal says

Every line of these tables is a test in `tests/system/mistakes`. It makes the mistake, runs the command, and compares the exit code
and the words. [Getting started](start.md) explains the exit codes.

This command writes the page:

```
python3 -B tests/system/mistakes/make_page.py
```
"""


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def command(mistake):
    words = mistake.command.format(malaga="maps/malaga", configs="configs", maps="maps", here=".")
    text = f"opal {words}".strip() + (f" > {mistake.stdout}" if mistake.stdout else "")
    return text.replace(" --map maps/malaga/malaga-demo.map.yaml", " --map ...").replace(" -o out", "")


def row(mistake):
    says = ", ".join(f"`{words.strip()}`" for words in mistake.says)
    return f"| {cell(mistake.wrong)} | `{cell(command(mistake))}` | {mistake.exit_code} | {cell(says)} |"


def section(title, mistakes):
    found = [mistake for mistake in mistakes if mistake.name not in NOT_YET]
    rows = [row(mistake) for mistake in found]
    return f"\n## {title}\n\n| what is wrong | command | exit code | Opal says |\n| --- | --- | --- | --- |\n" + "\n".join(rows) + "\n"


def not_found():
    names = {m.name: m for _, mistakes in GROUPS.values() for m in mistakes}
    rows = [f"| {names[name].wrong} | {reason} |" for name, reason in NOT_YET.items()]
    if not rows:
        return ""
    return ("\n## Not found yet\n\nOpal does not notice these mistakes.\n\n| what is wrong | why |\n| --- | --- |\n" +
            "\n".join(rows) + "\n")


def page():
    return HEAD + "".join(section(*group) for group in GROUPS.values()) + not_found()


def main():
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(page())
        return 0
    if PAGE.exists() and PAGE.read_text() == page():
        return 0
    print("docs/mistakes.md is not what the table says: write it again with make_page.py")
    return 1


if __name__ == "__main__":
    sys.exit(main())
