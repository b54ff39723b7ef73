#include "script/dialogue/lane.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace parlour::dialogue {

namespace {

// Lists of steps that are over whose memory is kept.
constexpr std::size_t most_blanks = 4;

} // namespace

void Lane::queue(std::vector<Step> item) {
  queue_from(item);
}

void Lane::queue_from(std::vector<Step>& item) {
  if (item.empty())
    return;
  auto steps = std::exchange(item, blank());
  if (at_rest())
    put_in_front(std::move(steps), contexts_.back());
  else
    queue_.push_back(std::move(steps));
}

bool Lane::at_rest() const {
  return !running_ && queue_.empty() && contexts_.size() == 1 &&
         contexts_.back().waiting == 0 && !contexts_.back().has_steps();
}

bool Lane::Context::has_steps() const {
  return std::any_of(agendas.begin(), agendas.end(),
                     [](const Agenda& agenda) { return !agenda.over(); });
}

void Lane::now(std::vector<Step> steps) {
  if (!steps.empty())
    put_in_front(std::move(steps), running());
  else
    keep_memory(std::move(steps));
}

void Lane::now_from(std::vector<Step>& steps) {
  if (!steps.empty())
    put_in_front(std::exchange(steps, blank()), running());
}

void Lane::at_once(Step&& step) {
  auto steps = blank();
  steps.push_back(std::move(step));
  put_in_front(std::move(steps), running());
}

Lane::Context& Lane::running() {
  if (contexts_.back().waiting != 0)
    contexts_.emplace_back();
  return contexts_.back();
}

void Lane::put_in_front(std::vector<Step>&& steps, Context& context) {
  context.agendas.push_back({std::move(steps), 0});
}

std::vector<Step> Lane::blank() {
  if (blanks_.empty())
    return {};
  auto steps = std::move(blanks_.back());
  blanks_.pop_back();
  return steps;
}

void Lane::keep_memory(std::vector<Step>&& steps) {
  steps.clear();
  if (steps.capacity() > 0 && blanks_.size() < most_blanks)
    blanks_.push_back(std::move(steps));
}

Step* Lane::take_from(Context& context) {
  auto& agendas = context.agendas;
  for (; !agendas.empty(); agendas.pop_back()) {
    auto& front = agendas.back();
    if (!front.over())
      return &front.steps[front.taken++];
    keep_memory(std::move(front.steps));
  }
  return nullptr;
}

Step* Lane::next() {
  running_ = true;
  abandoned_.clear();
  for (;;) {
    auto& top = contexts_.back();
    if (top.waiting != 0) {
      if (!top.for_user || queue_.empty())
        break;
      put_in_front(queue_.take(), contexts_.emplace_back());
    } else if (auto* step = take_from(top)) {
      return step;
    } else if (contexts_.size() > 1) {
      contexts_.pop_back(); // the one below goes on, or still waits
    } else if (!queue_.empty()) {
      put_in_front(queue_.take(), top);
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
  std::vector<Step> item;
  const Step* last = nullptr; // of all that the context will take
  for (auto agenda = context.agendas.rbegin(); agenda != context.agendas.rend();
       ++agenda) {
    auto& steps = agenda->steps;
    const auto acts = std::stable_partition(
        steps.begin() + static_cast<std::ptrdiff_t>(agenda->taken), steps.end(),
        [](const Step& step) { return step.kind != StepKind::take_act; });
    std::move(acts, steps.end(), std::back_inserter(item));
    steps.erase(acts, steps.end());
    if (!agenda->over())
      last = &steps.back();
  }
  if (item.empty())
    return;
  if (last && last->kind == StepKind::conclude)
    item.push_back(*last);
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
      auto steps = blank();
      steps.push_back(std::move(step));
      put_in_front(std::move(steps), context);
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
  std::move(contexts_.begin(), contexts_.end(), std::back_inserter(abandoned_));
  contexts_.clear();
  contexts_.emplace_back();
  return waits;
}

void Lane::clear() {
  queue_.clear();
  if (auto& top = contexts_.back(); !running_ && top.waiting == 0)
    top.agendas.clear(); // an item that came while the lane was at rest
}

bool Lane::idle() const {
  const auto& top = contexts_.back();
  const bool nothing_to_take =
      top.waiting != 0 || (contexts_.size() == 1 && !top.has_steps());
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
