"""What the program says of itself: its commands and their options, read from `opal COMMAND --help`.

Manual pages and the completion of the shell are made of this, so that no list of options is kept twice.
"""

import dataclasses
import re
import subprocess

SECTION = re.compile(r"^(\S.*):$")
ENTRY = re.compile(r"^ {2}(\S.*?)(?: {2,}(\S.*))?$")
CONTINUED = re.compile(r"^ {3,}(\S.*)$")


@dataclasses.dataclass
class Entry:
    """A line of a section: an option, a positional or a command."""

    name: str
    text: str


@dataclasses.dataclass
class Command:
    """One page of help. `words` leads to it: [] is the program itself, ["map", "import"] a command of a command."""

    words: list
    description: str
    usage: str
    sections: dict  # title to entries, in the order of the page
    commands: list

    def options(self):
        """The words that begin with a dash, as the shell completes them."""
        names = []
        for title, entries in self.sections.items():
            if title in ("Positionals", "Subcommands"):
                continue
            for entry in entries:
                first = re.split(r"[ ={\[:]", entry.name)[0]
                names += [name for name in first.split(",") if name.startswith("-")]
        return names

    def walk(self):
        yield self
        for command in self.commands:
            yield from command.walk()


def sections_of(lines):
    sections, title = {}, None
    for line in lines:
        if found := SECTION.match(line):
            title = found[1]
            sections[title] = []
        elif title and (found := CONTINUED.match(line)) and sections[title]:
            entry = sections[title][-1]
            entry.text = f"{entry.text} {found[1]}".strip()
        elif title and (found := ENTRY.match(line)):
            sections[title].append(Entry(found[1], found[2] or ""))
    return sections


def read_command(program, words):
    """@throws ValueError if the help does not look as CLI11 writes it."""
    told = subprocess.run([program, *words, "--help"], capture_output=True, text=True)
    lines = told.stdout.splitlines()
    usage = [number for number, line in enumerate(lines) if line.startswith("Usage: ")]
    if told.returncode != 0 or not usage:
        raise ValueError(f"{program} {' '.join(words)} --help: ended with {told.returncode} and said "
                         f"{(told.stderr or told.stdout)[:200]!r}, expected a line that begins with 'Usage: '")
    sections = sections_of(lines[usage[0] + 1:])
    commands = [read_command(program, [*words, entry.name]) for entry in sections.get("Subcommands", [])]
    return Command(words, " ".join(lines[:usage[0]]).strip(), lines[usage[0]][len("Usage: "):], sections, commands)


def read_program(program):
    """The program at this path, with all commands below it."""
    return read_command(program, [])
