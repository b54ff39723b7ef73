// LogSMS (role SMS) is a stand-in for an SMS gateway. No message is sent.
//
//  Send(number, text)  Sent, or Failed(reason)
#pragma once

#include "adapters/standins/stand_in.hpp"

namespace parlour::adapters {

class LogSMS : public StandIn {
public:
  LogSMS() : StandIn("sms") {}

protected:
  Expected<void> on_options(const Options& options) override;
  bool carry_out(const Message& message) override;

private:
  // The option `answer`: every message fails.
  bool fails_ = false;
};

PluginFactory log_sms_factory();

} // namespace parlour::adapters
