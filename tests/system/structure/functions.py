"""Where the functions of a C++ source begin and end: a counter of braces that knows comments, literals and initialisers."""

import collections
import re

Function = collections.namedtuple("Function", "name first_line last_line")

SKIPPED = re.compile(r"""//[^\n]*|/\*.*?\*/|R"(?P<mark>[^()\s\\]{0,16})\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|"""
                     r"""(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*""", re.DOTALL | re.MULTILINE)
SCOPE = re.compile(r"(^|\s|>)(namespace|class|struct|union|enum|extern)\b")
CONSTRUCTOR_LIST = re.compile(r"\)[\w\s]*:(?!:)")
INITIALISER = re.compile(r"(=|,|\(|\breturn|\{)\s*$")
TOKEN = re.compile(r"[{}();\n]|[^{}();\n]+")
NAME = re.compile(r"(~?[\w:]+|operator\S+?)\s*\(")


def without_literals(text):
    """The same lines with blanks for comments, directives and the content of literals."""
    def blank(match):
        kept = match[0][:1] if match[0][0] in "\"'" else ""
        return (kept * 2 or " ") + "\n" * match[0].count("\n")
    return SKIPPED.sub(blank, text)


def opens_function(head):
    """Whether the brace after `head`, the text since the last statement, begins the body of a function."""
    words = head.strip()
    if not words or INITIALISER.search(words) or "(" not in words:
        return bool(re.search(r"\]\s*$", words)) and "=" in words  # a lambda without parameters
    if SCOPE.search(words.split("(")[0]) and not re.search(r"\)\s*(const|noexcept|override|->.*)?\s*$", words):
        return False
    if CONSTRUCTOR_LIST.search(words) and "?" not in words:
        return bool(re.search(r"[)}]\s*$", words))  # otherwise the braces around one member's value
    return True


def name_of(head):
    test = re.search(r"\b(?:TEST_CASE|SCENARIO|BENCHMARK)\w*\s*\(", head)
    found = test or NAME.search(head)
    return (test[0].rstrip("( ") if test else found[1]) if found else "lambda"


class _Reader:
    def __init__(self, text):
        self.functions, self.open = [], []  # open: kind of each brace
        self.head, self.head_line, self.line, self.parentheses = "", 1, 1, 0
        for token in TOKEN.findall(without_literals(text)):
            self.take(token)

    def take(self, token):
        inside = "function" in (kind for kind, *_ in self.open)
        if token == "{":
            self.begin(inside)
        elif token == "}" and self.open:
            self.end()
        elif not inside:
            self.add_to_head(token)
        self.line += token == "\n"

    def begin(self, inside):
        if inside or self.parentheses > 0:
            self.open.append(("inner", self.parentheses))
        elif opens_function(self.head):
            self.open.append(("function", 0, name_of(self.head), self.head_line))
        elif SCOPE.search(self.head) and "=" not in self.head.split("(")[0]:
            self.open.append(("scope", 0))
            self.head = ""
        else:
            self.open.append(("value", self.parentheses))

    def end(self):
        kind, *rest = self.open.pop()
        if kind == "function":
            self.functions.append(Function(rest[1], rest[2], self.line))
        if kind in ("function", "scope"):
            self.head = ""
        elif "function" not in (other for other, *_ in self.open):
            self.head += "}"

    def add_to_head(self, token):
        self.parentheses += (token == "(") - (token == ")")
        if token == ";" and self.parentheses == 0:
            self.head = ""
        elif self.head.strip() in ("public:", "private:", "protected:"):
            self.head = token
        elif not self.head.strip() and not token.isspace():
            self.head, self.head_line = token, self.line
        else:
            self.head += token


def functions_of(text):
    return _Reader(text).functions
