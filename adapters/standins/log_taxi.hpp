// LogTaxi (role Taxi) is a stand-in for a taxi company. It makes up a plate and
// a waiting time, the same ones in every run with the same seed.
//
//  Book(from, to, time, name)  Booked(plate, minutes), or Refused(reason)
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "adapters/standins/stand_in.hpp"

namespace parlour::adapters {

class LogTaxi : public StandIn {
public:
  LogTaxi() : StandIn("taxi") {}

protected:
  Expected<void> on_options(const Options& options) override;
  bool carry_out(const Message& message) override;

private:
  // The option `answer`: every booking is refused.
  bool refuses_ = false;
  std::uint64_t seed_ = 0;
  std::uint64_t bookings_ = 0;
};

// A plate in the form of Singapore's taxis, "SHA 1234 G", with its check
// letter. The same number gives the same plate.
std::string singapore_taxi_plate(std::uint64_t number);

// The letter at the end of a plate, from its prefix of three letters and its
// number of up to four digits.
char singapore_check_letter(std::string_view prefix, std::uint64_t digits);

PluginFactory log_taxi_factory();

} // namespace parlour::adapters
