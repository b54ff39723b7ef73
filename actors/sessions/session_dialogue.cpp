#include "actors/sessions/session_dialogue.hpp"

#include <utility>

#include "script/dialogue/inputs/replay.hpp"
#include "script/dialogue/inputs/session_record.hpp"
#include "script/vm/program_identity.hpp"

namespace parlour::actors {

SessionDialogue::SessionDialogue(std::shared_ptr<const script::Program> program,
                                 dialogue::ConversationOptions options,
                                 MakePort make_port,
                                 std::shared_ptr<Journal> journal)
    : program_(std::move(program)), options_(std::move(options)),
      make_port_(std::move(make_port)), journal_(std::move(journal)),
      port_(make_port_()),
      conversation_(std::make_unique<dialogue::Conversation>(program_, options_,
                                                             seen(*port_))) {
  if (journal_)
    journal_->append(dialogue::to_bytes(
        {options_.session,
         dialogue::SessionOpened{script::identity_of(*program_),
                                 options_.seed}}));
}

void SessionDialogue::take(dialogue::SessionInput input, Timestamp now) {
  if (!journal_)
    return dialogue::take(*conversation_, std::move(input), now);
  // Before it is dealt with: the conversation may take it apart.
  auto noted = dialogue::to_bytes(*program_, {now, input});
  dialogue::take(*conversation_, std::move(input), now);
  auto answers = dialogue::to_bytes(*program_, recording_->take_answers());
  journal_->append(dialogue::to_bytes(
      {options_.session,
       dialogue::InputTaken{std::move(noted), std::move(answers)}}));
}

dialogue::Port& SessionDialogue::seen(SessionPort& port) {
  if (!journal_)
    return port;
  recording_ = std::make_unique<dialogue::RecordingPort>(port);
  return *recording_;
}

Expected<void> SessionDialogue::renew(Timestamp now) {
  const bool keeps_port = conversation_->expects_outcome();
  auto port = keeps_port ? nullptr : make_port_();
  // The recording port of the conversation before lives as long as that one.
  auto recording = std::move(recording_);
  auto next = dialogue::Conversation::restore(program_, options_,
                                              seen(keeps_port ? *port_ : *port),
                                              conversation_->save());
  if (!next) {
    recording_ = std::move(recording);
    return tl::make_unexpected(std::move(next.error()));
  }
  conversation_ = std::move(*next);
  if (keeps_port)
    return {};
  port_ = std::move(port); // what worked for the one before ends with its port
  take(dialogue::input::Resumed(), now);
  return {};
}

} // namespace parlour::actors
