#include "script/dialogue/inputs/session_history.hpp"

#include <utility>

namespace parlour::dialogue {

namespace {

// True: the record follows what is known. A record of a session of which
// nothing came before, such as an input whose beginning was removed with an old
// part, does not; a state always does.
struct Taker {
  SessionHistory& history;
  HistoryFrom from;
  bool known; // something of the session came before

  bool operator()(SessionOpened& opened) {
    history.opened = opened;
    return true;
  }
  bool operator()(InputTaken& taken) {
    history.inputs.push_back(std::move(taken));
    return known;
  }
  // Where it goes on from what is known, that is longer, and shows more: a
  // replay from the beginning leaves it out. Behind a gap, with another
  // program, or where only the last state is wanted, all before it is
  // forgotten.
  bool operator()(StateKept& kept) {
    const bool follows = known && kept.inputs == history.count() &&
                         kept.opened.program == history.opened.program;
    if (follows && from == HistoryFrom::beginning)
      return true;
    history.opened = kept.opened;
    history.closed = false;
    history.state = std::move(kept.state);
    history.before = kept.inputs;
    history.turns = std::move(kept.turns);
    history.inputs.clear();
    return true;
  }
  bool operator()(EffectsDone& done) {
    history.posted = done.inputs;
    return known;
  }
  bool operator()(SessionClosed&) {
    history.closed = true;
    return known;
  }
};

} // namespace

bool take(SessionHistory& history, SessionRecord record, HistoryFrom from) {
  const bool known = !history.id.empty();
  history.id = std::move(record.session);
  return std::visit(Taker{history, from, known}, record.what);
}

} // namespace parlour::dialogue
