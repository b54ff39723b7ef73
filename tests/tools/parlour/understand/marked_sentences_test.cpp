#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/console/line_reader.hpp"
#include "tools/parlour/understand/marked_sentences.hpp"

namespace parlour::tools {
namespace {

Expected<std::vector<MarkedSentence>> read(const std::string& text) {
  std::istringstream in(text);
  return read_marked_sentences(in, "own.jsonl");
}

TEST(MarkedSentences, HaveAnIntentSlotsAndAContext) {
  const auto read_all =
      read("{\"text\": \"six\", \"topic\": \"Taxi\", \"slots\": {\"Time\": "
           "\"06:00\"}, \"context\": {\"current\": \"Taxi\"}}\n\n"
           "{\"text\": \"yes\", \"act\": \"confirm\", \"id\": 7}\n"
           "{\"text\": \"a cab\", \"intent\": \"Taxi\"}\n"
           "{\"text\": \"moo\", \"topic\": null}\n");
  ASSERT_TRUE(read_all);
  const auto& all = *read_all;
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(intent_of(all[0]), "Taxi");
  EXPECT_EQ(all[0].slots.find("Time")->text(), "06:00");
  EXPECT_EQ(all[0].context.find("current")->text(), "Taxi");
  EXPECT_EQ(intent_of(all[1]), "confirm");
  EXPECT_EQ(all[1].line, 3u);
  EXPECT_EQ(intent_of(all[2]), "Taxi");
  EXPECT_EQ(intent_of(all[3]), "nothing");
}

TEST(MarkedSentences, TellTheLineOfAMistake) {
  const auto too_long =
      "{\"text\": \"a\"}\n" + std::string(longest_line + 1, ' ');
  for (const auto* wrong :
       {"{\"text\": \"a\"}\n{\"text\": ", "{\"text\": \"a\"}\n[1]",
        "{\"text\": \"a\"}\n{\"topic\": \"Taxi\"}",
        "{\"text\": \"a\"}\n{\"text\": \"b\", \"acts\": []}",
        "{\"text\": \"a\"}\n{\"text\": \"b\", \"slots\": [1]}",
        too_long.c_str()}) {
    const auto made = read(wrong);
    ASSERT_FALSE(made) << wrong;
    EXPECT_EQ(made.error().place.file, "own.jsonl");
    EXPECT_EQ(made.error().place.line, 2u);
  }
}

} // namespace
} // namespace parlour::tools
