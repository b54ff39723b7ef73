#include "adapters/nlu/encoder/dense.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace parlour::adapters::nlu {

static_assert(std::endian::native == std::endian::little,
              "the numbers of the file are little-endian");

namespace {

// The largest integer that a number which goes in becomes.
constexpr std::int32_t largest_input = 8191;
// With as many, a sum always has room in 32 bits.
constexpr std::size_t most_inputs =
    std::numeric_limits<std::int32_t>::max() / (largest_input * 128);
// How many products are added side by side, and how many rows are worked on
// with the same weights. Rows of integers are filled up with zeros to multiples
// of both.
constexpr std::size_t lanes = 8;
constexpr std::size_t together = 4;
using Sums = std::array<std::int32_t, together>;

std::size_t filled_up(std::size_t count, std::size_t multiple) {
  return (count + multiple - 1) / multiple * multiple;
}

// Rows as integers, and what one of them is worth in each row.
struct IntegerRows {
  explicit IntegerRows(const Rows& rows)
      : width(filled_up(rows.width, lanes)), steps(rows.count()),
        integers(filled_up(rows.count(), together) * width) {
    for (std::size_t at = 0; at < rows.count(); ++at)
      fill(at, rows.row(at), rows.width);
  }

  void fill(std::size_t at, const float* numbers, std::size_t count) {
    float largest = 0;
    for (std::size_t column = 0; column < count; ++column)
      largest = std::max(largest, std::abs(numbers[column]));
    const auto scale = largest_input / largest;
    if (!(largest > 0) || !std::isfinite(largest) || !std::isfinite(scale))
      return;
    steps[at] = largest / largest_input;
    for (std::size_t column = 0; column < count; ++column)
      if (!std::isnan(numbers[column]))
        integers[at * width + column] =
            static_cast<std::int16_t>(std::lrint(numbers[column] * scale));
  }

  std::size_t width;
  std::vector<float> steps;
  std::vector<std::int16_t> integers;
};

// The sums of the products of weights and each of the rows that lie one behind
// the other. Compilers find no good instructions for it at the level that all
// else is well with.
#ifdef __SSE2__
__m128i eight(const std::int16_t* integers) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(integers));
}

std::int32_t sum_of(__m128i four) {
  four = _mm_add_epi32(four, _mm_shuffle_epi32(four, 0b01001110));
  four = _mm_add_epi32(four, _mm_shuffle_epi32(four, 0b10110001));
  return _mm_cvtsi128_si32(four);
}

Sums products(const std::int16_t* weights, const std::int16_t* rows,
              std::size_t width) {
  auto first = _mm_setzero_si128();
  auto second = first;
  auto third = first;
  auto fourth = first;
  for (std::size_t at = 0; at < width; at += lanes) {
    const auto weight = eight(weights + at);
    const auto add = [&](__m128i& sums, std::size_t row) {
      sums = _mm_add_epi32(
          sums, _mm_madd_epi16(weight, eight(rows + row * width + at)));
    };
    add(first, 0);
    add(second, 1);
    add(third, 2);
    add(fourth, 3);
  }
  return {sum_of(first), sum_of(second), sum_of(third), sum_of(fourth)};
}
#else
Sums products(const std::int16_t* weights, const std::int16_t* rows,
              std::size_t width) {
  Sums sums{};
  for (std::size_t row = 0; row < together; ++row)
    for (std::size_t at = 0; at < width; ++at)
      sums[row] += weights[at] * rows[row * width + at];
  return sums;
}
#endif

} // namespace

std::vector<float> read_numbers(ByteReader& reader, std::size_t count) {
  const auto bytes = reader.block();
  if (reader.ok() && bytes.size() != count * sizeof(float))
    reader.fail("there should be " + std::to_string(count) + " numbers");
  std::vector<float> made;
  if (!reader.ok())
    return made;
  made.resize(count);
  std::memcpy(made.data(), bytes.data(), bytes.size());
  if (std::ranges::any_of(made, [](float one) { return !std::isfinite(one); }))
    reader.fail("a number is not finite");
  return made;
}

ByteTable ByteTable::read(ByteReader& reader) {
  ByteTable made;
  const auto rows = reader.count("rows");
  made.columns_ = reader.count("columns");
  made.steps_ = read_numbers(reader, rows);
  const auto bytes = reader.block();
  if (reader.ok() && (made.columns_ == 0 || bytes.size() % made.columns_ != 0 ||
                      bytes.size() / made.columns_ != rows))
    reader.fail("a table has too few bytes, or too many");
  if (!reader.ok())
    return {};
  made.bytes_.resize(bytes.size());
  std::memcpy(made.bytes_.data(), bytes.data(), bytes.size());
  return made;
}

Dense Dense::read(ByteReader& reader) {
  Dense made;
  const auto table = ByteTable::read(reader);
  if (table.columns() > most_inputs)
    reader.fail("a layer has too many inputs");
  made.added_ = read_numbers(reader, table.rows());
  if (!reader.ok())
    return {};
  made.inputs_ = table.columns();
  const auto width = filled_up(made.inputs_, lanes);
  made.weights_.resize(table.rows() * width);
  for (std::size_t output = 0; output < table.rows(); ++output) {
    made.steps_.push_back(table.step(output));
    std::copy_n(table.row(output), made.inputs_,
                made.weights_.begin() +
                    static_cast<std::ptrdiff_t>(output * width));
  }
  return made;
}

// The weights of one output after the other, since they are most of the memory.
Rows Dense::apply(const Rows& rows) const {
  Rows made(rows.count(), outputs());
  const IntegerRows inputs(rows);
  for (std::size_t output = 0; output < outputs(); ++output)
    for (std::size_t first = 0; first < rows.count(); first += together) {
      const auto sums =
          products(&weights_[output * inputs.width],
                   &inputs.integers[first * inputs.width], inputs.width);
      const auto count = std::min(together, rows.count() - first);
      for (std::size_t at = first; at < first + count; ++at)
        made.row(at)[output] = static_cast<float>(sums[at - first]) *
                                   (inputs.steps[at] * steps_[output]) +
                               added_[output];
    }
  return made;
}

} // namespace parlour::adapters::nlu
