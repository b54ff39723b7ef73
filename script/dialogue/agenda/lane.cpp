#include "script/dialogue/agenda/lane.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

// An item that finds the lane at rest goes into the agenda directly, which
// saves the way through the queue.
void Lane::queue(StepList item) {
  if (item.empty())
    return;
  if (takes_at_once())
    contexts_.back().agenda = std::move(item);
  else
    queue_.push_back(std::move(item));
}

bool Lane::takes_at_once() const {
  return !running_ && queue_.empty() && contexts_.size() == 1 &&
         contexts_.back().waiting == 0 && contexts_.back().agenda.empty();
}

void Lane::now(StepList steps) {
  if (!steps.empty())
    running().agenda.prepend(std::move(steps));
}

Lane::Context& Lane::running() {
  if (contexts_.back().waiting != 0)
    contexts_.emplace_back();
  return contexts_.back();
}

// Contexts that are done are left, and what waits to run is brought up, until
// there is a step or nothing can be taken.
Step* Lane::next() {
  running_ = true;
  taken_.reset();
  while (!contexts_.back().can_run())
    if (!bring_up_next()) {
      running_ = false;
      return nullptr;
    }
  taken_ = contexts_.back().agenda.take();
  return &taken_->step;
}

// Something that can run, or at least one context less, on top. The order is
// the one of engine rule 2.4: a wait that holds the lane comes before all, then
// what was woken, then the next item.
bool Lane::bring_up_next() {
  if (contexts_.size() > 1 && contexts_.back().waiting == 0) {
    contexts_.pop_back(); // it is done
    return true;
  }
  if (held())
    return false;
  if (bring_up_woken())
    return true;
  if (queue_.empty())
    return false;
  running().agenda = queue_.take();
  return true;
}

// The latest that no longer waits. It moves above all others, which wait:
// contexts need not end in the order in which they began, as calls do.
bool Lane::bring_up_woken() {
  const auto woken =
      std::find_if(contexts_.rbegin(), contexts_.rend(),
                   [](const Context& context) { return context.can_run(); });
  if (woken == contexts_.rend())
    return false;
  std::rotate(woken.base() - 1, woken.base(), contexts_.end());
  return true;
}

StepList Lane::take_acts() {
  return acts_of(contexts_.back());
}

// The acts that are still to be taken become the next item.
void Lane::part_with_acts(Context& context) {
  if (auto item = acts_of(context); !item.empty())
    queue_.push_front(std::move(item));
}

// Both items conclude, as each may lead to a question of its own.
StepList Lane::acts_of(Context& context) {
  auto item = context.agenda.take_if(is<steps::TakeAct>);
  if (const auto& remaining = context.agenda;
      !item.empty() && !remaining.empty() &&
      is<steps::Conclude>(remaining.back()))
    item.add(remaining.back());
  return item;
}

void Lane::wait(WaitId wait, Others others) {
  auto& top = contexts_.back();
  if (others == Others::go_on) // what else was said does not wait
    part_with_acts(top);
  top.waiting = wait;
  top.others = others;
}

Lane::Contexts::iterator Lane::waiting_so(WaitId wait) {
  return std::find_if(
      contexts_.begin(), contexts_.end(),
      [&](const Context& context) { return context.waits_so(wait); });
}

// The context is moved above those behind it that wait without holding the
// lane. It stays below one that runs, which goes on first, and below one that
// holds the lane.
bool Lane::wake(WaitId wait, StepList steps) {
  const auto woken = waiting_so(wait);
  if (woken == contexts_.end())
    return false;
  woken->waiting = 0;
  woken->agenda.prepend(std::move(steps));
  const auto holds =
      std::find_if(woken + 1, contexts_.end(), [](const Context& context) {
        return context.waiting == 0 || context.others == Others::are_held;
      });
  std::rotate(woken, woken + 1, holds);
  return true;
}

void Lane::follow(WaitId wait, steps::Settle&& step) {
  const auto context = waiting_so(wait);
  if (context == contexts_.end() ||
      std::ranges::any_of(context->agenda, [&](const Step& other) {
        const auto* known = std::get_if<steps::Settle>(&other);
        return known && known->topic == step.topic;
      }))
    return;
  context->agenda.prepend(StepList(std::move(step)));
}

StepList Lane::take_out(WaitId wait) {
  const auto context = waiting_so(wait);
  if (context == contexts_.end())
    return {};
  auto agenda = std::move(context->agenda);
  contexts_.erase(context);
  if (contexts_.empty())
    contexts_.emplace_back();
  return agenda;
}

// A context that has no wait is dropped with its steps, the running one
// included: what the user wants out of has nothing more to do.
std::vector<WaitId> Lane::abandon(const std::vector<WaitId>& but) {
  const auto stays = [&](const Context& context) {
    return context.waiting != 0 &&
           std::ranges::find(but, context.waiting) != but.end();
  };
  std::vector<WaitId> waits;
  for (auto context = contexts_.rbegin(); context != contexts_.rend();
       ++context)
    if (context->waiting != 0 && !stays(*context))
      waits.push_back(context->waiting);
  std::erase_if(contexts_,
                [&](const Context& context) { return !stays(context); });
  contexts_.emplace_back();
  return waits;
}

void Lane::clear() {
  queue_.clear();
  if (auto& top = contexts_.back(); !running_ && top.waiting == 0)
    top.agenda.clear(); // an item that came while nothing ran
}

bool Lane::idle() const {
  return queue_.empty() && !held() &&
         std::none_of(contexts_.begin(), contexts_.end(),
                      [](const Context& context) { return context.can_run(); });
}

bool Lane::held() const {
  return std::any_of(
      contexts_.begin(), contexts_.end(), [](const Context& context) {
        return context.waiting != 0 && context.others == Others::are_held;
      });
}

bool Lane::waits() const {
  return std::any_of(
      contexts_.begin(), contexts_.end(),
      [](const Context& context) { return context.waiting != 0; });
}

bool Lane::waits(WaitId wait) const {
  return std::any_of(
      contexts_.begin(), contexts_.end(),
      [&](const Context& context) { return context.waits_so(wait); });
}

// The last context is the running one.
bool Lane::returning() const {
  return std::any_of(contexts_.begin(), contexts_.end() - 1,
                     [](const Context& context) { return context.can_run(); });
}

} // namespace parlour::dialogue
