// Each walk begins with another arc of the start state, so that every rule is
// walked, and ends where a rule is complete. The rule, and the tags on the way,
// tell the meaning. Chance begins anew with each walk, from its first word:
// what is drawn from a rule does not hang on the other rules.
#include "adapters/nlu/grammar/sampled_sentences.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "adapters/nlu/text/hash.hpp"
#include "runtime/base/random.hpp"

namespace parlour::adapters::nlu {

namespace {

// A longer walk goes in circles.
constexpr std::size_t longest = 24;

class Walker {
public:
  Walker(const Automaton& automaton, const Schema& schema)
      : automaton_(automaton), schema_(schema),
        words_(automaton.vocabulary.size() + 1) {
    for (const auto& [word, number] : automaton.vocabulary)
      words_[number] = word;
  }

  std::vector<SampledSentence> run(std::size_t count);

private:
  // The arcs of a state as one list: first those of words.
  struct Step {
    const Arc* arc = nullptr;
    bool is_value = false;
  };

  static std::vector<Step> steps_from(const State& state);
  std::string text_of(const Step& step) const;
  std::optional<SampledSentence> walk(Step step);
  void take(const Step& step);
  void read_tags(std::uint32_t actions);
  void close(const TagInfo& tag);
  std::optional<SentenceMeaning> meaning(const RuleInfo& rule) const;
  TopicNumber only_topic() const;

  const Automaton& automaton_;
  const Schema& schema_;
  Random random_{0};
  std::vector<std::string_view> words_; // by number
  // Of the walk.
  SampledSentence made_;
  std::vector<std::string> slots_;
  // The last value within each slot that is open.
  std::vector<std::optional<EntityId>> open_slots_;
  bool fills_with_words_ = false;
  bool is_unusable_ = false;
};

std::vector<Walker::Step> Walker::steps_from(const State& state) {
  std::vector<Step> steps;
  for (const auto& arc : state.words)
    steps.push_back({&arc, false});
  for (const auto& arc : state.entities)
    steps.push_back({&arc, true});
  return steps;
}

std::string Walker::text_of(const Step& step) const {
  const auto symbol = step.arc->symbol;
  return step.is_value ? value_word(symbol) : std::string(words_[symbol]);
}

std::vector<SampledSentence> Walker::run(std::size_t count) {
  std::vector<SampledSentence> sentences;
  const auto starts = steps_from(automaton_.states[0]);
  if (starts.empty())
    return sentences;
  std::set<std::vector<std::string>> seen;
  for (std::size_t at = 0; at < count; ++at) {
    const auto& start = starts[at % starts.size()];
    random_ = Random(hash_of(text_of(start)) + at / starts.size());
    if (auto sentence = walk(start))
      if (seen.insert(sentence->words).second)
        sentences.push_back(std::move(*sentence));
  }
  return sentences;
}

// Where a rule may end or go on, one is as likely as the other.
std::optional<SampledSentence> Walker::walk(Step step) {
  made_ = {};
  slots_.clear();
  open_slots_.clear();
  is_unusable_ = fills_with_words_ = false;
  for (std::size_t length = 0; length < longest && !is_unusable_; ++length) {
    take(step);
    const auto& state = automaton_.states[step.arc->target];
    const auto steps = steps_from(state);
    if (!state.accepts.empty() && (steps.empty() || random_.next() % 2 == 0)) {
      const auto& accept = state.accepts[random_.next() % state.accepts.size()];
      read_tags(accept.actions);
      auto found = meaning(automaton_.rules[accept.rule]);
      if (!found || made_.words.empty())
        return {};
      made_.meaning = std::move(*found);
      if (fills_with_words_ && schema_.at(made_.meaning.topic).enquiry)
        made_.words.push_back(value_word(words_entity));
      return made_;
    }
    if (steps.empty())
      return {};
    step = steps[random_.next() % steps.size()];
  }
  return {};
}

void Walker::take(const Step& step) {
  read_tags(step.arc->actions);
  const auto symbol = step.arc->symbol;
  if (!step.is_value) {
    made_.words.emplace_back(words_[symbol]);
  } else if (symbol == asked_entity) {
    is_unusable_ = true;
  } else if (has_known_values(symbol)) {
    made_.words.push_back(value_word(symbol));
    std::ranges::fill(open_slots_, symbol);
  } else {
    fills_with_words_ = fills_with_words_ || !open_slots_.empty();
  }
}

void Walker::read_tags(std::uint32_t actions) {
  for (const auto& action : automaton_.actions[actions]) {
    const auto& tag = automaton_.tags[action.tag];
    if (tag.kind == TagKind::slot && action.opens)
      open_slots_.emplace_back();
    else if (tag.kind == TagKind::slot)
      close(tag);
    if (!action.opens)
      continue;
    if (tag.kind == TagKind::act)
      made_.meaning.act = tag.name;
    else if (tag.kind == TagKind::topic)
      made_.meaning.topic = tag.topic;
    else if (tag.kind != TagKind::slot)
      is_unusable_ = true;
    else if (slots_.push_back(tag.name); tag.has_value)
      made_.meaning.literals.emplace_back(tag.name, tag.value);
    if (tag.kind == TagKind::slot && tag.topic != no_topic &&
        made_.meaning.topic == no_topic)
      made_.meaning.topic = tag.topic;
  }
}

void Walker::close(const TagInfo& tag) {
  if (open_slots_.back() && !tag.has_value)
    made_.values.emplace_back(tag.name, *open_slots_.back());
  open_slots_.pop_back();
}

std::optional<SentenceMeaning> Walker::meaning(const RuleInfo& rule) const {
  if (is_unusable_ || rule.generic || rule.bare)
    return {};
  auto read = made_.meaning;
  if (read.topic == no_topic)
    read.topic = rule.topic;
  if (read.topic == no_topic)
    read.topic = only_topic();
  if (read.topic == no_topic)
    return {};
  if (read.act.empty())
    read.act = schema_.at(read.topic).usual_act();
  if (read.act != "request" && read.act != "inform")
    return {};
  std::ranges::stable_sort(read.literals, {},
                           &std::pair<std::string, Value>::first);
  return read;
}

// The topic that has all slots, if there is one.
TopicNumber Walker::only_topic() const {
  auto found = no_topic;
  if (slots_.empty())
    return found;
  for (TopicNumber topic = 0; topic < schema_.topics().size(); ++topic) {
    const bool has_all =
        std::ranges::all_of(slots_, [&](const std::string& slot) {
          return schema_.at(topic).find(slot) != nullptr;
        });
    if (has_all && found != no_topic)
      return no_topic;
    if (has_all)
      found = topic;
  }
  return found;
}

} // namespace

std::string value_word(EntityId entity) {
  return '@' + std::to_string(entity);
}

std::optional<EntityId> kind_of_word(std::string_view word) {
  if (!word.starts_with('@'))
    return {};
  EntityId entity = 0;
  std::from_chars(word.data() + 1, word.data() + word.size(), entity);
  return entity;
}

std::vector<SampledSentence> sample_sentences(const Automaton& automaton,
                                              const Schema& schema,
                                              std::size_t count) {
  return Walker(automaton, schema).run(count);
}

} // namespace parlour::adapters::nlu
