// same-example: two topics have the same example, perhaps with other courtesy
// or another value, so nobody can tell which is meant.
//
//   <topic name="Taxi"><examples><value>I want to go to [Bedok](To)</value>…
//   <topic name="Room"><examples><value>go to [Tampines](To), please</value>…
#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Said around a wish and part of none: with and without them an example is the
// same.
bool is_courtesy(const std::string& word) {
  static const std::set<std::string> words{
      "a",   "an",   "and", "can",  "could", "d",     "hello",  "hi",   "i",
      "id",  "like", "me",  "my",   "need",  "our",   "please", "some", "thank",
      "the", "to",   "us",  "want", "we",    "would", "you"};
  return words.contains(word);
}

// The words of an example without punctuation and courtesy: "I want
// [David](Host)!" becomes "david"; with `by_slots` "[host]".
class KeyWords {
public:
  KeyWords(std::string_view example, bool by_slots) : by_slots_(by_slots) {
    for (std::size_t at = 0; at < example.size(); ++at)
      take(example, at);
    end_word();
  }

  // All words, where courtesy is all that is said.
  const std::string& text() const {
    return keys_.empty() ? all_ : keys_;
  }

private:
  void take(std::string_view example, std::size_t at) {
    const auto letter = static_cast<unsigned char>(example[at]);
    const bool opens = letter == '(' && at > 0 && example[at - 1] == ']';
    if (opens || letter == '[' || letter == ')')
      end_word();
    in_value_ = (in_value_ || letter == '[') && letter != ']';
    in_slot_name_ = (in_slot_name_ || opens) && letter != ')';
    const bool hidden = by_slots_ ? in_value_ : in_slot_name_;
    if (letter >= 0x80 || std::isalnum(letter)) {
      if (!hidden)
        word_ += static_cast<char>(std::tolower(letter));
    } else if (letter != '\'') {
      end_word();
    }
  }

  void end_word() {
    if (word_.empty())
      return;
    all_ += word_ + ' ';
    if (!is_courtesy(word_))
      keys_ += word_ + ' ';
    word_.clear();
  }

  const bool by_slots_;
  bool in_value_ = false;
  bool in_slot_name_ = false;
  std::string word_, all_, keys_;
};

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
  struct Known {
    std::string topic;
    std::string example;
  };
  using Examples = std::map<std::string, Known>; // the first of these words

  // The same words twice in one topic are harmless.
  void look_at(const Element& example, const std::string& topic) {
    const bool is_marked = example.text.find("](") != std::string::npos;
    const auto said = same_as(by_words_, example, topic, false);
    const auto other =
        said || !is_marked ? said : same_as(by_slots_, example, topic, true);
    if (other)
      warn(findings_, "same-example", example.position,
           "the topic '" + other->topic + "' has this example too" +
               (other->example == example.text
                    ? std::string()
                    : " (\"" + collapsed(other->example) + "\")") +
               ": who says so may be asked which is meant; keep it in one of "
               "them, or add words that tell them apart");
  }

  static std::optional<Known> same_as(Examples& examples,
                                      const Element& example,
                                      const std::string& topic, bool by_slots) {
    const auto words = KeyWords(example.text, by_slots).text();
    const auto [known, fresh] =
        examples.try_emplace(words, Known{topic, example.text});
    if (words.empty() || fresh || known->second.topic == topic)
      return {};
    return known->second;
  }

  Examples by_words_;
  Examples by_slots_; // of those that have marks
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
