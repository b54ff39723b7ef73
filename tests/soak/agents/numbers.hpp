// The numbered messages that both sides of the soak test send each other: what
// belongs to each number, and which of them have arrived.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace parlour::soak {

// How many numbers may be on their way before the other side confirms some: so
// no outbox is ever full.
inline constexpr std::uint64_t window = 500;
// How often the other side is told what has arrived.
inline constexpr std::uint64_t confirm_every = 50;

// The text that travels with a number: of many lengths, and some of them with
// all that a line has to escape.
inline std::string filler(std::uint64_t number) {
  std::string text(number % 97, 'x');
  if (number % 10 == 0)
    text += "\",\\\r\n \u00e9 ";
  return text;
}
// Some of these texts travel as a payload.
inline bool is_binary(std::uint64_t number) {
  return number % 64 == 0;
}

// Which numbers from 1 to `total` have arrived.
class Tally {
public:
  explicit Tally(std::uint64_t total) : arrived_(total + 1) {}

  void take(std::uint64_t number, const std::string& text) {
    if (number == 0 || number >= arrived_.size() || text != filler(number))
      ++altered;
    else if (arrived_[number])
      ++duplicates;
    else
      add(number);
  }

  bool is_complete() const {
    return count + 1 == arrived_.size();
  }

  std::uint64_t count = 0;
  std::uint64_t duplicates = 0;
  std::uint64_t altered = 0;
  std::uint64_t out_of_order = 0;

private:
  void add(std::uint64_t number) {
    arrived_[number] = true;
    out_of_order += number == last_ + 1 ? 0 : 1;
    last_ = number;
    ++count;
  }

  std::vector<bool> arrived_;
  std::uint64_t last_ = 0;
};

} // namespace parlour::soak
