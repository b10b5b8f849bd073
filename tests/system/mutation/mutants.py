"""Small changes of C++ sources that tests should notice, found on clang's AST.

An end of a range (`<` or `<=`) moves only where an operand is an integer. Between two real numbers it matters only if they are equal
to the last bit, and which side such a pair belongs to is no promise that a test should hold.

All mutants of a build are compiled in at once, and the environment picks one (mutant schemata: Untch, Offutt and Harrold 1993).
"""

import bisect
import collections
import pathlib

import clang.cindex as cindex
from clang.cindex import CursorKind, TypeKind

# What a test may miss: an end of a range, a sign, a case, a step that is left out (DeMillo, Lipton and Sayward 1978).
SWAPS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "*": "/", "/": "*", "&&": "||", "||": "&&"}
BOUNDED = ("<", "<=", ">", ">=")
REAL = (TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE)
STATEMENTS = (CursorKind.CALL_EXPR, CursorKind.UNEXPOSED_EXPR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR, CursorKind.BINARY_OPERATOR,
              CursorKind.UNARY_OPERATOR)
FUNCTIONS = (CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR, CursorKind.FUNCTION_TEMPLATE, CursorKind.LAMBDA_EXPR,
             CursorKind.CONVERSION_FUNCTION)
# The compiler needs their values, and a mutant is picked when the program runs.
CONSTANT = (CursorKind.STATIC_ASSERT, CursorKind.ENUM_CONSTANT_DECL, CursorKind.CASE_STMT, CursorKind.TEMPLATE_NON_TYPE_PARAMETER)
# A mutant may be as odd as it likes.
SILENT = ("parentheses", "misleading-indentation", "type-limits", "sign-compare", "unused-value", "unused-variable", "unused-result",
          "unused-but-set-variable", "div-by-zero", "bool-operation", "int-in-bool-context", "tautological-compare", "bool-compare")
HEAD = """#ifndef OPAL_MUTANT
#define OPAL_MUTANT
#include <cstdlib>
""" + "".join(f'#pragma GCC diagnostic ignored "-W{name}"\n' for name in SILENT) + """inline const int opal_mutant = std::getenv("OPAL_MUTANT") ? std::atoi(std::getenv("OPAL_MUTANT")) : 0;
#endif
"""

Mutant = collections.namedtuple("Mutant", "file start end line was becomes")  # offsets in bytes


def is_number(cursor):
    """Of a type for which `a ? x : y` is what x and y are; expressions of Eigen are none."""
    kind = cursor.type.get_canonical().kind
    return TypeKind.BOOL.value <= kind.value <= TypeKind.LONGDOUBLE.value or kind == TypeKind.ENUM


def is_real(cursor):
    """A floating-point number as it is written: `0` is none, even where it is compared with a double."""
    children = list(cursor.get_children())
    if cursor.kind == CursorKind.UNEXPOSED_EXPR and len(children) == 1 and is_number(children[0]):  # an implicit conversion
        return is_real(children[0])
    return cursor.type.get_canonical().kind in REAL


