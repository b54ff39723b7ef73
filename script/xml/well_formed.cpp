#include "script/xml/well_formed.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "script/xml/xml_characters.hpp"
#include "script/xml/xml_declaration.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view entities[] = {"lt", "gt", "amp", "quot", "apos"};
constexpr std::size_t most_faults = 1000;

bool is_alphanumeric(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// "&name;", "&#65;", "&#x41;" or what was meant to be one, from its `&` on.
struct Reference {
  std::string_view name; // without & and ;
  bool is_closed = false;

  std::size_t length() const {
    return 1 + name.size() + (is_closed ? 1 : 0);
  }
  bool is_number() const {
    return name.starts_with('#');
  }
};

Reference reference_at(std::string_view text) {
  std::size_t end = 1;
  if (end < text.size() && text[end] == '#')
    ++end;
  while (end < text.size() && is_alphanumeric(text[end]))
    ++end;
  return {text.substr(1, end - 1), end < text.size() && text[end] == ';'};
}

// The number of the character that "#65" or "#x41" is; nothing where it is
// none.
std::optional<std::uint32_t> number_of(std::string_view name) {
  const bool hexadecimal = name.starts_with("#x");
  const auto digits = name.substr(hexadecimal ? 2 : 1);
  std::uint32_t code = 0;
  const auto* last = digits.data() + digits.size();
  const auto [end, error] =
      std::from_chars(digits.data(), last, code, hexadecimal ? 16 : 10);
  if (digits.empty() || end != last || error == std::errc::invalid_argument)
    return {};
  return error == std::errc{} ? code : 0;
}

bool is_entity(std::string_view name) {
  return std::find(std::begin(entities), std::end(entities), name) !=
         std::end(entities);
}

class Scanner {
public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<XmlSlip> scan();

private:
  bool starts(std::string_view what) const {
    return text_.substr(at_).starts_with(what);
  }
  // The offset of what ends here, or the end of the text.
  std::size_t find(std::string_view what, std::size_t from) const {
    return std::min(text_.find(what, from), text_.size());
  }
  void tell(std::size_t offset, std::size_t length, std::string message,
            std::optional<std::string> replacement = {}) {
    faults_.push_back(
        {offset, length, std::move(message), std::move(replacement)});
  }
  void skip_blanks() {
    at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
  }
  void markup();
  void text();
  void comment();
  void instruction();
  void declaration();
  void start_tag();
  void attribute();
  void name(std::string_view ends, const char* of_what);
  void reference();
  void number(const Reference& found);

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<XmlSlip> faults_;
};

std::vector<XmlSlip> Scanner::scan() {
  while (at_ < text_.size() && faults_.size() < most_faults)
    if (text_[at_] == '<')
      markup();
    else
      text();
  return std::move(faults_);
}

void Scanner::markup() {
  if (starts("<!--"))
    return comment();
  if (starts("<?"))
    return instruction();
  if (starts("<![CDATA[")) {
    at_ = find("]]>", at_) + 3;
  } else if (starts("<!")) {
    at_ = find(">", at_) + 1;
  } else if (starts("</")) {
    at_ += 2;
    name("> \t\r\n", "an element");
    at_ = find(">", at_) + 1;
  } else {
    start_tag();
  }
}

void Scanner::text() {
  const auto end = find("<", at_);
  while (at_ < end) {
    at_ = std::min(text_.substr(0, end).find_first_of("&]", at_), end);
    if (at_ == end)
      return;
    if (text_[at_] == '&') {
      reference();
    } else if (starts("]]>")) {
      tell(at_, 3, "']]>' in a text is written ]]&gt;", "]]&gt;");
      at_ += 3;
    } else {
      ++at_;
    }
  }
}

// In one, "--" stands at its end only.
void Scanner::comment() {
  const auto begin = at_;
  const auto end = find("-->", begin + 4);
  for (at_ = begin + 4; at_ < end;) {
    const auto dashes = text_.find("--", at_);
    if (dashes >= end)
      break;
    if (dashes >= 2 && text_.substr(dashes - 2).starts_with("<!--")) {
      tell(dashes - 2, 4,
           "a comment cannot stand in another one, which would end at the "
           "first '-->'");
      at_ = dashes + 2;
      continue;
    }
    const auto behind = text_.find_first_not_of('-', dashes);
    if (dashes + 2 == behind &&
        (text_[behind] == '\n' || text_[behind] == '\r')) {
      tell(dashes, 2, "a comment ends with '-->': '>' is missing here");
      at_ = behind;
      continue;
    }
    // What is left of them belongs to the end: "--->".
    const auto last = std::min(behind, end);
    std::string apart;
    for (auto i = dashes; i < last; ++i)
      apart += i + 1 < behind ? "- " : "-";
    tell(dashes, last - dashes,
         "'--' may not stand in a comment; put a blank between the dashes",
         std::move(apart));
    at_ = last;
  }
  at_ = end + 3;
}

void Scanner::declaration() {
  if (auto fault = declaration_fault(text_, at_))
    faults_.push_back(std::move(*fault));
}

void Scanner::instruction() {
  const auto begin = at_;
  const auto end = find("?>", begin);
  if (is_xml_declaration(text_.substr(begin))) {
    const bool only_blanks = text_.find_first_not_of(blanks) == begin;
    if (begin == 0)
      declaration();
    else if (only_blanks)
      tell(0, begin,
           "the XML declaration stands at the very beginning of a file; take "
           "the blanks before it out",
           "");
    else
      tell(begin, end + 2 - begin,
           "an XML declaration stands at the very beginning of a file; take "
           "this one out",
           "");
  } else {
    at_ += 2;
    name("? \t\r\n", "an instruction");
  }
  at_ = end + 2;
}

// Up to one of `ends`.
void Scanner::name(std::string_view ends, const char* of_what) {
  const auto end = std::min(text_.find_first_of(ends, at_), text_.size());
  const auto name = text_.substr(at_, end - at_);
  if (name.empty())
    tell(at_, 1, "the name of " + std::string(of_what) + " is missing here");
  else if (xml_name_length(name) != name.size())
    tell(at_, name.size(),
         "'" + std::string(name) + "' cannot be the name of " + of_what +
             ": a name begins with a letter or _, and goes on with letters, "
             "digits, _, - or .");
  at_ = end;
}

void Scanner::start_tag() {
  ++at_;
  name("/> \t\r\n", "an element");
  for (;;) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] == '>')
      break;
    if (text_[at_] == '/')
      ++at_;
    else
      attribute();
  }
  ++at_;
}

