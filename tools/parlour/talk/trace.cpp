// The words of a kind are those of the table in inspection.hpp.
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

std::string_view word_for(InspectionKind kind) {
  switch (kind) {
#define X(name, sentence)                                                      \
  case InspectionKind::name:                                                   \
    return #name;
    PARLOUR_INSPECTION_KINDS(X)
#undef X
  }
  return "";
}

} // namespace

std::string trace_line(const Inspection& inspection) {
  std::string line(word_for(inspection.kind));
  line.resize(12, ' '); // the column where the text begins
  const auto with_message = inspection.message != nullptr;
  line += with_message ? to_string(*inspection.message) : inspection.subject;
  if (!with_message || inspection.kind == InspectionKind::unhandled)
    line += (inspection.subject.empty() ? "" : ": ") + inspection.detail;
  if (!inspection.way.empty())
    line += "  [" + inspection.way + "]";
  return as_one_line(std::move(line));
}

std::string as_one_line(std::string text) {
  std::string line;
  for (const auto c : text)
    if (c != '\n' && c != '\r')
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  return line;
}

} // namespace parlour::tools
