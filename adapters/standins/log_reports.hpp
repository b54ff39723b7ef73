// LogWeather (role Weather) and LogTraffic (role Traffic) are stand-ins for
// services that report on weather and traffic. They answer from a file of the
// application (report_table.hpp).
//
//  Weather: Ask(place, when)   Traffic: Ask(road)
//  Report(text, data), or Failed(reason), which lists what there is
#pragma once

#include <string>
#include <vector>

#include "adapters/standins/report_table.hpp"
#include "adapters/standins/stand_in.hpp"

namespace parlour::adapters {

class LogReports : public StandIn {
public:
  // `keys` are the parameters of Ask, under the names of the file's columns.
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
