// Files of small encoders, as tools/sentences writes them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/encoder/sentence_encoder.hpp"
#include "runtime/base/bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::nlu::small {

using Numbers = std::vector<float>;
using Table = std::vector<std::vector<signed char>>;

inline void write_numbers(ByteWriter& writer, const Numbers& numbers) {
  writer.text({reinterpret_cast<const char*>(numbers.data()),
               numbers.size() * sizeof(float)});
}

// Each row has the same step.
inline void write_table(ByteWriter& writer, const Table& rows, float step) {
  writer.number(rows.size());
  writer.number(rows.empty() ? 0 : rows[0].size());
  write_numbers(writer, Numbers(rows.size(), step));
  std::string bytes;
  for (const auto& row : rows)
    bytes.append(row.begin(), row.end());
  writer.text(bytes);
}

// Adds nothing.
inline void write_dense(ByteWriter& writer, const Table& rows, float step) {
  write_table(writer, rows, step);
  write_numbers(writer, Numbers(rows.size()));
}

inline Table identity(std::size_t width) {
  Table rows(width, std::vector<signed char>(width));
  for (std::size_t at = 0; at < width; ++at)
    rows[at][at] = 1;
  return rows;
}

inline Table zeros(std::size_t rows, std::size_t columns) {
  return Table(rows, std::vector<signed char>(columns));
}

// The numbers of a piece are so large that its place does not matter.
inline void write_pieces(ByteWriter& writer) {
  const std::vector<std::string_view> pieces{
      "?",         "\u2581i", "\u2581need", "\u2581a", "\u2581taxi",
      "\u2581cab", "\u2581b", "ank",        "\u2581"};
  writer.number(pieces.size());
  for (const auto piece : pieces)
    writer.text(piece);
  write_numbers(writer, Numbers(pieces.size(), -1));
  write_table(writer,
              {{0, 0, 0, 0},
               {0, 0, 5, 0},
               {0, 0, 0, 10},
               {0, 0, 2, 0},
               {100, 0, 0, 0},
               {90, 10, 0, 0},
               {0, 100, 0, 0},
               {0, 90, 0, 0},
               {0, 0, 0, 0}},
              1);
}

// Says of "taxi" and "cab" nearly the same, and something else of "bank".
inline std::string small_encoder_file() {
  ByteWriter writer;
  write_pieces(writer);
  writer.number(0);
  write_dense(writer, identity(4), 0.01F);
  return "PARLOURS" + writer.take();
}

// One layer, in which each row gets the mean of all.
inline std::string encoder_file_with_layer(std::uint64_t heads = 2) {
  ByteWriter writer;
  write_pieces(writer);
  writer.number(1);
  writer.number(heads);
  // A norm that leaves nothing but 1, 2, 3, 4.
  write_numbers(writer, Numbers(4));
  write_numbers(writer, {1, 2, 3, 4});
  auto values = zeros(8, 4);
  for (auto& row : identity(4))
    values.push_back(row);
  write_dense(writer, values, 1);
  write_dense(writer, identity(4), 1);
  write_numbers(writer, Numbers(4, 1));
  write_numbers(writer, Numbers(4));
  write_dense(writer, zeros(8, 4), 1);
  write_dense(writer, zeros(4, 8), 1);
  write_dense(writer, identity(4), 0.001F);
  return "PARLOURS" + writer.take();
}

inline Expected<std::shared_ptr<const SentenceEncoder>>
encoder_of(const std::string& bytes) {
  const parlour::test::TemporaryFolder folder;
  folder.write("sentences.encoder", bytes);
  return SentenceEncoder::read(folder.path() / "sentences.encoder");
}

inline std::shared_ptr<const SentenceEncoder> small_encoder() {
  return *encoder_of(small_encoder_file());
}

} // namespace parlour::adapters::nlu::small
