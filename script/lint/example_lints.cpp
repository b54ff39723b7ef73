// same-example: two topics have the same example, so nobody can tell which is
// meant.
//
//   <topic name="Taxi"><examples><value>I want to go</value>…
//   <topic name="Room"><examples><value>I want to go!</value>…
#include <cctype>
#include <map>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// The words of an example without marks and punctuation: "I want
// [David](Host)!" becomes "i want david".
std::string words_of(std::string_view example) {
  std::string words;
  bool in_slot_name = false;
  for (std::size_t at = 0; at < example.size(); ++at) {
    const auto letter = static_cast<unsigned char>(example[at]);
    const bool opens = letter == '(' && at > 0 && example[at - 1] == ']';
    in_slot_name = (in_slot_name || opens) && letter != ')';
    const bool counts = letter >= 0x80 || std::isalnum(letter);
    if (!in_slot_name && counts)
      words += static_cast<char>(std::tolower(letter));
    else if (std::isspace(letter) && !words.empty() && words.back() != ' ')
      words += ' ';
  }
  if (words.ends_with(' '))
    words.pop_back();
  return words;
}

// Remembers the topic of each example seen so far.
class ExampleLint {
public:
  explicit ExampleLint(Findings& findings) : findings_(findings) {}

  void look_at(const Element& topic) {
    const auto* examples = topic.child("examples");
    if (!examples)
      return;
    for (const auto& example : examples->children)
      look_at(example, topic.value("name"));
  }

private:
  // The same words twice in one topic are harmless.
  void look_at(const Element& example, const std::string& topic) {
    const auto words = words_of(example.text);
    const auto [known, fresh] = topics_.try_emplace(words, topic);
    if (!words.empty() && !fresh && known->second != topic)
      warn(findings_, "same-example", example.position,
           "the topic '" + known->second +
               "' has this example too: who says so may be asked which is "
               "meant; keep it in one of them, or add words that tell them "
               "apart");
  }

  std::map<std::string, std::string> topics_; // the first one with these words
  Findings& findings_;
};

} // namespace

void lint_examples(const LintContext& context, Findings& findings) {
  ExampleLint lint(findings);
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    if (element.is("topic") && !is_statement(rule))
      lint.look_at(element);
  });
}

} // namespace parlour::script::lint
