// Player plays the lines of one dialogue with a conversation of its own and
// reports what did not hold. The simulated user speaks in acts. The slots that
// are compared are those of the conversation's frames.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tools/corpus/turns.hpp"
#include "tools/corpus/world.hpp"

namespace parlour::tools::corpus {

// The kinds of faults: name, sentence.
// clang-format off
#define PARLOUR_CORPUS_FAULTS(X) \
  X(wrong, "a slot is not as the corpus says") \
  X(lost, "a slot was not kept until its topic was taken up again") \
  X(silent, "a turn was answered by nothing: a dead end") \
  X(endless, "the conversation does not come to rest: a dead end") \
  X(error, "a script failed") \
  X(unsaid, "words that should have come did not") \
  X(elsewhere, "another topic is the current one") \
  X(unasked, "a topic asked nothing though it was not over")
// clang-format on

enum class FaultKind : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_CORPUS_FAULTS(X)
#undef X
};

std::string_view name_of(FaultKind kind);

struct Fault {
  FaultKind kind = FaultKind::wrong;
  std::string dialogue;
  std::string turn;
  std::string topic;
  std::string slot;
  std::string wanted;
  std::string found;
};

struct Counts {
  std::uint64_t dialogues = 0;
  std::uint64_t turns = 0;
  // Frames of topics, and slots with a value, that were compared.
  std::uint64_t states = 0;
  std::uint64_t slots = 0;
  std::uint64_t returns = 0;
};

// Not thread-safe.
class Player {
public:
  using Tell = std::function<void(const Fault&)>;

  // `tell` is called for each fault, in order, from within play().
  Player(std::shared_ptr<const script::Program> program, Tell tell);

  void play(const std::vector<Line>& lines);

  const Counts& counts() const {
    return counts_;
  }

private:
  using Slots = std::map<std::string, std::string>;

  void take(const Line& line);
  // One function for each kind of line (PARLOUR_CORPUS_LINES).
  void dialogue(const Line& line);
  void turn(const Line& line);
  void returns(const Line& line);
  void calls(const Line& line);
  void act(const Line& line);
  void slot(const Line& line);
  void say(const Line& line);
  void wait(const Line& line);
  void state(const Line& line);
  void is(const Line& line);
  void said(const Line& line);
  void topic(const Line& line);
  void answer(const Line& line);
  void fill(const Line& line);
  void keeps(const Line& line);

  // Says acts and notes that the user has spoken.
  void utter(List acts);
  // Called when all slots of the compared topic have been named: the others
  // must be empty.
  void close_state();
  void end_turn();
  void compare(const std::string& slot, const std::string& wanted,
               const std::string& found);
  // Answers the last question about the topic. False if there is none.
  bool answer_question(const std::string& topic);
  // The values of all slots of a topic, as texts.
  Slots slots_of(const std::string& topic) const;
  void fault(FaultKind kind, std::string topic = {}, std::string slot = {},
             std::string wanted = {}, std::string found = {});

  std::shared_ptr<const script::Program> program_;
  std::shared_ptr<const PhraseEvaluator> phrases_;
  Tell tell_;
  Counts counts_;

  // The state of the current dialogue.
  std::unique_ptr<World> world_;
  std::string name_;
  std::string turn_;
  List acts_;
  // The user has spoken in this turn.
  bool spoke_ = false;
  // The number of outputs before this turn.
  std::size_t said_before_ = 0;
  // The number of outputs that lines `said` have passed.
  std::size_t looked_at_ = 0;
  std::size_t errors_told_ = 0;
  // The topic of the last line `state`, and those of its slots that no line
  // `is` has named.
  std::string compared_;
  Slots left_to_compare_;
  std::string returned_to_;
  // The topics and slots of this turn's acts.
  std::map<std::string, Slots> acted_on_;
  // The slots of each topic when it was last acted on.
  std::map<std::string, Slots> known_;
};

} // namespace parlour::tools::corpus
