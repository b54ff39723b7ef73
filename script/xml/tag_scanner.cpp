#include "script/xml/tag_scanner.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "script/source/findings.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view blanks = " \t\r\n";

bool is_name_start(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return std::isalpha(byte) || letter == '_' || byte >= 0x80;
}

bool is_name_part(char letter) {
  return is_name_start(letter) ||
         std::isdigit(static_cast<unsigned char>(letter)) ||
         std::string_view("-.:").find(letter) != npos;
}

// The length of a typographic quotation mark; 0 if there is none.
std::size_t typographic_quote(std::string_view text) {
  return text.size() > 2 && text[0] == '\xe2' && text[1] == '\x80' &&
                 static_cast<unsigned char>(text[2]) >= 0x98 &&
                 static_cast<unsigned char>(text[2]) <= 0x9f
             ? 3
             : 0;
}

// In double quotes if the value has none itself.
std::string in_quotes(std::string_view value) {
  const char quote = value.find('"') == npos ? '"' : '\'';
  return quote + std::string(value) + quote;
}

// The attribute that a value without a name probably belongs to.
std::string likely_attribute(std::string_view element) {
  for (const auto& rule : element_table())
    if (same_name(rule.name, element))
      for (const auto& attribute : rule.attributes)
        if (attribute.required)
          return attribute.name;
  return "name";
}

class TagScanner {
public:
  TagScanner(std::string_view text, std::size_t offset,
             std::vector<XmlMistake>& mistakes)
      : text_(text), begin_(offset), at_(offset), mistakes_(mistakes) {}

  ScannedTag scan();

private:
  ScannedTag special();
  ScannedTag end_tag();
  ScannedTag start_tag();
  void attribute();
  void value(std::string_view name);
  void quoted(std::string_view name);
  void unquoted(std::string_view name);
  void typographic();
  void without_value(std::string_view name, std::size_t begin);
  void stray();
  bool lost_quote(std::string_view name, std::size_t begin);
  bool is_less_than() const;
  bool ends_value(std::size_t behind) const;
  bool mixed_quotes(std::string_view name, std::size_t begin, std::size_t end);

