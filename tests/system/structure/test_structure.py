"""Tests of the rules themselves, with small trees. Python's standard library only."""

import pathlib
import tempfile
import unittest

import compile_commands
import rules_of_comments
import rules_of_rooms
import rules_of_size
import rules_of_types
import rules_of_words
from functions import functions_of
from source_tree import ROOT, Rooms, WrongTable, framework_includes


def lengths(text):
    return {f.name: f.last_line - f.first_line + 1 for f in functions_of(text)}


class Tree(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def rooms(self, *lines):
        return Rooms(self.write("rooms.txt", "[all]\n" + "\n".join(lines) + "\n"))

    def broken(self, rule, *arguments):
        return [f"{pathlib.Path(path).relative_to(self.root)}:{line}: {sentence}" for path, line, sentence in rule(*arguments)]


class RulesOfRooms(Tree):
    def setUp(self):
        super().setUp()
        self.write("framework/low/low.hpp", "#pragma once\n")
        self.write("framework/high/high.hpp", '#pragma once\n#include "low/low.hpp"\n')
        self.write("framework/include/opal/high/door.hpp", "#pragma once\n")

    def includes(self):
        return list(framework_includes(self.root))

    def test_a_room_sees_the_rooms_above_it(self):
        self.assertEqual(self.broken(rules_of_rooms.order, self.includes(), self.rooms("low", "high")), [])
        told = self.broken(rules_of_rooms.order, self.includes(), self.rooms("high", "low"))
        self.assertEqual(told, ["framework/high/high.hpp:2: 'high' includes low/low.hpp, but rooms.txt has 'low' below 'high'"])

    def test_an_exception_excuses_a_file_or_a_room_and_must_be_needed(self):
        for source in ("high", "high/high.hpp"):
            excused = self.rooms("high", "low", f"except {source} -> low/low.hpp: because")
            self.assertEqual(self.broken(rules_of_rooms.order, self.includes(), excused), [])
        idle = self.rooms("low", "high", "except high -> low: because")
        self.assertIn("excuses no include", self.broken(rules_of_rooms.order, self.includes(), idle)[0])
        with self.assertRaises(WrongTable):
            self.rooms("low", "except high -> low")

    def test_circles_are_told_unless_an_exception_says_that_there_is_one(self):
        self.write("framework/low/low.cpp", "#include <opal/high/door.hpp>\n")
        plain = self.rooms("low", "high", "except low -> high: because")
        self.assertEqual(self.broken(rules_of_rooms.circles, self.includes(), plain),
                         ["framework/low/low.cpp:1: closes a circle: 'low' includes 'high' includes 'low'"])
        said = self.rooms("low", "high", "circle low -> high: because")
        self.assertEqual(self.broken(rules_of_rooms.circles, self.includes(), said), [])
        self.write("framework/high/high.hpp", "#pragma once\n")
        self.assertIn("closes no circle", self.broken(rules_of_rooms.circles, self.includes(), said)[0])

    def test_public_headers_and_plugins_see_public_headers_only(self):
        self.write("framework/include/opal/high/door.hpp", '#include "low/low.hpp"\n#include <opal/high/gone.hpp>\n')
        self.write("plugins/one/one.cpp", '#include "low/low.hpp"\n#include <low/low.hpp>\n#include "one.hpp"\n')
        told = self.broken(rules_of_rooms.doors, self.root, self.includes())
        self.assertEqual([line.split(":")[:2] for line in told],
                         [["framework/include/opal/high/door.hpp", "1"], ["framework/include/opal/high/door.hpp", "2"],
                          ["plugins/one/one.cpp", "1"], ["plugins/one/one.cpp", "2"]])

    def test_an_include_line_names_the_room(self):
        self.write("framework/high/high.cpp", '#include "high.hpp"\n')
        self.assertIn("is no path below framework/", self.broken(rules_of_rooms.doors, self.root, self.includes())[0])

    def test_a_room_depends_on_what_its_readme_names(self):
        rooms = self.rooms("low", "high", "high/inner")
        self.write("framework/high/inner/inner.hpp", '#include "low/low.hpp"\n#include <opal/high/door.hpp>\n')
        self.write("framework/high/inner/README.md", "| may depend on | `high`, `lost`; Eigen |\n")
        for row, told in (("`low`", 0), ("all rooms", 0), ("no other room", 1)):
            self.write("framework/high/README.md", f"# High\n| may depend on | {row} |\n")
            found = self.broken(rules_of_rooms.dependencies, self.root, self.includes(), rooms)
            self.assertEqual(len(found), told + 2, row)
        self.assertEqual(found, [
            "framework/high/README.md:2: does not say that 'high' may depend on 'low', but framework/high/high.hpp:2 includes low/low.hpp",
            "framework/high/inner/README.md:1: may depend on 'lost', which is no room",
            "framework/high/inner/README.md:1: does not say that 'high/inner' may depend on 'low', but "
            "framework/high/inner/inner.hpp:1 includes low/low.hpp"])

    def test_a_folder_that_is_no_room_is_told(self):
        told = self.broken(rules_of_rooms.folders_and_table, self.root, self.rooms("low", "gone"))
        self.assertEqual(len(told), 2)


class RulesOfSize(Tree):
    def test_functions_end_where_their_body_ends(self):
        text = ('namespace a {\nclass B : public C {\n public:\n  B(int x) : x_{x}, y_(1) {\n    run([] {\n    });\n  }\n'
                '  int x_ = 1, y_{2};\n};\n\nint B::run(const std::vector<int>& of) const\n    noexcept {\n  // }}}\n'
                '  const char* s = "}" R"(}\n})";\n  if (of.empty()) {\n  }\n  return \'}\';\n}\n\nconst Table kTable = {\n'
                '  {1, make({2})},\n};\nconst auto f = [](int x) {\n  return x;\n};\n}\n')
        self.assertEqual(lengths(text), {"B": 4, "B::run": 9, "lambda": 3})

    def test_large_files_folders_and_functions_are_told_unless_excused(self):
        self.write("framework/a/long.cpp", "void f() {\n" + "  g();\n" * 400 + "}\n")
        for k in range(26):
            self.write(f"framework/b/{k}.hpp", "")
        self.write("framework/b/README.md", "")
        excused = self.write("exceptions.txt", "file framework/a/long.cpp 402: why\nfunction framework/a/long.cpp f 402: why\n"
                             "folder framework/b 26: why\n")
        self.assertEqual(self.broken(rules_of_size.breaks, self.root, excused), [])
        tight = self.write("exceptions.txt", "file framework/a/long.cpp 401: why\nfolder framework/c 30: why\n")
        told = "\n".join(self.broken(rules_of_size.breaks, self.root, tight))
        for sentence in ("has 402 lines", "f has 402 lines", "holds 26 source files", "exceptions.txt:2: excuses nothing"):
            self.assertIn(sentence, told)

    def test_leftovers_have_no_place(self):
        self.write("framework/a/map_utils.hpp", "")
        self.write("framework/a/a.hpp", "class PluginManager {\n")
        self.assertEqual(len(self.broken(rules_of_size.names, self.root)), 2)


class RulesOfTypes(Tree):
    def test_two_types_of_one_name_are_told(self):
        self.write("framework/a/a.hpp", "namespace opal {\nstruct A {\n  enum class Kind { one };\n};\nstruct Later;\n}\n")
        self.write("framework/a/b.cpp", "namespace opal {\nnamespace {\nstruct A {};\n}\nclass B : A { struct A {}; };\n"
                   "template <>\nstruct Later<B> {};\nvoid f() {\n  struct A {};\n}\n}\n")
        self.assertEqual(self.broken(rules_of_types.breaks, self.root), [])
        self.write("plugins/c/c.hpp", "namespace opal::c {\nstruct A {};\n}\nnamespace opal {\nenum class A { x };\n}\n")
        self.assertEqual(self.broken(rules_of_types.breaks, self.root),
                         ["plugins/c/c.hpp:5: defines opal::A, as framework/a/a.hpp does: the linker takes both for one"])


class RulesOfComments(Tree):
    def test_a_source_that_a_comment_names_is_there(self):
        self.write("framework/a/a.hpp", "")
        self.write("framework/a/a.cpp", '#include <boost/dll/info.hpp>\n// a.hpp, a/a.hpp and info.hpp\nconst char* x = "gone.cpp";\n'
                   "/* text\n  b/a.hpp */ // gone.cpp:\n")
        self.assertEqual(self.broken(rules_of_comments.breaks, self.root),
                         ["framework/a/a.cpp:5: names b/a.hpp, which is no file of the tree",
                          "framework/a/a.cpp:5: names gone.cpp, which is no file of the tree"])


class RulesOfWords(Tree):
    def test_old_words_are_told_with_the_new_one(self):
        self.write("docs/page.md", "good\nthe Oldword of it\n")
        self.write("docs/notes/oldword.md", "")
        table = self.write("tests/words.txt", "\\boldword -> new word\nexcept docs/notes/* *: a diary\n")
        self.assertEqual(self.broken(rules_of_words.breaks, self.root, table), ["docs/page.md:2: 'Oldword', expected: new word"])


class CompileCommands(Tree):
    def test_the_unit_of_a_folder_has_its_sources(self):
        unit = self.write("build/Unity/opal/framework_a.cpp", '#include "framework/cmake/precompiled.cpp"\n#include "made/by_the_build.cpp"\n')
        self.assertEqual(compile_commands.sources_of(unit), [ROOT / "framework/cmake/precompiled.cpp"])
        alone = self.write("framework/a/a.cpp", '#include "framework/a/b.cpp"\n')
        self.assertEqual(compile_commands.sources_of(alone), [alone])

    def test_options_of_the_preprocessor_are_kept_with_their_values(self):
        words = ["c++", "-DA=1", "-isystem", "/usr/include/eigen3", "-O3", "-I/tree", "-c", "a.cpp"]
        self.assertEqual(compile_commands.preprocessor_options(words),
                         [("-DA=1",), ("-isystem", "/usr/include/eigen3"), ("-I/tree",)])


if __name__ == "__main__":
    unittest.main()
