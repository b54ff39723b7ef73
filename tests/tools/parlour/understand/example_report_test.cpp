#include <gmock/gmock.h>

#include "tools/parlour/understand/example_report.hpp"

namespace parlour::tools {
namespace {

using adapters::nlu::LeftOutExample;
using testing::ElementsAre;
using testing::IsEmpty;

LeftOutExample understood(const std::string& topic,
                          const std::string& example) {
  return {topic, example, false, topic, 0.9, true};
}

TEST(ExampleReport, TopicsThatAreFineAreNotNamed) {
  std::vector<LeftOutExample> examples;
  for (const auto* example : {"a", "b", "c", "d", "e"})
    examples.push_back(understood("Taxi", example));
  EXPECT_THAT(example_report(examples),
              ElementsAre("5 examples of 1 topics. If each were not there, 5 "
                          "(100 %) would be understood, 0 taken for another "
                          "topic, 0 for none."));
}

TEST(ExampleReport, TellsWhatIsTakenForWhatAndWhatToAdd) {
  std::vector<LeftOutExample> examples;
  for (const auto* example : {"a", "b", "c"})
    examples.push_back(understood("Taxi", example));
  examples.push_back({"Taxi", "a ride", false, "Bus", 0.8, false, "the ride"});
  examples.push_back(
      {"Taxi", "get me there", false, "", 0, false, "", {"wheels"}});
  EXPECT_THAT(example_report(examples),
              ElementsAre("5 examples of 1 topics. If each were not there, 3 "
                          "(60 %) would be understood, 1 taken for another "
                          "topic, 1 for none.",
                          "", "Taxi: 3 of 5 understood",
                          "  not understood (1): \"get me there\"",
                          "  taken for Bus (1): \"a ride\"",
                          "    which has: \"the ride\"",
                          "  add another example with: wheels"));
}

TEST(ExampleReport, FewExamplesAndThoseThatSayTheSameAreTooFew) {
  std::vector<LeftOutExample> examples{understood("Few", "one")};
  for (const auto* example : {"a", "b", "c", "d", "e"}) {
    examples.push_back(understood("Same", example));
    examples.back().repeats = true;
  }
  EXPECT_THAT(
      example_report(examples),
      ElementsAre(testing::_, "", "Few: 1 of 1 understood",
                  "  add examples in other words: five to ten that differ do",
                  "", "Same: 5 of 5 understood",
                  "  the same but for values and small words (5): \"a\", "
                  "\"b\", \"c\" and 2 more",
                  "  put others in their place: they teach the same again"));
}

TEST(ExampleReport, TheWorstTopicIsTheFirst) {
  std::vector<LeftOutExample> examples{understood("A", "one")};
  examples.push_back({"B", "two", false, "", 0, false});
  const auto lines = example_report(examples);
  ASSERT_GE(lines.size(), 3u);
  EXPECT_EQ(lines[2], "B: 0 of 1 understood");
}

TEST(ExampleReport, NoExamplesAreNoReport) {
  EXPECT_THAT(example_report({}), IsEmpty());
}

} // namespace
} // namespace parlour::tools
