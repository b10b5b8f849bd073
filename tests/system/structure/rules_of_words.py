"""Rule of words: one thing has one word, and words that were replaced are gone from code, options and pages."""

import fnmatch
import re

from source_tree import WrongTable, files_below, lines_of_table

FOLDERS = ("framework", "plugins", "patterns", "tests", "docs", "configs", "maps", ".ci")
TEXT = {".cpp", ".hpp", ".in", ".js", ".css", ".html", ".py", ".sh", ".md", ".txt", ".cmake", ".jsonld", ".json", ".yaml", ".yml", ""}


class Words:
    """words.txt: 'PATTERN -> word' and 'except PATHS PATTERN-or-*: reason'."""

    def __init__(self, path):
        self.path, self.words, self.exceptions = path, [], []
        for number, line in lines_of_table(path):
            exception = re.fullmatch(r"except (\S+) (.+?): (.+)", line)
            word = re.fullmatch(r"(.+?) -> (.+)", line)
            if exception:
                self.exceptions.append((number, exception[1], exception[2]))
            elif word:
                self.words.append((word[1], re.compile(word[1], re.IGNORECASE), word[2]))
            else:
                raise WrongTable(f"{path}:{number}: expected 'PATTERN -> word' or 'except PATHS PATTERN: reason': {line}")
        self.used = set()

    def excused(self, path, pattern):
        numbers = [number for number, paths, of in self.exceptions if of in ("*", pattern) and fnmatch.fnmatch(path, paths)]
        self.used.update(numbers)
        return bool(numbers)

    def in_line(self, path, line):
        for pattern, expression, word in self.words:
            found = expression.search(line)
            if found and not self.excused(path, pattern):
                yield found[0], word


def texts(root, table):
    for folder in FOLDERS:
        yield from (path for path in files_below(root, folder) if path.suffix in TEXT and path != table)
    yield from sorted(path for path in root.iterdir() if path.is_file() and path.suffix in TEXT and path.name != "LICENSE")


def breaks(root, table):
    words = Words(table)
    for path in texts(root, table):
        below = path.relative_to(root).as_posix()
        for found, word in words.in_line(below, below):
            yield path, 1, f"is named '{found}', expected: {word}"
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            for found, word in words.in_line(below, line):
                yield path, number, f"'{found}', expected: {word}"
    for number, paths, _ in words.exceptions:
        if number not in words.used:
            yield table, number, f"excuses no word in {paths} any more: remove it"
