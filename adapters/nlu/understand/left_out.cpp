// Examples with the same key words form a group. The groups are dealt out over
// a few rounds; in each round an engine is built without the round's groups and
// reads them.
#include "adapters/nlu/understand/left_out.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "adapters/nlu/grammar/marked_text.hpp"
#include "adapters/nlu/text/tokens.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// More rounds leave out fewer examples at a time, which is nearer to the truth
// and takes longer.
constexpr std::size_t rounds = 5;

using Words = std::set<std::string>;

// What an example says besides its values: "a cab to [Bedok](To)" has "cab" and
// "[To]". All of its words where none has a meaning of its own.
Words key_words(const MarkedText& marked) {
  Words all, keys;
  for (const auto& token : tokenize(marked.text).list) {
    const auto mark =
        std::ranges::find_if(marked.marks, [&](const auto& candidate) {
          return token.begin < candidate.end && token.end > candidate.begin;
        });
    if (mark != marked.marks.end()) {
      keys.insert('[' + mark->slot + ']');
      continue;
    }
    all.insert(token.word);
    if (!is_function_word(token.word))
      keys.insert(token.word);
  }
  all.insert(keys.begin(), keys.end());
  const bool says_little = std::ranges::all_of(
      keys, [](const auto& word) { return word.starts_with('['); });
  return says_little ? all : keys;
}

struct Read {
  std::size_t topic = 0; // of the model
  std::string example;
  MarkedText marked;
  Words keys;
  std::size_t round = 0;
};

class LeftOut {
public:
  LeftOut(const UnderstandingModel& model, const ColumnReader& columns,
          const NluEngine::Options& options)
      : model_(model), columns_(columns), options_(options) {}

  std::vector<LeftOutExample> read() {
    collect();
    deal_out();
    for (std::size_t round = 0; round < rounds; ++round)
      if (!read_round(round))
        return {};
    return std::move(made_);
  }

private:
  void collect();
  void deal_out();
  bool read_round(std::size_t round);
  LeftOutExample judged(const Read& read, const Understanding& understood,
                        bool repeats) const;
  std::string nearest(const Read& read, const std::string& topic) const;
  std::vector<std::string> lone_words(const Read& read) const;

  const UnderstandingModel& model_;
  const ColumnReader& columns_;
  const NluEngine::Options& options_;
  std::vector<Read> examples_;
  std::map<std::pair<std::size_t, Words>, std::size_t> groups_; // their sizes
  std::vector<LeftOutExample> made_;
};

void LeftOut::collect() {
  for (std::size_t topic = 0; topic < model_.topics.size(); ++topic)
    for (const auto& example : model_.topics[topic].examples)
      if (auto marked = read_marks(example)) {
        auto keys = key_words(*marked);
        examples_.push_back(
            {topic, example, std::move(*marked), std::move(keys), 0});
      }
}

// One group after the other, so that each round has some of every topic.
void LeftOut::deal_out() {
  std::map<std::pair<std::size_t, Words>, std::size_t> rounds_of;
  for (auto& example : examples_) {
    const std::pair group(example.topic, example.keys);
    ++groups_[group];
    example.round =
        rounds_of.try_emplace(group, rounds_of.size() % rounds).first->second;
  }
}

bool LeftOut::read_round(std::size_t round) {
  auto model = model_;
  for (auto& topic : model.topics)
    topic.examples.clear();
  for (const auto& example : examples_)
    if (example.round != round)
      model.topics[example.topic].examples.push_back(example.example);
  const auto engine = NluEngine::build(model, columns_, options_);
  if (!engine)
    return false;
  for (const auto& example : examples_)
    if (example.round == round && !model.topics[example.topic].part)
      made_.push_back(judged(
          example, engine->understand(example.marked.text, Map{{"now", 0}}),
          groups_.at({example.topic, example.keys}) > 1));
  return true;
}

LeftOutExample LeftOut::judged(const Read& read,
                               const Understanding& understood,
                               bool repeats) const {
  LeftOutExample made{model_.topics[read.topic].name, read.example, repeats};
  made.score = understood.score;
  made.lone = lone_words(read);
  const auto is_own = [&](const Value& act) {
    return act[act_key::topic] == Value(made.topic);
  };
  for (const auto& act : understood.acts) {
    if (made.taken_for.empty() && !act[act_key::topic].is_unknown())
      made.taken_for = act[act_key::topic].text();
    made.own |= is_own(act);
    if (const auto* others = act[act_key::alternatives].if_list())
      made.own |= std::ranges::any_of(*others, is_own);
  }
  if (!made.own && !made.taken_for.empty())
    made.like = nearest(read, made.taken_for);
  return made;
}

// By the share of words that both have.
std::string LeftOut::nearest(const Read& read, const std::string& topic) const {
  double best = 0;
  std::string found;
  for (const auto& other : examples_) {
    if (model_.topics[other.topic].name != topic)
      continue;
    std::vector<std::string> both;
    std::ranges::set_intersection(read.keys, other.keys,
                                  std::back_inserter(both));
    const auto share =
        double(both.size()) / double(read.keys.size() + other.keys.size());
    if (share > best) {
      best = share;
      found = other.example;
    }
  }
  return found;
}

std::vector<std::string> LeftOut::lone_words(const Read& read) const {
  std::vector<std::string> lone;
  for (const auto& word : read.keys)
    if (!word.starts_with('[') && !is_function_word(word) &&
        std::ranges::none_of(examples_, [&](const auto& other) {
          return other.topic == read.topic && other.example != read.example &&
                 other.keys.contains(word);
        }))
      lone.push_back(word);
  return lone;
}

} // namespace

std::vector<LeftOutExample> read_left_out(const UnderstandingModel& model,
                                          const ColumnReader& columns,
                                          const NluEngine::Options& options) {
  return LeftOut(model, columns, options).read();
}

} // namespace parlour::adapters::nlu
