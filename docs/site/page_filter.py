"""Doxygen's view of a Markdown page: ids for pages and headings, links that resolve in the site, text that is no command.

Doxygen calls it with a file and reads what it prints. The pages themselves stay as a forge shows them.
"""

import html
import os
import re
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
PAGES = re.compile(r"(README|CONTRIBUTING)\.md|docs/(notebook/|examples/(.*/)?)?[^/]*\.md|framework/(.*/)?README\.md")
LINK = re.compile(r"(!?)\[([^\[\]]*)\]\(([^()\s]+)\)")
FENCE = re.compile(r"^( *)```(\w*)[^\n]*\n(.*?)^ *```[ \t]*$", re.M | re.S)
CODE = re.compile(r"(`+)(?!`).+?(?<!`)\1(?!`)", re.S)


def page_id(page):
    if page == "README.md":
        return "index"
    return "page_" + re.sub(r"\W+", "_", re.sub(r"(/README)?\.md$", "", page))


def parent_of(page):
    """The page under which the navigation shows this one."""
    folder = os.path.dirname(page)
    if folder == "docs/notebook":
        return "docs/notebook.md"
    if os.path.basename(page) == "README.md":
        folder = os.path.dirname(folder)
    while folder and not os.path.exists(os.path.join(ROOT, folder, "README.md")):
        folder = os.path.dirname(folder)
    return os.path.join(folder, "README.md")


def all_pages():
    folders = [*os.walk("docs"), *os.walk("framework")]
    paths = (os.path.join(folder, name) for folder, _, names in folders for name in names)
    return ["CONTRIBUTING.md", *sorted(path for path in paths if PAGES.fullmatch(path))]


def title_of(page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        return re.search(r"^# +(.*?) *$", file.read(), re.M).group(1).replace("`", "")


def slug_of(heading):
    """The anchor that a forge gives to a heading."""
    heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")


class Page:
    def __init__(self, path):
        self.page = os.path.relpath(os.path.realpath(path), ROOT)
        self.children = set()
        self.slugs = {}
        self.kept = []

    def keep(self, text):
        """What nothing below may change: a mark, until the end."""
        self.kept.append(text)
        return f"\0{len(self.kept) - 1}\0"

    def fence(self, match):
        indent, language, body = match.groups()
        body = re.sub(f"^{indent}", "", body, flags=re.M)
        begin, end = ("@code{.cpp}", "@endcode") if language in ("cpp", "c++") else ("@verbatim", "@endverbatim")
        return indent + self.keep(f"{begin}\n{body}{end}")

    def code(self, match):
        """An apostrophe ends a code span for Doxygen, so such a span is written as HTML."""
        span = match.group(0)
        if "'" in span:
            span = re.sub(r"([@\\])", r"\1\1", html.escape(span.strip("`").strip(), quote=False))
            span = f"<code>{span.replace('|', '&#124;')}</code>"
        return self.keep(span)

    def link(self, match):
        image, text, target = match.groups()
        text = " ".join(text.split())  # Doxygen takes a link that goes over two lines for the begin of a quotation
        if re.match(r"[a-z]+:", target):
            return self.keep(match.group(0))
        path, _, anchor = target.partition("#")
        if image:
            return self.keep(f"![{text}]({os.path.basename(path)})")
        page = os.path.normpath(os.path.join(os.path.dirname(self.page), path)) if path else self.page
        if os.path.exists(os.path.join(ROOT, page, "README.md")):
            page += "/README.md"
        if not os.path.exists(os.path.join(ROOT, page)):
            sys.exit(f"{self.page}: {target} is not there")
        if not PAGES.fullmatch(page):
            return text  # a file of the tree, which the site does not hold
        text = title_of(page) if text in (page, path) else self.shown(text).replace("`", "")
        if anchor:
            return f"[{text}](@ref {page_id(page)}--{anchor})"
        if parent_of(page) == self.page and page != self.page and page not in self.children:
            self.children.add(page)
            return f'@subpage {page_id(page)} "{text}"'
        return f"[{text}](@ref {page_id(page)})"

    def heading(self, match):
        marks, text = match.groups()
        text = self.shown(text).replace("`", "")  # Doxygen shows titles as they are
        if marks == "#":
            return f"# {text} {{#{'mainpage' if self.page == 'README.md' else page_id(self.page)}}}"
        slug = slug_of(text)
        count = self.slugs[slug] = self.slugs.get(slug, -1) + 1
        return f"{marks} {text} {{#{page_id(self.page)}--{slug}{f'-{count}' if count else ''}}}"

    def shown(self, text):
        while "\0" in text:
            text = re.sub(r"\0(\d+)\0", lambda mark: self.kept[int(mark.group(1))], text)
        return text

    def text(self):
        with open(os.path.join(ROOT, self.page), encoding="utf-8") as file:
            text = file.read()
        text = FENCE.sub(self.fence, text)
        text = CODE.sub(self.code, text)
        text = text.replace("@", "@@")
        text = re.sub(r"\*\*(?=\S)((?:[^*\n]|\n(?!\n))+)\*\*", r"<b>\1</b>", text)  # also where it begins with code
        text = re.sub(r"^(#+) +(.*?) *$", self.heading, text, flags=re.M)
        return self.shown(LINK.sub(self.link, text)) + self.more_pages()

    def more_pages(self):
        """The pages below this one that its text does not mention."""
        more = [page for page in all_pages() if parent_of(page) == self.page and page not in {self.page} | self.children]
        lines = [f'- @subpage {page_id(page)} "{title_of(page)}"\n' for page in more]
        return f"\n## More pages {{#{page_id(self.page)}--more-pages}}\n\n{''.join(lines)}" if lines else ""


if __name__ == "__main__":
    page = Page(sys.argv[1])
    os.chdir(ROOT)
    sys.stdout.write(page.text())
