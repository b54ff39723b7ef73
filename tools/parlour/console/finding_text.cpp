// Findings as lines and as JSON. The excerpt with its mark is script/source.
#include "tools/parlour/console/finding_text.hpp"

#include <map>
#include <ostream>
#include <utility>

#include <nlohmann/json.hpp>

#include "script/source/excerpt.hpp"
#include "script/xml/source_reader.hpp"

namespace parlour::tools {

namespace {

using Json = nlohmann::ordered_json;

// The text of a file, read once and kept in `texts`; empty if it cannot be
// read.
const script::SourceText&
text_of(const std::string& file,
        std::map<std::string, script::SourceText>& texts) {
  const auto found = texts.find(file);
  if (found != texts.end())
    return found->second;
  auto bytes = file.empty() ? Expected<std::string>(std::string())
                            : script::read_bytes(file);
  return texts.emplace(file, script::SourceText(bytes.value_or(std::string())))
      .first->second;
}

Json json_of(const script::Finding& finding) {
  const auto& place = finding.place;
  const auto& end = finding.end.line > 0 ? finding.end : place;
  auto edits = Json::array();
  for (const auto& edit : finding.fix)
    edits.push_back({{"begin", edit.range.begin},
                     {"end", edit.range.end},
                     {"text", edit.text}});
  return {{"file", place.file},
          {"line", place.line},
          {"column", place.column},
          {"end", {{"line", end.line}, {"column", end.column}}},
          {"kind",
           finding.severity == script::Severity::error ? "error" : "warning"},
          {"name", finding.name.empty() ? "declaration" : finding.name},
          {"message", finding.message},
          {"fix", std::move(edits)}};
}

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
  std::map<std::string, script::SourceText> texts;
  for (auto finding : findings) {
    const auto& source = text_of(finding.place.file, texts);
    finding.place.file = shown_path(places, finding.place.file);
    out << script::to_string(finding) << '\n'
        << script::excerpt(source, finding);
  }
}

// Invalid UTF-8 in a message is replaced, so that the JSON is always valid.
void print_json(std::ostream& out,
                const std::vector<script::Finding>& findings) {
  auto array = Json::array();
  for (const auto& finding : findings)
    array.push_back(json_of(finding));
  out << array.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace parlour::tools
