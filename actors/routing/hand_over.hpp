// Messages into components' mailboxes, and the answers for those that cannot be
// handed over. The one place for the rule that a message which waits for an
// answer gets exactly one (engine rule 1).
#pragma once

#include <optional>
#include <string>

#include "actors/routing/component_mailbox.hpp"
#include "actors/routing/routing_table.hpp"
#include "runtime/base/message.hpp"

namespace parlour::actors {

struct Services;

// The event that answers a message whose component failed.
Message failure_answer(const std::string& component, const Message& message,
                       const std::string& reason);

// Where even the answer for a component that failed is for one that failed,
// nobody is answered again, however the routes lead.
enum class Answers : bool { no, yes };

// Puts it into the component's mailbox. Where that does not take it, it is
// counted and shown as unhandled; returned is the event that answers it, if it
// waits for one.
std::optional<Message> hand_over(Services& services, const Target& target,
                                 ComponentMailbox::Job job);

// Sends a question by the table, as every sender may (engine rule 1); false
// where nobody is there to take it.
bool ask_by_table(Services& services, Message question, const Work& work);

} // namespace parlour::actors
