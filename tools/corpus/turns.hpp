// The input of the corpus runner: one line for each thing that happens or must
// hold, with fields separated by tabs. Each dialogue begins with the line
// `dialogue`. The script tools/corpus/run writes these lines from a corpus.
//
//  dialogue  1_00001
//  turn      0
//  act       inform  Restaurant  no      the user informs about Restaurant
//  slot      City    Singapore           … that City is Singapore
//  say                                   the act is said
//  state     Restaurant                  now the frame of Restaurant
//  is        City    Singapore  singapore   has one of these values
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::tools::corpus {

// The kinds of lines: name, number of fields (the last one of `is` may
// repeat), sentence.
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

// A line without its first field, which is the kind.
struct Line {
  LineKind kind = LineKind::dialogue;
  std::vector<std::string> fields;
};

// Parses one line. The error, of kind Settings, says what is wrong.
Expected<Line> parse_line(const std::string& text);

// Reads the input one dialogue at a time.
class TurnReader {
public:
  explicit TurnReader(std::istream& input) : input_(input) {}

  // The lines of the next dialogue, from its `dialogue` on; empty at the end.
  // The error has the number of the line.
  Expected<std::vector<Line>> next();

private:
  std::istream& input_;
  // The number of the last line read.
  std::uint32_t number_ = 0;
  // The line `dialogue` that ended the previous dialogue.
  std::vector<Line> ahead_;
};

} // namespace parlour::tools::corpus
