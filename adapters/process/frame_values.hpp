// What frames carry, as values and back. Reading fails with an error of kind
// Network where the value is none of those.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/message.hpp"
#include "runtime/base/phrases.hpp"
#include "runtime/base/understanding.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

Value to_value(const Message& message);
Expected<Message> message_from(const Value& value);

Value to_value(const Error& error);
// Never fails: an error that cannot be read is one of kind Network.
Error error_from(const Value& value);

Value to_value(const Rendering& rendering);
// Never fails: what cannot be read has no words.
Rendering rendering_from(const Value& value);

Value to_value(const Options& options);
Expected<Options> options_from(const Value& value);

Value to_value(const std::vector<std::string>& texts);
Expected<std::vector<std::string>> texts_from(const Value& value);

// Null is unknown.
Value to_value(const std::shared_ptr<const UnderstandingModel>& model);
Expected<std::shared_ptr<const UnderstandingModel>>
understanding_from(const Value& value);

} // namespace parlour::adapters
