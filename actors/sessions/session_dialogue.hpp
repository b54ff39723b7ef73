// SessionDialogue: the conversation of a session, the port by which it reaches
// others, and what of it is kept in a journal. The conversation can be renewed:
// it is written, and another one goes on from the bytes with a port of its own,
// as it would in another process; or it goes over to another program. Lives on
// the session's thread.
#pragma once

#include <functional>
#include <memory>

#include "actors/sessions/program_change.hpp"
#include "actors/sessions/session_port.hpp"
#include "runtime/base/outside/journal.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/inputs/recording_port.hpp"
#include "script/dialogue/inputs/saved_session.hpp"
#include "script/dialogue/inputs/session_input.hpp"
#include "script/dialogue/inputs/session_record.hpp"

namespace parlour::actors {

// How a session uses the journal.
struct JournalUse {
  std::shared_ptr<Journal> journal; // null: nothing is kept
  bool strict = false;
  // What to do, on any thread, once this record is written: it leads to
  // SessionDialogue::written().
  std::function<std::function<void()>(std::uint64_t record)> when_written = {};
};

// With a journal each input leads to one record: the input, and what the port
// answered at once while it was dealt with. Now and then a state follows, from
// which a replay or a recovery begins (engine rule 7.10).
class SessionDialogue {
public:
  // A session that begins, or with `saved` one that goes on, whose first input
  // is Resumed. `saved` can be restored.
  SessionDialogue(std::shared_ptr<const script::Program> program,
                  dialogue::ConversationOptions options,
                  std::unique_ptr<SessionPort> port, JournalUse kept = {},
                  const dialogue::SavedSession* saved = {});

  // The only way into the conversation.
  // An input that is taken after a record was lost leads to a state instead of
  // a record, which mends the gap.
  void take(dialogue::SessionInput input, Timestamp now);
  // The journal has this record: what waited for it is done.
  void written(std::uint64_t record);
  // Turns are answered: they are counted. Whoever numbers them is told that
  // those up to `turn` are; 0: nobody does.
  void turns_done(const TurnMeter::Answered& answered, std::uint64_t turn);
  // It has ended: the manager is told, and what works for it ends.
  void close(std::vector<Message> unread);
  // What comes after its end is the manager's, as soon as that has been told.
  void pass_on(const std::vector<Message>& late);

  // Where it rests, this brings it back.
  const dialogue::Conversation& conversation() {
    wake();
    return *conversation_;
  }
  SessionPort& port() {
    return *port_;
  }
  const SessionPort& port() const {
    return *port_;
  }
  // What it wants would have to wait for a record that the journal could not
  // keep.
  bool is_stuck() const {
    return kept_.strict && has_gap_;
  }

  // While an outcome is to come, which only the present port can hear, that one
  // stays. An error leaves all as it was.
  Expected<void> renew(Timestamp now);

  // -- rest (engine rule 7.14)

  // Where no input was taken for so long, and nothing goes on, here or with
  // others, of which it has to hear first: the conversation is written down and
  // ends, and so do its topics' frames. Whatever comes next finds it as it was.
  void rest_if_idle(Milliseconds idle, Timestamp now);

  // -- another program (engine rule 7.13)

  // It is to go over to this as soon as it may; the last one counts.
  void change_to(std::shared_ptr<const ProgramChange> change) {
    change_ = std::move(change);
  }
  // Null: it is to stay as it is.
  const std::shared_ptr<const ProgramChange>& change() const {
    return change_;
  }
  // There is a change, and nothing is going on that has no counterpart there.
  bool may_go_over(Timestamp now) {
    return change_ && conversation().is_at_rest(now);
  }
  // What keeps it from that, as far as it waits in scripts, ends with an error.
  void end_scripts(Timestamp now);
  // What is lost of the dialogue, a phrase each. Only where may_go_over().
  std::vector<std::string> go_over(Timestamp now);

  // "waits for an answer in state Welcome".
  std::string doing() const;

  // What it has not read when it has ended.
  std::vector<Message> take_unread() {
    return conversation_->take_unread();
  }

private:
  bool may_rest(Timestamp now) const;
  void wake();
  // The port, as the conversation sees it.
  dialogue::Port& seen(SessionPort& port);
  // Appends a record; notes where it stands, or that it was lost.
  void keep(decltype(dialogue::SessionRecord::what) what);
  // If it is kept, a gap is over: what was lost is in the state.
  void keep_state();
  // What the port holds back from now on waits for the last record, too.
  void bind_effects();
  // What each state begins with, so that it can be read alone.
  dialogue::SessionOpened opened() const;
  // What was just done is no input that the journal knows.
  void keep_state_behind_gap();

  std::shared_ptr<const script::Program> program_;
  dialogue::ConversationOptions options_;
  const JournalUse kept_;
  std::uint64_t inputs_ = 0;          // that it has taken
  std::uint64_t inputs_in_state_ = 0; // those that the last state knows
  dialogue::TurnLog turns_;
  std::uint64_t last_record_ = 0; // of this session in the journal
  // Where its last state, or its beginning, stands in the journal.
  std::shared_ptr<const Journal::Part> part_;
  bool has_moved_ = false; // the journal has gone on to another part
  bool has_gap_ = false;   // a record was lost
  std::shared_ptr<const ProgramChange> change_; // null: none
  // Both before the conversation, which they outlive.
  std::unique_ptr<SessionPort> port_;
  std::unique_ptr<dialogue::RecordingPort> recording_;   // null: no journal
  std::unique_ptr<dialogue::Conversation> conversation_; // null: it rests
  std::string at_rest_;      // what it is made from then
  Timestamp last_input_ = 0; // 0: it has not begun
};

} // namespace parlour::actors
