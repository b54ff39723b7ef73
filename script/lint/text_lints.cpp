// text-like-expression: braces that embed nothing although a variable stands
// in them. (What no braces are needed for, the compiler tells.)
#include <cctype>

#include "script/attribute_check.hpp"
#include "script/lint/passes.hpp"
#include "script/plain_brace.hpp"

namespace parlour::script::lint {

namespace {

// Every name that anything in the application gives to a variable.
std::set<std::string> declared_names(const Subject& subject) {
  std::set<std::string> names{"this"};
  walk(subject, true, [&](const Element& element, const ElementRule&) {
    for (const auto* attribute : {"name", "return", "each", "index"})
      if (const auto value = element.value(attribute); is_identifier(value))
        if (element.is("var") || element.is("const") || element.is("param") ||
            element.is("object") || element.is("getlist") ||
            element.is("for") || element.is("catch") ||
            std::string_view(attribute) == "return")
          names.insert(value);
  });
  return names;
}

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

struct Text {
  std::string_view text;
  Position position;
  bool collapsed = false;
  bool is_spoken = false; // a brace in it is hardly meant
};

class TextLint {
public:
  TextLint(const std::set<std::string>& names, Findings& findings)
      : names_(names), findings_(findings) {}

  void look_at(const Text& text) {
    if (!look_for_variables(text) && text.is_spoken)
      look_for_braces(text);
  }

private:
  bool look_for_variables(const Text& text);
  void look_for_braces(const Text& text);
  void warn_at(const Text& text, std::size_t at, std::size_t length,
               std::string message) {
    findings_.add({Severity::warning,
                   {text.position, at, length, text.collapsed},
                   std::move(message),
                   "text-like-expression"});
  }

  const std::set<std::string>& names_;
  Findings& findings_;
};

void TextLint::look_for_braces(const Text& text) {
  const auto at = plain_brace(text.text);
  if (at != std::string_view::npos)
    warn_at(text, at, 1,
            "this brace is said as it is, as it embeds no expression; for a "
            "brace that is meant write '{{' or '}}'");
}

// Whether there was anything to warn of.
bool TextLint::look_for_variables(const Text& text) {
  constexpr auto npos = std::string_view::npos;
  const auto all = text.text;
  const auto before = findings_.all().size();
  for (auto at = all.find('{'); at != npos; at = all.find('{', at + 1)) {
    const bool doubled = at + 1 < all.size() && all[at + 1] == '{';
    const auto inner = all.substr(at + (doubled ? 2 : 1));
    const auto close = inner.find('}');
    const auto word = first_word(inner);
    at += doubled ? 1 : 0;
    if (!names_.count(word))
      continue;
    if (close == npos)
      warn_at(text, at, 1,
              "this brace embeds nothing, as it is not closed; for the "
              "variable write {" +
                  word + "}");
    else if (doubled)
      warn_at(text, at - 1, close + 4,
              "doubled braces are said as they are; for the variable write {" +
                  word + "}");
    else if (!parse_expression(inner.substr(0, close)).node)
      warn_at(text, at, close + 2,
              "these braces are said as they are, as what is inside is no "
              "expression; for the variable write {" +
                  word + "}");
  }
  return findings_.all().size() > before;
}

// What is said as it stands there.
bool is_spoken(const Element& element, const std::string& attribute) {
  return (element.is("speak") && attribute == "param") ||
         ((element.is("slot") || element.is("confirm")) &&
          attribute == "question") ||
         (element.is("constraint") && attribute == "message");
}

} // namespace

void lint_texts(const Subject& subject, Findings& findings) {
  const auto names = declared_names(subject);
  TextLint lint(names, findings);
  std::set<const Element*> wordings; // of questions and explanations
  walk(subject, false, [&](const Element& element, const ElementRule& rule) {
    using enum AttributeKind;
    for (const auto& attribute : element.attributes) {
      const auto* known = rule.attribute(attribute.name);
      if (known &&
          (known->kind == text || (known->kind == text_or_expression &&
                                   !parse_expression(attribute.value).node)))
        lint.look_at({attribute.value, attribute.value_position, false,
                      is_spoken(element, attribute.name)});
    }
    if (element.is("help") || element.is("explain"))
      for (const auto& wording : element.children)
        wordings.insert(&wording);
    const bool is_said = element.is("phrase") || element.is("value");
    if (is_said && element.text.find('{') != std::string::npos) {
      const auto said = collapsed(element.text);
      lint.look_at(
          {said, element.text_position, true, wordings.count(&element) > 0});
    }
  });
}

} // namespace parlour::script::lint