void Scanner::attribute() {
  name("= \t\r\n", "an attribute");
  at_ = std::min(text_.find_first_of("\"'", at_), text_.size());
  const auto end = at_ == text_.size() ? at_ : text_.find(text_[at_], at_ + 1);
  const auto close = std::min(end, text_.size());
  while (at_ < close) {
    at_ = std::min(text_.substr(0, close).find_first_of("&<", at_), close);
    if (at_ == close)
      break;
    if (text_[at_] == '&') {
      reference();
      continue;
    }
    tell(at_, 1, "'<' in a value must be written &lt; (in an expression: lt)",
         "&lt;");
    ++at_;
  }
  at_ = close + 1;
}

void Scanner::number(const Reference& found) {
  const auto shown = std::string(text_.substr(at_, found.length()));
  const auto code = number_of(found.name);
  if (found.name.starts_with("#X"))
    return tell(at_, found.length(),
                shown + " is written &#x" + std::string(found.name.substr(2)) +
                    ";");
  if (!code)
    return tell(at_, found.length(),
                shown + " is no character; expected its number, such as "
                        "&#233; or &#xe9;");
  if (!found.is_closed)
    return tell(at_, found.length(), "';' is missing behind " + shown,
                shown + ";");
  if (!is_xml_character(*code))
    tell(at_, found.length(),
         shown + " is a character that XML does not allow; take it out");
}

void Scanner::reference() {
  const auto found = reference_at(text_.substr(at_));
  const auto shown = "&" + std::string(found.name);
  if (found.is_number()) {
    number(found);
    at_ += found.length();
    return;
  }
  std::size_t length = found.length();
  if (text_.substr(at_).starts_with("&&"))
    tell(at_, length = 2,
         "'&&' must be written &amp;&amp; (in an expression: and)",
         "&amp;&amp;");
  else if (!is_entity(found.name) && found.is_closed)
    tell(at_, length,
         "there is no " + shown + "; in XML: write the character itself");
  else if (is_entity(found.name) && !found.is_closed)
    tell(at_, length, "';' is missing: expected " + shown + ";", shown + ";");
  else if (!found.is_closed)
    tell(at_, length = 1, "'&' must be written &amp; (in an expression: and)",
         "&amp;");
  at_ += length;
}

} // namespace

std::vector<XmlSlip> find_faults(std::string_view text) {
  return Scanner(text).scan();
}

} // namespace parlour::script
