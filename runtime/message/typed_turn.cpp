#include "runtime/message/typed_turn.hpp"

#include <cstddef>
#include <utility>

namespace parlour {

namespace {

constexpr const char* recogniser = "ASR";
constexpr const char* recognised = "RecognitionResult";
// Behind text, confidence, alternatives and words (roles.def).
constexpr std::size_t place = 4;

} // namespace

Message typed_turn(std::string words, std::uint64_t number) {
  Message turn;
  turn.source = recogniser;
  turn.command = recognised;
  turn.params = {std::move(words), 1};
  if (number != 0) {
    turn.params.resize(place);
    turn.params.emplace_back(static_cast<std::int64_t>(number));
  }
  return turn;
}

std::uint64_t number_of_turn(const Message& message) {
  if (message.params.size() <= place || message.command != recognised ||
      message.source != recogniser)
    return 0;
  const auto* number = message.params[place].if_integer();
  return number && *number > 0 ? static_cast<std::uint64_t>(*number) : 0;
}

} // namespace parlour
