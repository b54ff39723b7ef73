// text-like-expression: braces that embed nothing although a variable is in
// them. The compiler reports texts without braces that look like expressions.
//
//   <speak param="Hello {name"/>          not closed
//   <speak param="Hello ${name}"/>        the $ is spoken, too
//   <speak param="Hello {{name}}"/>       spoken with its braces
#include <algorithm>
#include <cctype>
#include <map>

#include "script/expression/brace_mistakes.hpp"
#include "script/expression/plain_brace.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

constexpr auto npos = std::string_view::npos;

// The first word, behind blanks only.
std::string first_word(std::string_view text) {
  std::string word;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalnum(byte) || letter == '_' || byte >= 0x80)
      word += letter;
    else if (!word.empty() || letter != ' ')
      break;
  }
  return word;
}

// A text to examine, and who will get it.
struct Text {
  std::string_view text;
  Position position;
  bool collapsed = false;
  bool is_spoken = false;    // braces are hardly meant
  bool may_be_heard = false; // or read; not SQL or a file's name
};

// Examines one text after the other. The names are those declared anywhere in
// the application: which of them are visible at a place is the compiler's
// business.
class TextLint {
public:
  TextLint(const TextLint&) = delete;
  TextLint(const LintContext& context, Findings& findings)
      : names_(declared_names(context)), functions_(context.program.functions),
        known_{[this](const auto& name) { return names_.count(name) > 0; },
               [this](const auto& name) { return functions_.count(name) > 0; }},
        findings_(findings) {}

  // Variables in braces first; if there is none, any brace that would be
  // spoken.
  void look_at(const Text& text) {
    if (!look_for_variables(text) && text.is_spoken)
      look_for_braces(text);
    if (text.may_be_heard)
      look_for_foreign(text);
  }

private:
  bool look_for_variables(const Text& text);
  void look_at_doubled(const Text& text, std::size_t at);
  std::size_t look_at_brace(const Text& text, std::size_t at);
  void look_for_foreign(const Text& text);
  void look_for_braces(const Text& text);
  void warn_at(const Text& text, std::size_t at, std::size_t length,
               std::string message,
               std::optional<std::string> replacement = {}) {
    findings_.add({Severity::warning,
                   {text.position, at, length, text.collapsed},
                   std::move(message),
                   "text-like-expression",
                   std::move(replacement)});
  }

  std::set<std::string> names_;
  const std::map<std::string, CodeId, std::less<>>& functions_;
  KnownNames known_;
  Findings& findings_;
};

// The first brace that embeds nothing, if nothing more specific was found.
void TextLint::look_for_braces(const Text& text) {
  const auto at = plain_brace(text.text);
  if (at != std::string_view::npos)
    warn_at(text, at, 1,
            "this brace is said as it is, as it embeds no expression; for a "
            "brace that is meant write '{{' or '}}'");
}

// Explains {{name}}, which is said with its braces.
void TextLint::look_at_doubled(const Text& text, std::size_t at) {
  const auto inner = text.text.substr(at + 2);
  const auto close = inner.find('}');
  const auto word = first_word(inner);
  if (!names_.count(word))
    return;
  if (close == npos)
    return warn_at(text, at, 1,
                   "this brace embeds nothing, as it is not closed; for the "
                   "variable write {" +
                       word + "}");
  warn_at(text, at, close + 4,
          "doubled braces are said as they are; for the variable write {" +
              mended(inner.substr(0, close)).value_or(word) + "}");
}

// Returns the offset behind what was examined.
std::size_t TextLint::look_at_brace(const Text& text, std::size_t at) {
  const auto all = text.text;
  if (const auto end = embedded(all, at).end; end > 0)
    return end;
  const auto mistake = explain_brace(all, at, known_, text.may_be_heard);
  if (!mistake)
    return at + 1;
  if (mistake->length == 1)
    warn_at(text, at, 1,
            "this brace embeds nothing, as it is not closed; " +
                mistake->message);
  else
    warn_at(text, at, mistake->length,
            "these braces are said as they are, as what is inside is no "
            "expression: " +
                mistake->message,
            mistake->replacement);
  return at + mistake->length;
}

// Returns whether there was anything to warn of.
bool TextLint::look_for_variables(const Text& text) {
  const auto all = text.text;
  const auto before = findings_.all().size();
  for (auto at = all.find('{'); at != npos; at = all.find('{', at)) {
    const bool doubled = at + 1 < all.size() && all[at + 1] == '{';
    if (doubled)
      look_at_doubled(text, at);
    at = doubled ? at + 2 : look_at_brace(text, at);
  }
  return findings_.all().size() > before;
}

// Explains $name, ${name}, #{name}, %name% and {% … %}, the ways in which other
// languages embed values.
void TextLint::look_for_foreign(const Text& text) {
  const auto all = text.text;
  for (std::size_t at = 0; at + 1 < all.size(); ++at) {
    const char sign = all[at];
    if (sign == '{' && all[at + 1] == '%')
      return warn_at(text, at, 2,
                     "'{%' is said as it is; conditions and loops are "
                     "elements here: <if>, <for>");
    const bool braced = all[at + 1] == '{';
    if ((sign != '$' && sign != '%' && !(sign == '#' && braced)) ||
        (at > 0 && std::isalnum(static_cast<unsigned char>(all[at - 1]))))
      continue;
    const auto inner = all.substr(at + (braced ? 2 : 1));
    const auto word = first_word(inner);
    if (!names_.count(word) || !inner.starts_with(word) ||
        (sign == '%' &&
         (braced || !inner.substr(word.size()).starts_with('%'))))
      continue;
    warn_at(text, at, 1,
            "this '" + std::string(1, sign) +
                "' is said as it is; for the variable write {" + word + "}");
    at += word.size();
  }
}

// Whether the attribute is spoken as it is.
bool is_spoken(const Element& element, const std::string& attribute) {
  return (element.is("speak") && attribute == "param") ||
         ((element.is("slot") || element.is("confirm")) &&
          attribute == "question") ||
         (element.is("constraint") && attribute == "message");
}

// Whether somebody hears or reads the attribute.
bool may_be_heard(const Element& element, const std::string& attribute) {
  return is_spoken(element, attribute) ||
         ((element.is("print") || element.is("log")) && attribute == "param");
}

} // namespace

// Attributes that are text, or that could be an expression and are none; and
// the texts of phrases, wordings and examples.
void lint_texts(const LintContext& context, Findings& findings) {
  TextLint lint(context, findings);
  std::set<const Element*> wordings; // of questions and explanations
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    using enum AttributeKind;
    for (const auto& attribute : element.attributes) {
      const auto* known = rule.attribute(attribute.name);
      if (known &&
          (known->kind == text || (known->kind == text_or_expression &&
                                   !parse_expression(attribute.value).node)))
        lint.look_at({attribute.value, attribute.value_position, false,
                      is_spoken(element, attribute.name),
                      may_be_heard(element, attribute.name)});
    }
    if (element.is("help") || element.is("explain"))
      for (const auto& wording : element.children)
        wordings.insert(&wording);
    const bool is_said = element.is("phrase") || element.is("value");
    if (is_said && element.text.find_first_of("{$%") != std::string::npos) {
      const auto said = collapsed(element.text);
      lint.look_at({said, element.text_position, true,
                    wordings.count(&element) > 0, true});
    }
  });
}

} // namespace parlour::script::lint
