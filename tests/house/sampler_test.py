#!/usr/bin/env python3
"""The sampler of faults (verification/faults/sample): each operator on a snippet, what is left alone, the switch, the interval."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verification/faults"))
from mutants import score, trial, workshop  # noqa: E402
from mutants.schemata import SWITCH, draw, mutants_of, numbered  # noqa: E402


def changes(text, operator=None):
    """What the lines of a snippet become, by operator."""
    found = mutants_of("a.cpp", text)
    return {m.after for m in found if operator is None or m.operator.startswith(operator)}


class Operators(unittest.TestCase):
    def body(self, line):
        return f"double f(double a, double b) {{\n  {line}\n}}\n"

    def expect(self, operator, line, *after):
        self.assertEqual(changes(self.body(line), operator), set(after))

    def test_sign(self):
        self.expect("sign", "return a + b;", "return a - b;")
        self.expect("sign", "a -= b;", "a += b;")
        self.expect("sign", "return -a * b;", "return a * b;")
        self.expect("sign", 'return name + "text";')

    def test_factor(self):
        self.expect("factor 2", "return a * b;", "return 2 * (a * b);")
        self.expect("factor 0.5", "a = b;", "a = 0.5 * (b);")
        self.expect("factor", "return a < b;")
        self.expect("factor", 'return "text";')

    def test_index(self):
        self.expect("index", "return X[i] - X[j];", "return X[j] - X[j];", "return X[i] - X[i];")
        self.expect("index", "return F(a, b) + G(b);", "return F(b, b) + G(b);", "return F(a, a) + G(b);", "return F(a, b) + G(a);")
        self.expect("index", "return box.lower + box.upper;", "return box.upper + box.upper;", "return box.lower + box.lower;")
        self.expect("index", "return X[i];")

    def test_off_by_one(self):
        self.expect("off by one", "return v[0];", "return v[1];")
        self.expect("off by one", "const Mat<3> F = Mat<3>::Identity();")
        self.expect("off by one", "std::array<double, 3> x;")

    def test_constant(self):
        self.expect("constant", "return 0.5 * a;", "return 0.55 * a;")
        self.expect("constant", "return a > 1e-12;")  # a limit of round-off
        self.assertEqual(changes("constexpr double hour = 3600.0;\n", "constant"), {"constexpr double hour = 3960.0000000000005;"})

    def test_dropped(self):
        self.expect("term", "return a + b * a - 1;", "return a - 1;", "return a + b * a ;")
        self.expect("statement", "sum += a;", ";")
        self.expect("statement", "list.push_back(a);", ";")
        self.expect("statement", "return f(a);")

    def test_arguments(self):
        self.expect("arguments", "return f(a, b + 1);", "return f(b + 1, a);")
        self.expect("arguments", "if (a > b) return 1;")
        self.expect("arguments", "return f(a, b, a);")

    def test_comparison(self):
        self.expect("comparison", "return a < b;", "return a <= b;", "return a > b;")
        self.expect("comparison", "return a == 1 && b;", "return a != 1 && b;", "return a == 1 || b;")
        self.expect("comparison", "return std::min(a, b);", "return std::max(a, b);")
        self.expect("comparison", "std::vector<double> v;")

    def test_key(self):
        self.expect("key", 'return row.at("n") + row["order"];', 'return row.at("order") + row["order"];', 'return row.at("n") + row["n"];')
        self.expect("key", 'return row.at("n");', 'return row.at("n_");')
        self.expect("key", 'print("hello");')

    def test_left_alone(self):
        for line in ('throw InputError("a" + b, 2);', "static_assert(d < 3);", "list.reserve(2 * n);", "// return a + b;"):
            self.expect("", line)
        self.assertEqual(changes("#define X 1 + 2\n#include <a>\nusing T = A<2>;\nenum { a = 3 };\n"), set())

    def test_tables_and_members(self):
        table = 'constexpr std::array<Unit, 2> units{{\n    {"min", 60.0},\n    {"h", 3600.0},\n}};\n'
        self.assertEqual(changes(table, "constant"), {'{"min", 66.0},', '{"h", 3960.0000000000005},'})
        self.assertEqual(changes(table, "key"), {'{"min_", 60.0},', '{"h_", 3600.0},'})
        self.assertEqual(changes("struct A {\n  double beta = 0.9;\n};\n", "constant"), {"double beta = 0.9900000000000001;"})
        made = "struct A {\n  explicit A(double e)\n      : a(e + b) {}\n};\n"
        self.assertEqual(changes(made, "sign"), {": a(e - b) {}"})


PROGRAM = """#include <array>
#include <cstdio>

constexpr std::array<double, 2> table{
    1.5,
    2.5};

struct Pair {
  double a, b;
  explicit Pair(double x)
      : a(x + 1), b(2 * x) {}
};

template <int d>
constexpr double power(double x) {
  double p = 1;
  for (int k = 0; k < d; ++k) p *= x;
  return p;
}

