// Lines follow the rules of CSV (RFC 4180), with backslashes for line breaks:
// so a message is always one line, and a person can type it.
#include "adapters/agents/wire/text_line.hpp"

#include <algorithm>
#include <charconv>
#include <deque>

#include "runtime/base/utf8.hpp"

namespace parlour::adapters::agents {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// -- writing ------------------------------------------------------------------

// A field that would otherwise be split or lose its blanks.
bool needs_quotes(std::string_view field) {
  return field.find_first_of(",\"") != std::string_view::npos ||
         (!field.empty() &&
          (is_blank(field.front()) || is_blank(field.back())));
}

// Escapes what would end the line, the field or the quotation.
void add_character(std::string& line, char c) {
  switch (c) {
  case '\n':
    line += "\\n";
    break;
  case '\r':
    line += "\\r";
    break;
  case '\\':
    line += "\\\\";
    break;
  case '"':
    line += "\"\"";
    break;
  default:
    line += c;
  }
}

// Most fields need neither quotation marks nor escapes and are copied as they
// are.
void add_field(std::string& line, std::string_view field) {
  const bool quoted = needs_quotes(field);
  if (quoted)
    line += '"';
  if (field.find_first_of("\n\r\\\"") == std::string_view::npos)
    line += field;
  else
    for (const char c : field)
      add_character(line, c);
  if (quoted)
    line += '"';
}

// -- reading ------------------------------------------------------------------

// Splits a line into its fields. Most fields are views of the line itself. A
// field with quotation marks or escapes is written anew into `made_`, whose
// entries keep their addresses for as long as the fields are used.
class FieldScanner {
public:
  explicit FieldScanner(std::string_view line) : rest_(line) {}

  Read<std::vector<std::string_view>> run() {
    for (;;) {
      auto field = next();
      if (!field)
        return tl::make_unexpected(std::move(field.error()));
      fields_.push_back(*field);
      if (fields_.size() > max_fields)
        return oversized("a message has too many fields");
      if (rest_.empty())
        return std::move(fields_);
      rest_.remove_prefix(1); // the comma
    }
  }

private:
  // Kind, time, component and command, and a payload's format and length.
  static constexpr std::size_t max_fields = max_parameters + 6;

  // Reads a field. The rest then begins with a comma or is empty.
  Read<std::string_view> next() {
    if (rest_.starts_with('"'))
      return quoted();
    const auto field = rest_.substr(0, rest_.find(','));
    rest_.remove_prefix(field.size());
    if (field.find('"') != std::string_view::npos)
      return malformed("a quotation mark stands within a field that does not "
                       "begin with one");
    return unescaped(field);
  }

  // Finds the closing quotation mark: the first one that is not doubled.
  Read<std::string_view> quoted() {
    std::size_t end = 1;
    bool doubled = false;
    for (;; end += 2) {
      end = rest_.find('"', end);
      if (end == std::string_view::npos)
        return malformed("a quotation mark is not closed");
      if (end + 1 >= rest_.size() || rest_[end + 1] != '"')
        break;
      doubled = true;
    }
    const auto inside = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    if (!rest_.empty() && rest_.front() != ',')
      return malformed("a comma must follow a closing quotation mark");
    return unescaped(doubled ? without_doubled(inside) : inside);
  }

  // Every quotation mark inside of a quoted field is one of a pair.
  std::string_view without_doubled(std::string_view text) {
    std::string single;
    for (std::size_t i = 0; i < text.size(); ++i) {
      single += text[i];
      if (text[i] == '"')
        ++i; // the second of the pair
    }
    return made_.emplace_back(std::move(single));
  }

  // Replaces escapes. Only line breaks and backslashes have one.
  Read<std::string_view> unescaped(std::string_view text) {
    if (text.find('\\') == std::string_view::npos)
      return text;
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '\\') {
        plain += text[i];
        continue;
      }
      const auto escaped = ++i < text.size() ? text[i] : '\0';
      if (escaped == 'n')
        plain += '\n';
      else if (escaped == 'r')
        plain += '\r';
      else if (escaped == '\\')
        plain += '\\';
      else
        return malformed("a backslash is followed by n, r or a backslash");
    }
    return made_.emplace_back(std::move(plain));
  }

  std::string_view rest_;
  std::vector<std::string_view> fields_;

