// LogWeather (role Weather) and LogTraffic (role Traffic), stand-ins for the
// services that report on either: they read out what was written beforehand in
// the application's file of reports (report_table.hpp).
//
//   Weather: Ask(place, when)   Traffic: Ask(road)
//   both: Report(text, data), or Failed(reason) that says what there is
#pragma once

#include <string>
#include <vector>

#include "adapters/standins/report_table.hpp"
#include "adapters/standins/stand_in.hpp"

namespace parlour::adapters {

class LogReports : public StandIn {
public:
  // `keys` are the parameters of Ask, as the file's columns name them.
  LogReports(std::string record, std::vector<std::string> keys)
      : StandIn(std::move(record)), keys_(std::move(keys)) {}

protected:
  Expected<void> on_options(const Options& options) override;
  bool carry_out(const Message& message) override;

private:
  void fail_to_find(const std::string& subject);

  std::vector<std::string> keys_;
  ReportTable table_;
};

PluginFactory log_weather_factory();
PluginFactory log_traffic_factory();

} // namespace parlour::adapters
