#include "adapters/nlu/encoder/sentence_encoder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/base/text/word_hash.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::string_view file_mark = "PARLOURS";
constexpr std::size_t most_pieces = 128;
constexpr std::size_t most_layers = 16;
// Keeps a deviation of 0 from being divided by.
constexpr float smallest_variance = 1e-6F;
// The waves by which a row knows its place: the longest is as many times as
// long as the shortest.
constexpr float longest_wave = 10'000;

// Adds the place of each row: sines of waves from short to long, then cosines.
void add_places(Rows& rows) {
  const auto waves = rows.width / 2;
  for (std::size_t wave = 0; wave < waves; ++wave) {
    const auto part = static_cast<float>(wave) /
                      static_cast<float>(std::max<std::size_t>(waves - 1, 1));
    const auto speed = std::pow(longest_wave, -part);
    for (std::size_t at = 0; at < rows.count(); ++at) {
      const auto angle = static_cast<float>(at) * speed;
      rows.row(at)[wave] += std::sin(angle);
      rows.row(at)[waves + wave] += std::cos(angle);
    }
  }
}

void add(Rows& rows, const Rows& others) {
  for (std::size_t at = 0; at < rows.numbers.size(); ++at)
    rows.numbers[at] += others.numbers[at];
}

float product(const float* left, const float* right, std::size_t count) {
  return std::inner_product(left, left + count, right, 0.0F);
}

// Makes scores to shares of 1; differences count by their exponential.
void make_shares(std::vector<float>& scores) {
  const auto most = *std::ranges::max_element(scores);
  float sum = 0;
  for (auto& score : scores)
    sum += score = std::exp(score - most);
  for (auto& score : scores)
    score /= sum;
}

std::vector<float> mean_of(const Rows& rows) {
  std::vector<float> mean(rows.width);
  for (std::size_t at = 0; at < rows.count(); ++at)
    for (std::size_t column = 0; column < rows.width; ++column)
      mean[column] += rows.row(at)[column] / static_cast<float>(rows.count());
  return mean;
}

// Reads a layer that must have that many inputs, and outputs if they are told.
Dense read_dense(ByteReader& reader, std::size_t inputs,
                 std::optional<std::size_t> outputs = {}) {
  auto made = Dense::read(reader);
  if (made.inputs() != inputs || (outputs && made.outputs() != *outputs))
    reader.fail("a layer does not fit the one before");
  return made;
}

} // namespace

SentenceEncoder::Norm SentenceEncoder::Norm::read(ByteReader& reader,
                                                  std::size_t width) {
  auto scale = read_numbers(reader, width);
  return {std::move(scale), read_numbers(reader, width)};
}

Rows SentenceEncoder::Norm::apply(Rows rows) const {
  const auto width = static_cast<float>(rows.width);
  for (std::size_t at = 0; at < rows.count(); ++at) {
    auto* row = rows.row(at);
    const auto mean = std::accumulate(row, row + rows.width, 0.0F) / width;
    float variance = 0;
    for (std::size_t column = 0; column < rows.width; ++column) {
      row[column] -= mean;
      variance += row[column] * row[column] / width;
    }
    const auto deviation = std::sqrt(variance + smallest_variance);
    for (std::size_t column = 0; column < rows.width; ++column)
      row[column] = row[column] / deviation * scale[column] + moved[column];
  }
  return rows;
}

SentenceEncoder::Layer SentenceEncoder::Layer::read(ByteReader& reader,
                                                    std::size_t width) {
  Layer made;
  made.heads = reader.number();
  if (made.heads == 0 || width % made.heads != 0)
    reader.fail("the heads of a layer do not divide its width");
  made.norm_of_attention = Norm::read(reader, width);
  made.queries_keys_values = read_dense(reader, width, 3 * width);
  made.attended = read_dense(reader, width);
  const auto wide = made.attended.outputs();
  if (wide != width)
    made.passing = read_dense(reader, width, wide);
  made.norm_of_work = Norm::read(reader, wide);
  made.widening = read_dense(reader, wide);
  made.narrowing = read_dense(reader, made.widening.outputs(), wide);
  return made;
}

