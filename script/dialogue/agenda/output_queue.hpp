// OutputQueue: what the robot wants to say, until it is released or withdrawn
// (engine rule 3). Plain data with rules; who speaks is not its business. The
// order in which outputs are pushed is the order in which they leave, so one
// that waits for its words blocks the others.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/clock.hpp"
#include "script/program/program.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

// Counted in each session from 1; 0: none.
using OutputId = std::uint64_t;

// What an output is (engine rule 3.3 has the table). Questions, reprompts and
// resumes can be withdrawn.
enum class OutputAct : std::uint8_t {
  answer,
  question,
  reprompt,
  resume,
  chat
};

// The stages of an output, in order. An output leaves the queue when it is
// released; the queue then remembers it as a part of the robot's last turn.
enum class OutputState : std::uint8_t {
  worded,  // waits for its words (an NLG component is asked)
  pending, // has its words; waits for release
  playing, // released; being spoken or shown
  heard,
  withdrawn,
};

// One thing that the robot says. The OutputManager makes it; the port and the
// seat get it when it is released.
struct Output {
  OutputId id = 0;
  OutputAct act = OutputAct::answer;
  OutputState state = OutputState::pending;
  // Empty while it waits for its words.
  std::string text;
  script::TopicId topic = script::no_id; // of a question, reprompt or resume
  script::SlotId slot = script::no_id;
  std::uint64_t turn = 0; // the user turn that it answers; 0: none
  bool interruptible = true;
  bool awaited = false; // by a script, which waits for the answer

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id, text, turn, interruptible, awaited);
    archive.up_to(act, OutputAct::chat);
    archive.up_to(state, OutputState::withdrawn);
    archive.slot(topic, slot);
  }
};

class OutputQueue {
public:
  // Gives the entry an id, rising, and returns it. A `worded` one blocks those
  // behind it until `word` gives its text (an empty text drops it).
  OutputId push(Output output);
  // The words have come. Nothing happens where the entry was withdrawn
  // meanwhile.
  void word(OutputId id, std::string text);
  // Whether it is still queued: neither released nor withdrawn.
  bool has(OutputId id) const;

  // Decides for one output.
  using Which = std::function<bool(const Output&)>;
  struct Released {
    std::span<const Output> released; // in order; until the next call
    std::vector<Output> withdrawn;    // questions, reprompts, resumes only
  };
  // Releases what can be released now. Questions, reprompts and resumes are
  // withdrawn where a user turn has begun, as `begun` tells of an entry;
  // answers never are, but one that was given in the same user turn with the
  // same words is forgotten. An entry that waits for its words can be
  // withdrawn, too; it is never released.
  Released release(const Which& begun);
  Released release(bool begun) { // for all alike
    return release([=](const Output&) { return begun; });
  }

  // Withdraws all questions, whoever talks (a transit, a cancel, another
  // topic), and returns them.
  std::vector<Output> withdraw_questions();

  bool empty() const; // nothing waits for words or release
  // The texts of the last robot turn as far as they were heard, for "repeat".
  // Nothing of an output that was not heard at all, and of many only the newest
  // `most_repeated`.
  std::vector<std::string> last_turn() const;
  // An output of that turn; null where it is none of them.
  const Output* released(OutputId id) const;
  // Of an output of that turn only these words were heard. Returns it as it
  // was released; nothing where it is no longer known. Called again for the
  // same output, the later words count.
  std::optional<Output> cut(OutputId id, std::string heard);
  // The next release starts a new robot turn; the last one is known until then.
  void turn_begins();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(entries_, last_turn_, cut_, fresh_turn_, last_id_);
  }

private:
  // More than a robot says in one turn (architecture rule 5).
  static constexpr std::size_t most_repeated = 64;

  std::vector<Output> withdraw(const Which& which); // of the questions
  void forget_what_is_too_much();
  std::span<const Output> release_pending();
  bool was_answered(const Output& output) const;

  ShortLivedList<Output> entries_;
  // Of the robot, as they were released: the newest, and what was released at
  // once with them.
  ShortLivedList<Output> last_turn_;
  std::vector<std::pair<OutputId, std::string>>
      cut_; // of these, what was heard
  bool fresh_turn_ = true;
  OutputId last_id_ = 0;
};

} // namespace parlour::dialogue
