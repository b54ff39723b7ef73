// LintCase: a table of small scripts and what lint finds in them.
#pragma once

#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "script/lint/passes.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script::lint {

struct Linted {
  const char* dialogue; // inside of <dialogue>
  const char* said;     // "line:column name", each; empty: nothing
};

inline std::ostream& operator<<(std::ostream& stream, const Linted& linted) {
  return stream << linted.dialogue;
}

inline std::string lints_of(const std::string& dialogue,
                            const std::string& start = "Welcome") {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings start='" + start +
                                   "'><Scripts><Script>a.xml</Script>"
                                   "</Scripts><agents><agent name='Porter' "
                                   "roles='Robot'/></agents></settings>");
  folder.write("a.xml", "<dialogue>\n<state name='Welcome'/>\n" + dialogue +
                            "\n</dialogue>");
  auto compiled = compile_application(folder.path(), test::platform());
  EXPECT_FALSE(compiled.findings.has_errors())
      << to_string(compiled.findings.all().front());
  lint(compiled, {});
  std::string said;
  for (const auto& finding : compiled.findings.all())
    said += (said.empty() ? "" : ", ") + std::to_string(finding.place.line) +
            ":" + std::to_string(finding.place.column) + " " + finding.name;
  return said;
}

inline std::string in_main(const std::string& body) {
  return "<function name='main'>" + body + "</function>";
}

class LintCase : public testing::TestWithParam<Linted> {};

} // namespace parlour::script::lint
