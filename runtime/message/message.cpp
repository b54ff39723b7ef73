#include "runtime/message/message.hpp"

namespace parlour {

std::string to_string(const Message& message) {
  auto text = message.source + "." + message.command + "(";
  for (const auto& param : message.params)
    text += (&param == message.params.data() ? "" : ", ") + to_string(param);
  text += ")";
  for (const auto& sink : message.sinks)
    text += (&sink == message.sinks.data() ? " -> " : ", ") + sink;
  return text;
}

} // namespace parlour
