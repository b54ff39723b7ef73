#include <gmock/gmock.h>

#include "script/compiler/application/environment_text.hpp"

namespace parlour::script {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string environment(const std::string& name) {
  return name == "HOME_OF" ? "Ann" : "";
}

struct Read {
  std::string text;
  std::vector<std::string> messages;
};

Read read(const std::string& value, Environment given = environment) {
  Findings findings;
  findings.add_file("s.xml");
  Attribute attribute;
  attribute.value = value;
  Read result{with_environment(attribute, given, findings), {}};
  for (const auto& finding : findings.all())
    result.messages.push_back(finding.message);
  return result;
}

TEST(EnvironmentText, ReplacesEachVariable) {
  EXPECT_EQ(read("a ${HOME_OF} and ${HOME_OF}!").text, "a Ann and Ann!");
  EXPECT_EQ(read("$ {} $HOME_OF").text, "$ {} $HOME_OF");
}

TEST(EnvironmentText, WarnsOfVariablesThatAreMissing) {
  const auto [text, messages] = read("x${NONE}y");
  EXPECT_EQ(text, "xy");
  EXPECT_THAT(messages, ElementsAre(HasSubstr("'NONE'")));
  EXPECT_THAT(read("${HOME_OF}", nullptr).messages,
              ElementsAre(HasSubstr("'HOME_OF'")));
}

TEST(EnvironmentText, ABraceThatIsNotClosedIsAnError) {
  EXPECT_THAT(read("${HOME_OF").messages, ElementsAre(HasSubstr("without")));
  EXPECT_THAT(read("plain").messages, IsEmpty());
}

} // namespace
} // namespace parlour::script
