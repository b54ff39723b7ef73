#include "adapters/nlu/parse/chain.hpp"

#include <algorithm>
#include <optional>

namespace parlour::adapters::nlu {

namespace {

// What it costs to begin an island, so that one long one is better than two,
// and to change the topic in the middle.
constexpr double island_cost = 0.15;
constexpr double change_cost = 0.5;
// To say one slot twice in a row without correcting it.
constexpr double again_cost = 0.4;
constexpr std::size_t look_back = 8;

class ChainSearch {
public:
  ChainSearch(const std::vector<Island>& islands, std::size_t size,
              const Context& context)
      : islands_(islands), context_(context), ends_(size + 1),
        beginning_(size + 1) {
    for (const auto& island : islands_)
      beginning_[island.begin].push_back(&island);
  }

  std::vector<Chain> run() {
    nodes_.push_back({});
    ends_[0].push_back(0);
    for (std::size_t at = 0; at < ends_.size(); ++at) {
      if (at > 0)
        for (const auto node : ends_[at - 1])
          offer(at, node);
      for (const auto* island : beginning_[at])
        add(at, *island);
    }
    return chains();
  }

private:
  struct Node {
    std::uint32_t before = 0;
    ChainLink link;
    double score = 0;
  };

  // Keeps the node if it is the best that ends here in its topic.
  void offer(std::size_t position, std::uint32_t node) {
    for (auto& other : ends_[position]) {
      if (nodes_[other].link.topic != nodes_[node].link.topic)
        continue;
      if (nodes_[node].score > nodes_[other].score)
        other = node;
      return;
    }
    ends_[position].push_back(node);
  }

  void add(std::size_t position, const Island& island) {
    const auto befores = ends_[position];
    for (const auto before : befores) {
      const auto last = nodes_[before].link; // nodes_ grows below
      if (island.weak && !may_be_meant(island, last))
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

  // "no, four"; "and the third?" where such a thing was asked before.
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

  double expectation(const Island& island, const ChainLink& last,
                     TopicNumber topic) const {
    const bool changes = topic != last.topic && last.topic != no_topic;
    double bonus = changes ? -change_cost : 0;
    if (topic != last.topic)
      bonus += context_.bonus(topic);
    // "what time is it now?": what ends a question is no answer to ours.
    if (topic == context_.asked_topic && island.find(context_.asked_slot) &&
        !changes)
      bonus += asked_bonus;
    return bonus;
  }

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

  void append(std::uint32_t before, ChainLink link, double bonus) {
    const auto score =
        nodes_[before].score + link.island->score - island_cost + bonus;
    if (score <= nodes_[before].score &&
        link.topic == nodes_[before].link.topic)
      return;
    nodes_.push_back({before, link, score});
    offer(link.island->end, static_cast<std::uint32_t>(nodes_.size() - 1));
  }

  std::vector<Chain> chains() const {
    std::vector<Chain> found;
    for (const auto end : ends_.back()) {
      Chain chain;
      chain.score = nodes_[end].score;
      for (auto at = end; at != 0; at = nodes_[at].before)
        chain.links.push_back(nodes_[at].link);
      std::ranges::reverse(chain.links);
      found.push_back(std::move(chain));
    }
    std::ranges::stable_sort(found, std::greater(), &Chain::score);
    return found;
  }

  const std::vector<Island>& islands_;
  const Context& context_;
  std::vector<Node> nodes_;
  std::vector<std::vector<std::uint32_t>> ends_; // nodes by position
  std::vector<std::vector<const Island*>> beginning_;
};

} // namespace

std::vector<Chain> best_chains(const std::vector<Island>& islands,
                               std::size_t size, const Context& context) {
  return ChainSearch(islands, size, context).run();
}

} // namespace parlour::adapters::nlu
