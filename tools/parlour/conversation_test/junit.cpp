// The XML is small, so it is printed with format strings.
#include "tools/parlour/conversation_test/junit.hpp"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "tools/parlour/conversation_test/report.hpp"

namespace parlour::tools {

namespace {

// Escapes text for attributes and elements. Control characters, which XML does
// not allow, become '?'.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const auto c : text)
    switch (c) {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    case '\n':
      safe += "&#10;";
      break;
    case '\t':
      safe += c;
      break;
    default:
      safe += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  return safe;
}

// A failure's text is the same as in the printed report.
void print_case(std::ostream& out, const std::string& application,
                const ConversationResult& result) {
  out << fmt::format("  <testcase classname=\"{}\" name=\"{}\" file=\"{}\" "
                     "time=\"{:.3f}\"",
                     escaped(application), escaped(result.name),
                     escaped(result.file), result.seconds);
  if (!result.failure) {
    out << "/>\n";
    return;
  }
  out << fmt::format(">\n    <failure message=\"{}\">{}</failure>\n"
                     "  </testcase>\n",
                     escaped("line " + std::to_string(result.failure->line) +
                             ": " + result.failure->found),
                     escaped(failure_text(result)));
}

} // namespace

void print_junit(std::ostream& out, const std::string& application,
                 const std::vector<ConversationResult>& results) {
  double seconds = 0;
  for (const auto& result : results)
    seconds += result.seconds;
  // CI servers want the totals before the cases.
  const auto failures =
      std::count_if(results.begin(), results.end(),
                    [](const auto& result) { return !!result.failure; });
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      << fmt::format("<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
                     "time=\"{:.3f}\">\n",
                     escaped(application), results.size(), failures, seconds);
  for (const auto& result : results)
    print_case(out, application, result);
  out << "</testsuite>\n";
}

} // namespace parlour::tools
