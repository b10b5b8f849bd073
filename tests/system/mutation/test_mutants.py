"""Mutants are found where tests could notice them, and compile."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
try:
    import mutants
    import run_mutants
except ModuleNotFoundError:
    print("no python3-clang-14: skipped")
    sys.exit(77)

SOURCE = """
#include <cstdlib>
#include <string>
#define TWICE(x) ((x) + (x))
constexpr double kStep = 2 + 1;
static_assert(kStep > 2);
struct Sum { double value = 0; void add(double x) { value += x; } };
Sum operator+(Sum a, Sum b) { return {a.value + b.value}; }
constexpr int square(int x) { return x * x; }
template <class T> T half(T x) { return x / 2; }
[[noreturn]] void give_up(int code) { std::exit(code); }
double limit(int count) { return 10. * count; }
double sum_of(const double* values, int count) {
  Sum sum;
  for (int k = 0; k < count; ++k) {
    if (values[k] > 0 && k != 7) sum.add(values[k]);
  }
  sum = sum + Sum{};
  if (sum.value > limit(count) || values[0] >= values[1]) sum = Sum{};
  return TWICE(sum.value);
}
int main() {
  constexpr int kBits = 2, kMask = (1 << kBits) - 1;
  static_assert(kMask == 3);
  const double values[] = {1, 2, -3};
  return sum_of(values, 3) == 6 ? 0 : 1;
}
"""


class MutantTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.path = self.folder / "sum.cpp"
        self.path.write_text(SOURCE)
        self.found = mutants.mutants_of(self.path, [])

    def was(self):
        return {mutant.was for mutant in self.found}

    def test_operators_on_numbers_and_statements_are_found(self):
        self.assertLessEqual({"k < count", "values[k] > 0 && k != 7", "values[k] > 0", "k != 7", "a.value + b.value", "value += x",
                              "sum = sum + Sum{}"}, self.was())

    def test_what_the_compiler_computes_and_what_macros_make_is_left_alone(self):
        for never in ("2 + 1", "kStep > 2", "x * x", "(x) + (x)", "sum + Sum{}", "std::exit(code)",
                      "(1 << kBits) - 1"):
            self.assertNotIn(never, self.was())

    def test_an_end_of_a_range_moves_only_where_an_operand_is_an_integer(self):
        self.assertLessEqual({"k < count", "values[k] > 0"}, self.was())
        self.assertIn("sum.value > limit(count) || values[0] >= values[1]", self.was())
        self.assertNotIn("sum.value > limit(count)", self.was())
        self.assertNotIn("values[0] >= values[1]", self.was())

    def test_of_those_that_lie_in_each_other_one_is_taken(self):
        chosen = mutants.without_overlap(self.found, 100)
        spans = sorted((mutant.start, mutant.end) for mutant in chosen)
        self.assertTrue(all(before[1] <= after[0] for before, after in zip(spans, spans[1:])))
        self.assertEqual(len(mutants.without_overlap(self.found, 2)), 2)

    def test_what_an_earlier_draw_changed_is_as_it_was_again(self):
        root, tree = self.folder / "root", self.folder / "tree"
        for folder in (root, tree):
            (folder / "framework").mkdir(parents=True)
            for name in ("first.cpp", "second.cpp"):
                (folder / "framework" / name).write_text(SOURCE)
        draws = [mutants.without_overlap(mutants.mutants_of(root / "framework" / name, []), 3) for name in ("first.cpp", "second.cpp")]
        with unittest.mock.patch.object(run_mutants, "ROOT", root):
            for draw in draws:
                run_mutants.write_mutants(tree, draw)
        self.assertEqual((tree / "framework/first.cpp").read_text(), SOURCE)
        self.assertIn("opal_mutant != 1", (tree / "framework/second.cpp").read_text())

    def test_what_the_sources_have_no_more_is_gone_from_the_copy(self):
        root, tree = self.folder / "root", self.folder / "tree"
        for folder in run_mutants.FOLDERS:
            (root / folder / "kept").mkdir(parents=True)
        for name in ("CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "LICENSE"):
            (root / name).touch()
        (root / "framework/kept/kept.cpp").write_text(SOURCE)
        (tree / "framework/kept").mkdir(parents=True)
        (tree / "framework/gone").mkdir()
        for gone in ("kept/gone.cpp", "gone/gone.cpp"):
            (tree / "framework" / gone).write_text(SOURCE)
        with unittest.mock.patch.object(run_mutants, "ROOT", root):
            run_mutants.copy_tree(tree)
        self.assertEqual(sorted(path.name for path in (tree / "framework").rglob("*")), ["kept", "kept.cpp"])

    def test_one_program_holds_all_of_them_and_runs_the_one_that_is_asked_for(self):
        compiler = shutil.which("g++")
        if compiler is None:
            self.skipTest("no g++")
        chosen = mutants.without_overlap([mutant for mutant in self.found if mutant.was in ("k < count", "values[k] > 0", "value += x")], 9)
        mutated = self.folder / "mutated.cpp"
        mutated.write_bytes(mutants.mutated(self.path.read_bytes(), dict(enumerate(chosen, 1))))
        program = self.folder / "program"
        subprocess.run([compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", str(mutated), "-o", str(program)], check=True)
        codes = {mutant.was: subprocess.run([str(program)], env={"OPAL_MUTANT": str(number)}, check=False).returncode
                 for number, mutant in enumerate(chosen, 1)}
        self.assertEqual(subprocess.run([str(program)], check=False).returncode, 0)
        self.assertEqual(codes["value += x"], 1)
        self.assertEqual(codes["values[k] > 0"], 0)  # no value is 0: nobody can notice


if __name__ == "__main__":
    unittest.main()
