#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <gmock/gmock.h>

#include "adapters/nlu/encoder/sentence_encoder.hpp"
#include "tests/adapters/nlu/encoder/small_encoder.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

float likeness(const std::vector<float>& left,
               const std::vector<float>& right) {
  return std::inner_product(left.begin(), left.end(), right.begin(), 0.0F);
}

TEST(SentenceEncoder, SaysTheSameOfWhatMeansTheSame) {
  const auto encoder = small::small_encoder();
  const auto taxi = encoder->encode("i need a taxi");
  EXPECT_THAT(taxi, SizeIs(4));
  EXPECT_NEAR(likeness(taxi, taxi), 1, 1e-5);
  const auto cab = likeness(taxi, encoder->encode("i need a cab"));
  const auto bank = likeness(taxi, encoder->encode("i need a bank"));
  EXPECT_GT(cab, 0.95F);
  EXPECT_LT(bank, 0.8F);
  EXPECT_EQ(encoder->encode("i need a taxi"), taxi);
}

TEST(SentenceEncoder, ReadsAnyText) {
  const auto encoder = small::small_encoder();
  for (const auto& text : {std::string(), std::string(" "), std::string("zz"),
                           std::string(5000, 'a')})
    for (const auto number : encoder->encode(text))
      EXPECT_TRUE(std::isfinite(number)) << text.size();
}

// The norm makes each row 1, 2, 3, 4, and the mean of all rows is the same; it
// is added to what the row was.
TEST(SentenceEncoder, LetsRowsLookAtEachOther) {
  const auto layered = small::encoder_of(small::encoder_file_with_layer());
  ASSERT_TRUE(layered) << layered.error().message;
  const auto made = (*layered)->encode("taxi");
  // The numbers of "taxi" twice, and its place.
  const double sums[] = {200 + 0 + 1, 0 + 0 + 2, 0 + 1 + 3, 0 + 1 + 4};
  double length = 0;
  for (const auto sum : sums)
    length += std::pow(std::tanh(0.001 * sum), 2);
  for (std::size_t at = 0; at < 4; ++at)
    EXPECT_NEAR(made[at], std::tanh(0.001 * sums[at]) / std::sqrt(length),
                1e-3);
}

std::string refusal_of(const std::string& bytes) {
  const auto read = small::encoder_of(bytes);
  EXPECT_FALSE(read);
  if (read)
    return {};
  EXPECT_EQ(read.error().kind, ErrorKind::file);
  EXPECT_THAT(read.error().place.file, HasSubstr("sentences.encoder"));
  return read.error().message;
}

TEST(SentenceEncoder, IsRefusedIfTheFileIsAnother) {
  EXPECT_THAT(refusal_of(""), HasSubstr("tools/dependencies sentences"));
  EXPECT_THAT(refusal_of("PARLOURW"), HasSubstr("the mark"));
  EXPECT_THAT(refusal_of(small::small_encoder_file() + "x"),
              HasSubstr("more bytes than layers"));
  EXPECT_THAT(refusal_of(small::encoder_file_with_layer(0)),
              HasSubstr("heads"));
  EXPECT_THAT(refusal_of(small::encoder_file_with_layer(3)),
              HasSubstr("heads"));
}

TEST(SentenceEncoder, IsRefusedIfTheFileEndsTooEarly) {
  const auto whole = small::encoder_file_with_layer();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal_of(whole.substr(0, size)), "") << size;
}

TEST(SentenceEncoder, IsTheSameIfItsFileIs) {
  EXPECT_TRUE(*small::small_encoder() == *small::small_encoder());
  EXPECT_FALSE(*small::small_encoder() ==
               **small::encoder_of(small::encoder_file_with_layer()));
}

} // namespace
} // namespace parlour::adapters::nlu
