// LogTelephone (role Telephone), a stand-in for the telephone exchange.
//
//   Call(number, who)  Ringing, then Answered, Busy or NoAnswer
//   Transfer(number)   the same
//   a number that cannot be dialled: Failed(reason)
#pragma once

#include <string>

#include "adapters/standins/stand_in.hpp"

namespace parlour::adapters {

class LogTelephone : public StandIn {
public:
  LogTelephone() : StandIn("telephone") {}

protected:
  Expected<void> on_options(const Options& options) override;
  bool carry_out(const Message& message) override;

private:
  void ring(const Message& message);

  std::string outcome_; // the event that ends a call
  Milliseconds ringing_{};
};

PluginFactory log_telephone_factory();

} // namespace parlour::adapters
