"""Tests which sources tools/cmake/unite.py compiles together. Alone:
python3 tests/tools/cmake/unite_test.py"""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tools/cmake"))
from unite import choice, united


def helper(code, rest=""):
    return f"namespace here {{\nnamespace {{\n{code}\n}}\n{rest}\n}}\n"


class Unite(unittest.TestCase):
    def pieces(self, *codes, limit=8, folders=None):
        """The numbers of the sources that come together, by pieces."""
        with tempfile.TemporaryDirectory() as folder:
            names = []
            for number, code in enumerate(codes):
                room = Path(folder, folders[number] if folders else "room")
                room.mkdir(exist_ok=True)
                names.append(str(room / f"{number}.cpp"))
                Path(names[-1]).write_text(code)
            return [[int(Path(source).stem) for source in piece.sources]
                    for piece in united(names, limit)]

    def assert_apart(self, one, other):
        self.assertEqual([[0], [1]], self.pieces(one, other))

    def assert_together(self, one, other):
        self.assertEqual([[0, 1]], self.pieces(one, other))

    def test_sources_without_names_of_their_own_come_together(self):
        self.assert_together("int one() { return 1; }", "int two();")

    def test_no_piece_has_more_sources_than_the_limit(self):
        self.assertEqual([[0, 1], [2, 3], [4]],
                         self.pieces(*["int x();"] * 5, limit=2))

    def test_helpers_of_one_name_are_compiled_apart(self):
        for code in ("int run(int x) { return x; }", "struct run { int x; };",
                     "enum class run { a, b };", "using run = int;",
                     "constexpr int run = 3;", "const char* run[] = {0};",
                     "template <typename T> void run(T x) {}",
                     "template <class T> struct run { T x; };",
                     "int other() { return 0; }\nint run() { return 1; }"):
            self.assert_apart(helper(code), helper(code))

    def test_a_helper_stays_away_from_sources_that_mention_its_name(self):
        source = "int far(int run) { return run; }"
        for code in ("struct run { int x; };", "constexpr int run = 3;",
                     "const int run = made();", "const int run{made()};",
                     "enum class run { a, b };", "using run = int;"):
            self.assert_apart(helper(code), source)
            self.assert_apart(source, helper(code))

    def test_a_function_stays_away_from_sources_that_call_its_name(self):
        for source in ("int far() { return run(1); }", "int run(int);",
                       "struct run { int x; };\nint x(run y);",
                       helper("struct run { int x; };")):
            self.assert_apart(helper("int run();"), source)
            self.assert_apart(source, helper("int run();"))
        self.assert_together(helper("int run();"),
                             "int far(int run) { return run; }")

    def test_members_and_what_is_in_classes_are_other_names(self):
        for source in ("int far(X& x) { return x.run(); }",
                       "int far(X* x) { return x->run(); }",
                       "int far() { return X::run; }"):
            self.assert_together(helper("int run();"), source)
            self.assert_together(helper("constexpr int run = 3;"), source)
        code = helper("int X::run(int x) const { return x; }")
        self.assert_together(code, code.replace("X", "Y"))

    def test_what_stands_in_texts_comments_and_bodies_does_not_count(self):
        for source in ('const char* text = "run";', "// run\nint x();",
                       "/* run */ int x();", 'auto text = R"xml(" run)xml";'):
            self.assert_together(helper("int run();"), source)
        self.assert_together(helper("int one() { int x = 0; return x; }"),
                             helper("int two() { int x = 1; return x; }"))

    def test_names_outside_of_unnamed_namespaces_belong_to_all(self):
        self.assert_together(helper("", "int run();"),
                             helper("", "int go() { return run(); }"))

    def test_macros_are_kept_away_from_their_names(self):
        self.assert_apart("#define HOW 1\n", "int HOW;")

    def test_opened_namespaces_are_kept_apart(self):
        opened = "using namespace far;\n"
        self.assert_apart(opened, opened)
        self.assert_together(opened, "int x();")
        literals = "using namespace std::chrono_literals;\n"
        self.assert_together(literals, literals)

    def test_what_opens_an_enumeration_is_compiled_alone(self):
        self.assert_apart("using enum X;\n", "int x();")
        self.assert_together("void f() {\n  using enum X;\n}\n", "int x();")

    def test_operators_are_kept_apart(self):
        code = helper("bool operator==(A, A) { return true; }")
        self.assert_apart(code, code)

    def test_tests_are_no_names(self):
        self.assert_together(helper("TEST(A, B) { int x; }"),
                             helper("TEST(A, C) { int x; }"))

    def test_sources_of_a_folder_come_first(self):
        self.assertEqual([[0, 2], [1, 3]],
                         self.pieces(*["int x();"] * 4, limit=2,
                                     folders=["a", "b", "a", "b"]))

    def test_what_is_left_of_folders_comes_together(self):
        self.assertEqual([[0, 1]],
                         self.pieces("int x();", "int y();",
                                     folders=["a", "b"]))

    def test_each_target_has_pieces_of_its_own(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in "abcde":
                Path(folder, f"{name}.cpp").write_text(f"int {name}();")
            listed = [f"{target} {folder}/{name}.cpp"
                      for target, name in zip("xyxyz", "abcde")]
            self.assertEqual(
                [f"x 0 {folder}/a.cpp", f"x 0 {folder}/c.cpp",
                 f"y 0 {folder}/b.cpp", f"y 0 {folder}/d.cpp"],
                choice(listed, limit=8))


if __name__ == "__main__":
    unittest.main()
