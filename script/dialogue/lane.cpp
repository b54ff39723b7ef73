#include "script/dialogue/lane.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace parlour::dialogue {

void Lane::queue(std::vector<Step> item) {
  queue_from(item);
}

void Lane::queue_from(std::vector<Step>& item) {
  if (item.empty())
    return;
  if (at_rest())
    take_item(item, contexts_.back());
  else
    queue_.push_back(std::exchange(item, {}));
}

bool Lane::at_rest() const {
  return !running_ && queue_.empty() && contexts_.size() == 1 &&
         contexts_.back().waiting == 0 && contexts_.back().agenda.empty();
}

void Lane::now(std::vector<Step> steps) {
  now_from(steps);
}

void Lane::now_from(std::vector<Step>& steps) {
  if (steps.empty())
    return;
  auto& agenda = running().agenda;
  agenda.insert(agenda.end(), std::make_move_iterator(steps.rbegin()),
                std::make_move_iterator(steps.rend()));
  steps.clear();
}

void Lane::at_once(Step&& step) {
  running().agenda.push_back(std::move(step));
}

Lane::Context& Lane::running() {
  if (contexts_.back().waiting != 0)
    contexts_.emplace_back();
  return contexts_.back();
}

std::optional<Step> Lane::next() {
  running_ = true;
  for (;;) {
    auto& top = contexts_.back();
    if (top.waiting != 0) {
      if (!top.for_user || queue_.empty())
        break;
      auto item = queue_.take();
      take_item(item, contexts_.emplace_back());
    } else if (!top.agenda.empty()) {
      std::optional<Step> step(std::move(top.agenda.back()));
      top.agenda.pop_back();
      return step;
    } else if (contexts_.size() > 1) {
      contexts_.pop_back(); // the one below goes on, or still waits
    } else if (!queue_.empty()) {
      auto item = queue_.take();
      take_item(item, top);
    } else {
      break;
    }
  }
  running_ = false;
  return std::nullopt;
}

void Lane::take_item(std::vector<Step>& item, Context& context) {
  if (context.agenda.empty() && context.agenda.capacity() < item.size())
    context.agenda.reserve(4 * item.size());
  std::move(item.rbegin(), item.rend(), std::back_inserter(context.agenda));
  item.clear();
}

// What else the user said does not wait for the answer: it is an item of its
// own, and both conclude.
void Lane::part_with_acts(Context& context) {
  auto& agenda = context.agenda; // what is next is at its end
  const auto acts =
      std::stable_partition(agenda.begin(), agenda.end(), [](const Step& step) {
        return step.kind != StepKind::take_act;
      });
  if (acts == agenda.end())
    return;
  std::vector<Step> item(std::make_move_iterator(agenda.rbegin()),
                         std::make_move_iterator(std::reverse_iterator(acts)));
  agenda.erase(acts, agenda.end());
  if (!agenda.empty() && agenda.front().kind == StepKind::conclude)
    item.push_back(agenda.front());
  queue_.push_front(std::move(item));
}

void Lane::wait(WaitId wait, bool for_user) {
  auto& top = contexts_.back();
  if (for_user)
    part_with_acts(top);
  top.waiting = wait;
  top.for_user = for_user;
}

bool Lane::wake(WaitId wait, Step step) {
  for (auto& context : contexts_)
    if (context.waiting == wait) {
      context.waiting = 0;
      context.agenda.push_back(std::move(step));
      return true;
    }
  return false;
}

std::vector<WaitId> Lane::abandon() {
  std::vector<WaitId> waits;
  for (auto context = contexts_.rbegin(); context != contexts_.rend();
       ++context)
    if (context->waiting != 0)
      waits.push_back(context->waiting);
  contexts_.assign(1, {});
  return waits;
}

void Lane::clear() {
  queue_.clear();
  if (auto& top = contexts_.back(); !running_ && top.waiting == 0)
    top.agenda.clear(); // an item that came while the lane was at rest
}

bool Lane::idle() const {
  const auto& top = contexts_.back();
  const bool nothing_to_take =
      top.waiting != 0 || (top.agenda.empty() && contexts_.size() == 1);
  return queue_.empty() && nothing_to_take && !held();
}

bool Lane::held() const {
  return std::any_of(contexts_.begin(), contexts_.end(),
                     [](const Context& context) {
                       return context.waiting != 0 && !context.for_user;
                     });
}

bool Lane::waits_for_user() const {
  return std::any_of(contexts_.begin(), contexts_.end(),
                     [](const Context& context) {
                       return context.waiting != 0 && context.for_user;
                     });
}

bool Lane::waits(WaitId wait) const {
  return std::any_of(
      contexts_.begin(), contexts_.end(),
      [&](const Context& context) { return context.waiting == wait; });
}

bool Lane::returning() const {
  return contexts_.size() > 1 && contexts_[contexts_.size() - 2].waiting == 0;
}

} // namespace parlour::dialogue
