"""What one mistake is, and the bench on which it is made."""

import dataclasses
import gzip
import os
import pathlib
import resource
import shlex
import signal
import subprocess
from typing import Callable

TREE = pathlib.Path(__file__).resolve().parents[3]
MALAGA = TREE / "maps" / "malaga"


class Bench:
    """A folder in which files are made wrong and the program is run."""

    def __init__(self, program, folder):
        self.program = str(program)
        self.folder = pathlib.Path(folder)

    def path(self, name):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def write(self, name, content):
        path = self.path(name)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def opal(self, *words):
        """Makes what a mistake needs by a command that has to succeed."""
        subprocess.run([self.program, *words], cwd=self.folder, env=self.environment({}), check=True, capture_output=True)

    def environment(self, more):
        kept = {key: value for key, value in os.environ.items() if not key.startswith("OPAL_")}
        kept.update({"HOME": str(self.folder), "XDG_CACHE_HOME": str(self.folder / "cache"), "LC_ALL": "C.UTF-8"})
        kept.update(more)
        return kept


def nothing(bench):
    """Nothing has to be made: the command is wrong by itself."""


@dataclasses.dataclass
class Mistake:
    """A row of the table."""

    name: str
    wrong: str  # what a person did, as a sentence
    command: str  # {malaga}, {configs}, {maps} and {here} are folders
    exit_code: int
    says: list  # fragments of what is printed
    make: Callable = nothing
    never: list = dataclasses.field(default_factory=list)  # fragments that would be nonsense
    environment: dict = dataclasses.field(default_factory=dict)
    stdout: str = ""  # a file that takes what is printed
    largest_kb: int = 0  # of a file, as `ulimit -f` says; 0: any
    absent: list = dataclasses.field(default_factory=list)  # files that must not be there afterwards

    def words(self, bench):
        places = {"malaga": MALAGA, "configs": TREE / "configs", "maps": TREE / "maps", "here": bench.folder}
        return [word.format(**places) for word in shlex.split(self.command)]


@dataclasses.dataclass
class Answer:
    exit_code: int
    text: str


def run(mistake, bench):
    """Makes the mistake and returns what the program answers."""
    mistake.make(bench)

    def limit():
        if mistake.largest_kb:
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1024 * mistake.largest_kb,) * 2)

    more = {key: value.format(here=bench.folder) for key, value in mistake.environment.items()}
    out = open(mistake.stdout, "wb") if mistake.stdout else subprocess.PIPE
    done = subprocess.run([bench.program, *mistake.words(bench)], cwd=bench.folder, env=bench.environment(more),
                          stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.PIPE, preexec_fn=limit, timeout=300)
    text = (done.stdout or b"") + done.stderr
    return Answer(done.returncode, text.decode(errors="replace").replace(str(bench.folder), "."))


def complaints(mistake, answer, bench):
    """What is not as the table says; empty if all is."""
    wrong = []
    if answer.exit_code != mistake.exit_code:
        wrong.append(f"exit code {answer.exit_code}, expected {mistake.exit_code}")
    wrong += [f"does not say '{words}'" for words in mistake.says if words not in answer.text]
    wrong += [f"says '{words}'" for words in mistake.never if words in answer.text]
    wrong += [f"leaves {name}" for name in mistake.absent if (bench.folder / name).exists()]
    return wrong


def log_lines():
    """The recorded log of a corridor, 37 scans: lines of text."""
    return gzip.open(MALAGA / "malaga-demo.log.gz", "rt").read().splitlines()
