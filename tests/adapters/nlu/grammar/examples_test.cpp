#include <gtest/gtest.h>

#include "adapters/nlu/grammar/examples.hpp"

namespace parlour::adapters::nlu {
namespace {

std::string text(const jsgf::Node& node) {
  std::string joined;
  for (const auto& child : node.children)
    joined += (joined.empty() ? "" : " ") +
              std::string(child.kind == jsgf::NodeKind::word ? "" : "@") +
              child.text;
  return joined;
}

TEST(Examples, BecomeRules) {
  TopicModel topic;
  topic.name = "T";
  std::vector<Error> errors;
  const auto rules = example_rules(
      topic, "I'm [David](Visitor) from [Comptec](Firm), please", errors);
  EXPECT_TRUE(errors.empty());
  EXPECT_EQ(text(rules.whole), "i am @T.Visitor from @T.Firm please");
  ASSERT_EQ(rules.parts.size(), 2U);
  EXPECT_EQ(text(rules.parts[0]), "i am @T.Visitor");
  EXPECT_EQ(text(rules.parts[1]), "from @T.Firm");
}

TEST(Examples, AreNotTooLong) {
  TopicModel topic;
  topic.name = "T";
  std::vector<Error> errors;
  example_rules(topic, std::string(max_example_bytes + 1, 'a'), errors);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].message.find("has more than 1000 bytes"),
            std::string::npos);
}

TEST(Examples, SayHowSlotsAreMarked) {
  std::vector<Error> errors;
  example_rules({}, "I am [David]", errors);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].message.find("[words](Slot)"), std::string::npos);
}

} // namespace
} // namespace parlour::adapters::nlu
