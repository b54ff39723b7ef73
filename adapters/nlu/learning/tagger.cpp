#include "adapters/nlu/learning/tagger.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "adapters/nlu/learning/shuffle.hpp"

namespace parlour::adapters::nlu {

namespace {

// How often each text is seen.
constexpr int rounds = 16;
// In training each wrong label gets this bonus, so that the right labels must
// win by a margin.
constexpr float margin = 1;
// With so many texts, features that occur with only one word are left out.
constexpr std::size_t many_texts = 2000;
// Labels that are worked on at once.
constexpr std::size_t lanes = 4;

// The labels of these slots, `outside` first.
std::vector<TagLabel> labels_of(const std::vector<std::uint32_t>& slots) {
  std::vector<TagLabel> made{outside};
  for (const auto slot : slots) {
    made.push_back(begins(slot));
    made.push_back(goes_on(slot));
  }
  return made;
}

} // namespace

// The best sequence of labels for one text (the Viterbi algorithm). `truth`
// holds the right labels, in training only.
class LabelSearch {
public:
  LabelSearch(const Tagger& tagger, const Tagger::Rows& rows,
              const std::vector<std::uint32_t>& slots,
              const std::vector<TagLabel>* truth)
      : tagger_(tagger), rows_(rows), labels_(labels_of(slots)), truth_(truth),
        places_(tagger.labels_, absent), scores_(tagger.stride_),
        came_from_(rows.size() * labels_.size()) {
    for (std::size_t place = 0; place < labels_.size(); ++place)
      places_[labels_[place]] = place;
  }

  std::vector<TagLabel> run() {
    // The word before the first one is outside.
    std::vector<float> before(labels_.size(), impossible);
    before[0] = 0;
    for (std::size_t at = 0; at < rows_.size(); ++at)
      before = step(at, before);
    const auto best = std::ranges::max_element(before) - before.begin();
    return way(static_cast<std::size_t>(best));
  }

private:
  static constexpr float impossible = std::numeric_limits<float>::lowest() / 4;

  static constexpr std::size_t absent = static_cast<std::size_t>(-1);

  // The best score of each label at word `at`, from the best scores at the word
  // before.
  std::vector<float> step(std::size_t at, const std::vector<float>& before) {
    score_word(at);
    std::vector<float> here(labels_.size());
    for (std::size_t one = 0; one < labels_.size(); ++one) {
      const auto label = labels_[one];
      const auto from = best_before(before, label);
      came_from_[at * labels_.size() + one] = static_cast<std::uint32_t>(from);
      here[one] = before[from] + weight(labels_[from], label) + scores_[label];
      if (truth_ && (*truth_)[at] != label)
        here[one] += margin;
    }
    return here;
  }

  // What the features of the word say of all labels.
  void score_word(std::size_t at) {
    std::ranges::fill(scores_, 0.0F);
    for (const auto feature : rows_[at]) {
      const auto* row = tagger_.row(feature);
      for (std::size_t first = 0; first < scores_.size(); first += lanes) {
        std::array<float, lanes> sums;
        for (std::size_t lane = 0; lane < lanes; ++lane)
          sums[lane] = scores_[first + lane] + row[first + lane];
        for (std::size_t lane = 0; lane < lanes; ++lane)
          scores_[first + lane] = sums[lane];
      }
    }
  }

  float weight(TagLabel before, TagLabel label) const {
    return tagger_.row(tagger_.after(before))[label];
  }

  // The place of the best label before `label`. There is always one: `outside`
  // may precede a beginning, and a beginning its continuation.
  std::size_t best_before(const std::vector<float>& before,
                          TagLabel label) const {
    std::size_t best = 0;
    float most = std::numeric_limits<float>::lowest();
    for (const auto last : tagger_.before_[label]) {
      const auto place = places_[last];
      if (place == absent)
        continue;
      const auto score = before[place] + weight(last, label);
      if (score > most) {
        most = score;
        best = place;
      }
    }
    return best;
  }

  // Follows the links back from the last word.
  std::vector<TagLabel> way(std::size_t last) const {
    std::vector<TagLabel> made(rows_.size());
    for (auto at = rows_.size(); at-- > 0;) {
      made[at] = labels_[last];
      last = came_from_[at * labels_.size() + last];
    }
    return made;
  }

