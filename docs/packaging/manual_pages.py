"""Manual pages of the program: manual_pages.py PROGRAM VERSION FOLDER

One page for the program, and one for each of its commands. Commands of a command are sections of its page. The date of the
pages is that of SOURCE_DATE_EPOCH, so that two builds of one version make the same files.
"""

import os
import pathlib
import sys
import time

import program_help

FILES = [("/etc/opal", "what the service opal-ros2 reads: robot.jsonld and map.jsonld; empty at first"),
         ("/usr/share/opal/configs", "the configurations that ship; their names are enough on the command line"),
         ("/usr/share/opal/maps", "maps that ship, and the recordings of opal demo"),
         ("/usr/share/opal/docs", "the pages, if the package opal-doc is installed")]
VARIABLES = [("OPAL_PLUGIN_PATH", "folders with further plugins, with colons between them"),
             ("ROS_DOMAIN_ID, ROS_AUTOMATIC_DISCOVERY_RANGE", "of opal ros2, as for any node of ROS 2")]


def plain(text):
    """Text for troff: nothing in it is a request or an escape."""
    text = text.replace("\\", r"\e").replace("-", r"\-").replace("`", r"\(ga")
    return r"\&" + text if text.startswith((".", "'")) else text


def entries_as_list(entries):
    for name, text in entries:
        yield ".TP"
        yield rf"\fB{plain(name)}\fR"
        yield plain(text) or r"\&"


def options_of(command, level):
    for title, entries in command.sections.items():
        if title != "Subcommands":
            yield f'.{level} "{plain(title).upper() if level == "SH" else plain(title)}"'
            yield from entries_as_list((e.name, e.text) for e in entries)


def heading(words, version, description):
    day = time.strftime("%Y-%m-%d", time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", time.time()))))
    name = "-".join(["opal", *words])
    yield f'.TH "{plain(name.upper())}" "1" "{day}" "opal {version}" "User Commands"'
    yield ".ad l"  # words of options are long and cannot be parted
    yield ".SH NAME"
    yield rf"{plain(name)} \- {plain(description)}"


def program_page(program, version):
    yield from heading([], version, program.description.removeprefix("Opal: "))
    yield ".SH SYNOPSIS"
    yield plain(program.usage)
    yield from options_of(program, "SH")
    yield ".SH COMMANDS"
    yield "Each command has a page of its own."
    yield from entries_as_list((f"opal-{c.words[0]}(1)", c.description) for c in program.commands)
    yield ".SH FILES"
    yield from entries_as_list(FILES)
    yield ".SH ENVIRONMENT"
    yield from entries_as_list(VARIABLES)


def command_page(command, version):
    yield from heading(command.words, version, command.description)
    yield ".SH SYNOPSIS"
    yield plain(command.usage)
    yield from options_of(command, "SH")
    for below in (c for c in command.walk() if c is not command):
        yield f'.SH "{plain("opal " + " ".join(below.words))}"'
        yield plain(below.description)
        yield ".PP"
        yield plain(below.usage)
        yield from options_of(below, "SS")
    yield ".SH SEE ALSO"
    yield r"\fBopal\fR(1)"


def main():
    program, version, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    top = program_help.read_program(program)
    folder.mkdir(parents=True, exist_ok=True)
    pages = {"opal": program_page(top, version)}
    pages.update({f"opal-{c.words[0]}": command_page(c, version) for c in top.commands})
    for name, lines in pages.items():
        (folder / f"{name}.1").write_text("\n".join(lines) + "\n")
    print(f"{len(pages)} manual pages in {folder}")


main()
