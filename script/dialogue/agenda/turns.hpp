// Turns: which user turns have begun and are not yet taken up by the dialogue
// (engine rule 3: a question waits for nobody who is already talking). A turn
// begins when a recogniser's result, or a typed line, enters the session; it
// stays open while a message of it is queued, a component is asked on its
// behalf, or a script works for it. For example, the visitor says something
// while a topic is about to ask for the time. His words begin turn 7; the
// handler posts them to NLU, which holds the turn until its answer is there;
// the answer's act is taken up, and turn 7 is done. A question that was to be
// released in between was withdrawn.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"
#include "runtime/message/message.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

using TurnId = std::uint64_t; // 0: none

// Plain data, owned by the DialogueContext; it is told the time and asks no
// clock. All times are in milliseconds since 1970.
class Turns {
public:
  // A user turn begins; returns its id, rising from 1. Whoever works for it
  // calls hold(): a turn that nobody holds is not open. `heard`: what the
  // recogniser may have heard, the likeliest text first; a list, or unknown
  // where there is no choice.
  TurnId begin(Value heard = {});
  // The same; unknown once the turn is over.
  Value heard(TurnId turn) const;

  // The user was heard to speak, though not yet understood: a turn is open
  // until its result begins it, or this time is over.
  void speaks(Timestamp until) {
    speech_until_ = until;
  }
  // The same for who may be known to speak longer.
  void speaks_on(Timestamp until) {
    speech_until_ = std::max(speech_until_, until);
  }
  void speech_is_over() {
    speech_until_ = 0;
  }
  bool speaking(Timestamp now) const {
    return speech_until_ > now;
  }

  // Something works for the turn: a queued message, a script, a step. Each hold
  // needs one let_go; nothing happens for turn 0, or for one that is over.
  void hold(TurnId turn) {
    if (auto* found = find(turn))
      ++found->holders;
  }
  void let_go(TurnId turn);

  // A component was asked on the turn's behalf; its first answer, or the
  // timeout, ends that. `meaning`: it was asked what the turn means.
  void asked(Correlation correlation, TurnId turn, Timestamp until,
             bool meaning = false);
  // The turn that an answer belongs to; 0 where it answers nothing we know.
  TurnId of(Correlation correlation) const;
  // The first answer ends the waiting; the turn of later ones can still be
  // asked for by of().
  void answered(Correlation correlation);

  // The dialogue took up what the turn said: from now on it withdraws no
  // question, whatever still works for it.
  void taken_up(TurnId turn);

  // Forgets questions whose time is over, and turns that hang on nothing else.
  // Returns the turns that were not taken up and whose meaning never came.
  std::vector<TurnId> expire(Timestamp now);

  // Whether any component was asked, of late.
  bool asked_anything() const {
    return !questions_.empty();
  }
  // Whether some turn is open, another than this one.
  bool any_open(Timestamp now, TurnId besides = 0) const {
    return speaking(now) || any_said(now, besides);
  }
  // The same, of those whose words have come.
  bool any_said(Timestamp now, TurnId besides = 0) const {
    return !turns_.empty() && any_waits(now, besides);
  }
  // Whether somebody has said more since that turn, which is still to be taken
  // up.
  bool said_since(TurnId turn, Timestamp now) const;
  // When the last of the open turns is given up if no component answers;
  // nothing where none is open, or something still works for one.
  std::optional<Timestamp> open_until(Timestamp now) const;
  std::size_t count() const { // turns that are remembered
    return turns_.size();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(turns_, questions_, last_, speech_until_);
  }

private:
  // Open, in the sense of engine rule 3.1, while it is not taken and anybody
  // holds it or is asked.
  struct Turn {
    TurnId id = 0;
    // How many hold it (hold).
    int holders = 0;
    bool taken = false;
    Value heard = {};

    template <class Archive>
    void serialize(Archive& archive) {
      archive(id, holders, taken, heard);
    }
  };
  // A component that was asked on a turn's behalf.
  struct Question {
    TurnId turn = 0;
    Timestamp until = 0;
    // Neither answered nor expired. A closed one is kept, so that a late answer
    // finds its turn.
    bool open = true;
    bool meaning = false;

    // One that was answered only tells whose turn an answer belongs to.
    template <class Archive>
    void serialize(Archive& archive) {
      archive(turn, open);
      if (open)
        archive(until, meaning);
    }
  };

  bool any_waits(Timestamp now, TurnId besides) const;
  bool waits(const Turn& turn, Timestamp now) const;
  // The latest time until which a component is waited for; 0: none.
  Timestamp asked_until(TurnId turn, Timestamp now) const;
  Turn* find(TurnId turn) { // null where it is over
    if (turn != 0)
      for (auto& known : turns_)
        if (known.id == turn)
          return &known;
    return nullptr;
  }
  void close_if_idle(TurnId turn);

  ShortLivedList<Turn> turns_; // those that are remembered, few
  std::map<Correlation, Question> questions_;
  TurnId last_ = 0;
  Timestamp speech_until_ = 0;
};

} // namespace parlour::dialogue
