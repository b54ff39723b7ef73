// LogSMS (role SMS), a stand-in for the SMS gateway.
//
//   Send(number, text)  Sent, or Failed(reason)
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
  bool fails_ = false;
};

PluginFactory log_sms_factory();

} // namespace parlour::adapters
