#include <gmock/gmock.h>

#include "adapters/nlu/learning/word_vectors.hpp"
#include "tests/adapters/nlu/learning/small_vectors.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::HasSubstr;

TEST(WordVectors, HaveTheNumbersOfTheirWords) {
  const auto vectors = test::small_vectors();
  const auto cab = vectors->find("cab");
  EXPECT_EQ(cab.steps, "\x4c\x66");
  EXPECT_FLOAT_EQ(cab.step, 1.0F / 127);
  EXPECT_EQ(cab.group, 1);
  EXPECT_EQ(cab.smaller_group, 1);
  for (const auto* word : {"taxi", "train", "bank"})
    EXPECT_NE(vectors->find(word).group, 0) << word;
}

TEST(WordVectors, HaveNothingOfOtherWords) {
  const auto vectors = test::small_vectors();
  for (const auto* word : {"", "cabs", "Cab", "zebra"})
    EXPECT_TRUE(vectors->find(word).steps.empty()) << word;
}

TEST(WordVectors, MayBeNone) {
  const auto vectors =
      test::vectors_of("PARLOURW" + test::bytes_of<std::uint64_t>(0));
  ASSERT_TRUE(vectors);
  EXPECT_TRUE((*vectors)->find("cab").steps.empty());
}

TEST(WordVectors, AreRefusedIfTheFileIsAnother) {
  const auto whole = test::small_vectors_file();
  auto other_mark = whole;
  other_mark[0] = 'p';
  for (const auto& bytes :
       {std::string(), whole.substr(0, 10), whole.substr(0, whole.size() - 1),
        whole + "x", other_mark}) {
    const auto vectors = test::vectors_of(bytes);
    ASSERT_FALSE(vectors);
    EXPECT_EQ(vectors.error().kind, ErrorKind::file);
    EXPECT_THAT(vectors.error().message, HasSubstr("tools/dependencies words"));
    EXPECT_THAT(vectors.error().place.file, HasSubstr("words.vectors"));
  }
}

} // namespace
} // namespace parlour::adapters::nlu
