// LogTelephone (role Telephone) is a stand-in for a telephone exchange. No call
// is made.
//
//  Call(number, who)  Ringing, then Answered, Busy or NoAnswer
//  Transfer(number)   the same
//  an invalid number  Failed(reason)
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

  // The event with which every call ends.
  std::string outcome_;
  // How long it rings before that.
  Milliseconds ringing_{};
};

PluginFactory log_telephone_factory();

} // namespace parlour::adapters
