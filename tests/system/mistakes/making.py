"""How files are made wrong: from the recorded corridor in maps/malaga, and by hand."""

import gzip
import json
import pathlib
import shutil

from mistake import MALAGA, TREE, log_lines


def copy(*names):
    """Copies files of maps/malaga; a pair (name, new name) renames."""

    def make(bench):
        for name in names:
            old, new = name if isinstance(name, tuple) else (name, name)
            shutil.copy(MALAGA / old, bench.path(new))

    return make


def both(*makers):
    def make(bench):
        for one in makers:
            one(bench)

    return make


def file(name, content):
    return lambda bench: bench.write(name, content)


def cut(source, name, share):
    """The first part of a file."""

    def make(bench):
        content = pathlib.Path(source).read_bytes()
        bench.write(name, content[: int(share * len(content))])

    return make


def changed_json(source, name, change):
    """A document with one thing changed by a function."""

    def make(bench):
        document = json.loads(pathlib.Path(source).read_text())
        change(document)
        bench.write(name, json.dumps(document))

    return make


def config(change):
    """configs/malaga.jsonld as config.jsonld, with the corridor's map, changed."""

    def all_changes(document):
        document["map"] = str(MALAGA / "malaga-demo.map.yaml")
        change(document)

    return changed_json(TREE / "configs" / "malaga.jsonld", "config.jsonld", all_changes)


def grid(name, change):
    """A grid's yaml with its image's name made whole, and one thing replaced."""

    def make(bench):
        text = (MALAGA / "malaga-demo.map.yaml").read_text()
        bench.write(name, change(text.replace("malaga-demo.map.pgm", str(MALAGA / "malaga-demo.map.pgm"))))

    return make


class Log:
    """The corridor's log, line by line in words."""

    def __init__(self):
        self.lines = [line.split() for line in log_lines()]

    def text(self):
        return "\n".join(" ".join(words) for words in self.lines) + "\n"


def log(change, name="wrong.log", zipped=False):
    """The corridor's log, changed by a function of a Log."""

    def make(bench):
        wrong = Log()
        change(wrong)
        text = wrong.text().encode()
        bench.write(name, gzip.compress(text) if zipped else text)

    return make


def ranges(change):
    """Changes every range, which stays text."""

    def make(log):
        for words in log.lines:
            if words[0] == "FLASER":
                end = 2 + int(words[1])
                words[2:end] = change(words[2:end])
                words[1] = str(len(words) - 2 - 9)

    return make


def poses(change):
    """Changes every pose (x, y, heading) of odometry."""

    def make(log):
        for words in log.lines:
            places = [1] if words[0] == "ODOM" else [-9, -6] if words[0] == "FLASER" else []
            for place in places:
                at = place % len(words)
                pose = change(*(float(word) for word in words[at : at + 3]))
                words[at : at + 3] = [f"{value:.4f}" for value in pose]

    return make


def stamps(change):
    """Changes every time."""

    def make(log):
        for words in log.lines:
            for at in (-3, -1) if words[0] in ("ODOM", "FLASER") else ():
                words[at] = change(words[at])

    return make


def only(*kinds):
    """Keeps records of some kinds."""

    def make(log):
        log.lines = [words for words in log.lines if words[0] in kinds]

    return make
