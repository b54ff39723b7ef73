// Messenger: the messages that a conversation makes itself: events that it
// raises for its own reactions, and what it posts to components (engine rules
// 1.3 and 2.6).
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/inbox.hpp"

namespace parlour::dialogue {

// Keeps nothing; the inbox has what it raises, the port sends what it posts.
class Messenger {
public:
  // Both must outlive the messenger.
  Messenger(DialogueContext& context, Inbox& inbox)
      : context_(context), inbox_(inbox) {}

  // An event of a reserved source, raised in this session. It is queued, and
  // taken before any message from outside.
  void raise(const char* source, std::string command, std::vector<Value> params,
             TurnId turn = 0);
  // Sends a message on behalf of a turn; what inline components answer is
  // queued before any external event. Returns its correlation. The turn stays
  // open until the answer comes, or until `request-timeout` is over.
  Correlation post(std::string module, std::string command,
                   std::vector<Value> params, TurnId turn);
  // One of another session, which gets the answers; its correlation means
  // nothing here.
  void post_for_another(Message message);
  // Whether something that is not taken yet answers this.
  bool is_answered(Correlation correlation) const {
    return inbox_.has_answer_to(correlation);
  }
  // Whether such an answer ends a request.
  bool has_reply(Correlation correlation) const {
    return inbox_.any([&](const Message& message) {
      return message.correlation == correlation &&
             context_.port.reply_to_request(message) != Reply::none;
    });
  }
  // Counts one. False where there were too many of them without an external one
  // (Inbox): Script.Error is raised then, once, and the caller drops what it
  // was about to do.
  bool one_more_internal_event();
  // Script.Error (language rule 12.19).
  void raise_error(const Error& error, TurnId turn);
  // Shown as an error, and raised. For those that no activation of a script
  // reports itself.
  void script_failed(const Error& error, TurnId turn);

private:
  DialogueContext& context_;
  Inbox& inbox_;
};

} // namespace parlour::dialogue
