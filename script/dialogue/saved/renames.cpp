#include "script/dialogue/saved/renames.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace parlour::dialogue {

namespace {

using script::no_id;

// Of equal names the first counts.
template <class T>
std::map<std::string_view, std::uint32_t> by_name(const std::vector<T>& all) {
  std::map<std::string_view, std::uint32_t> ids;
  for (std::uint32_t id = 0; id < all.size(); ++id)
    ids.try_emplace(all[id].name, id);
  return ids;
}

// For each of the first program its id in the other one.
template <class T>
std::vector<std::uint32_t> matches(const std::vector<T>& from,
                                   const std::vector<T>& to) {
  const auto ids = by_name(to);
  std::vector<std::uint32_t> found;
  for (const auto& one : from) {
    const auto same = ids.find(one.name);
    found.push_back(same == ids.end() ? no_id : same->second);
  }
  return found;
}

std::uint32_t at(const std::vector<std::uint32_t>& ids, std::uint32_t id) {
  return id < ids.size() ? ids[id] : no_id;
}

// "timer 'lunch' in …": what stands before the place; empty: no timer's, or one
// whose name is computed.
std::string_view timer_of(const script::Code& code) {
  const std::string_view name = code.name;
  const auto end = name.find("' in ");
  return name.starts_with("timer '") && end != name.npos ? name.substr(0, end)
                                                         : std::string_view();
}

bool takes_the_same(const script::Code& one, const script::Code& other) {
  return one.parameter_names == other.parameter_names &&
         one.required_count == other.required_count;
}

} // namespace

// A variable that is a constant in either program is not renamed: its value is
// what the other program says.
Renames::Renames(Program from, Program to)
    : from_(std::move(from)), to_(std::move(to)),
      topics_(matches(from_->topics, to_->topics)),
      states_(matches(from_->states, to_->states)),
      variables_(matches(from_->variables, to_->variables)),
      codes_(from_->code.size(), script::no_code) {
  for (script::TopicId id = 0; id < topics_.size(); ++id)
    slots_.push_back(
        topics_[id] == no_id
            ? std::vector<script::SlotId>()
            : matches(from_->topics[id].slots, to_->topics[topics_[id]].slots));
  for (std::uint32_t id = 0; id < variables_.size(); ++id)
    if (auto& same = variables_[id];
        same != no_id &&
        (from_->variables[id].is_constant || to_->variables[same].is_constant))
      same = no_id;
  match_codes();
}

// A body has no name of its own; the compiler names it by the place where it
// stands, as in "timer 'lunch' in …". Of several in one place the first is the
// first there, and so on. A timer that has moved to another place is found by
// its own name. One with other local variables is not the same: its arguments
// would go astray.
void Renames::match_codes() {
  using Place = std::pair<std::string_view, std::size_t>;
  std::map<Place, script::CodeId> places;
  std::map<std::string_view, script::CodeId> timers;
  std::map<std::string_view, std::size_t> counts;
  for (script::CodeId id = 0; id < to_->code.size(); ++id) {
    const auto& code = to_->code[id];
    places[{code.name, counts[code.name]++}] = id;
    if (const auto timer = timer_of(code); !timer.empty())
      timers.try_emplace(timer, id);
  }
  counts.clear();
  for (script::CodeId id = 0; id < codes_.size(); ++id) {
    const auto& code = from_->code[id];
    const auto same = places.find({code.name, counts[code.name]++});
    const auto timer = timers.find(timer_of(code));
    auto& found = codes_[id];
    if (same != places.end())
      found = same->second;
    else if (timer != timers.end())
      found = timer->second;
    if (found != script::no_code && !takes_the_same(code, to_->code[found]))
      found = script::no_code;
  }
}

script::TopicId Renames::topic(script::TopicId id) const {
  return at(topics_, id);
}

script::SlotId Renames::slot(script::TopicId of, script::SlotId id) const {
  return of < slots_.size() ? at(slots_[of], id) : no_id;
}

script::StateId Renames::state(script::StateId id) const {
  return at(states_, id);
}

std::uint32_t Renames::variable(std::uint32_t id) const {
  return at(variables_, id);
}

script::CodeId Renames::code(script::CodeId id) const {
  return at(codes_, id);
}

} // namespace parlour::dialogue
