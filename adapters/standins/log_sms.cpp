#include "adapters/standins/log_sms.hpp"

namespace parlour::adapters {

Expected<void> LogSMS::on_options(const Options& options) {
  auto answer = option_of(options, "answer", {"sent", "failed"});
  if (!answer)
    return tl::make_unexpected(answer.error());
  fails_ = *answer == "failed";
  return {};
}

bool LogSMS::carry_out(const Message& message) {
  if (message.command != "Send")
    return false;
  const auto number = text_param(message, 0);
  if (!is_phone_number(number))
    fire_event("Failed", {"'" + number + "' is not a telephone number."});
  else if (text_param(message, 1).empty())
    fire_event("Failed", {"There is no text to send."});
  else if (fails_)
    fire_event("Failed", {"The gateway does not answer."});
  else
    fire_event("Sent");
  return true;
}

PluginFactory log_sms_factory() {
  auto description = describe_stand_in("LogSMS", "SMS", "the SMS gateway",
                                       {{"answer",
                                         "sent",
                                         "how messages end",
                                         false,
                                         OptionType::choice,
                                         {"sent", "failed"}}});
  return {description, [] { return std::make_unique<LogSMS>(); }};
}

} // namespace parlour::adapters
