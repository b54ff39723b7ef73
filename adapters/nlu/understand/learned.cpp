#include "adapters/nlu/understand/learned.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapters/nlu/grammar/marked_text.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::uint32_t nothing = 0; // the label of what is about no topic

// Below this many texts, sharpness cannot be told from them.
constexpr std::size_t many_texts = 300;
constexpr std::size_t words_of_nothing = 20; // in one text
constexpr std::size_t one_in = 5; // is held out to find the sharpness

// Of an utterance; a few letters alone, as in "foo" of "for", are less, and
// "renting" of "rent" is more.
constexpr float least_known = 0.3F;

bool is_certain(const Span& span) {
  return !span.weak && !span.unmatched && span.begin == span.core;
}

float highest(std::vector<float> scores, float sharpness) {
  for (auto& score : scores)
    score *= sharpness;
  const auto probabilities = softmax(std::move(scores));
  return *std::ranges::max_element(probabilities);
}

// How much sharper the scores of texts that were held out must be so that 97 of
// 100 reach the threshold.
float sharpness_of(const std::vector<std::vector<float>>& held_out,
                   double threshold) {
  const auto reaches = [&](float sharpness) {
    std::size_t count = 0;
    for (const auto& scores : held_out)
      count += highest(scores, sharpness) >= threshold ? 1U : 0U;
    return count * 100 >= held_out.size() * 97;
  };
  float low = 1;
  float high = 8;
  for (int step = 0; step < 12; ++step) {
    const auto middle = std::sqrt(low * high);
    (reaches(middle) ? high : low) = middle;
  }
  return high;
}

} // namespace

std::vector<LearningWord> learning_words(const Utterance& utterance,
                                         const Spans& spans) {
  std::vector<LearningWord> words;
  for (const auto& token : utterance.tokens.list)
    words.push_back({token.word, 0});
  std::vector<const Span*> known;
  for (const auto& span : spans.all())
    if (is_certain(span))
      known.push_back(&span);
  std::ranges::stable_sort(known, [](const Span* left, const Span* right) {
    return left->end - left->begin > right->end - right->begin;
  });
  for (const auto* span : known) {
    const auto part =
        std::span(words).subspan(span->begin, span->end - span->begin);
    if (std::ranges::all_of(part,
                            [](const auto& one) { return one.kind == 0; }))
      for (auto& word : part)
        word.kind = span->entity + 1;
  }
  return words;
}

// All examples, on their way into what is learnt.
class Lesson {
public:
  Lesson(Learned& learned, const Schema& schema, const Automaton& automaton,
         LearningLimits limits)
      : learned_(learned), schema_(schema), automaton_(automaton),
        limits_(limits) {
    learned_.slots_of_.resize(schema.topics().size());
  }

  Expected<void> add(const TopicModel& topic) {
    if (topic.examples.empty())
      return {};
    learned_.topics_.push_back(schema_.topic(topic.name));
    for (const auto& example : topic.examples)
      if (const auto marked = read_marks(example)) {
        add(*marked);
        if (features_ > limits_.features)
          return fail(ErrorKind::limit,
                      "the examples are too many to be learnt: there is room "
                      "for the first " +
                          std::to_string(texts_.size() - 1) +
                          "; leave out some, of those that say the same");
      }
    return {};
  }

  Expected<void> learn(double threshold) {
    if (learned_.topics_.empty())
      return {};
    number_slots();
    add_nothing();
    return learn_topics(threshold).and_then([this] { return learn_slots(); });
  }

private:
  Expected<void> learn_topics(double threshold) {
    const auto labels = static_cast<std::uint32_t>(learned_.topics_.size() + 1);
    auto classifier = Classifier::train(texts_, labels, limits_.weights);
    if (!classifier)
      return fail(ErrorKind::limit,
                  "the examples of " + std::to_string(labels - 1) +
                      " topics are too many to be learnt; leave out examples, "
                      "or write one topic for several");
    learned_.classifier_ = std::move(*classifier);
    if (texts_.size() >= many_texts)
      learned_.sharpness_ = find_sharpness(labels, threshold);
    texts_ = {};
    return {};
  }

  Expected<void> learn_slots() {
    for (std::size_t at = 0; at < tagged_.size(); ++at)
      tagged_[at].slots = learned_.slots_of_[tagged_topics_[at]];
    const auto slots = static_cast<std::uint32_t>(learned_.slots_.size());
    auto tagger = Tagger::train(tagged_, slots, limits_.weights);
    if (!tagger)
      return fail(ErrorKind::limit,
                  "the examples of " + std::to_string(slots) +
                      " slots are too many to be learnt; leave out examples, "
                      "or write one slot for several");
    learned_.tagger_ = std::move(*tagger);
    return {};
  }

  struct Read {
    explicit Read(std::string_view text, const Schema& schema,
                  const Automaton& automaton)
        : utterance(make_utterance(text, automaton)),
          spans(schema, utterance, automaton.entities, Timestamp{0}),
          words(learning_words(utterance, spans)) {}

    Utterance utterance;
    Spans spans;
    std::vector<LearningWord> words;
  };