Rows SentenceEncoder::Layer::attend(const Rows& rows) const {
  const auto width = rows.width / 3;
  const auto part = width / heads;
  const auto scale = 1 / std::sqrt(static_cast<float>(part));
  Rows made(rows.count(), width);
  std::vector<float> shares(rows.count());
  for (std::size_t at = 0; at < rows.count(); ++at)
    for (std::size_t head = 0; head < heads; ++head) {
      const auto* query = rows.row(at) + head * part;
      for (std::size_t other = 0; other < rows.count(); ++other)
        shares[other] =
            scale * product(query, rows.row(other) + width + head * part, part);
      make_shares(shares);
      auto* to = made.row(at) + head * part;
      for (std::size_t other = 0; other < rows.count(); ++other) {
        const auto* value = rows.row(other) + 2 * width + head * part;
        for (std::size_t column = 0; column < part; ++column)
          to[column] += shares[other] * value[column];
      }
    }
  return made;
}

Rows SentenceEncoder::Layer::apply(Rows rows) const {
  auto looked = attended.apply(
      attend(queries_keys_values.apply(norm_of_attention.apply(rows))));
  add(looked, passing.outputs() == 0 ? rows : passing.apply(rows));
  auto wide = widening.apply(norm_of_work.apply(looked));
  for (auto& number : wide.numbers)
    number = std::max(number, 0.0F);
  add(looked, narrowing.apply(wide));
  return looked;
}

Expected<void> SentenceEncoder::read_parts(std::string_view bytes) {
  ByteReader reader(bytes);
  pieces_ = WordPieces::read(reader);
  meanings_ = ByteTable::read(reader);
  if (meanings_.rows() != pieces_.size() || pieces_.size() == 0 ||
      meanings_.columns() % 2 != 0)
    reader.fail("each piece of a word should have numbers");
  auto width = meanings_.columns();
  const auto layers = reader.below(most_layers + 1, "layer");
  for (std::size_t at = 0; at < layers && reader.ok(); ++at) {
    layers_.push_back(Layer::read(reader, width));
    width = layers_.back().attended.outputs();
  }
  last_ = read_dense(reader, width);
  if (reader.ok() && !reader.at_end())
    reader.fail("there are more bytes than layers");
  if (!reader.ok())
    return tl::make_unexpected(reader.error());
  return {};
}

Expected<std::shared_ptr<const SentenceEncoder>>
SentenceEncoder::read(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes)
    return tl::make_unexpected(bytes.error());
  auto made = std::make_shared<SentenceEncoder>();
  std::string why = "the mark at its beginning is missing";
  if (bytes->starts_with(file_mark)) {
    WordHash hash;
    hash.add(*bytes);
    made->sum_ = hash.value();
    const auto read =
        made->read_parts(std::string_view(*bytes).substr(file_mark.size()));
    if (read)
      return std::shared_ptr<const SentenceEncoder>(std::move(made));
    why = read.error().message;
  }
  return fail(ErrorKind::file,
              "this file has no sentence encoder, or not all of it (" + why +
                  "); `tools/dependencies sentences` makes it anew",
              {path.string(), 1, 1});
}

// The pieces count twice, once with their place.
Rows SentenceEncoder::rows_of(std::string_view text) const {
  const auto pieces = pieces_.cut(text, most_pieces);
  Rows rows(pieces.size(), meanings_.columns());
  for (std::size_t at = 0; at < pieces.size(); ++at)
    for (std::size_t column = 0; column < rows.width; ++column)
      rows.row(at)[column] =
          2 * meanings_.step(pieces[at]) *
          static_cast<float>(meanings_.row(pieces[at])[column]);
  add_places(rows);
  return rows;
}

std::vector<float> SentenceEncoder::encode(std::string_view text) const {
  auto rows = rows_of(text);
  for (const auto& layer : layers_)
    rows = layer.apply(std::move(rows));
  Rows sentence(1, rows.width);
  sentence.numbers = mean_of(rows);
  auto made = last_.apply(sentence).numbers;
  float length = 0;
  for (auto& number : made) {
    number = std::tanh(number);
    length += number * number;
  }
  for (auto& number : made)
    number /= std::max(std::sqrt(length), smallest_variance);
  return made;
}

} // namespace parlour::adapters::nlu
