// Dense is a layer of a neural network: each number that comes out is a
// weighted sum of all that go in. Its weights are small integers, and what goes
// in is made to integers too, so the sums are exact and the same with every
// compiler and on every processor; what is done with them is not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/base/bytes.hpp"

namespace parlour::adapters::nlu {

// Numbers for each piece of a text: one row for each.
struct Rows {
  Rows() = default;
  Rows(std::size_t rows, std::size_t columns)
      : width(columns), numbers(rows * columns) {}

  std::size_t count() const {
    return width == 0 ? 0 : numbers.size() / width;
  }
  float* row(std::size_t at) {
    return numbers.data() + at * width;
  }
  const float* row(std::size_t at) const {
    return numbers.data() + at * width;
  }

  std::size_t width = 0;
  std::vector<float> numbers;
};

// A block of floats. Another count than `count` is a failure of the reader.
std::vector<float> read_numbers(ByteReader& reader, std::size_t count);

// A table of numbers, a byte each: a row has a step, by which each of its bytes
// is multiplied.
class ByteTable {
public:
  ByteTable() = default;

  // The counts of rows and columns; a block with a step (a float) for each row;
  // a block of signed bytes.
  static ByteTable read(ByteReader& reader);

  std::size_t rows() const {
    return steps_.size();
  }
  std::size_t columns() const {
    return columns_;
  }
  float step(std::size_t row) const {
    return steps_[row];
  }
  // Not owned: part of the table.
  const std::int8_t* row(std::size_t row) const {
    return &bytes_[row * columns_];
  }

private:
  std::size_t columns_ = 0;
  std::vector<float> steps_;
  std::vector<std::int8_t> bytes_;
};

// Immutable; any number of threads may use it.
class Dense {
public:
  Dense() = default;

  // A ByteTable with a row for each number that comes out, then a block with
  // what is added to each (a float). More than some thousand inputs are a
  // failure of the reader.
  static Dense read(ByteReader& reader);

  // `rows` has inputs() columns.
  Rows apply(const Rows& rows) const;

  std::size_t inputs() const {
    return inputs_;
  }
  std::size_t outputs() const {
    return steps_.size();
  }

private:
  std::size_t inputs_ = 0;
  std::vector<float> steps_; // by output
  std::vector<float> added_; // by output
  // By output; each row is filled up with zeros.
  std::vector<std::int16_t> weights_;
};

} // namespace parlour::adapters::nlu
