#include "tools/parlour/status/status_report.hpp"

#include <algorithm>
#include <array>
#include <ostream>

#include <nlohmann/json.hpp>

namespace parlour::tools {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const actors::ActorStatus& status, Timestamp now) {
  Json json = {{"actor", status.kind},       {"name", status.name},
               {"does", status.doing},       {"queue", status.queue},
               {"in_call_ms", nullptr},      {"last_error", status.last_error},
               {"answered", status.answered}};
  if (status.call_since)
    json["in_call_ms"] = now - *status.call_since;
  return json;
}

Json json_of(const StatusReport& report) {
  auto all = Json::array();
  for (const auto& status : report.actors)
    all.push_back(json_of(status, report.time));
  return {{"application", report.application},
          {"folder", report.folder},
          {"process", report.process},
          {"time", report.time},
          {"actors", std::move(all)}};
}

std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

actors::ActorStatus status_from(const Json& json, Timestamp now) {
  actors::ActorStatus status;
  status.kind = json.at("actor");
  status.name = json.at("name");
  status.doing = json.at("does");
  status.queue = json.at("queue");
  status.last_error = json.at("last_error");
  status.answered = json.at("answered");
  if (const auto& in_call = json.at("in_call_ms"); !in_call.is_null())
    status.call_since = now - in_call.get<Timestamp>();
  return status;
}

// -- the table ----------------------------------------------------------------

using Row = std::array<std::string, 6>;

Row row_of(const actors::ActorStatus& status, Timestamp now) {
  const auto in_call = status.call_since
                           ? std::to_string(now - *status.call_since) + " ms"
                           : std::string("-");
  return {status.kind,
          status.name.empty() ? "-" : status.name,
          std::to_string(status.queue),
          in_call,
          status.doing,
          status.last_error};
}

void print_row(std::ostream& out, const Row& row,
               const std::array<std::size_t, 6>& widths) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    line += row[i];
    line.append(widths[i] - std::min(widths[i], row[i].size()) + 2, ' ');
  }
  out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
}

} // namespace

std::string to_json(const StatusReport& report) {
  return dump(json_of(report));
}

Expected<StatusReport> report_from_json(const std::string& text) {
  try {
    const auto json = Json::parse(text);
    StatusReport report;
    report.application = json.at("application");
    report.folder = json.at("folder");
    report.process = json.at("process");
    report.time = json.at("time");
    for (const auto& one : json.at("actors"))
      report.actors.push_back(status_from(one, report.time));
    return report;
  } catch (const Json::exception& thrown) {
    return fail(ErrorKind::network,
                std::string("no status was told: ") + thrown.what());
  }
}

void print_table(std::ostream& out, const StatusReport& report) {
  std::vector<Row> rows = {
      {"actor", "name", "queue", "in a call", "does", "last error"}};
  for (const auto& status : report.actors)
    rows.push_back(row_of(status, report.time));
  std::array<std::size_t, 6> widths = {};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  out << report.application << " (process " << report.process << ", "
      << report.folder << ")\n";
  for (const auto& row : rows)
    print_row(out, row, widths);
}

void print_json(std::ostream& out, const std::vector<StatusReport>& reports) {
  auto all = Json::array();
  for (const auto& report : reports)
    all.push_back(json_of(report));
  out << dump(all);
}

} // namespace parlour::tools
