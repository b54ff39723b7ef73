// Pipeline: the pipeline lane (engine rules 1d and 2). Gives a message to the
// active state's <Messages>, then to every matching handler in file order. A
// handler that waits holds only later messages of the same source and command;
// none where it waits for the user, and what the user says not where it waits
// for time (language rules 10.1 and 12.16).
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "script/dialogue/agenda/step.hpp"
#include "script/dialogue/engine/input.hpp"
#include "script/dialogue/engine/runner.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

struct Core;

// Messages of one source and command that wait behind a handler that waits.
inline constexpr std::size_t most_held = 100;

class Pipeline {
public:
  explicit Pipeline(Core& core);

  // Behind an activation that waits at most most_held wait; a further one
  // is an error and is dropped. What is an answer to one that waits for the
  // user goes straight to it (answers.hpp).
  void take(Input&& input);
  // An activation of this lane goes on; false where it is none of ours.
  bool resume(WaitId wait, Expected<Value> outcome);
  // <consume/> in the reaction that is running; false where none is.
  bool consume();

  void register_handler(const std::string& name, bool registered);
  std::vector<WaitId> waits() const;
  bool waits(WaitId wait) const;

  // Reactions to an event, in the order in which they are tried: the active
  // state's, then the handlers'.
  struct Match {
    const script::Reaction* reaction = nullptr;
    VisitId visit = 0;     // of the state that it is of
    bool captures = false; // ends the search by itself
    bool named() const;    // it names the source and the event, no '*'
  };
  std::vector<Match> matches(const std::string& source,
                             const std::string& event) const;
  // Whether there is any.
  bool listens(const std::string& source, const std::string& event) const;
  // Whether the active state has any, or keeps every event for itself.
  bool state_listens(const std::string& source, std::string_view event) const;

private:
  struct Item {
    std::shared_ptr<const Message> message;
    TurnId turn = 0;
    bool raised = false;
    std::vector<Match> reactions;
    std::size_t next = 0;
    bool consumed = false;
    bool is_said = false;   // by the user
    bool overflows = false; // too much is behind it
    bool holds_turn = true;
    WaitId waiting = 0;
    Runner::WaitFor what = Runner::WaitFor::answer;
    std::vector<Input> behind; // same source and command

    const Match& running() const {
      return reactions[next - 1];
    }
  };

  // Tells them to `visit` in that order, until it wants no more (false).
  template <class Visit>
  bool visit_each(const std::vector<script::Reaction>& reactions,
                  VisitId of_state, bool captures, const std::string& source,
                  const std::string& event, Visit& visit) const;
  template <class Visit>
  void visit_matches(const std::string& source, const std::string& event,
                     Visit visit) const;
  void hold(Item& item, Input input);
  static bool holds(const Item& item, const Input& input);
  // The one that waits and that this message must wait for; null: none.
  Item* waits_before(const Input& input) const;
  // Whether a reaction that waits for the user would get the message, too.
  bool asks_again(const Item& item) const;
  void go_on(Item& item);
  void started(Item& item, WaitId wait);
  void finish(Item& item);
  void keep(Item&& item); // until what it waits for comes
  void let_go_of_held(Item& item);
  static bool was_worded(const Item& item);
  bool means_nothing(const Item& item) const;
  void not_understood(const Item& item, bool taken);
  bool is_source(const std::string& wanted, const std::string& source) const;

  Core& core_;
  std::vector<std::unique_ptr<Item>> waiting_;
  std::set<std::string, std::less<>> unregistered_;
  Item* running_ = nullptr;
  std::vector<Match> spare_; // of an item that is over: its memory
};

} // namespace parlour::dialogue
