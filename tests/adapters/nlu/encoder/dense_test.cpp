#include <limits>
#include <random>

#include <gmock/gmock.h>

#include "adapters/nlu/encoder/dense.hpp"
#include "tests/adapters/nlu/encoder/small_encoder.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

Dense dense_of(const small::Table& weights, float step,
               const small::Numbers& added) {
  ByteWriter writer;
  small::write_table(writer, weights, step);
  small::write_numbers(writer, added);
  const auto bytes = writer.take();
  ByteReader reader(bytes);
  auto made = Dense::read(reader);
  EXPECT_TRUE(reader.ok() && reader.at_end());
  return made;
}

Rows rows_of(std::size_t width, const small::Numbers& numbers) {
  Rows rows(numbers.size() / width, width);
  rows.numbers = numbers;
  return rows;
}

TEST(Dense, AddsWeightedSums) {
  const auto dense = dense_of({{1, 2, 3}, {-4, 0, 4}}, 0.5F, {10, 20});
  EXPECT_EQ(dense.inputs(), 3U);
  EXPECT_EQ(dense.outputs(), 2U);
  const auto made = dense.apply(rows_of(3, {1, 1, 1, 0, 8191, -8191}));
  EXPECT_EQ(made.width, 2U);
  EXPECT_EQ(made.count(), 2U);
  EXPECT_NEAR(made.row(0)[0], 13, 0.01);
  EXPECT_NEAR(made.row(0)[1], 20, 0.01);
  EXPECT_NEAR(made.row(1)[0], 10 - 4095.5, 0.01);
  EXPECT_NEAR(made.row(1)[1], 20 - 2 * 8191, 0.01);
}

// Of widths and counts that fill no group of integers, too.
TEST(Dense, IsCloseToExactArithmetic) {
  std::mt19937 random(1);
  const auto number = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) -
           most;
  };
  for (const std::size_t width : {1U, 7U, 8U, 9U, 40U}) {
    small::Table weights(5, std::vector<signed char>(width));
    for (auto& row : weights)
      for (auto& weight : row)
        weight = static_cast<signed char>(number(127));
    const auto dense = dense_of(weights, 0.01F, small::Numbers(5));
    for (const std::size_t count : {1U, 3U, 4U, 6U}) {
      Rows rows(count, width);
      for (auto& one : rows.numbers)
        one = static_cast<float>(number(1000)) / 1000;
      const auto made = dense.apply(rows);
      for (std::size_t at = 0; at < count; ++at)
        for (std::size_t output = 0; output < 5; ++output) {
          float sum = 0;
          for (std::size_t column = 0; column < width; ++column)
            sum += 0.01F * static_cast<float>(weights[output][column]) *
                   rows.row(at)[column];
          EXPECT_NEAR(made.row(at)[output], sum, 0.01);
        }
    }
  }
}

TEST(Dense, TakesNothingForWhatIsNoNumber) {
  const auto dense = dense_of({{1, 1}}, 1, {7});
  const auto none = std::numeric_limits<float>::quiet_NaN();
  const auto endless = std::numeric_limits<float>::infinity();
  EXPECT_THAT(
      dense.apply(rows_of(2, {0, 0, endless, 1, none, 0, 1e-42F, 0})).numbers,
      Each(7));
  EXPECT_NEAR(dense.apply(rows_of(2, {none, 3})).numbers[0], 10, 0.01);
  EXPECT_THAT(dense.apply(Rows(0, 2)).numbers, ElementsAre());
}

std::string refusal_of(const std::string& bytes) {
  ByteReader reader(bytes);
  const auto made = Dense::read(reader);
  EXPECT_EQ(reader.ok(), made.outputs() != 0);
  return reader.ok() ? "" : reader.error().message;
}

TEST(Dense, IsRefusedIfAWeightIsNoNumber) {
  for (const auto bad : {std::numeric_limits<float>::quiet_NaN(),
                         std::numeric_limits<float>::infinity()}) {
    ByteWriter writer;
    small::write_dense(writer, {{1, 2}}, bad);
    EXPECT_THAT(refusal_of(writer.take()), HasSubstr("not finite"));
  }
}

TEST(Dense, IsRefusedIfItsPartsDoNotFit) {
  ByteWriter writer;
  small::write_dense(writer, {{1, 2}, {3, 4}}, 1);
  const auto whole = writer.take();
  EXPECT_EQ(refusal_of(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal_of(whole.substr(0, size)), "") << size;
  ByteWriter uneven;
  uneven.number(2);
  uneven.number(2);
  small::write_numbers(uneven, {1, 1});
  uneven.text("abc");
  EXPECT_THAT(refusal_of(uneven.take()), HasSubstr("too few bytes"));
  ByteWriter wide;
  small::write_dense(wide, small::zeros(1, 3000), 1);
  EXPECT_THAT(refusal_of(wide.take()), HasSubstr("too many inputs"));
}

} // namespace
} // namespace parlour::adapters::nlu
