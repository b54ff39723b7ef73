#include "adapters/standins/log_reports.hpp"

#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

namespace {

// Both plug-ins are the same class with other names.
PluginFactory factory(const std::string& name, const std::string& role,
                      const std::string& service, const std::string& record,
                      const std::vector<std::string>& keys) {
  auto description = describe_stand_in(
      name, role, service,
      {{"reports", "", "what it reads out, a .tsv file of the application",
        true}});
  return {description, [record, keys] {
            return std::make_unique<LogReports>(record, keys);
          }};
}

} // namespace

Expected<void> LogReports::on_options(const Options& options) {
  const auto name = option_or(options, "reports", "");
  if (name.empty())
    return fail(ErrorKind::settings,
                "option 'reports' names the file of what is reported");
  const auto path = inside(host().application_folder(), name, "reports");
  if (!path)
    return tl::make_unexpected(path.error());
  auto table = ReportTable::read(*path, keys_);
  if (!table)
    return tl::make_unexpected(table.error());
  table_ = std::move(*table);
  return {};
}

bool LogReports::carry_out(const Message& message) {
  if (message.command != "Ask")
    return false;
  // One parameter for each key column.
  std::vector<std::string> asked;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    asked.push_back(text_param(message, i));
  if (auto report = table_.find(asked))
    fire_event("Report", {report->text, report->data});
  else
    fail_to_find(asked.front());
  return true;
}

// Lists what can be asked for.
void LogReports::fail_to_find(const std::string& subject) {
  std::string known;
  for (const auto& name : table_.subjects())
    known += (known.empty() ? "" : ", ") + name;
  fire_event("Failed", {"There is no report for '" + subject +
                        "'; there are reports for " + known + "."});
}

PluginFactory log_weather_factory() {
  return factory("LogWeather", "Weather", "the weather service", "weather",
                 {"place", "when"});
}

PluginFactory log_traffic_factory() {
  return factory("LogTraffic", "Traffic", "the traffic service", "traffic",
                 {"road"});
}

} // namespace parlour::adapters
