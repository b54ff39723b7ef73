// Lines follow the rules of CSV (RFC 4180), with backslashes for line breaks:
// so a message is always one line, and a person can type it.
#include "adapters/agents/wire/text_line.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <forward_list>

#include "adapters/agents/wire/special_characters.hpp"
#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::agents {
namespace {

// What a reader holds if no message is longer.
constexpr std::size_t usual_capacity = 64 << 10;

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

// Neither quotation marks nor escapes are needed.
bool is_plain(std::string_view field) {
  return field.empty() || !(is_blank(field.front()) || is_blank(field.back()) ||
                            has_special(field));
}

// Most fields are copied as they are.
void add_field(std::string& line, std::string_view field) {
  if (is_plain(field)) {
    line += field;
    return;
  }
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
  FieldScanner(std::string_view line, std::vector<std::string_view>& fields)
      : rest_(line),
        is_simple_(line.find('"') == line.npos && line.find('\\') == line.npos),
        fields_(fields) {}

  Read<void> run() {
    fields_.clear();
    for (;;) {
      auto field = next();
      if (!field)
        return tl::make_unexpected(std::move(field.error()));
      fields_.push_back(*field);
      if (fields_.size() > max_fields)
        return oversized("a message has too many fields");
      if (rest_.empty())
        return {};
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
    if (is_simple_)
      return field;
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
    return made_.emplace_front(std::move(single));
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
    return made_.emplace_front(std::move(plain));
  }

  std::string_view rest_;
  // Fields are what stands between commas, without exception.
  const bool is_simple_;
  std::vector<std::string_view>& fields_;
  // A list, which needs no memory as long as it is empty.
  std::forward_list<std::string> made_;
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

Read<void> split(FieldScanner& scanner, std::string_view line) {
  Read<void> done;
  if (find_invalid_utf8(line))
    done = malformed("the line is not UTF-8");
  else
    done = scanner.run();
  if (!done && begins_binary(line))
    return lost_track(std::move(done.error()));
  return done;
}

} // namespace

Read<std::string> line_of(const AgentMessage& message) {
  std::string line;
  if (auto appended = append_line(line, message); !appended)
    return tl::make_unexpected(std::move(appended.error()));
  return line;
}

// Fields at the end are left out as fields_of() does.
Read<void> append_line(std::string& text, const AgentMessage& message) {
  if (auto checked = check_writable(message); !checked)
    return checked;
  append_attributes(text, message);
  const bool has_more = !message.parameters.empty() || message.payload;
  const bool has_command = has_more || !message.command.empty();
  const bool has_component = has_command || !message.component.empty();
  if (has_component || message.time)
    text += ',';
  if (message.time)
    append_number(text, *message.time);
  const auto add = [&](std::string_view field) {
    text += ',';
    add_field(text, field);
  };
  if (has_component)
    add(message.component);
  if (has_command)
    add(message.command);
  for (const auto& parameter : message.parameters)
    add(parameter);
  if (message.payload) {
    add(message.payload->format);
    text += ',';
    append_number(text, message.payload->bytes.size());
  }
  text += '\n';
  if (message.payload)
    text += message.payload->bytes;
  return {};
}

void LineReader::add(std::string_view bytes) {
  if (bytes.empty())
    return;
  std::memcpy(room(bytes.size()).data(), bytes.data(), bytes.size());
  added(bytes.size());
}

std::span<char> LineReader::room(std::size_t least) {
  if (at_ == end_)
    at_ = end_ = scanned_ = 0;
  if (capacity_ - end_ < least || (end_ == 0 && capacity_ > usual_capacity))
    make_room(least);
  return {held_.get() + end_, capacity_ - end_};
}

void LineReader::added(std::size_t bytes) {
  end_ += bytes;
}

// What was read gives way first. More memory than usual is let go of once it is
// not needed any more. It grows by doubling, so that each byte is moved once or
// twice on average.
void LineReader::make_room(std::size_t least) {
  const auto kept = unread();
  const auto needed = kept.size() + least;
  if (needed <= capacity_ && capacity_ <= usual_capacity) {
    std::memmove(held_.get(), kept.data(), kept.size());
  } else {
    const auto capacity = std::max(
        usual_capacity, needed <= usual_capacity ? needed : 2 * needed);
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    if (!kept.empty())
      std::memcpy(larger.get(), kept.data(), kept.size());
    held_ = std::move(larger);
    capacity_ = capacity;
  }
  end_ -= at_;
  scanned_ -= std::min(scanned_, at_);
  at_ = 0;
}

// Reads one line.
void LineReader::take(std::string_view line, Next& next) {
  FieldScanner scanner(line, fields_);
  if (auto done = split(scanner, line); done)
    take_fields(next);
  else
    next = tl::make_unexpected(std::move(done.error()));
}

// A payload is awaited even if its line is malformed, since its bytes are not
// lines.
void LineReader::take_fields(Next& next) {
  auto length = take_length(fields_);
  if (!length) {
    next = lost_track(std::move(length.error()));
    return;
  }
  auto& message = next.emplace();
  if (auto read = read_message(fields_, *length, *message); !read)
    message = tl::make_unexpected(std::move(read.error()));
  if (*length == 0 || (!message && closes_connection(message.error())))
    return;
  waiting_ = std::exchange(next, {});
  wanted_ = *length;
}

// Nothing until the payload has arrived completely.
void LineReader::take_payload(Next& next) {
  if (unread().size() < wanted_)
    return;
  if (*waiting_)
    (*waiting_)->payload->bytes = unread().substr(0, wanted_);
  at_ += wanted_;
  next = std::exchange(waiting_, {});
}

// The next line without its line break; nothing until it has arrived
// completely.
std::optional<std::string_view> LineReader::line() {
  const auto all = unread();
  const auto end = all.find('\n', std::max(at_, scanned_) - at_);
  if (end == std::string_view::npos) {
    scanned_ = end_;
    return {};
  }
  auto line = all.substr(0, end);
  at_ += end + 1;
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  return line;
}

std::optional<Read<AgentMessage>> LineReader::next() {
  Next next;
  while (!next) {
    if (waiting_) {
      take_payload(next);
      break;
    }
    const auto found = line();
    // A line that is too long is refused before its end has arrived.
    if (!found && unread().size() <= max_line_bytes)
      break;
    if (!found || found->size() > max_line_bytes)
      next = oversized("the line is too long");
    else if (!found->empty()) // an empty line has no effect
      take(*found, next);
    // A payload of which all has arrived already follows at once.
  }
  return next;
}

} // namespace parlour::adapters::agents
