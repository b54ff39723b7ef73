// Conversation: one session's dialogue as a plain state machine: inputs come in
// by the functions below, wishes go out through its Port. No thread, clock or
// actor in it; equal inputs give equal states and words (architecture rule 1).
// Not thread-safe; owned by a session actor.
//
// Inputs are queued by receive() and taken one at a time by step(), so that
// whatever waits in the queue is known before a question is released (engine
// rule 3). While awaiting_frame(), frame_applied() is the only input allowed. A
// session actor calls it like this, one input after the other:
//
//   conversation.open(now);               // once
//   conversation.receive(message);        // whenever one arrives
//   while (conversation.step(now))        // after what else is in the mailbox
//     ;                                   //   unless a frame is awaited
//   conversation.timer_fired(id, now);    // and the other outcomes
//   conversation.close(now);              // where somebody wants it to end
//   if (conversation.ended()) …           // after each input
//
// Inputs that come after the end are ignored. What scripts do wrong is shown
// and raised there; no input returns an error or throws.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/message/message.hpp"
#include "script/dialogue/acts/acts.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/context/conversation_options.hpp"
#include "script/dialogue/frame/topic_frame.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

class ConversationImplementation;
class Renames; // saved/renames.hpp

// Each input function but take_acts() and end_scripts() has its alternative in
// SessionInput (inputs/session_input.hpp), by which it is kept and repeated.
class Conversation {
public:
  using Options = ConversationOptions;

  // The port must outlive the conversation. Nothing runs before open().
  Conversation(std::shared_ptr<const script::Program> program, Options options,
               Port& port);
  ~Conversation();

  // Session.Started: variables get their values, the start state or topic is
  // entered. An error of an initial value ends the session. The first input.
  void open(Timestamp now);

  // Queues a message that the message centre gave to this session. It is only
  // noted here (a turn may begin, speech is known); step() deals with it.
  void receive(Message message);
  // The same for one that others may have got, too.
  void receive(std::shared_ptr<const Message> message);

  // What the user did with one utterance, from somebody who speaks in acts and
  // not in words: the dialogue engine without script and understanding. Not for
  // sessions: benches measure with it. All of it is dealt with at once.
  void take_acts(std::span<const ActPointer> acts, Timestamp now);

  // Something is queued, or an output waits for release. False after the end,
  // and while a frame is awaited.
  bool has_work() const;
  // A filling event is with the topic's actor (Port::apply).
  bool awaiting_frame() const;
  // Takes one queued input to its end or wait, or releases outputs if there
  // is no input. Returns has_work(). `now` must not be earlier than that of the
  // input before.
  bool step(Timestamp now);

  // The answer to Port::apply. One that nobody awaits is ignored: the session
  // may have begun to end since.
  void frame_applied(FrameResult result, Timestamp now);
  // Outcomes of what was wanted from the port, by the id given there; one that
  // nobody waits for any more is ignored. Of a query it is a result set, which
  // scripts then share.
  void query_answered(QueryId id, Expected<Value> outcome, Timestamp now);
  void file_answered(QueryId id, Expected<Value> outcome, Timestamp now);
  void component_answered(QueryId id, Expected<void> outcome, Timestamp now);
  void socket_opened(SocketId id, Expected<void> outcome, Timestamp now);
  // By the other side. Whoever tells of it receives its message, too.
  void socket_closed(SocketId id);
  // One that was cancelled in the meantime is ignored.
  void timer_fired(TimerId id, Timestamp now);
  // The seat has shown it; `played` false: it was interrupted before a word was
  // heard. Where a loudspeaker plays it, too, its Speaker.Finished counts
  // instead.
  void output_finished(OutputId id, bool played, Timestamp now);

  // Ends the session: Exit runs, waits are cancelled, Session.Ended is fired.
  // It may not be over when this returns, as these scripts may wait for
  // components, for `request-timeout` at most: ended() says so. What was not
  // released yet leaves, but for questions.
  void close(Timestamp now);
  // Nothing else will be wanted of the port.
  bool ended() const;

  // Waits for a component, a query or words: the world is not quiet while one
  // of these is due to come by itself. A script's <wait> is the clock's matter.
  bool waits_for_answer() const;

  // Whatever was said to it is taken up, and nothing more is to come of it by
  // itself but after some time. With a voice, it has finished speaking, too.
  bool has_answered(Timestamp now) const;

  // All that it knows as bytes (saved/archive.hpp), between any two inputs.
  std::string save() const;
  // Goes on from there, in any process that has compiled the same program.
  // Nothing is said to the port: what was asked of one before is still wanted,
  // and where this is another one, resume() asks it. Bytes of another program
  // or damaged ones are an error of kind File.
  static Expected<std::unique_ptr<Conversation>>
  restore(std::shared_ptr<const script::Program> program, Options options,
          Port& port, std::string_view bytes);

  // The port is another one than before save() and knows nothing of what was
  // asked for: it is asked anew, timers at the times when they were due. What
  // might be done twice is not: such an outcome is an error of kind InDoubt
  // (engine rule 7.9). An input like others, the first one here, and the only
  // one that is allowed while awaiting_frame().
  void resume(Timestamp now);
  // What was asked last is asked again, unless something else is going on.
  void ask_again();
  // Something is outstanding, beside timers, that resume() would ask for again
  // or give up. A session that is renewed keeps its port while this is true.
  bool expects_outcome() const;

  // Nothing runs, waits or is said, and nobody is heard: another program may
  // take over here (engine rule 7.12). Silence may be watched, and timers of
  // scripts be due.
  bool is_at_rest(Timestamp now) const;
  // What waits in scripts ends with an error of kind Cancelled. An input. It
  // leads to rest unless their <catch> begins something new.
  void end_scripts(Timestamp now);
  // The dialogue of `before`, which is at rest, as another conversation of the
  // program that `renames` leads to; at the same port, which is told of nothing
  // but what is over. `before` is left as it is, and must take no further
  // input.
  struct TakenOver {
    std::unique_ptr<Conversation> conversation;
    std::vector<std::string> lost; // a phrase each
  };
  static TakenOver take_over(const Conversation& before, const Renames& renames,
                             Options options, Port& port, Timestamp now);
  // Another program's dialogue from its beginning in the place of `before`,
  // which is at rest and must take no further input; open() comes next. Its
  // timers are cancelled at the port; nothing that is still on its way to
  // `before` is taken for an answer to this one.
  static std::unique_ptr<Conversation>
  begin_instead(const Conversation& before,
                std::shared_ptr<const script::Program> program, Options options,
                Port& port);

  // Whether a <request> waits for what answers this message.
  bool awaits_reply(Correlation correlation) const;

  // What was received but not yet taken when the session ended, in order: for
  // another session of the same seat (engine rule 4.6).
  std::vector<Message> take_unread();

  // For `expect slot` and `expect state`, the console and the trace: no input,
  // and nothing changes. Unknown or empty where there is no such thing.
  Value slot_value(std::string_view topic, std::string_view slot) const;
  std::string state() const;
  std::string current_topic() const;

private:
  std::unique_ptr<ConversationImplementation> implementation_;
};

} // namespace parlour::dialogue
