#include "tests/tools/bench/nlu/data_folder.hpp"
#include "tools/bench/nlu/desk_data.hpp"

namespace parlour::tools {
namespace {

using DeskDataTest = DataFolderTest;

TEST_F(DeskDataTest, HoldsWholeTemplatesBack) {
  std::string rows;
  for (const std::string verb : {"call", "dial", "ring", "page", "reach"})
    for (const std::string name : {"ann", "bob"})
      rows += R"({"text": ")" + verb + " " + name + " lee" +
              R"(", "intent": "call", "toks": [")" + verb + R"(", ")" + name +
              R"(", "lee"], "tags": ["O", "B-person", "I-person"]})" + "\n";
  rows += R"({"text": "hi", "intent": "greeting", "toks": ["hi"],)"
          R"( "tags": ["O"]})";
  write("desk/train.jsonl", rows);
  write("desk/gazetteer.json", R"({"person": ["ann lee", "bob lee"]})");
  const auto sets = read_desk(folder(), DataPart::test);
  ASSERT_TRUE(sets) << to_string(sets.error());
  ASSERT_EQ(sets->size(), 4U);
  std::size_t measured = 0;
  for (const auto& set : *sets) {
    measured += set.texts.size();
    ASSERT_EQ(set.model.topics.size(), 1U);
    EXPECT_EQ(set.model.topics[0].slots[0].source, "db:desk.person");
    EXPECT_EQ(set.columns("db:desk.person")->size(), 2U);
    for (const auto& example : set.model.topics[0].examples)
      for (const auto& text : set.texts)
        EXPECT_FALSE(example.starts_with(text.text.substr(0, 4))) << example;
  }
  EXPECT_EQ(measured, 11U);
  EXPECT_EQ(sets->at(0).model.topics[0].examples[0], "dial [ann lee](person)");
  EXPECT_EQ(sets->at(1).texts.back().topic, "greet");
}

TEST_F(DeskDataTest, SaysWhatIsNotThere) {
  EXPECT_FALSE(read_desk(folder(), DataPart::test));
  write("desk/train.jsonl", "{}\n");
  EXPECT_FALSE(read_desk(folder(), DataPart::test));
}

} // namespace
} // namespace parlour::tools
