// `parlour format`. The layout itself is script/format.
#include <algorithm>
#include <istream>
#include <iterator>
#include <optional>
#include <ostream>

#include "script/format/format.hpp"
#include "script/xml/source_reader.hpp"
#include "tools/parlour/application/fix.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"

namespace parlour::tools {

namespace {

// Formats one text after the other and remembers the worst exit status.
class Formatting {
public:
  Formatting(const Places& places, const FormatOptions& options,
             const Console& console)
      : places_(places), options_(options), console_(console) {}

  // Reads all of standard input and prints the result.
  void standard_input(std::istream& in);
  // Formats a file in place. It is only written if its text changes.
  void file(const std::string& name);
  int status() const {
    return status_;
  }

private:
  // The formatted text; nothing if the source is not well-formed. Findings
  // about it are printed then.
  std::optional<std::string> formatted(const std::string& text,
                                       const std::string& name);
  // With --check, reports an unformatted text. True if nothing remains to be
  // written.
  bool only_checks(const std::string& before, const std::string& after,
                   const std::string& name);
  // One bad file does not stop the others; the worst status counts.
  void failed(int status, const std::string& message) {
    say_error(console_, message);
    status_ = std::max(status_, status);
  }

  const Places& places_;
  const FormatOptions& options_;
  const Console& console_;
  int status_ = exit_code::success;
};

std::optional<std::string> Formatting::formatted(const std::string& text,
                                                 const std::string& name) {
  script::Findings findings;
  auto result =
      script::format_source(text, findings.add_file(name, text), findings);
  if (!result) {
    print_lines(console_.err, findings.all(), places_);
    status_ = std::max(status_, exit_code::wrong);
  }
  return result;
}

bool Formatting::only_checks(const std::string& before,
                             const std::string& after,
                             const std::string& name) {
  if (!options_.check)
    return before == after;
  if (before != after) {
    console_.err << name << ": not formatted\n";
    status_ = std::max(status_, exit_code::wrong);
  }
  return true;
}

void Formatting::standard_input(std::istream& in) {
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto result = formatted(text, "standard input");
  if (!result)
    return;
  if (options_.check)
    only_checks(text, *result, "standard input");
  else
    console_.out << *result << std::flush;
}

// A file that cannot be read is wrong usage, one that is not well-formed an
// error inside of it.
void Formatting::file(const std::string& name) {
  const auto path = places_.working / name;
  const auto text = script::read_bytes(path);
  if (!text)
    return failed(exit_code::usage, name + ": " + text.error().message);
  const auto result = formatted(*text, path.string());
  if (!result || only_checks(*text, *result, name))
    return;
  if (const auto written = replace_file(path, *result); !written)
    failed(exit_code::wrong, written.error().message);
}

} // namespace

int format_command(const Places& places, const FormatOptions& options,
                   std::istream& in, const Console& console) {
  Formatting formatting(places, options, console);
  for (const auto& file : options.files)
    if (file == "-")
      formatting.standard_input(in);
    else
      formatting.file(file);
  return formatting.status();
}

} // namespace parlour::tools