class Source:
    """One file, as clang reads it."""

    def __init__(self, path, options):
        self.path, self.bytes = path, path.read_bytes()
        arguments = ["-x", "c++", "-std=c++20", "-w", *(word for option in options for word in option)]
        self.unit = cindex.Index.create().parse(str(path), args=arguments)
        errors = [str(said) for said in self.unit.diagnostics if said.severity >= cindex.Diagnostic.Error]
        if errors:
            raise ValueError(f"{path}: clang cannot read it: {errors[0]}")
        self.line_starts = [0]
        for line in self.bytes.splitlines(keepends=True):
            self.line_starts.append(self.line_starts[-1] + len(line))

    def mutants(self):
        found = []
        for cursor in self.unit.cursor.get_children():
            if self._is_here(cursor):
                self._visit(cursor, False, found)
        return found

    def text(self, start, end):
        return self.bytes[start:end].decode()

    def _is_here(self, cursor):
        return cursor.location.file is not None and pathlib.Path(cursor.location.file.name) == self.path

    def _span(self, cursor):
        """None for what a macro makes."""
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        return (start, end) if self._is_here(cursor) and start < end else None

    def _visit(self, cursor, in_function, found):
        if cursor.kind in CONSTANT or self._is_constexpr(cursor) or self._never_returns(cursor):
            return
        in_function = in_function or cursor.kind in FUNCTIONS
        if in_function:
            self._swap(cursor, found)
        if cursor.kind == CursorKind.COMPOUND_STMT:
            for child in cursor.get_children():
                self._leave_out(child, found)
        for child in cursor.get_children():
            self._visit(child, in_function, found)

    def _is_constexpr(self, cursor):
        """Declarations, and `if constexpr`."""
        statements = (CursorKind.IF_STMT, CursorKind.DECL_STMT)
        if not (cursor.kind.is_declaration() or cursor.kind in statements) or cursor.kind == CursorKind.NAMESPACE:
            return False
        start = cursor.extent.start.offset
        return "constexpr" in self.text(start, start + 60).split("{")[0].split("(")[0].split("=")[0].split()

    def _never_returns(self, cursor):
        """Without what it ends with, it would return, and the compiler objects."""
        start = cursor.extent.start.offset
        return cursor.kind in FUNCTIONS and "[[noreturn]]" in self.text(max(0, start - 14), start + 14)

    def _swap(self, cursor, found):
        if cursor.kind != CursorKind.BINARY_OPERATOR or not is_number(cursor):
            return
        sides = list(cursor.get_children())
        span, left, right = self._span(cursor), self._span(sides[0]), self._span(sides[1])
        if not (span and left and right and left[1] <= right[0] and is_number(sides[0]) and is_number(sides[1])):
            return
        operator = self.text(left[1], right[0]).strip()
        if operator in SWAPS and not (operator in BOUNDED and all(map(is_real, sides))):
            becomes = f"(({self.text(*left)}) {SWAPS[operator]} ({self.text(*right)}))"
            found.append(Mutant(self.path, *span, cursor.location.line, self.text(*span), becomes))

    def _leave_out(self, cursor, found):
        """A statement of a block. It stays where the compiler sees it, so that nothing is unused."""
        span = self._span(cursor)
        if span is None or cursor.kind not in STATEMENTS or self.bytes[span[1]:span[1] + 1] != b";":
            return
        found.append(Mutant(self.path, *span, cursor.location.line, self.text(*span), ""))


def mutants_of(path, options):
    """@param options  of the preprocessor, each a tuple of words. @raise ValueError if clang cannot read it."""
    return Source(path, options).mutants()


def without_overlap(mutants, most):
    """The first ones, as many as are wanted, of which none lies in another."""
    chosen, taken = [], collections.defaultdict(list)
    for mutant in mutants:
        spans = taken[mutant.file]
        at = bisect.bisect(spans, (mutant.start, mutant.end))
        if (at > 0 and spans[at - 1][1] > mutant.start) or (at < len(spans) and spans[at][0] < mutant.end):
            continue
        spans.insert(at, (mutant.start, mutant.end))
        chosen.append(mutant)
        if len(chosen) == most:
            break
    return chosen


def mutated(text, mutants):
    """A file with its mutants in it. @param text  bytes. @param mutants  by number."""
    for number, mutant in sorted(mutants.items(), key=lambda item: -item[1].start):
        was = text[mutant.start:mutant.end].decode()
        now = f"(opal_mutant == {number} ? {mutant.becomes} : ({was}))" if mutant.becomes else f"if (opal_mutant != {number}) {was}"
        text = text[:mutant.start] + now.encode() + text[mutant.end:]
    return HEAD.encode() + b"#line 1\n" + text
