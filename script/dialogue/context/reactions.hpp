// Reactions: who reacts to an event, in the order in which they are tried: the
// active state's <Messages>, then every registered handler in file order
// (engine rule 1d).
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "script/dialogue/context/dialogue_context.hpp"

namespace parlour::dialogue {

// Finds reactions and runs none. It reads the program and the active state, and
// keeps which handlers are unregistered.
class Reactions {
public:
  explicit Reactions(const DialogueContext& context) : context_(context) {}

  struct Match {
    const script::Reaction* reaction = nullptr;
    // Of the state that it is of; 0: it is a handler's.
    VisitId visit = 0;
    // It is of a state with `capture`: it ends the search by itself.
    bool captures = false;
    bool named() const; // it names the source and the event, no '*'

    template <class Archive>
    void serialize(Archive& archive) {
      archive.reaction(reaction);
      archive(visit, captures);
    }
  };
  // Those that fit, in order, are appended to what is there: with a list that
  // is used again, a message costs no allocation.
  void find(const std::string& source, const std::string& event,
            std::vector<Match>& found) const;
  std::vector<Match> matches(const std::string& source,
                             const std::string& event) const;
  // Whether there is any.
  bool listens(const std::string& source, const std::string& event) const;
  // Whether the active state has any, or keeps every event for itself.
  bool state_listens(const std::string& source, std::string_view event) const;

  // <register> and <unregister>; all are registered at first. A name that no
  // handler has changes nothing.
  void register_handler(const std::string& name, bool registered);

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_);
    archive(unregistered_);
  }

private:
  // Tells them to `visit` in that order, until it wants no more (false).
  template <class Visit>
  bool visit_each(const std::vector<script::Reaction>& reactions,
                  VisitId of_state, bool captures, const std::string& source,
                  const std::string& event, Visit& visit) const;
  template <class Visit>
  void visit_matches(const std::string& source, const std::string& event,
                     Visit visit) const;
  bool is_source(const std::string& wanted, const std::string& source) const;

  const DialogueContext& context_;
  std::set<std::string, std::less<>> unregistered_;
};

} // namespace parlour::dialogue
