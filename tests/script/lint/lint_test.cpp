#include <gtest/gtest.h>

#include "script/lint/lint.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script::lint {

// The platform's own applications are right.
TEST(LintApplications, that_are_right_give_no_alarm) {
  for (const auto* name :
       {"config/apps/receptionist", "tests/fixtures/paper/app",
        "tests/fixtures/paper/staff"}) {
    auto compiled =
        compile_application(test::source_path(name), test::platform());
    ASSERT_TRUE(compiled.program) << name;
    lint(compiled, {});
    for (const auto& finding : compiled.findings.all())
      ADD_FAILURE() << to_string(finding);
  }
}

TEST(LintFiles, that_are_part_of_something_are_not_judged_as_a_whole) {
  for (const auto* name : {"fig7-slot", "post-nlu", "transit-if",
                           "post-microphone", "querydb-staff"}) {
    auto compiled = compile_file(
        test::source_path("tests/fixtures/paper/" + std::string(name) + ".xml"),
        test::platform());
    const auto before = compiled.findings.all().size();
    lint(compiled, {});
    EXPECT_EQ(compiled.findings.all().size(), before) << name;
  }
}

} // namespace parlour::script::lint
