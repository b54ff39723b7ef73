#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/nlu/grammar/example_file.hpp"
#include "adapters/nlu/grammar/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ExampleFile : public testing::Test {
protected:
  ExampleFile() {
    model_.topics = {{"Visit", false, {{"Host", "", {}, "", true, false}}, {}},
                     {"Weather", true, {}, {"will it rain"}}};
  }

  // What is wrong with a file of this text: "line:column: message".
  std::vector<std::string> add(const std::string& text) {
    folder_.write("more.tsv", text);
    std::vector<std::string> wrong;
    for (const auto& error :
         add_example_file(folder_.path() / "more.tsv", model_))
      wrong.push_back(std::to_string(error.place.line) + ':' +
                      std::to_string(error.place.column) + ": " +
                      error.message);
    return wrong;
  }

  parlour::test::TemporaryFolder folder_;
  UnderstandingModel model_;
};

TEST_F(ExampleFile, AddsToItsTopics) {
  EXPECT_THAT(add("\xEF\xBB\xBF# of the desk\n\nVisit\tI meet [Ada](Host)\r\n"
                  "Weather\tis it hot"),
              IsEmpty());
  EXPECT_THAT(model_.topics[0].examples, ElementsAre("I meet [Ada](Host)"));
  EXPECT_THAT(model_.topics[1].examples,
              ElementsAre("will it rain", "is it hot"));
}

TEST_F(ExampleFile, TellsWhatIsWrongAndWhere) {
  EXPECT_THAT(
      add("Visit\tto meet [Ada](Host)\n"
          "will it be hot\n"
          "Wether\tis it hot\n"
          "Visit\tsee [Ada] now\n"
          "Visit\t\xC3\x84 [Ada](Host) or [Bob](Hots)\n"
          "Weather\t \n"
          "Weather\tcaf\xE9\n"),
      ElementsAre("2:1: a line is a topic, a tab, and the example's text",
                  "3:1: there is no topic 'Wether', did you mean 'Weather'?",
                  "4:11: a slot's words are marked like this: [words](Slot)",
                  "5:30: the topic 'Visit' has no slot 'Hots', did you mean "
                  "'Host'?",
                  "6:1: a line is a topic, a tab, and the example's text",
                  "7:12: this is not UTF-8; save the file as UTF-8"));
  EXPECT_EQ(model_.topics[0].examples.size(), 1U);
  EXPECT_EQ(model_.topics[1].examples.size(), 1U);
}

TEST_F(ExampleFile, HasBounds) {
  const std::string longest(max_example_bytes, 'a');
  EXPECT_THAT(add("Weather\t" + longest + "\nWeather\t" + longest + "a\n"),
              ElementsAre("2:9: an example has at most 1000 bytes"));
  std::string many;
  for (int line = 0; line < 200; ++line)
    many += "nothing\n";
  EXPECT_EQ(add(many).size(), 100U);
  EXPECT_THAT(add(std::string(max_example_file_bytes + 1, '\n')),
              ElementsAre("0:0: this file is larger than 8 MB"));
}

TEST_F(ExampleFile, MissesTheFile) {
  const auto wrong = add_example_file(folder_.path(), model_);
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_EQ(wrong[0].kind, ErrorKind::file);
  EXPECT_THAT(wrong[0].message, HasSubstr("this is a folder, not a file"));
}

class WordingFile : public ExampleFile {
protected:
  // What is wrong with a file of this text.
  std::vector<std::string> read(const std::string& text) {
    folder_.write("wordings.tsv", text);
    std::vector<std::string> wrong;
    for (const auto& error :
         read_wording_file(folder_.path() / "wordings.tsv", model_, wordings_))
      wrong.push_back(std::to_string(error.place.line) + ':' +
                      std::to_string(error.place.column) + ": " +
                      error.message);
    return wrong;
  }

  std::vector<Wording> wordings_;
};

TEST_F(WordingFile, HasConstantsBehindTheTopic) {
  model_.topics[0].slots.push_back({"Floor", "", {}, "", false, false});
  EXPECT_THAT(read("# of the desk\n"
                   "Weather\twill I get wet\n"
                   "Visit Host=\"Ada King\"  Floor=3\tthe [boss](Host)\r\n"),
              IsEmpty());
  const Wording plain{"Weather", {}, "will I get wet"};
  const Wording full{
      "Visit",
      {{"Floor", Value(std::int64_t{3})}, {"Host", Value("Ada King")}},
      "the [boss](Host)"};
  EXPECT_THAT(wordings_, ElementsAre(plain, full));
  EXPECT_THAT(model_.topics[0].examples, IsEmpty());
}

TEST_F(WordingFile, TellsWhatIsWrongAndWhere) {
  const std::string written =
      "a slot's value is written Slot=value or Slot=\"some value\"";
  EXPECT_THAT(
      read("Visit Hots=Ada\tto see her\n"
           "Visit Host\tto see her\n"
           "Visit Host=\tto see her\n"
           "Visit Host=\"Ada\tto see her\"\n"
           "Wether Host=Ada\tis it hot\n"),
      ElementsAre("1:7: the topic 'Visit' has no slot 'Hots', did you mean "
                  "'Host'?",
                  "2:7: " + written, "3:7: " + written, "4:7: " + written,
                  "5:1: there is no topic 'Wether', did you mean 'Weather'?"));
  EXPECT_THAT(wordings_, IsEmpty());
}

} // namespace
} // namespace parlour::adapters::nlu
