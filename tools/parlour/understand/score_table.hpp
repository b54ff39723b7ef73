// ScoreTable compares what was understood with what is marked.
//
//  intent    the topic is right, or the act where no topic is marked
//  slots     name and value are right
//  frame     intent, marked act and all slots are right, and nothing else is
//            said; what is marked as nothing is not understood
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/value.hpp"
#include "tools/parlour/understand/marked_sentences.hpp"

namespace parlour::tools {

class ScoreTable {
public:
  // `acts` are those of the understanding, `score` the best one's.
  void add(const MarkedSentence& sentence, const List& acts, double score);

  // A figure a line, with what it is without any understanding: always the
  // most frequent intent, without slots. Then what is most often taken for
  // something else, and the ten surest mistakes.
  std::vector<std::string> lines() const;

private:
  struct Mistake {
    double score = 0;
    std::string text;
  };

  void add_slots(const MarkedSentence& sentence, const Value& act);

  std::size_t sentences_ = 0, intents_ = 0, frames_ = 0;
  std::size_t nothing_ = 0, rejected_ = 0;
  std::size_t wanted_ = 0, found_ = 0, right_ = 0; // slots
  std::map<std::string, std::size_t> by_intent_;
  // Of those, by intent, without slots.
  std::map<std::string, std::size_t> bare_;
  std::map<std::pair<std::string, std::string>, std::size_t> confused_;
  std::vector<Mistake> mistakes_;
};

} // namespace parlour::tools
