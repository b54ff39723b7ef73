// Turns: what a corpus becomes for the runner, a line for each thing that
// happens or must hold, its fields separated by tabs. One dialogue after the
// other, each begun by `dialogue`. The front end (`run`) writes them.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::tools::corpus {

// Name, number of fields (the last one may repeat), sentence.
// clang-format off
#define PARLOUR_CORPUS_LINES(X) \
  X(dialogue, 1, "a conversation begins: its name") \
  X(turn, 1, "the user's turn with this number begins") \
  X(returns, 1, "this turn goes back to a topic that was left") \
  X(calls, 1, "what is written to the database from now on succeeds or fails") \
  X(act, 3, "the user does this: kind, topic, elliptical (yes or no)") \
  X(slot, 2, "a slot of the last act: name, value") \
  X(say, 0, "the acts are said, and the conversation comes to rest") \
  X(wait, 1, "nobody says anything for so many milliseconds") \
  X(state, 1, "the slots of this topic are compared; those that follow") \
  X(is, 2, "a slot of that topic and the ways to write its value; *: any") \
  X(said, 1, "these words were said next, whatever else was said before") \
  X(topic, 1, "this is the current topic; empty: there is none") \
  X(answer, 1, "the question about this topic that was asked is answered") \
  X(fill, 1, "each question about this topic is answered, until it is over") \
  X(keeps, 1, "this topic still has the slots that it had been filled with")
// clang-format on

enum class LineKind : std::uint8_t {
#define X(name, fields, sentence) name,
  PARLOUR_CORPUS_LINES(X)
#undef X
};

struct Line {
  LineKind kind = LineKind::dialogue;
  std::vector<std::string> fields;
};

Expected<Line> parse_line(const std::string& text);

// The lines of the next dialogue, from its `dialogue` on; empty at the end.
class TurnReader {
public:
  explicit TurnReader(std::istream& input) : input_(input) {}

  Expected<std::vector<Line>> next();

private:
  std::istream& input_;
  std::uint32_t number_ = 0; // of the last line read
  std::vector<Line> ahead_;  // the `dialogue` that ended the one before
};

} // namespace parlour::tools::corpus
