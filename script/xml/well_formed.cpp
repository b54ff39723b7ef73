// One pass over the text, construct by construct:
//
//   markup       what begins with '<': comments, instructions, tags
//   text         character data between tags
//   attribute    a name and a quoted value
//   reference    &name; and &#number;

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
constexpr std::size_t max_faults = 1000;

bool is_alphanumeric(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// A reference such as "&name;", "&#65;" or "&#x41;", or an attempt at one,
// which starts at its `&`.
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

// Letters and digits behind '&', and whether a semicolon closes them.
Reference reference_at(std::string_view text) {
  std::size_t end = 1;
  if (end < text.size() && text[end] == '#')
    ++end;
  while (end < text.size() && is_alphanumeric(text[end]))
    ++end;
  return {text.substr(1, end - 1), end < text.size() && text[end] == ';'};
}

// The code point of "#65" or "#x41"; nothing if it has no digits or others. A
// number that is too large becomes 0, which is no XML character.
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

// Whether XML defines an entity of this name.
bool is_entity(std::string_view name) {
  return std::find(std::begin(entities), std::end(entities), name) !=
         std::end(entities);
}

// Walks over the markup of a text once. The parser has accepted it, so tags and
// comments are known to end; only what is inside of them is checked.
class Scanner {
public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<XmlMistake> scan();

private:
  bool starts(std::string_view what) const {
    return text_.substr(at_).starts_with(what);
  }
  // The offset of the next `what`, or the end of the text.
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
  std::vector<XmlMistake> faults_;
};

// Each function starts at the construct that it reads and leaves at_ behind it.
std::vector<XmlMistake> Scanner::scan() {
  while (at_ < text_.size() && faults_.size() < max_faults)
    if (text_[at_] == '<')
      markup();
    else
      text();
  return std::move(faults_);
}

// The kinds are told apart by their first characters, the longest first.
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

// Character data up to the next tag: references, and "]]>", which XML reserves.
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

// A comment may contain "--" only as part of its end. Typical causes are told
// apart: a comment inside of a comment, a missing '>', and dashes as
// decoration.
void Scanner::comment() {
  const auto begin = at_;
  const auto end = find("-->", begin + 4);
  for (at_ = begin + 4; at_ < end;) {
    const auto dashes = text_.find("--", at_);
    if (dashes >= end)
      break;
    // The dashes of a comment that begins inside of this one.
    if (dashes >= 2 && text_.substr(dashes - 2).starts_with("<!--")) {
      tell(dashes - 2, 4,
           "a comment cannot stand in another one, which would end at the "
           "first '-->'");
      at_ = dashes + 2;
      continue;
    }
    // The whole run of dashes.
    const auto behind = text_.find_first_not_of('-', dashes);
    if (dashes + 2 == behind &&
        (text_[behind] == '\n' || text_[behind] == '\r')) {
      tell(dashes, 2, "a comment ends with '-->': '>' is missing here");
      at_ = behind;
      continue;
    }
    // The dashes before '>' belong to the end of the comment: "--->".
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

// Only at the very beginning of the file "<?xml" is the declaration.
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

// Checks the name up to one of the characters `ends`.
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

// The name and the attributes of a start tag; the parser knows that it ends.
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

// An attribute's value may contain neither a bare '<' nor a bare '&'.
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

// A numeric reference: its form first, then whether XML allows the character.
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

// XML has five named entities; all others need a document type, which scripts
// do not have.
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

std::vector<XmlMistake> find_faults(std::string_view text) {
  return Scanner(text).scan();
}

} // namespace parlour::script
