#include <gtest/gtest.h>

#include "runtime/base/text/word_hash.hpp"

namespace parlour {
namespace {

std::uint64_t hash_of(std::initializer_list<std::string_view> texts) {
  WordHash hash;
  for (const auto text : texts)
    hash.add(text);
  return hash.value();
}

TEST(WordHash, IsTheSameOnEveryMachine) {
  EXPECT_EQ(hash_of({"a text of some length"}),
            hash_of({"a text of some length"}));
  EXPECT_EQ(hash_of({"parlour"}), 0xc2445fad8f20d917u);
}

TEST(WordHash, TellsTextsApartAlsoByWhereTheyEnd) {
  EXPECT_NE(hash_of({"ab", "c"}), hash_of({"a", "bc"}));
  EXPECT_NE(hash_of({""}), hash_of({}));
  EXPECT_NE(hash_of({"12345678"}), hash_of({"123456789"}));
  EXPECT_NE(hash_of({std::string_view("a\0", 2)}), hash_of({"a"}));
}

} // namespace
} // namespace parlour