  char here() const {
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool starts(std::string_view what) const {
    return text_.substr(at_).starts_with(what);
  }
  void skip_blanks() {
    at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
  }
  std::string_view take_name() {
    const auto begin = at_;
    while (at_ < text_.size() && is_name_part(text_[at_]))
      ++at_;
    return text_.substr(begin, at_ - begin);
  }
  void tell(std::size_t begin, std::size_t end, std::string message,
            std::optional<std::string> replacement = {}) {
    mistakes_.push_back(
        {begin, end - begin, std::move(message), std::move(replacement)});
  }
  // Where the tag probably ends if one of its quotes is not closed: at the last
  // '>' of the line, else at the line's end.
  std::size_t end_on_line(std::size_t from) const {
    const auto line = std::min(text_.find('\n', from), text_.size());
    const auto close = text_.substr(0, line).rfind('>');
    if (close == npos || close < from)
      return line;
    return text_[close - 1] == '/' ? close - 1 : close;
  }

  std::string_view text_;
  std::size_t begin_;
  std::size_t at_;
  std::string_view name_;
  std::vector<XmlMistake>& mistakes_;
};

ScannedTag TagScanner::special() {
  static constexpr std::pair<std::string_view, std::string_view> kinds[] = {
      {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};
  for (const auto& [open, close] : kinds) {
    if (!starts(open))
      continue;
    const auto found = text_.find(close, at_ + open.size());
    const auto end = found == npos ? text_.size() : found + close.size();
    if (found == npos)
      tell(at_, at_ + open.size(),
           (open == "<!--" ? "this comment" : "what begins here") +
               std::string(" does not end; expected ") + std::string(close));
    return {TagKind::other, {}, end};
  }
  tell(at_, at_ + 1,
       "a '<' that begins no tag is written &lt; (in an expression: lt)",
       is_less_than() ? std::optional<std::string>("&lt;") : std::nullopt);
  return {TagKind::other, {}, at_ + 1};
}

// Whether the '<' compares or is part of a text: there are words before it, and
// no tag begins with it.
bool TagScanner::is_less_than() const {
  const auto before = text_.find_last_not_of(blanks, at_ - 1);
  const auto behind = text_.find_first_not_of(blanks, at_ + 1);
  constexpr std::string_view followed = " =0123456789";
  return at_ > 0 && before != npos && text_[before] != '>' && behind != npos &&
         text_[behind] != '<' && followed.find(text_[at_ + 1]) != npos;
}

ScannedTag TagScanner::end_tag() {
  at_ += 2;
  skip_blanks();
  name_ = take_name();
  skip_blanks();
  if (here() != '>') {
    tell(begin_, at_, "'>' is missing: expected </" + std::string(name_) + ">");
    if (const auto close = end_on_line(at_);
        close < text_.size() && text_[close] == '>')
      at_ = close + 1;
    return {TagKind::end, name_, at_};
  }
  return {TagKind::end, name_, at_ + 1};
}

// An attribute that consists of its name only.
void TagScanner::without_value(std::string_view name, std::size_t begin) {
  const auto end = begin + name.size();
  if (name == "if" && name_ == "else")
    return tell(begin_, end, "'else if' is one element: <elseif cond=\"…\">");
  tell(begin, end,
       "the attribute '" + std::string(name) + "' has no value; expected " +
           std::string(name) + "=\"…\"");
}

void TagScanner::typographic() {
  const auto begin = at_;
  at_ += 3;
  const auto from = at_;
  while (at_ < text_.size() && text_[at_] != '>' && text_[at_] != '\n' &&
         !typographic_quote(text_.substr(at_)))
    ++at_;
  const auto inner = text_.substr(from, at_ - from);
  const bool closed = typographic_quote(text_.substr(at_)) > 0;
  at_ += closed ? 3 : 0;
  tell(begin, at_,
       "these are typographic quotation marks; a value stands in straight "
       "ones: " +
           in_quotes(inner),
       closed ? std::optional(in_quotes(inner)) : std::nullopt);
}

// Whether a value can end before this offset: the tag ends there, or another
// attribute follows.
bool TagScanner::ends_value(std::size_t behind) const {
  const auto next = text_.find_first_not_of(blanks, behind);
  if (next == npos || text_[next] == '>' ||
      text_.substr(next).starts_with("/>"))
    return next != npos;
  auto end = next;
  while (end < text_.size() && is_name_part(text_[end]))
    ++end;
  return next > behind && end > next && text_.substr(end).starts_with("=");
}

// A value without its opening quote; the closing one is on the same line.
bool TagScanner::lost_quote(std::string_view name, std::size_t begin) {
  const auto line = std::min(text_.find_first_of("\n<", begin), text_.size());
  const auto end = text_.find('"', begin);
  if (end >= line || !ends_value(end + 1))
    return false;
  const auto value = text_.substr(begin, end - begin);
  if (value.empty() || value.find('>') != npos)
    return false;
  at_ = end + 1;
  tell(begin, at_,
       "the value of '" + std::string(name) +
           "' has no opening quote; expected " + std::string(name) + "=\"…\"",
       in_quotes(value));
  return true;
}

void TagScanner::unquoted(std::string_view name) {
  const auto begin = at_;
  if (lost_quote(name, begin))
    return;
  while (at_ < text_.size() && blanks.find(text_[at_]) == npos &&
         text_[at_] != '>' && !starts("/>") && text_[at_] != '<')
    ++at_;
  const auto value = text_.substr(begin, at_ - begin);
  tell(begin, std::max(at_, begin + 1),
       "a value stands in quotes: " + std::string(name) + "=" +
           in_quotes(value),
       value.empty() || value.find_first_of("\"'`") != npos
           ? std::nullopt
           : std::optional(in_quotes(value)));
}

// More of the value follows its closing quote, because the value contains the
// same quotes: param="say "hello" to him".
bool TagScanner::mixed_quotes(std::string_view name, std::size_t begin,
                              std::size_t end) {
  const char next = end + 1 < text_.size() ? text_[end + 1] : '>';
  constexpr std::string_view ends = " \t\r\n>/?,;";
  if (ends.find(next) != npos)
    return false;
  if (is_name_start(next)) { // perhaps only the blank is missing
    auto behind = end + 1;
    while (behind < text_.size() && is_name_part(text_[behind]))
      ++behind;
    if (text_.substr(behind).starts_with("=\"") ||
        text_.substr(behind).starts_with("='")) {
      tell(end, end + 1, "a blank is missing behind this quote",
           std::string(1, text_[end]) + " ");
      return false;
    }
  }
  const auto quote = std::string(1, text_[begin]);
  tell(end, end + 1,
       "the value of '" + std::string(name) + "' ends at this " + quote +
           ", and more follows; inside of " + quote + "…" + quote +
           " texts stand in " +
           (quote == "\"" ? "'…', and a value is embedded as {name}"
                          : "\"…\", and a value is embedded as {name}"));
  return true;
}

void TagScanner::quoted(std::string_view name) {
  const auto begin = at_;
  const auto quote = text_[at_];
  const auto end = text_.find(quote, at_ + 1);
  const auto value = text_.substr(begin + 1, end - begin - 1);
  const auto line = value.find('\n');
  // The value runs on beyond the tag's end and into the next tag.
  const bool swallows =
      end == npos || (value.substr(0, line).find('>') != npos && line != npos &&
                      value.find('<', line) != npos);
  if (swallows) {
    at_ = end_on_line(begin + 1);
    return tell(begin, begin + 1,
                "the value of '" + std::string(name) +
                    "' has no closing quote; expected another " +
                    std::string(1, quote));
  }
  at_ = end + 1;
  if (mixed_quotes(name, begin, end))
    at_ = std::max(at_, end_on_line(end));
}

void TagScanner::value(std::string_view name) {
  ++at_; // '='
  skip_blanks();
  if (here() == '"' || here() == '\'')
    quoted(name);
  else if (typographic_quote(text_.substr(at_)))
    typographic();
  else
    unquoted(name);
}

// Something that cannot be an attribute.
void TagScanner::stray() {
  const auto begin = at_;
  const char sign = here();
  if (sign == '"' || sign == '\'') {
    const auto end = text_.find(sign, at_ + 1);
    const auto close = end_on_line(at_);
    at_ = end == npos || end > close ? close : end + 1;
    const auto name = likely_attribute(name_);
    return tell(begin, at_,
                "a value without the name of its attribute; expected " + name +
                    "=" + std::string(text_.substr(begin, at_ - begin)));
  }
  ++at_;
  if (sign == ',' || sign == ';')
    return tell(begin, at_,
                "attributes are separated by blanks; leave out the '" +
                    std::string(1, sign) + "'",
                "");
  while (at_ < text_.size() && blanks.find(text_[at_]) == npos &&
         text_[at_] != '>' && text_[at_] != '<')
    ++at_;
  tell(begin, at_,
       "'" + std::string(text_.substr(begin, at_ - begin)) +
           "' is not expected in a tag; attributes are name=\"value\"");
}

void TagScanner::attribute() {
  const auto begin = at_;
  if (!is_name_start(here()) || typographic_quote(text_.substr(at_)))
    return stray();
  const auto name = take_name();
  const auto behind = at_;
  skip_blanks();
  if (here() == '=')
    return value(name);
  if (here() == ':' || here() == '"' || here() == '\'') {
    tell(begin, behind, "'=' is missing behind '" + std::string(name) + "'");
    if (here() == ':')
      return value(name);
    return quoted(name);
  }
  at_ = behind;
  without_value(name, begin);
}

ScannedTag TagScanner::start_tag() {
  ++at_;
  name_ = take_name();
  for (;;) {
    skip_blanks();
    if (starts("/>"))
      return {TagKind::empty, name_, at_ + 2};
    if (here() == '>')
      return {TagKind::start, name_, at_ + 1};
    if (here() == '\0' || here() == '<') {
      tell(begin_, begin_ + 1 + name_.size(),
           "this tag is not closed: '>' or '/>' is missing");
      return {holds_nothing(name_) ? TagKind::empty : TagKind::start, name_,
              at_};
    }
    if (here() == '/') {
      tell(at_, at_ + 1, "'/' stands directly before the '>': />");
      ++at_;
      continue;
    }
    attribute();
  }
}

ScannedTag TagScanner::scan() {
  const auto told = static_cast<std::ptrdiff_t>(mistakes_.size());
  const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
  auto tag = next == '/'           ? end_tag()
             : is_name_start(next) ? start_tag()
                                   : special();
  tag.is_certain = std::all_of(
      mistakes_.begin() + told, mistakes_.end(),
      [](const XmlMistake& mistake) { return mistake.replacement; });
  if (!tag.is_certain)
    std::for_each(mistakes_.begin() + told, mistakes_.end(),
                  [](XmlMistake& mistake) { mistake.replacement.reset(); });
  return tag;
}

} // namespace

bool holds_nothing(std::string_view name) {
  bool known = false;
  for (const auto& rule : element_table()) {
    if (rule.name != name &&
        same_but_case(rule.name, {std::string(name)}).empty())
      continue;
    if (!rule.holds.empty())
      return false;
    known = true;
  }
  return known;
}

ScannedTag scan_tag(std::string_view text, std::size_t offset,
                    std::vector<XmlMistake>& mistakes) {
  return TagScanner(text, offset, mistakes).scan();
}

} // namespace parlour::script
