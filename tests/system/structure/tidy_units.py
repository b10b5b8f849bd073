"""Which sources clang-tidy reads together, as one unit: it looks at all headers again in every unit."""

import functools
import json
import pathlib
import re
import shlex

from source_tree import ROOT, sources_below

MOST = 95  # sources of a unit, about: two units at once need 3 GB
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|enum class|enum|union) (?:OPAL_EXPORT )?(\w+)\b(?:[^;]*|.*\{.*)$")
FUNCTION = re.compile(r"(?!TEST_CASE|SECTION|OPAL_|namespace|using|return)[\[\w:][\w:<>,&*\s\[\]\"]*?[\s&*](\w+)\(")
CONSTANT = re.compile(r"(?:inline |static )*(?:constexpr|const) [^(]*?\b(\w+)(?: =|\{|\[)")
MORE_CONSTANTS = re.compile(r", (k[A-Z]\w*)(?: =|\{|\[)")  # of the same line
NAMESPACE = re.compile(r"^namespace (?:\w+::)+(\w+)", re.MULTILINE)
ALIAS = re.compile(r"using (?:(\w+) = .*|(?:\w+::)+(\w+);)")
# Plugins and programs define these, each its own; in a unit they get a number.
OWN = ("register_types", "LLVMFuzzerTestOneInput", "main")
PLUGIN_MACRO = """#include <opal/plugin/plugin.hpp>
#undef OPAL_PLUGIN
#define OPAL_PLUGIN(NAME, VERSION, REGISTER)
"""


def commands(build):
    """Of every source that a configured build compiles: its options for the preprocessor."""
    options = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        for source in sources_of(pathlib.Path(entry["file"])):
            options.setdefault(source, preprocessor_options(words))
    return options


def sources_of(file):
    """The file, or what it includes if the build made it as the unit of a folder."""
    if file.parent.parent.name != "Unity":
        return [file]
    return [ROOT / name for name in re.findall(r'#include "(.+\.cpp)"', file.read_text()) if (ROOT / name).is_file()]


def preprocessor_options(words):
    kept, words = [], iter(words)
    for word in words:
        if word in ("-isystem", "-I"):
            kept += [(word, next(words))]
        elif word.startswith(("-D", "-I")):
            kept += [(word,)]
    return kept


def macros_of(options):
    return {word[0][2:].partition("=")[0]: word[0] for word in options if word[0].startswith("-D")}


def files_of(source, root):
    """The source, the sources that it includes, and the headers of tests: these define functions, too."""
    files = [source]
    for file in files:
        for name in re.findall(r'^#include "(.+)"', file.read_text(), re.MULTILINE):
            for path in (file.parent / name, root / name):
                if path.is_file() and (path.suffix == ".cpp" or is_test(path, root)) and path not in files:
                    files.append(path)
    return files


def is_test(path, root):
    return path.is_relative_to(root / "tests")


def names_of(file, text):
    """Names at the start of a line and what they stand for. Types, functions and constants are the file's own. Overloads of
    two files are kept apart, too: where one file alone is clear, both together are often ambiguous."""
    names = {}
    for line in text.splitlines():
        found = ALIAS.match(line) or TYPE.match(line) or FUNCTION.match(line) or CONSTANT.match(line)
        if found:
            names[found[1] or found[2]] = line if found.re is ALIAS else str(file)
            if found.re is CONSTANT:
                names.update((more, str(file)) for more in MORE_CONSTANTS.findall(line))
    return {name: meaning for name, meaning in names.items() if name not in OWN}


def headers_of(file, root):
    """The headers of the tree that a file includes, and those that they include."""
    found = set()
    for name in re.findall(r'^#include ["<](.+\.hpp)[">]', file.read_text(), re.MULTILINE):
        for folder in (file.parent, root, root / "framework", root / "framework/include"):
            if (folder / name).is_file():
                found |= header_and_its_own(folder / name, root)
                break
    return found


@functools.cache
def header_and_its_own(header, root):
    return {header} | headers_of(header, root)


@functools.cache
def names_for_all(header):
    """What a header gives to all who see it: name, namespace, and whether it is a function."""
    text = re.sub("//.*", "", header.read_text())
    space = (re.findall(r"^namespace ([\w:]+) \{", text, re.MULTILINE) or [""])[0]
    functions = {found[1] for found in map(FUNCTION.match, text.splitlines()) if found}
    names = {(name, space, name in functions) for name in names_of(header, text)}
    return names | {(space.partition("::")[0], "", False)}


def spaces_of(text):
    """The namespaces that a source sees without a qualifier."""
    seen = {""}
    for space in re.findall(r"^(?:using )?namespace ([\w:]+)(?: \{|;)", text, re.MULTILINE):
        parts = space.split("::")
        seen |= {"::".join(parts[:number]) for number in range(1, len(parts) + 1)}
    return seen


def shared_names(source, text, own, root):
    """Names that are a header's in some sources and a source's own in others. A function's matters where it is used."""
    words = set(re.findall(r"\w+", text))
    shared = {(name, space): "a header's" for header in headers_of(source, root)
              for name, space, is_function in names_for_all(header) if name in words or not is_function}
    seen = spaces_of(text)
    spaces = {name: space for name, space in shared if name in words and space in seen and name[0].isupper()}
    shared.update({(name, space): "its own" for name in own for space in seen})
    return {f"{name} in {space}": meaning for (name, space), meaning in shared.items()} | {
        f"the space of {name}": space for name, space in spaces.items()}


def types_of_namespaces(root):
    """Of every namespace: the types in its headers, which sources see by `using namespace`."""
    types = {}
    for header in sources_below(root, "framework"):
        text = header.read_text()
        for namespace in re.findall(r"^namespace ([\w:]+) {", text, re.MULTILINE):
            types.setdefault(namespace, set()).update(found[1] for found in map(TYPE.match, text.splitlines()) if found)
    return types


def meanings(options, root):
    """Of every source: what it means by macros, by names that it gives, and by types and namespaces that others have."""
    files = {source: files_of(source, root) for source in options}
    texts = {file: re.sub("//.*", "", file.read_text()) for group in files.values() for file in group}
    namespaces = {name for text in texts.values() for name in NAMESPACE.findall(text)}
    names = {file: names_of(file, text) for file, text in texts.items()}
    given = {name for file, own in names.items() for name in own
             if (name[0].isupper() or name in namespaces) and own[name] == str(file)}
    types, of_source = types_of_namespaces(root), {}
    for source, group in files.items():
        seen = set(re.findall(r"\w+", texts[source]))
        for namespace in re.findall(r"^using namespace (opal::[\w:]+);", texts[source], re.MULTILINE):
            seen |= types.get(namespace, set())
        of_source[source] = {name: "another" for name in given & seen}
        for file in group:
            of_source[source] |= names[file]
            if file.suffix == ".cpp":
                of_source[source] |= shared_names(file, texts[file], names[file], root)
        of_source[source] |= macros_of(options[source])
    return of_source


class Unit:
    def __init__(self):
        self.sources, self.meanings, self.options = [], {}, []

    def takes(self, meanings):
        return all(self.meanings.get(name, meaning) == meaning for name, meaning in meanings.items())

    def add(self, source, meanings, options):
        self.sources.append(source)
        self.meanings.update(meanings)
        self.options += [option for option in options if option not in self.options]

    def parts(self, apart):
        """Two units: with the sources `apart`, and the others; or halves."""
        first = [source for source in self.sources if str(source) in apart]
        if not first or len(first) == len(self.sources):
            first = self.sources[:len(self.sources) // 2]
        for sources in (first, [source for source in self.sources if source not in first]):
            part = Unit()
            part.sources, part.options = sources, self.options
            yield part

    def text(self):
        lines = [PLUGIN_MACRO]
        for number, source in enumerate(self.sources):
            own = [name for name in OWN if re.search(rf"^[\w:<>*& \"]* {name}\(", source.read_text(), re.MULTILINE)]
            lines += [f"#define {name} {name}_{number}" for name in own]
            lines += [f'#include "{source}"  // NOLINT(bugprone-suspicious-include)']
            lines += [f"#undef {name}" for name in own]
        return "\n".join(lines) + "\n"


def units_of(options, root=ROOT, most=MOST):
    """Neighbours are read together. A source that does not agree with them goes to the next unit that takes it."""
    units = [Unit() for _ in range(-(-len(options) // most))]
    of_source = meanings(options, root)
    for number, source in enumerate(options):
        first = number * len(units) // len(options)
        unit = next((unit for unit in units[first:] + units[:first] if unit.takes(of_source[source])), None)
        if unit is None:
            units.append(unit := Unit())
        unit.add(source, of_source[source], options[source])
    return [unit for unit in units if unit.sources]
