#include <fmt/format.h>

#include "tests/tools/bench/nlu/data_folder.hpp"
#include "tools/bench/nlu/labelled_data.hpp"

namespace parlour::tools {
namespace {

using LabelledDataTest = DataFolderTest;

TEST_F(LabelledDataTest, ReadsTagsAsSlots) {
  write("ATIS/train/seq.in", "to new york city now\n");
  write("ATIS/train/label", "atis_flight\n");
  write("ATIS/train/seq.out", "O B-toloc.city I-toloc.city I-toloc.city O\n");
  write("ATIS/valid/seq.in", "to boston today\nby bus\n");
  write("ATIS/valid/label", "atis_flight\natis_ground\n");
  write("ATIS/valid/seq.out", "O B-toloc.city B-date\nO O\n");
  const auto sets = read_atis(folder(), DataPart::validation);
  ASSERT_TRUE(sets) << to_string(sets.error());
  const auto& data = sets->at(0);
  ASSERT_EQ(data.model.topics.size(), 1U);
  EXPECT_EQ(data.model.topics[0].examples[0],
            "to [new york city](toloc_city) now");
  EXPECT_EQ(data.model.topics[0].slots[0].name, "toloc_city");
  ASSERT_EQ(data.texts.size(), 2U);
  ASSERT_EQ(data.texts[0].slots.size(), 2U);
  EXPECT_EQ(data.texts[0].slots[1],
            std::pair(std::string("date"), std::string("today")));
  EXPECT_TRUE(data.texts[1].slots.empty());
}

TEST_F(LabelledDataTest, ReadsTenOfATopic) {
  for (const std::string set : {"BANKING77", "CLINC150", "HWU64"})
    for (const std::string part : {"train_10", "train", "test"}) {
      const auto place = fmt::format("Datasets/{}/{}", set, part);
      write(place + "/seq.in", part + " one\n");
      write(place + "/label", "topic\n");
    }
  for (const auto read : {read_ten_of_banking, read_ten_of_clinc}) {
    const auto sets = read(folder(), DataPart::test);
    ASSERT_TRUE(sets);
    EXPECT_EQ(sets->at(0).model.topics[0].examples[0], "train_10 one");
    EXPECT_EQ(sets->at(0).texts[0].text, "test one");
  }
  EXPECT_EQ(
      read_hwu(folder(), DataPart::test)->at(0).model.topics[0].examples[0],
      "train one");
}

TEST_F(LabelledDataTest, ReadsCommasWithinQuotes) {
  std::string rows = "text,category\n";
  for (int row = 0; row < 9; ++row)
    rows += "plain,a\n";
  write("banking_data/train.csv",
        rows + "\"well, \"\"what\"\"\nis it\",card\n");
  write("banking_data/test.csv", "text,category\nhow,card\n");
  const auto sets = read_banking(folder(), DataPart::test);
  ASSERT_TRUE(sets);
  ASSERT_EQ(sets->at(0).model.topics.size(), 2U);
  EXPECT_EQ(sets->at(0).model.topics[1].examples[0], "well, what is it");
  EXPECT_EQ(sets->at(0).texts[0].text, "how");
  // Every tenth is held out.
  EXPECT_EQ(read_banking(folder(), DataPart::validation)->at(0).texts.size(),
            1U);
}

TEST_F(LabelledDataTest, ReadsCorpora) {
  for (const std::string name : {"Chatbot", "AskUbuntu", "WebApplications"})
    write(name + "Corpus.json", R"({"sentences": [
      {"text": "a", "intent": "X", "training": true},
      {"text": "b", "intent": "None", "training": true},
      {"text": "c", "intent": "X", "training": false},
      {"text": "d", "intent": "None", "training": false}]})");
  const auto sets = read_corpora(folder(), DataPart::test);
  ASSERT_TRUE(sets);
  ASSERT_EQ(sets->size(), 3U);
  EXPECT_EQ(sets->at(0).model.topics.size(), 1U);
  EXPECT_EQ(sets->at(0).texts.at(0).topic, "X");
  EXPECT_EQ(sets->at(0).texts.at(1).topic, "");
  // Of three sets, in five turns.
  EXPECT_EQ(read_corpora(folder(), DataPart::validation)->size(), 15U);
}

TEST_F(LabelledDataTest, ReadsAWordAndItsTagALine) {
  write("mit-restaurant/500-shot-train.txt",
        "-DOCSTART- O\r\n\r\nany O\r\nice B-Cuisine\r\ncream I-Cuisine\r\n\r\n"
        "open B-Hours\r\n");
  write("mit-restaurant/test.txt", "-DOCSTART- O\n\nthai B-Cuisine\n\n");
  const auto sets = read_restaurants(folder(), DataPart::test);
  ASSERT_TRUE(sets);
  const auto& topic = sets->at(0).model.topics.at(0);
  ASSERT_EQ(topic.examples.size(), 2U);
  EXPECT_EQ(topic.examples[0], "any [ice cream](Cuisine)");
  EXPECT_EQ(topic.examples[1], "[open](Hours)");
  EXPECT_EQ(topic.slots.size(), 2U);
  ASSERT_EQ(sets->at(0).texts.size(), 1U);
  EXPECT_EQ(sets->at(0).texts[0].text, "thai");
  EXPECT_EQ(sets->at(0).texts[0].slots.size(), 1U);
}

TEST_F(LabelledDataTest, SaysWhatIsNotThere) {
  for (const auto read :
       {read_banking, read_hwu, read_atis, read_corpora, read_ten_of_banking,
        read_ten_of_clinc, read_restaurants, read_films})
    EXPECT_FALSE(read(folder(), DataPart::test));
  write("AskUbuntuCorpus.json", "moo");
  write("ChatbotCorpus.json", "moo");
  EXPECT_FALSE(read_corpora(folder(), DataPart::test));
}

} // namespace
} // namespace parlour::tools
