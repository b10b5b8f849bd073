"""One name, one type: the linker takes two definitions of one qualified name for the same, and mixes up their functions."""

import re

from functions import without_literals
from source_tree import sources_below

FOLDERS = ("framework", "plugins", "patterns")
SCOPE = re.compile(r"""(?:inline\s+)?namespace\s*(?P<namespace>[\w:]*)\s*\{"""
                   r"""|(?P<special>template\s*<\s*>\s*)?\b(?:enum\s+class|enum\s+struct|enum|struct|class|union)\s+"""
                   r"""(?:OPAL_\w+\s+)?(?P<type>\w+)(?:\s+final)?\s*(?::[^:;{][^;{]*)?\{|[{}]""")


def types_of(text):
    """Line and qualified name of each type that other units can see."""
    text = without_literals(text)
    scopes = []  # names; None: something that hides what it holds
    for found in SCOPE.finditer(text):
        if found[0] == "}":
            del scopes[-1:]
            continue
        name = found["type"] or found["namespace"] or None
        if found["type"] and not found["special"] and None not in scopes:
            yield text.count("\n", 0, found.start()) + 1, "::".join([*scopes, name])
        scopes.append(name)


def breaks(root):
    known = {}
    for path in sources_below(root, *FOLDERS):
        for line, name in types_of(path.read_text()):
            first = known.setdefault(name, path)
            if first != path:
                yield path, line, f"defines {name}, as {first.relative_to(root)} does: the linker takes both for one"
