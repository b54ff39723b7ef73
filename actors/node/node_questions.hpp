// NodeQuestions: asks the node's own actors from outside of them, and waits for
// what they say.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include <caf/actor_system.hpp>
#include <caf/scoped_actor.hpp>

#include "actors/node/scheduler.hpp"
#include "actors/protocol/interfaces.hpp"
#include "runtime/base/error.hpp"

namespace parlour::actors {

// A copy asks the same node, which outlives it. From the driving thread, in
// real time from any that ends before the node stops (node.hpp).
class NodeQuestions {
public:
  NodeQuestions(caf::actor_system& system, Scheduler& scheduler, NodeTime& time)
      : system_(&system), scheduler_(&scheduler), time_(&time) {}

  // In real time only the answer is waited for, as sessions may keep the node
  // busy for ever. In virtual time the actors run meanwhile, and time passes
  // for what a component that is replaced has begun.
  //
  // An error of kind Cancelled: interrupted, or the actor has ended as the
  // application stops. Of kind Timeout: virtual time stands still without an
  // answer.
  template <class Answer, class Actor, class What>
  Expected<Answer> ask(const Actor& actor, What what) const {
    caf::scoped_actor self(*system_);
    auto answer = self->request(actor, caf::infinite, std::move(what));
    const auto arrived = wait([&](Milliseconds patience) {
      return self->await_data(std::chrono::high_resolution_clock::now() +
                              patience);
    });
    if (!arrived)
      return tl::make_unexpected(arrived.error());
    Expected<Answer> told = fail(ErrorKind::cancelled, "the application stops");
    answer.receive([&](Answer& it) { told = std::move(it); },
                   [](const caf::error&) {}); // it has ended
    return told;
  }

  // Has a component loaded or unloaded. The error may also be that it does not
  // start, or is not there.
  template <class What>
  Expected<void> order(const supervisor_actor& supervisor, What what) const {
    return ask<component_done>(supervisor, std::move(what))
        .and_then([](component_done done) { return std::move(done.outcome); });
  }

private:
  // `answered` waits for at most so long.
  Expected<void> wait(const std::function<bool(Milliseconds)>& answered) const;

  caf::actor_system* system_;
  Scheduler* scheduler_;
  NodeTime* time_;
};

} // namespace parlour::actors
