#include "adapters/nlu/acts/chain.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace parlour::adapters::nlu {

namespace {

// The cost of an island, so that one long island is better than two short ones,
// and of changing the topic.
constexpr double island_cost = 0.15;
constexpr double change_cost = 0.5;
// The cost of saying the same slot twice in a row without correcting it.
constexpr double again_cost = 0.4;
// How many islands back a repetition is looked for.
constexpr std::size_t look_back = 8;

// How many sequences memory is reserved for.
constexpr std::size_t usual_nodes = 64;

// Dynamic programming from left to right. The ends of token p are, for each
// topic, the best sequence that ends at or before it. The topic belongs to the
// key because the cost of the next island depends on it.
class ChainSearch {
public:
  ChainSearch(const std::vector<Island>& islands, std::size_t size,
              const Context& context)
      : context_(context), lists_(size + 1) {
    nodes_.reserve(usual_nodes);
    ends_.reserve(usual_nodes);
    by_begin_.reserve(islands.size());
    for (const auto& island : islands)
      by_begin_.push_back(&island);
    std::ranges::sort(by_begin_, {}, [](const Island* island) {
      return std::pair(island->begin, island);
    });
  }

  std::vector<Chain> run() {
    nodes_.push_back({});
    ends_.push_back({}); // entry 0 means the end of a list
    offer(0, 0);
    auto next = by_begin_.begin();
    // A sequence that ends before token `at` also counts at `at`: the token
    // between is not covered. All islands that end at `at` have been added,
    // since they begin before it.
    for (std::size_t at = 0; at < lists_.size(); ++at) {
      if (at > 0)
        for (auto end = lists_[at - 1].first; end != 0; end = ends_[end].next)
          offer(at, ends_[end].node);
      for (; next != by_begin_.end() && (*next)->begin == at; ++next)
        add(at, **next);
    }
    return chains();
  }

private:
  // An island at the end of a sequence; `before` is the node that it follows.
  // Node 0 is the empty sequence.
  struct Node {
    std::uint32_t before = 0;
    ChainLink link;
    double score = 0;
  };

  // The ends of a token are a list in the order in which they came.
  struct End {
    std::uint32_t node = 0;
    std::uint32_t next = 0;
  };
  struct Ends {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  // Keeps the node if it is the best that ends here with its topic.
  void offer(std::size_t position, std::uint32_t node) {
    auto& list = lists_[position];
    for (auto at = list.first; at != 0; at = ends_[at].next) {
      auto& other = ends_[at].node;
      if (nodes_[other].link.topic != nodes_[node].link.topic)
        continue;
      if (nodes_[node].score > nodes_[other].score)
        other = node;
      return;
    }
    const auto made = static_cast<std::uint32_t>(ends_.size());
    ends_.push_back({node, 0});
    (list.first == 0 ? list.first : ends_[list.last].next) = made;
    list.last = made;
  }

  // Appends an island to each sequence that ends before it, once for each topic
  // that it may be about. A generic act does not change the topic.
  void add(std::size_t position, const Island& island) {
    // Both grow below, but no more ends come here.
    for (auto end = lists_[position].first; end != 0; end = ends_[end].next) {
      const auto before = ends_[end].node;
      const auto last = nodes_[before].link;
      if (island.weak && !may_be_meant(island, last) &&
          !contrasts(before, island) && !goes_with_answer(island, last))
        continue;
      if (!island.is_content()) {
        append(before, {&island, last.topic}, 0);
        continue;
      }
      for (const auto topic : island.topics)
        append(before, {&island, topic},
               expectation(island, last, topic) -
                   (says_again(before, island, topic) ? again_cost : 0));
    }
  }

  // A weak island counts only after a marker ("no, four") or, if the topic is
  // expected, after words that lead in ("and the third?").
  bool may_be_meant(const Island& island, const ChainLink& last) const {
    if (!last.island || last.island->is_content())
      return false;
    const bool leads_in = last.island->act.empty();
    return last.island->is_marker() ||
           (leads_in &&
            std::ranges::any_of(island.topics, [&](TopicNumber topic) {
              return context_.bonus(topic) > 0;
            }));
  }

