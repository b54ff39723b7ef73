#include "adapters/standins/log_telephone.hpp"

namespace parlour::adapters {

namespace {

// The event that a value of the option `answer` means.
std::string outcome_of(const std::string& answer) {
  if (answer == "busy")
    return "Busy";
  return answer == "noanswer" ? "NoAnswer" : "Answered";
}

} // namespace

Expected<void> LogTelephone::on_options(const Options& options) {
  auto answer = option_of(options, "answer", {"answered", "busy", "noanswer"});
  if (!answer)
    return tl::make_unexpected(answer.error());
  auto ringing = parse_duration(option_or(options, "rings", "0s"));
  if (!ringing)
    return tl::make_unexpected(ringing.error());
  outcome_ = outcome_of(*answer);
  ringing_ = *ringing;
  return {};
}

bool LogTelephone::carry_out(const Message& message) {
  if (message.command != "Call" && message.command != "Transfer")
    return false;
  const auto number = text_param(message, 0);
  if (is_phone_number(number))
    ring(message);
  else
    fire_event("Failed", {"'" + number + "' is not a telephone number."});
  return true;
}

// Without ringing time the outcome follows at once, in the same call.
void LogTelephone::ring(const Message& message) {
  fire_event("Ringing");
  if (ringing_ == Milliseconds(0))
    return fire_event(outcome_);
  host().after(ringing_, [this, message] { answer(message, outcome_); });
}

PluginFactory log_telephone_factory() {
  auto description =
      describe_stand_in("LogTelephone", "Telephone", "the telephone exchange",
                        {{"answer",
                          "answered",
                          "how calls end",
                          false,
                          OptionType::choice,
                          {"answered", "busy", "noanswer"}},
                         {"rings", "0s", "how long it rings before that", false,
                          OptionType::duration}});
  return {description, [] { return std::make_unique<LogTelephone>(); }};
}

} // namespace parlour::adapters
