#include "actors/node/status_collector.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include <caf/actor_cast.hpp>
#include <caf/scoped_actor.hpp>

namespace parlour::actors {

namespace {

using SteadyClock = std::chrono::steady_clock;

// How long to wait before looking whether somebody has gone meanwhile.
constexpr Milliseconds glance{20};

bool has_gone(const caf::strong_actor_ptr& actor) {
  return actor->get()->getf(caf::abstract_actor::is_terminated_flag);
}

ActorStatus unanswered(const ActorHandle& handle) {
  ActorStatus status;
  status.kind = handle.kind;
  status.name = handle.name;
  status.doing = "does not answer";
  status.answered = false;
  return status;
}

// One collection; on the stack of who wants it.
//
// Questions are numbered, and each number is a place in `told_`: there stands
// "does not answer" until the answer comes.
class StatusCollector {
public:
  StatusCollector(caf::actor_system& system, Milliseconds patience,
                  Children children)
      : self_(system), deadline_(SteadyClock::now() + patience),
        with_children_(children == Children::asked) {}

  // A dead actor is asked as well: it is recognised as gone in the next round.
  void ask(const ActorHandle& handle) {
    if (!handle.actor)
      return;
    pending_.insert(told_.size());
    self_->send(caf::actor_cast<caf::actor>(handle.actor),
                get_status{told_.size(), with_children_});
    told_.push_back(unanswered(handle));
    asked_.push_back(handle);
  }

  // An answer may bring children, which are asked in turn: the loop ends when
  // nobody is left to wait for, or when the time is over.
  void take_answers(const std::function<void()>& let_run) {
    while (!pending_.empty()) {
      let_run();
      if (!take_one() && !time_is_left())
        return;
      forget_those_gone();
    }
  }

  // What was told, and of the others what can be seen from outside.
  std::vector<ActorStatus> finish() {
    for (auto number : pending_)
      if (const auto& call_since = asked_[number].call_since)
        told_[number].call_since = call_since();
    std::vector<ActorStatus> result;
    for (std::size_t i = 0; i < told_.size(); ++i)
      if (gone_.count(i) == 0)
        result.push_back(std::move(told_[i]));
    return result;
  }

private:
  bool time_is_left() const {
    return SteadyClock::now() < deadline_;
  }

  // False where there was none within a glance.
  bool take_one() {
    bool taken = false;
    const auto left = std::chrono::duration_cast<Milliseconds>(
        deadline_ - SteadyClock::now());
    self_->receive(
        [&](status_told& what) {
          taken = true;
          take(what);
        },
        caf::after(std::clamp(left, Milliseconds::zero(), glance)) >> [] {});
    return taken;
  }

  // Who does not know its own name, such as a seat's actor without one, keeps
  // the name it was asked under.
  void take(status_told& what) {
    if (pending_.erase(what.number) == 0)
      return;
    auto& status = told_[what.number];
    const auto name = std::exchange(status, std::move(what.status)).name;
    if (status.name.empty())
      status.name = name;
    if (with_children_)
      for (const auto& child : what.children)
        ask(child);
  }

  // Timers and queries end by themselves.
  void forget_those_gone() {
    std::erase_if(pending_, [this](auto number) {
      const bool gone = has_gone(asked_[number].actor);
      if (gone)
        gone_.insert(number);
      return gone;
    });
  }

  caf::scoped_actor self_;
  SteadyClock::time_point deadline_;
  const bool with_children_;
  std::vector<ActorHandle> asked_;
  std::vector<ActorStatus> told_;
  std::set<std::size_t> pending_; // numbers
  std::set<std::size_t> gone_;
};

} // namespace

std::vector<ActorStatus> collect_status(caf::actor_system& system,
                                        const std::vector<ActorHandle>& roots,
                                        const std::function<void()>& let_run,
                                        Milliseconds patience,
                                        Children children) {
  StatusCollector collector(system, patience, children);
  for (const auto& root : roots)
    collector.ask(root);
  collector.take_answers(let_run);
  return collector.finish();
}

} // namespace parlour::actors
