// Converts what messages carry to values and back. Structures become lists, in
// the order of their members. Reading checks the form; its error has the kind
// Network.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/phrases.hpp"
#include "runtime/message/understanding.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

Value to_value(const Message& message);
Expected<Message> message_from(const Value& value);

Value to_value(const Error& error);
// Never fails: an unknown kind of error is read as Network.
Error error_from(const Value& value);

Value to_value(const Rendering& rendering);
// Never fails: if the words cannot be read, they are empty.
Rendering rendering_from(const Value& value);

Value to_value(const Options& options);
Expected<Options> options_from(const Value& value);

Value to_value(const std::vector<std::string>& texts);
Expected<std::vector<std::string>> texts_from(const Value& value);

// A null pointer is unknown.
Value to_value(const std::shared_ptr<const UnderstandingModel>& model);
Expected<std::shared_ptr<const UnderstandingModel>>
understanding_from(const Value& value);

} // namespace parlour::adapters
