#include "tests/script/rows.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/script/margin.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::test {

namespace {

// The text as an attribute's value in XML.
std::string attribute(const std::string& text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == '&'    ? "&amp;"
               : c == '<'  ? "&lt;"
               : c == '"'  ? "&quot;"
               : c == '\n' ? std::string("&#10;")
                           : std::string(1, c);
  return '"' + escaped + '"';
}

std::string script_of(const std::vector<Row>& rows) {
  std::string text = "<function name='main'>";
  for (const auto& row : rows)
    text += "\n<try><var name='result' expr=" + attribute(row.expression) +
            "/><print param='{result}'/>"
            "<catch name='e'><print param='{e.kind}: {e.message}'/></catch>"
            "</try>";
  return text + "</function>";
}

} // namespace

void expect_rows(const std::vector<Row>& rows) {
  const auto outcome = compile_declarations(script_of(rows));
  for (const auto& line : outcome.lines)
    ADD_FAILURE() << line;
  ASSERT_TRUE(outcome.program);
  const auto run = run_script(outcome.program);
  for (const auto& [line, text] : run.errors)
    ADD_FAILURE() << "row " << line - 1 << ": " << text;
  std::istringstream printed(run.printed);
  for (const auto& row : rows) {
    std::string line;
    std::getline(printed, line);
    EXPECT_EQ(line, row.result) << row.expression;
  }
}

} // namespace parlour::test
