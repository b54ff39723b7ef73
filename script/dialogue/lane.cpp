#include "script/dialogue/lane.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

void Lane::queue(StepList item) {
  if (item.empty())
    return;
  if (at_rest())
    contexts_.back().agenda = std::move(item);
  else
    queue_.push_back(std::move(item));
}

bool Lane::at_rest() const {
  return !running_ && queue_.empty() && contexts_.size() == 1 &&
         contexts_.back().waiting == 0 && contexts_.back().agenda.empty();
}

void Lane::now(StepList steps) {
  if (!steps.empty())
    running().agenda.prepend(std::move(steps));
}

void Lane::at_once(Step&& step) {
  StepList steps;
  steps.push_back(std::move(step));
  now(std::move(steps));
}

Lane::Context& Lane::running() {
  if (contexts_.back().waiting != 0)
    contexts_.emplace_back();
  return contexts_.back();
}

Step* Lane::next() {
  running_ = true;
  taken_.reset();
  for (;;) {
    auto& top = contexts_.back();
    if (top.waiting != 0) {
      if (!top.for_user || queue_.empty())
        break;
      contexts_.emplace_back().agenda = queue_.take();
    } else if (!top.agenda.empty()) {
      taken_ = top.agenda.take();
      return taken_.get();
    } else if (contexts_.size() > 1) {
      contexts_.pop_back(); // the one below goes on, or still waits
    } else if (!queue_.empty()) {
      top.agenda = queue_.take();
    } else {
      break;
    }
  }
  running_ = false;
  return nullptr;
}

// What else the user said does not wait for the answer: it is an item of its
// own, and both conclude.
void Lane::part_with_acts(Context& context) {
  auto item = context.agenda.take_if(
      [](const Step& step) { return step.kind == StepKind::take_act; });
  if (item.empty())
    return;
  if (const auto& rest = context.agenda;
      !rest.empty() && rest.back().kind == StepKind::conclude)
    item.push_back(Step(rest.back()));
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
      StepList steps;
      steps.push_back(std::move(step));
      context.agenda.prepend(std::move(steps));
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
  contexts_.clear();
  contexts_.emplace_back();
  return waits;
}

void Lane::clear() {
  queue_.clear();
  if (auto& top = contexts_.back(); !running_ && top.waiting == 0)
    top.agenda.clear(); // an item that came while the lane was at rest
}

bool Lane::idle() const {
  const auto& top = contexts_.back();
  if (top.waiting != 0)
    return queue_.empty() && !held();
  return contexts_.size() == 1 && top.agenda.empty() && queue_.empty();
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
