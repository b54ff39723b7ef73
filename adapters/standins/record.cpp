#include "adapters/standins/record.hpp"

#include <ostream>
#include <string>

#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters {

namespace {

// Tabs and line breaks would destroy the form of the line.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (char c : text) {
    if (c == '\n')
      line += "\\n";
    else if (c == '\r')
      line += "\\r";
    else if (c == '\t')
      line += "\\t";
    else
      line += c;
  }
  return line;
}

// Quotes as RFC 4180 does: only a text with a comma or a quotation mark.
std::string csv(const Value& value) {
  const auto text = in_one_line(value.is_unknown() ? "" : value.text());
  if (text.find_first_of(",\"") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

} // namespace

Expected<void> Record::open(const std::filesystem::path& file) {
  if (auto may = check_may_be_file(file); !may)
    return may;
  // If the folder cannot be created, opening the file fails.
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  stream_.open(file, std::ios::app | std::ios::binary);
  if (!stream_)
    return fail(ErrorKind::file, "The record cannot be written.",
                {file.string(), 0, 0});
  return {};
}

bool Record::write(Timestamp time, const Message& message) {
  auto line = format_timestamp(time, "%Y-%m-%dT%H:%M:%S") + '\t' +
              in_one_line(message.command) + '\t';
  for (const auto& param : message.params)
    line += (&param == message.params.data() ? "" : ",") + csv(param);
  stream_.clear();
  stream_ << line << '\n' << std::flush;
  return stream_.good();
}

} // namespace parlour::adapters
