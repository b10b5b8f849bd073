"""Fills the marked tables of a page, cell by cell, and tells which numbers changed.

A marked table stands between `<!-- made by: ./run results NAME -->` and `<!-- end -->`. The page decides which rows and columns a
table has; a cell is found by the label of its row (first column) and of its column. Cells that were not made stay as they are.
"""

import dataclasses
import re

MADE_BY = re.compile(r"<!-- made by: \./run results ([\w-]+)[^>]*-->")
END = "<!-- end -->"
COST = ("CPU", "MB", "import s")


@dataclasses.dataclass
class Change:
    table: str
    row: str
    column: str
    old: str
    new: str

    @property
    def is_cost(self):
        """CPU, memory and time differ from run to run."""
        return any(word in self.column or word in self.row for word in COST)

    def is_within(self, share):
        """Whether two numbers differ by no more than another processor may make them: by a share, or by two of what is counted."""
        try:
            old, new = float(self.old), float(self.new)
        except ValueError:
            return False
        return abs(new - old) <= max(2, share * abs(old))

    def __str__(self):
        return f"{self.table}, {self.row}, {self.column}: {self.old or '(empty)'} -> {self.new}"


def cells_of(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def plain(cell):
    return cell.replace("**", "").replace("`", "").strip()


def filled(name, lines, made, keep_cost=False):
    """A marked table with new cells.

    @param made  {row label: {column label: text}}; None instead of a text keeps the old cell.
    @return the lines, and what changed.
    """
    header = [plain(cell) for cell in cells_of(lines[0])]
    rows = [cells_of(line) for line in lines[2:]]
    labels = [plain(row[0]) for row in rows]
    changes, filled_lines = [], list(lines)
    for label, values in made.items():
        if label not in labels:
            raise ValueError(f"table {name}: no row '{label}'; there are {', '.join(labels)}")
        index = labels.index(label)
        row = rows[index]
        if len(row) != len(header):
            raise ValueError(f"table {name}, row '{label}': {len(row)} cells, expected {len(header)}")
        for column, text in values.items():
            if column not in header:
                raise ValueError(f"table {name}: no column '{column}'; there are {', '.join(header)}")
            at = header.index(column)
            if text is None or plain(row[at]) == text:
                continue
            change = Change(name, label, column, plain(row[at]), text)
            if keep_cost and change.is_cost:
                continue
            changes.append(change)
            row[at] = text
            filled_lines[2 + index] = re.sub(r"  +", " ", "| " + " | ".join(row) + " |")
    return filled_lines, changes


def table_in(page, name):
    """The lines of a marked table."""
    lines = iter(page.split("\n"))
    for line in lines:
        marked = MADE_BY.fullmatch(line.strip())
        if marked and marked[1] == name:
            return [row for row in iter(lambda: next(lines, END), END) if row.startswith("|")]
    raise ValueError(f"no table is marked '{name}'")


def rewritten(page, made, keep_cost=False):
    """A page with new numbers.

    @param made  {table name: {row label: {column label: text}}}
    @return the page, and what changed. What is made but stands in no marked table is an error.
    """
    lines, out, changes, seen = page.split("\n"), [], [], set()
    at = 0
    while at < len(lines):
        out.append(lines[at])
        marked = MADE_BY.fullmatch(lines[at].strip())
        at += 1
        if not marked:
            continue
        try:
            end = lines.index(END, at)
        except ValueError:
            raise ValueError(f"table {marked[1]}: '{END}' is missing") from None
        block = lines[at:end]
        name = marked[1]
        seen.add(name)
        if name in made:
            table = [line for line in block if line.startswith("|")]
            if len(table) < 3:
                raise ValueError(f"table {name}: no rows between its comments")
            new, changed = filled(name, table, made[name], keep_cost)
            replaced = iter(new)
            block = [next(replaced) if line.startswith("|") else line for line in block]
            changes += changed
        out += block
        at = end
    missing = sorted(set(made) - seen)
    if missing:
        raise ValueError(f"no table is marked '{missing[0]}'")
    return "\n".join(out), changes