  const Tagger& tagger_;
  const Tagger::Rows& rows_;
  std::vector<TagLabel> labels_;
  const std::vector<TagLabel>* truth_;
  // By label: its place in `labels_`.
  std::vector<std::size_t> places_;
  // Of the current word, by label.
  std::vector<float> scores_;
  // The label before, by word and label.
  std::vector<std::uint32_t> came_from_;
};

// The perceptron's training. Averaging over all steps makes it robust: `sums_`
// collects each change times the number of the step, from which the average
// follows at the end.
class TaggerTraining {
public:
  explicit TaggerTraining(Tagger& tagger) : tagger_(tagger) {}

  void number_features(const std::vector<TaggedText>& texts) {
    const int needed = texts.size() < many_texts ? 1 : 2;
    std::unordered_map<Feature, int> counts;
    for (const auto& text : texts)
      for (const auto& word : text.features)
        for (const auto feature : word)
          if (++counts[feature] == needed)
            tagger_.table_.add(feature);
  }

  void run(const std::vector<TaggedText>& texts) {
    tagger_.weights_.assign(tagger_.after(tagger_.labels_) * tagger_.stride_,
                            0);
    sums_ = tagger_.weights_;
    std::vector<Tagger::Rows> rows;
    for (const auto& text : texts)
      rows.push_back(tagger_.rows(text.features));
    ShuffledOrder order(texts.size());
    for (int round = 0; round < rounds; ++round)
      for (const auto at : order.next())
        learn(texts[at], rows[at]);
    average();
  }

private:
  // Labels the text with the current weights. If a label is wrong, the weights
  // of the right labels are increased and those of the found ones decreased.
  void learn(const TaggedText& text, const Tagger::Rows& rows) {
    ++steps_;
    const auto found =
        LabelSearch(tagger_, rows, text.slots, &text.labels).run();
    if (found == text.labels)
      return;
    move(rows, text.labels, 1);
    move(rows, found, -1);
  }

  void move(const Tagger::Rows& rows, const std::vector<TagLabel>& labels,
            float by) {
    auto before = outside;
    for (std::size_t at = 0; at < labels.size(); ++at) {
      for (const auto feature : rows[at])
        move(feature, labels[at], by);
      move(tagger_.after(before), labels[at], by);
      before = labels[at];
    }
  }

  void move(std::size_t row, TagLabel label, float by) {
    const auto at = row * tagger_.stride_ + label;
    tagger_.weights_[at] += by;
    sums_[at] += by * steps_;
  }

  // average = final weight - sum of (change x step) / steps
  void average() {
    for (std::size_t at = 0; at < sums_.size(); ++at)
      tagger_.weights_[at] -= sums_[at] / std::max(steps_, 1.0F);
  }

  Tagger& tagger_;
  std::vector<float> sums_;
  float steps_ = 0;
};

std::optional<Tagger> Tagger::train(const std::vector<TaggedText>& texts,
                                    std::uint32_t slots,
                                    std::size_t max_weights) {
  Tagger made;
  made.labels_ = 2 * slots + 1;
  made.stride_ = (made.labels_ + lanes - 1) / lanes * lanes;
  made.see_orders(texts);
  TaggerTraining training(made);
  training.number_features(texts);
  if (made.after(made.labels_) * made.stride_ > max_weights)
    return {};
  training.run(texts);
  return made;
}

void Tagger::see_orders(const std::vector<TaggedText>& texts) {
  before_.assign(labels_, {outside});
  for (TagLabel label = 1; label < labels_; ++label)
    if (!is_beginning(label))
      before_[label] = {label - 1, label};
  for (const auto& text : texts)
    for (std::size_t at = 1; at < text.labels.size(); ++at)
      before_[text.labels[at]].push_back(text.labels[at - 1]);
  // Anything may end.
  for (TagLabel label = 1; label < labels_; ++label)
    before_[outside].push_back(label);
  for (auto& list : before_) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

Tagger::Rows
Tagger::rows(const std::vector<std::vector<Feature>>& features) const {
  Rows made(features.size());
  for (std::size_t at = 0; at < features.size(); ++at)
    for (const auto feature : features[at])
      if (const auto number = table_.find(feature); number != no_feature)
        made[at].push_back(number);
  return made;
}

std::vector<TagLabel>
Tagger::tag(const std::vector<std::vector<Feature>>& features,
            const std::vector<std::uint32_t>& slots) const {
  const auto numbered = rows(features);
  return LabelSearch(*this, numbered, slots, nullptr).run();
}

} // namespace parlour::adapters::nlu
