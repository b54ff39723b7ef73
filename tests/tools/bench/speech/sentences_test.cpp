#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/bench/speech/sentences.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;

TEST(Sentences, have_kinds) {
  std::istringstream in("# a\tcomment\nours\tone two\n\nno kind\n"
                        "theirs\tthree\nours\tfour\n");
  const auto read = read_sentences(in);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_THAT(read.at("ours"), ElementsAre("one two", "four"));
  EXPECT_THAT(read.at("theirs"), ElementsAre("three"));
}

TEST(Sentences, of_the_bench_are_enough) {
  const auto read = read_sentences(std::filesystem::path(
      test::source_path("tests/tools/bench/speech/sentences.txt")));
  ASSERT_TRUE(read);
  EXPECT_GE(read->at("foreign").size(), 30u);
  EXPECT_GE(read->at("belongs").size(), 50u);
  EXPECT_FALSE(read_sentences(std::filesystem::path("/no/such/file")));
}

TEST(Digits, are_found_in_words_and_figures) {
  EXPECT_EQ(digits_in("Nine, one two 34."), "91234");
  EXPECT_EQ(digits_in("double five oh zero"), "5500");
  EXPECT_EQ(digits_in("my number is 9123-4567"), "91234567");
  EXPECT_EQ(digits_in("no, someone"), "");
}

} // namespace
} // namespace parlour::tools
