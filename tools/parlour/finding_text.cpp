#include "tools/parlour/finding_text.hpp"

#include <ostream>

#include <nlohmann/json.hpp>

namespace parlour::tools {

namespace {

std::string counted(std::size_t number, const char* word) {
  return std::to_string(number) + ' ' + word + (number == 1 ? "" : "s");
}

} // namespace

FindingCount count(const std::vector<script::Finding>& findings) {
  FindingCount result;
  for (const auto& finding : findings)
    ++(finding.severity == script::Severity::error ? result.errors
                                                   : result.warnings);
  return result;
}

std::string to_string(const FindingCount& count) {
  return counted(count.errors, "error") + ", " +
         counted(count.warnings, "warning");
}

void print_lines(std::ostream& out,
                 const std::vector<script::Finding>& findings,
                 const Places& places) {
  for (auto finding : findings) {
    finding.place.file = shown_path(places, finding.place.file);
    out << script::to_string(finding) << '\n';
  }
}

void print_json(std::ostream& out,
                const std::vector<script::Finding>& findings) {
  auto array = nlohmann::ordered_json::array();
  for (const auto& finding : findings)
    array.push_back(
        {{"file", finding.place.file},
         {"line", finding.place.line},
         {"column", finding.place.column},
         {"severity",
          finding.severity == script::Severity::error ? "error" : "warning"},
         {"message", finding.message}});
  using Json = nlohmann::ordered_json;
  out << array.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace parlour::tools
