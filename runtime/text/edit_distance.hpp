// The edit distance of two spellings: the cheapest way to turn one into the
// other by inserting, removing, replacing and swapping letters. The caller sets
// the cost of each edit. The functions are pure and allocate nothing.
//
//   edit_distance<64>("flight"sv, "fligth"sv)  // 1: two letters are swapped
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace parlour {

// The costs of the edits, each of them 1. A type with the same members replaces
// it where edits cost differently (script/source/findings.cpp: a change of case
// is cheap).
struct PlainCosts {
  using Number = int;

  // The cost of swapping two neighbours.
  static constexpr Number swapped = 1;

  // The cost of replacing a letter by another; 0 if they are equal.
  template <class Letter>
  static constexpr Number change(Letter left, Letter right) {
    return left == right ? 0 : 1;
  }
  // The cost of inserting or removing a letter. The second argument is the
  // letter before it, or the null character at the beginning of the text.
  template <class Letter>
  static constexpr Number extra(Letter, Letter) {
    return 1;
  }
};

// Computes one edit distance. Cell (i, j) of the table is the distance of the
// first i letters of `left` and the first j letters of `right`. A row needs the
// two rows above it only, so three rows are kept and rotated. The time grows
// with the product of both lengths. The texts must outlive the table.
template <std::size_t longest, class Costs, class Text>
class EditTable {
public:
  using Number = typename Costs::Number;

  EditTable(const Text& left, const Text& right)
      : left_(left), right_(right),
        columns_(std::min<std::size_t>(right.size(), longest)) {
    // Row 0: every letter of `right` is inserted.
    (*last_)[0] = 0;
    for (std::size_t j = 1; j <= columns_; ++j) {
      extra_[j] = extra(right_, j);
      (*last_)[j] = (*last_)[j - 1] + extra_[j];
    }
  }

  // Some distance above `most` if it is more than that, which is known early.
  // May be called once, because it overwrites the rows.
  Number distance(Number most) {
    const auto rows = std::min<std::size_t>(left_.size(), longest);
    Number least_before = 0; // of the row before the last one
    Number least = 0;
    // `last_` holds row i - 1 and `before_` holds row i - 2.
    for (std::size_t i = 1; i <= rows; ++i) {
      const auto least_here = fill_row(i);
      least_before = std::exchange(least, least_here);
      std::swap(before_, last_);
      std::swap(last_, row_);
      // Each way goes on from the last row, or by a swap from the one before.
      if (least > most && least_before + Costs::swapped > most)
        return std::min(least, least_before + Costs::swapped);
    }
    return (*last_)[columns_];
  }

private:
  using Row = std::array<Number, longest + 1>;

  // Returns the least of the row.
  Number fill_row(std::size_t i) {
    const auto left_extra = extra(left_, i);
    auto least = (*row_)[0] = (*last_)[0] + left_extra;
    for (std::size_t j = 1; j <= columns_; ++j) {
      auto& cell = (*row_)[j];
      // The last letters are replaced (or equal), removed or inserted.
      cell = std::min(
          {(*last_)[j - 1] + Costs::change(left_[i - 1], right_[j - 1]),
           (*last_)[j] + left_extra, (*row_)[j - 1] + extra_[j]});
      if (are_swapped(i, j))
        cell = std::min(cell, (*before_)[j - 2] + Costs::swapped);
      least = std::min(least, cell);
    }
    return least;
  }

  bool are_swapped(std::size_t i, std::size_t j) const {
    return i > 1 && j > 1 && left_[i - 1] == right_[j - 2] &&
           left_[i - 2] == right_[j - 1];
  }

  static Number extra(const Text& text, std::size_t i) {
    return Costs::extra(text[i - 1],
                        i >= 2 ? text[i - 2] : typename Text::value_type{});
  }

  const Text& left_;
  const Text& right_;
  std::size_t columns_;
  Row extra_; // of the letters of `right_`
  std::array<Row, 3> rows_;
  Row* before_ = &rows_[0];
  Row* last_ = &rows_[1];
  Row* row_ = &rows_[2];
};

// The edit distance of two texts, in which no letter is edited twice (the
// restricted distance of Damerau and Levenshtein, also called optimal string
// alignment). Only the first `longest` letters of each text count. Of texts
// that are further apart than `most` it is any distance above that.
template <std::size_t longest, class Costs = PlainCosts, class Text>
typename Costs::Number
edit_distance(const Text& left, const Text& right,
              typename Costs::Number most =
                  std::numeric_limits<typename Costs::Number>::max()) {
  return EditTable<longest, Costs, Text>(left, right).distance(most);
}

// How alike two texts are that are not both empty: 1 minus their distance
// divided by the length of the longer one, at least 0. Of texts that are less
// alike than `least` it is any number below that.
template <std::size_t longest, class Costs, class Text>
double edit_similarity(const Text& left, const Text& right, double least) {
  // Distances may be sums of decimals.
  constexpr double tolerance = 1e-4;
  const auto length = static_cast<double>(
      std::min<std::size_t>(std::max(left.size(), right.size()), longest));
  const auto most =
      static_cast<typename Costs::Number>((1 - least) * length + tolerance);
  const auto distance = edit_distance<longest, Costs>(left, right, most);
  return std::max(0.0, 1 - static_cast<double>(distance) / length);
}

} // namespace parlour