int main() {
  const Pair pair(table[0]);
  const double sum = pair.a + pair.b - table[1];
  std::printf("%.3f %.3f\\n", sum, power<3>(sum));
}
"""


class Switch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        place = pathlib.Path(cls.folder.name)
        wanted = ("sign", "constant", "factor")
        cls.mutants = dict(enumerate((m for m in mutants_of("main.cpp", PROGRAM) if m.operator.startswith(wanted)), 1))
        (place / "switch.hpp").write_text(SWITCH)
        (place / "main.cpp").write_text(PROGRAM)
        (place / "mutated.cpp").write_text(numbered(PROGRAM, cls.mutants, place / "switch.hpp"))
        for name in ("main", "mutated"):
            subprocess.run(["g++", "-std=c++20", "-O0", place / f"{name}.cpp", "-o", place / name], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_program(self, name, **environment):
        return subprocess.run([pathlib.Path(self.folder.name) / name], check=True, capture_output=True, text=True,
                              env=os.environ | environment).stdout

    def test_a_list_of_constant_texts_stays_one(self):
        text = 'constexpr const char* names[] = {"solid", "dashed"};\nconstexpr double list[] = {0.5};\n'
        found = {n: m for n, m in enumerate(mutants_of("a.cpp", text), 1)}
        self.assertTrue(found)
        new = numbered(text, found, "switch.hpp")
        self.assertNotIn("const const", new)
        self.assertIn("inline const double", new)

    def test_off_changes_nothing(self):
        self.assertEqual(self.run_program("mutated"), self.run_program("main"))

    def test_each_lives_alone(self):
        outputs = {n: self.run_program("mutated", PLUMB_MUTANT=str(n)) for n in self.mutants}
        usual = self.run_program("main")
        self.assertEqual({self.mutants[n].after for n, o in outputs.items() if o == usual}, set())
        self.assertGreater(len(self.mutants), 10)
        expected = {": a(x - 1), b(2 * x) {}": "1.000 1.000", "1.6500000000000001,": "3.450 41.064",
                    "const double sum = pair.a + pair.b + table[1];": "8.000 512.000"}
        found = {m.after: outputs[n].strip() for n, m in self.mutants.items()}
        self.assertEqual({k: found[k] for k in expected}, expected)

    def test_seen_places_are_marked(self):
        seen = pathlib.Path(self.folder.name) / "seen"
        seen.write_bytes(bytes(trial.SEEN))
        self.run_program("mutated", PLUMB_MUTANTS_SEEN=str(seen))
        marked = {n for n, b in enumerate(seen.read_bytes()) if b}
        self.assertEqual(marked, set(self.mutants))


class Bookkeeping(unittest.TestCase):
    def test_interval(self):
        self.assertEqual(score.wilson(28, 54), [0.3885, 0.6461])  # by hand: (0.5173 +- 0.1288)
        self.assertEqual(score.wilson(0, 10), [0.0, 0.2775])
        self.assertEqual(score.wilson(10, 10), [0.7225, 1.0])
        self.assertIsNone(score.wilson(0, 0))

    def test_counts(self):
        rows = [{"file": "lib/schemes/tlsph/time/a.cpp", "state": s} for s in ("killed", "killed", "alive", "equivalent", "not compiled")]
        rows.append({"file": "mms/b.cpp", "state": "killed"})
        found = score.score(rows, {"seed": 1})
        self.assertEqual([f["folder"] for f in found["folders"]], ["lib/schemes/tlsph/time", "mms"])
        self.assertEqual({k: found["folders"][0][k] for k in ("sampled", "killed", "alive", "equivalent", "not_compiled", "share")},
                         {"sampled": 5, "killed": 2, "alive": 1, "equivalent": 1, "not_compiled": 1, "share": 0.6667})
        self.assertEqual(found["all"]["killed"], 3)

    def test_the_same_seed_draws_the_same(self):
        found = mutants_of("main.cpp", PROGRAM)
        self.assertEqual(draw(found, 5, 3), draw(list(reversed(found)), 5, 3))
        self.assertNotEqual(draw(found, 5, 3), draw(found, 5, 4))
        places = [m.start for m in draw(found, 1000, 3)]
        self.assertEqual(len(places), len(set(places)))

    def test_errors_name_their_mutants(self):
        mutants = dict(enumerate(mutants_of("lib/a.cpp", PROGRAM), 1))
        log = ("[1/9] g++ a\nFAILED: a.o\nIn file included from b.hpp:1:\nplumb_mutant_3:7:2: error: no\nplumb_mutant_4:7:2: note: but\n"
               "[2/9] g++ c\nplumb_mutant_5:1:1: warning: well\n")
        self.assertEqual(workshop.culprits(log, mutants), {3})
        constexpr = {n for n, m in mutants.items() if m.region.constexpr >= 0}
        self.assertEqual(workshop.culprits("FAILED: a.o\nlib/a.cpp:4: error: not a constant\n", mutants), constexpr)


if __name__ == "__main__":
    unittest.main()
