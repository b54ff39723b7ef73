// Generates sentences by walking through the syntax trees of grammars:
// alternatives and options are chosen at random (with a fixed seed), values are
// drawn from their sets, and the tags on the way give the expected meaning.
#include "tools/bench/nlu/frame_trial.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <utility>

#include "adapters/nlu/grammar/jsgf.hpp"
#include "runtime/base/random.hpp"

namespace parlour::tools {

namespace {

namespace jsgf = adapters::nlu::jsgf;
using jsgf::Node;
using jsgf::NodeKind;

// Words, and the value that they stand for.
struct Spoken {
  std::string words;
  std::string value;
};

// Examples of normal forms and of open words.
struct FormWords {
  std::string_view form;
  std::string_view words;
  std::string_view value;
};
constexpr FormWords form_words[] = {
    {"time", "half past three", "15:30"},
    {"time", "10:30 am", "10:30"},
    {"time", "quarter to five", "16:45"},
    {"time", "nine thirty", "09:30"},
    {"date", "tomorrow", "2026-11-22"},
    {"date", "the day after tomorrow", "2026-11-23"},
    {"date", "the third of December", "2026-12-03"},
    {"level", "the second floor", "2"},
    {"level", "level three", "3"},
    {"level", "basement one", "-1"},
    {"level", "the ground floor", "1"},
    {"number", "three", "3"},
    {"duration", "two hours", "7200"},
    {"phone", "nine one two three four five six seven", "91234567"},
    {"phone", "6555 0188", "65550188"},
    {"words", "Marina Bay", "Marina Bay"},
    {"words", "Tampines", "Tampines"},
    {"words", "Gabriel", "Gabriel"},
    {"words", "Northwind Traders", "Northwind Traders"}};

std::string joined(const std::string& left, const std::string& right) {
  return left.empty() || right.empty() ? left + right : left + ' ' + right;
}

// Generates sentences from the rules of one grammar, choosing alternatives at
// random.
class Speaker {
public:
  Speaker(const UnderstandingModel& model, const ColumnReader& columns,
          const jsgf::Grammar& grammar, Random& random)
      : model_(model), columns_(columns), grammar_(grammar), random_(random) {}

  // False if the rule gives no complete sentence with a topic, or cannot be
  // said.
  bool say(const Node& body, FrameTrial& trial) {
    trial_ = {};
    is_sentence_ = false;
    can_be_said_ = true;
    trial_.said = speak(body).words;
    trial = std::move(trial_);
    return is_sentence_ && can_be_said_ && !trial.topic.empty() &&
           !trial.said.empty();
  }

private:
  // The words of a node, with its tags applied.
  Spoken speak(const Node& node) {
    auto spoken = words_of(node);
    for (const auto& tag : node.tags)
      take(tag, spoken);
    return spoken;
  }

  // Stars and options are said or left out with equal probability.
  Spoken words_of(const Node& node) {
    switch (node.kind) {
    case NodeKind::word:
      return {node.text, node.text};
    case NodeKind::rule:
      return rule(node.text);
    case NodeKind::reference:
      return reference(node.text);
    case NodeKind::alternatives:
      return speak(one_of(node.children));
    case NodeKind::optional:
    case NodeKind::star:
      return random_.next() % 2 == 0 ? Spoken{} : all(node.children);
    case NodeKind::sequence:
    case NodeKind::plus:
      return all(node.children);
    case NodeKind::nothing:
      return {};
    case NodeKind::never:
      can_be_said_ = false;
    }
    return {};
  }

  // The value of a sequence is the one value in it, or else its words.
  Spoken all(const std::vector<Node>& nodes) {
    Spoken made;
    for (const auto& node : nodes) {
      const auto part = speak(node);
      made.value = joined(made.value, part.value);
      made.words = joined(made.words, part.words);
    }
    return made;
  }

  // Says the body of the rule in place of its name.
  Spoken rule(const std::string& name) {
    const auto found =
        std::ranges::find(grammar_.rules, name, &jsgf::Rule::name);
    if (found != grammar_.rules.end())
      return speak(found->body);
    can_be_said_ = false;
    return {};
  }

  // A slot's value is drawn from its set or column, or from the examples of its
  // form.
  Spoken reference(const std::string& name) {
    if (name.starts_with("db:"))
      return one_of_column(name);
    const auto point = name.find('.');
    if (point == std::string::npos)
      return form(name);
    const auto spoken = value_of(name.substr(0, point), name.substr(point + 1));
    trial_.slots[name.substr(point + 1)] = spoken.value;
    return spoken;
  }