  // "not three, four": behind a value that is denied, of the same slot.
  bool contrasts(std::uint32_t before, const Island& island) const {
    const auto& last = nodes_[before].link;
    if (before == 0 || !last.island->is_content())
      return false;
    const auto* const marker = nodes_[nodes_[before].before].link.island;
    return marker && marker->denies &&
           std::ranges::any_of(island.fills, [&](const Fill& fill) {
             return last.island->find(fill.slot) != nullptr;
           });
  }

  // "In which room?" "The bathroom. 24.": the last thing said, right behind the
  // answer, for another slot of what is asked about.
  bool goes_with_answer(const Island& island, const ChainLink& last) const {
    return last.island && last.topic == context_.asked_topic &&
           last.topic != no_topic && island.begin == last.island->end &&
           island.end + 1 == lists_.size() &&
           last.island->find(context_.asked_slot) &&
           !island.find(context_.asked_slot) &&
           std::ranges::find(island.topics, last.topic) != island.topics.end();
  }

  // What an island gets for being expected (understanding, "Score"), minus the
  // cost of a change of topic.
  double expectation(const Island& island, const ChainLink& last,
                     TopicNumber topic) const {
    const bool changes = topic != last.topic && last.topic != no_topic;
    double bonus = changes ? -change_cost : 0;
    if (topic != last.topic)
      bonus += context_.bonus(topic);
    // After an act about another topic, a value does not answer what was asked:
    // in "what time is it now?", "now" is no answer.
    if (topic == context_.asked_topic && island.find(context_.asked_slot) &&
        !changes)
      bonus += asked_bonus;
    bonus += context_.waiting_bonus(
        topic, !changes && island.find(context_.waiting_slot) != nullptr);
    return bonus;
  }

  // Whether a slot of the island was filled by one of the last islands of its
  // topic.
  bool says_again(std::uint32_t before, const Island& island,
                  TopicNumber topic) const {
    if (island.act == "request")
      return false;
    for (std::size_t step = 0; before != 0 && step < look_back; ++step) {
      const auto& link = nodes_[before].link;
      if (link.topic != topic || link.island->is_marker())
        return false;
      for (const auto& fill : island.fills)
        if (link.island->find(fill.slot))
          return true;
      before = nodes_[before].before;
    }
    return false;
  }

  // An island that makes the sequence worse is not appended, unless it changes
  // the topic: that sequence competes with others.
  void append(std::uint32_t before, ChainLink link, double bonus) {
    const auto score =
        nodes_[before].score + link.island->score - island_cost + bonus;
    if (score <= nodes_[before].score &&
        link.topic == nodes_[before].link.topic)
      return;
    nodes_.push_back({before, link, score});
    offer(link.island->end, static_cast<std::uint32_t>(nodes_.size() - 1));
  }

  // Follows the nodes back from the end of the utterance.
  std::vector<Chain> chains() const {
    std::vector<Chain> found;
    for (auto end = lists_.back().first; end != 0; end = ends_[end].next) {
      auto& chain = found.emplace_back();
      chain.score = nodes_[ends_[end].node].score;
      for (auto at = ends_[end].node; at != 0; at = nodes_[at].before)
        chain.links.push_back(nodes_[at].link);
      std::ranges::reverse(chain.links);
    }
    std::ranges::stable_sort(found, std::greater(), &Chain::score);
    return found;
  }

  const Context& context_;
  std::vector<const Island*> by_begin_;
  std::vector<Node> nodes_;
  std::vector<End> ends_;
  std::vector<Ends> lists_; // by token
};

} // namespace

double Chain::coverage(const Utterance& utterance) const {
  double covered = 0;
  for (const auto& link : links)
    covered += link.island->covered;
  const auto all = utterance.weight_of(0, utterance.size());
  return all > 0 ? covered / all : 0;
}

std::vector<Chain> best_chains(const std::vector<Island>& islands,
                               std::size_t size, const Context& context) {
  return ChainSearch(islands, size, context).run();
}

} // namespace parlour::adapters::nlu