  void add(const MarkedText& marked) {
    const Read read(marked.text, schema_, automaton_);
    texts_.push_back({text_features(read.words),
                      static_cast<std::uint32_t>(learned_.topics_.size())});
    features_ += texts_.back().features.size();
    const auto topic = learned_.topics_.back();
    if (schema_.at(topic).slots.empty())
      return;
    tagged_.push_back({word_features(read.words), labels(marked, read), {}});
    tagged_topics_.push_back(topic);
    for (const auto& word : tagged_.back().features)
      features_ += word.size();
  }

  std::vector<TagLabel> labels(const MarkedText& marked, const Read& read) {
    const auto& tokens = read.utterance.tokens.list;
    std::vector<TagLabel> made(tokens.size(), outside);
    for (const auto& mark : marked.marks) {
      const auto slot = slot_number(mark.slot);
      bool first = true;
      for (std::size_t at = 0; at < tokens.size(); ++at) {
        if (tokens[at].begin >= mark.end || tokens[at].end <= mark.begin)
          continue;
        made[at] = first ? begins(slot) : goes_on(slot);
        first = false;
      }
    }
    return made;
  }

  std::uint32_t slot_number(const std::string& slot) {
    auto& slots = learned_.slots_;
    const auto found = std::ranges::find(slots, slot);
    const auto number = static_cast<std::uint32_t>(found - slots.begin());
    if (found == slots.end())
      slots.push_back(slot);
    return number;
  }

  // Which of the slots each topic has.
  void number_slots() {
    for (const auto topic : learned_.topics_)
      for (std::uint32_t slot = 0; slot < learned_.slots_.size(); ++slot)
        if (schema_.at(topic).find(learned_.slots_[slot]))
          learned_.slots_of_[topic].push_back(slot);
  }

  // Words that mean nothing by themselves are about nothing; many in a text,
  // so that a few of them in an utterance do not outweigh what it says.
  void add_nothing() {
    std::string text;
    std::size_t count = 0;
    for (const auto word : all_function_words()) {
      text.append(word).append(" ");
      if (++count % words_of_nothing == 0)
        add_nothing(std::exchange(text, ""));
    }
    for (const auto phrase : filler_phrases())
      text.append(phrase).append(" ");
    add_nothing(text);
  }

  void add_nothing(const std::string& text) {
    texts_.push_back(
        {text_features(Read(text, schema_, automaton_).words), nothing});
  }

  // Takes the texts apart, so that none is held twice.
  float find_sharpness(std::uint32_t labels, double threshold) {
    std::vector<LabelledText> learnt;
    std::vector<LabelledText> held_out;
    for (std::size_t at = 0; at < texts_.size(); ++at) {
      const bool out = at % one_in == 0 && texts_[at].label != nothing;
      (out ? held_out : learnt).push_back(std::move(texts_[at]));
    }
    const auto trial = Classifier::train(learnt, labels);
    std::vector<std::vector<float>> scores;
    for (const auto& text : held_out)
      scores.push_back(trial->scores(text.features));
    return sharpness_of(scores, threshold);
  }

  Learned& learned_;
  const Schema& schema_;
  const Automaton& automaton_;
  const LearningLimits limits_;
  std::size_t features_ = 0; // of all examples so far
  std::vector<LabelledText> texts_;
  std::vector<TaggedText> tagged_;
  std::vector<TopicNumber> tagged_topics_;
};

Expected<Learned> Learned::train(const std::vector<TopicModel>& topics,
                                 const Schema& schema,
                                 const Automaton& automaton, double threshold,
                                 LearningLimits limits) {
  Learned learned;
  Lesson lesson(learned, schema, automaton, limits);
  for (const auto& topic : topics)
    if (auto added = lesson.add(topic); !added)
      return tl::make_unexpected(added.error());
  if (auto learnt = lesson.learn(threshold); !learnt)
    return tl::make_unexpected(learnt.error());
  return learned;
}

std::vector<TopicGuess>
Learned::topics(const std::vector<LearningWord>& words) const {
  const auto features = text_features(words);
  if (classifier_.known_share(features) < least_known)
    return {};
  auto scores = classifier_.scores(features);
  for (auto& score : scores)
    score *= sharpness_;
  const auto probabilities = softmax(std::move(scores));
  std::vector<TopicGuess> made;
  for (std::size_t at = 0; at < topics_.size(); ++at)
    made.push_back({topics_[at], probabilities[at + 1]});
  std::ranges::stable_sort(made, std::greater(), &TopicGuess::probability);
  return made;
}

std::vector<SlotGuess>
Learned::slots(TopicNumber topic,
               const std::vector<std::vector<Feature>>& features) const {
  const auto labels = tagger_.tag(features, slots_of_[topic]);
  std::vector<SlotGuess> made;
  for (std::uint32_t at = 0; at < labels.size(); ++at) {
    if (labels[at] == outside)
      continue;
    if (is_beginning(labels[at]))
      made.push_back({slots_[slot_of(labels[at])], at, at});
    made.back().end = at + 1;
  }
  return made;
}

} // namespace parlour::adapters::nlu