public:
  std::deque<std::string> made_;
};

std::optional<std::size_t> length_of(std::string_view text) {
  std::size_t length = 0;
  const auto* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, length);
  if (text.empty() || error != std::errc() || stop != end)
    return {};
  return length;
}

// Removes the length of the payload, which is the last field of a binary
// message.
Read<std::size_t> take_length(std::vector<std::string_view>& fields) {
  if (!is_binary(fields.front()))
    return std::size_t{0};
  const auto length = length_of(fields.back());
  if (!length)
    return malformed("the last field of a binary message is the length of its "
                     "payload");
  if (*length > max_message_bytes)
    return oversized("the payload is too long");
  fields.pop_back();
  return *length;
}

// The length of a payload is unknown: its bytes would be read as lines.
tl::unexpected<WireError> lost_track(WireError error) {
  error.loses_track = true;
  return tl::make_unexpected(std::move(error));
}

// Whether a line that cannot be split is that of a binary message.
bool begins_binary(std::string_view line) {
  if (line.starts_with('"'))
    line.remove_prefix(1);
  return is_binary(line.substr(0, line.find_first_of(",\"")));
}

Read<std::vector<std::string_view>> split(FieldScanner& scanner,
                                          std::string_view line) {
  Read<std::vector<std::string_view>> fields =
      malformed("the line is not UTF-8");
  if (!find_invalid_utf8(line))
    fields = scanner.run();
  if (!fields && begins_binary(line))
    return lost_track(std::move(fields.error()));
  return fields;
}

} // namespace

Read<std::string> line_of(const AgentMessage& message) {
  const auto fields = fields_of(message);
  if (!fields)
    return tl::make_unexpected(fields.error());
  std::string line;
  for (const auto& field : *fields) {
    if (&field != &fields->front())
      line += ',';
    add_field(line, field);
  }
  if (message.payload)
    line += ',' + std::to_string(message.payload->bytes.size());
  line += '\n';
  if (message.payload)
    line += message.payload->bytes;
  return line;
}

void LineReader::add(std::string_view bytes) {
  let_go_of_what_was_read();
  held_ += bytes;
}

// Removes what was read only if it is more than what is left, so that each byte
// is moved at most once on average.
void LineReader::let_go_of_what_was_read() {
  if (at_ < held_.size() / 2)
    return;
  held_.erase(0, at_);
  scanned_ -= std::min(scanned_, at_);
  at_ = 0;
}

// Reads one line. A payload is awaited even if its line is malformed, since its
// bytes are not lines.
std::optional<Read<AgentMessage>> LineReader::take(std::string_view line) {
  FieldScanner scanner(line);
  auto fields = split(scanner, line);
  if (!fields)
    return tl::make_unexpected(std::move(fields.error()));
  const auto length = take_length(*fields);
  if (!length)
    return lost_track(length.error());
  auto message = message_of(*fields, *length);
  if (*length == 0 || (!message && closes_connection(message.error())))
    return message;
  waiting_ = std::move(message);
  wanted_ = *length;
  return {};
}

// Nothing until the payload has arrived completely.
std::optional<Read<AgentMessage>> LineReader::payload() {
  if (held_.size() - at_ < wanted_)
    return {};
  if (*waiting_)
    (*waiting_)->payload->bytes = held_.substr(at_, wanted_);
  at_ += wanted_;
  return std::exchange(waiting_, {});
}

// The next line without its line break; nothing until it has arrived
// completely.
std::optional<std::string_view> LineReader::line() {
  const auto end = held_.find('\n', std::max(at_, scanned_));
  if (end == std::string::npos) {
    scanned_ = held_.size();
    return {};
  }
  auto line = std::string_view(held_).substr(at_, end - at_);
  at_ = end + 1;
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  return line;
}

std::optional<Read<AgentMessage>> LineReader::next() {
  for (;;) {
    if (waiting_)
      return payload();
    const auto found = line();
    // A line that is too long is refused before its end has arrived.
    if (!found && held_.size() - at_ <= max_line_bytes)
      return {};
    if (!found || found->size() > max_line_bytes)
      return oversized("the line is too long");
    // An empty line has no effect.
    if (found->empty())
      continue;
    if (auto read = take(*found))
      return read;
  }
}

} // namespace parlour::adapters::agents
