"""Rule of comments: a source that a comment names is there, in the tree or among the headers that the file includes."""

import re

from functions import SKIPPED
from source_tree import includes_of, sources_below

FOLDERS = ("framework", "plugins", "patterns", "tests", "docs")
NAMED = re.compile(r"[\w./-]*\w\.(?:cpp|hpp)\b")


def comments_of(text):
    """Number and text of each line of a comment."""
    for found in SKIPPED.finditer(text):
        if found[0].startswith("/"):
            first = text.count("\n", 0, found.start()) + 1
            yield from enumerate(found[0].splitlines(), first)


def ends(path):
    """A path by all its ends: `a/b/c.hpp`, `b/c.hpp`, `c.hpp`."""
    parts = path.split("/")
    return {"/".join(parts[k:]) for k in range(len(parts))}


def breaks(root):
    sources = sources_below(root, *FOLDERS)
    known = set().union(*(ends(path.relative_to(root).as_posix()) for path in sources))
    for path in sources:
        included = None
        for line, comment in comments_of(path.read_text()):
            for name in NAMED.findall(comment):
                if name in known:
                    continue
                included = included or set().union(*(ends(include.header) for include in includes_of(path)))
                if name not in included:
                    yield path, line, f"names {name}, which is no file of the tree"