  // A value that the slot takes, as its cardinality says.
  Spoken value_of(const std::string& topic_name, const std::string& slot_name) {
    const auto topic =
        std::ranges::find(model_.topics, topic_name, &TopicModel::name);
    if (topic == model_.topics.end())
      return form("");
    const auto slot =
        std::ranges::find(topic->slots, slot_name, &SlotModel::name);
    if (slot == topic->slots.end())
      return form("");
    if (!slot->source.empty())
      return one_of_column(slot->source);
    if (slot->values.empty())
      return form(slot->type.empty() ? "words" : slot->type);
    const auto& value = one_of(slot->values);
    return {value, value};
  }

  // A column without values makes the rule unsayable.
  Spoken one_of_column(const std::string& name) {
    const auto values =
        columns_ ? columns_(name) : Expected<std::vector<std::string>>();
    can_be_said_ = can_be_said_ && values && !values->empty();
    if (!can_be_said_)
      return {};
    const auto& value = one_of(*values);
    return {value, value};
  }

  // One of the examples of the form; a form without examples cannot be said.
  Spoken form(std::string_view name) {
    std::vector<Spoken> forms;
    for (const auto& one : form_words)
      if (one.form == name)
        forms.push_back({std::string(one.words), std::string(one.value)});
    can_be_said_ = can_be_said_ && !forms.empty();
    return forms.empty() ? Spoken{} : one_of(forms);
  }

  // Notes what a tag says about the words.
  void take(const jsgf::Tag& tag, const Spoken& spoken) {
    if (tag.name == "act")
      is_sentence_ = true;
    else if (tag.name == "topic")
      trial_.topic = tag.value;
    else if (tag.name == "denies")
      can_be_said_ = false;
    else
      trial_.slots[tag.name.substr(tag.name.find('.') + 1)] =
          tag.has_value ? tag.value : spoken.value;
  }

  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[random_.next() % all.size()];
  }

  const UnderstandingModel& model_;
  const ColumnReader& columns_;
  const jsgf::Grammar& grammar_;
  Random& random_;
  FrameTrial trial_;
  bool is_sentence_ = false;
  bool can_be_said_ = true;
};

// Simulates mistakes of a speech recogniser.
class Mishearing {
public:
  std::string run(const std::string& said) {
    std::istringstream in(said);
    std::string heard;
    for (std::string word; in >> word;)
      heard = joined(heard, random_.next() % misheard_one_in == 0
                                ? misheard(std::move(word))
                                : word);
    return heard;
  }

private:
  static constexpr std::uint64_t misheard_one_in = 10;

  // Small words are often not heard at all.
  std::string misheard(std::string word) {
    constexpr std::array<std::string_view, 9> small{
        "a", "an", "the", "to", "is", "of", "in", "on", "at"};
    if (std::ranges::find(small, word) != small.end())
      return "";
    switch (random_.next() % 4) {
    case 0:
      return "er " + word;
    case 1:
      return word + ' ' + word;
    default:
      return misspelt(std::move(word));
    }
  }

  // Replaces a letter by one that sounds or looks similar; never the first one
  // or a digit.
  std::string misspelt(std::string word) {
    constexpr std::string_view from = "aeioucksztdbpfvmnlr";
    constexpr std::string_view to = "eaeuokczstdpbvfnmrl";
    if (word.size() < 4)
      return word;
    auto& letter = word[1 + random_.next() % (word.size() - 1)];
    if (const auto at = from.find(letter); at != std::string_view::npos)
      letter = to[at];
    return word;
  }

  Random random_{11};
};

} // namespace

std::vector<FrameTrial> frame_trials(const UnderstandingModel& model,
                                     const ColumnReader& columns,
                                     std::size_t count) {
  std::vector<FrameTrial> made;
  std::vector<Error> ignored;
  Random random(5);
  std::vector<jsgf::Grammar> grammars;
  for (const auto& grammar : model.grammars)
    grammars.push_back(jsgf::parse(grammar, ignored));
  // Goes through all rules again and again, until there are enough sentences or
  // a round adds none.
  for (std::size_t before = 1; made.size() < count && made.size() != before;) {
    before = made.size();
    for (const auto& grammar : grammars) {
      Speaker speaker(model, columns, grammar, random);
      for (const auto& rule : grammar.rules)
        if (FrameTrial trial; rule.is_public && made.size() < count &&
                              speaker.say(rule.body, trial))
          made.push_back(std::move(trial));
    }
  }
  return made;
}

std::vector<FrameTrial> misheard(std::vector<FrameTrial> trials) {
  Mishearing mishearing;
  for (auto& trial : trials)
    trial.said = mishearing.run(trial.said);
  return trials;
}

} // namespace parlour::tools
