#include "adapters/nlu/grammar/merged_states.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace parlour::adapters::nlu {

namespace {

// How many states there may be for each that there was before.
constexpr std::size_t most_growth = 2;

constexpr std::uint32_t no_state = 0xFFFFFFFF;

// The numbers of states that became one, in the order of the grammar.
using Members = std::vector<std::uint32_t>;

bool are_alike(const Arc& left, const Arc& right) {
  return left.symbol == right.symbol && left.actions == right.actions &&
         left.weight == right.weight;
}

// Renumbers lists of actions: what opens without an extent is left out, since
// it would keep apart what begins alike, and equal lists share one number.
class ActionLists {
public:
  explicit ActionLists(Automaton& automaton) {
    for (const auto& list : automaton.actions)
      numbers_.push_back(number_of(effective(list, automaton.tags)));
    automaton.actions = std::move(lists_);
  }

  std::uint32_t now(std::uint32_t before) const {
    return numbers_[before];
  }

private:
  static std::vector<Action> effective(std::vector<Action> list,
                                       const std::vector<TagInfo>& tags) {
    std::erase_if(list, [&](const Action& action) {
      return action.opens && !has_extent(tags[action.tag].kind);
    });
    return list;
  }

  std::uint32_t number_of(std::vector<Action> list) {
    const auto next = static_cast<std::uint32_t>(lists_.size());
    const auto [place, is_new] = known_.try_emplace(list, next);
    if (is_new)
      lists_.push_back(std::move(list));
    return place->second;
  }

  std::vector<std::uint32_t> numbers_;
  std::map<std::vector<Action>, std::uint32_t> known_;
  std::vector<std::vector<Action>> lists_;
};

class Merger {
public:
  explicit Merger(const std::vector<State>& before)
      : before_(before), single_(before.size(), no_state) {}

  std::vector<State> run() {
    number_of({0});
    for (std::size_t at = 0; at < members_.size(); ++at) {
      // Taken out: merging finds new ones, which moves the list.
      const auto members = std::move(members_[at]);
      states_[at] = merged(members);
    }
    return std::move(states_);
  }

private:
  // An arc, and where all that are alike lead.
  struct Group {
    Arc arc;
    Members targets;
  };

  // New if there is none yet.
  std::uint32_t number_of(const Members& members) {
    const auto next = static_cast<std::uint32_t>(states_.size());
    auto& number = members.size() == 1
                       ? single_[members[0]]
                       : several_.try_emplace(members, no_state).first->second;
    if (number != no_state)
      return number;
    states_.emplace_back();
    members_.push_back(members);
    return number = next;
  }

  State merged(const Members& members) {
    State made;
    std::vector<Arc> words;
    std::vector<Arc> entities;
    for (const auto member : members) {
      const auto& state = before_[member];
      words.insert(words.end(), state.words.begin(), state.words.end());
      entities.insert(entities.end(), state.entities.begin(),
                      state.entities.end());
      made.word_bits |= state.word_bits;
      made.entity_bits |= state.entity_bits;
      for (const auto& accept : state.accepts)
        if (std::ranges::find(made.accepts, accept) == made.accepts.end())
          made.accepts.push_back(accept);
    }
    // Among equals the order of the grammar stays.
    if (members.size() > 1)
      std::ranges::stable_sort(words, {}, &Arc::symbol);
    made.words = united(words);
    made.entities = united(entities);
    return made;
  }

  std::vector<Arc> united(const std::vector<Arc>& arcs) {
    std::vector<Group> groups;
    std::size_t same_symbol = 0; // the first group with it
    for (const auto& arc : arcs) {
      if (same_symbol < groups.size() &&
          groups[same_symbol].arc.symbol != arc.symbol)
        same_symbol = groups.size();
      auto group = std::find_if(
          groups.begin() + static_cast<std::ptrdiff_t>(same_symbol),
          groups.end(),
          [&](const Group& other) { return are_alike(other.arc, arc); });
      if (group == groups.end())
        group = groups.insert(group, {arc, {}});
      if (std::ranges::find(group->targets, arc.target) == group->targets.end())
        group->targets.push_back(arc.target);
    }
    std::vector<Arc> made;
    made.reserve(groups.size());
    for (const auto& group : groups)
      add(made, group);
    return made;
  }

  void add(std::vector<Arc>& arcs, const Group& group) {
    auto arc = group.arc;
    if (states_.size() < most_growth * before_.size()) {
      arc.target = number_of(group.targets);
      arcs.push_back(arc);
      return;
    }
    for (const auto target : group.targets) {
      arc.target = number_of({target});
      arcs.push_back(arc);
    }
  }

  const std::vector<State>& before_;
  std::vector<State> states_;
  // By number: what became one, until it is merged.
  std::vector<Members> members_;
  // The number of a state alone, and of several.
  std::vector<std::uint32_t> single_;
  std::map<Members, std::uint32_t> several_;
};

} // namespace

Automaton merge_states(Automaton automaton) {
  if (automaton.states.empty())
    return automaton;
  const ActionLists lists(automaton);
  for (auto& state : automaton.states) {
    for (auto* arcs : {&state.words, &state.entities})
      for (auto& arc : *arcs)
        arc.actions = lists.now(arc.actions);
    for (auto& accept : state.accepts)
      accept.actions = lists.now(accept.actions);
  }
  automaton.states = Merger(automaton.states).run();
  return automaton;
}

} // namespace parlour::adapters::nlu
