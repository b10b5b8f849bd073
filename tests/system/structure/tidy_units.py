"""Which sources clang-tidy reads together, as one unit: it looks at all headers again in every unit."""

import json
import pathlib
import re
import shlex

from source_tree import ROOT, sources_below

MOST = 95  # sources of a unit, about: two units at once need 3 GB
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|enum class|enum|union) (?:OPAL_EXPORT )?(\w+)\b[^;]*$")
FUNCTION = re.compile(r"(?!TEST_CASE|SECTION|OPAL_|namespace|using|return)[\[\w:][\w:<>,&*\s\[\]\"]*?[\s&*](\w+\([^)]*)")
CONSTANT = re.compile(r"(?:inline |static )*(?:constexpr|const) [^(]*?\b(\w+)(?: =|\{|\[)")
NAMESPACE = re.compile(r"^namespace (?:\w+::)+(\w+)", re.MULTILINE)
ALIAS = re.compile(r"using (\w+) = .*")
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


def names_of(file, text, plain):
    """Names at the start of a line and what they stand for. Types and functions are the file's own.

    @param plain  names without overloads; None: there are no overloads."""
    names = {}
    for line in text.splitlines():
        found = ALIAS.match(line) or TYPE.match(line) or FUNCTION.match(line) or CONSTANT.match(line)
        if found:
            name, bracket, _ = found[1].partition("(")
            key = found[1] if bracket and plain is not None and name not in plain else name
            names[without_parameter_names(key)] = line if found.re is ALIAS else str(file)
    return {name: meaning for name, meaning in names.items() if name.partition("(")[0] not in OWN}


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
    names = {file: names_of(file, text, None if is_test(file, root) else namespaces) for file, text in texts.items()}
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
        of_source[source] |= macros_of(options[source])
    return of_source


def without_parameter_names(text):
    return re.sub(r"(?<=[ &*])\w+(?=,|$)", "", text) if "(" in text else text


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
            lines += [f"#define {name} {name}_{number}" for name in OWN]
            lines += [f'#include "{source}"  // NOLINT(bugprone-suspicious-include)']
            lines += [f"#undef {name}" for name in OWN]
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
