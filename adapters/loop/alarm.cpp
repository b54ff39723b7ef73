#include "adapters/loop/alarm.hpp"

#include <utility>

#include <asio/error_code.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

namespace parlour::adapters {

// asio's handlers share it, because they run later than a cancellation.
struct Alarm::State : std::enable_shared_from_this<Alarm::State> {
  State(asio::io_context& context, Loop::Action done)
      : timer(context), action(std::move(done)) {}

  // A timer that is too early stays: when it rings, the rest is waited for.
  // Deadlines that move with each message cost nothing that way.
  void set(Moment wanted) {
    moment = wanted;
    if (wanted >= rings_at)
      return;
    wait();
  }

  void wait() {
    rings_at = moment;
    ++round;
    timer.expires_at(moment);
    timer.async_wait(
        [self = shared_from_this(), made_in = round](const asio::error_code&) {
          if (self->round == made_in)
            self->ring();
        });
  }

  void ring() {
    rings_at = never;
    if (moment == never)
      return;
    if (moment > Moment::clock::now()) {
      wait();
      return;
    }
    moment = never;
    action();
  }

  void stop() {
    ++round;
    moment = never;
    rings_at = never;
    timer.cancel();
  }

  asio::steady_timer timer;
  const Loop::Action action;
  // When the action is to be called.
  Moment moment = never;
  // When the timer rings, at the same time or earlier.
  Moment rings_at = never;
  // Handlers of an earlier round do nothing.
  unsigned round = 0;
};

Alarm::Alarm(Loop& loop, Loop::Action action)
    : state_(std::make_shared<State>(loop.context(), std::move(action))) {}

Alarm::~Alarm() {
  state_->stop();
}

void Alarm::set(Moment moment) {
  state_->set(moment);
}

} // namespace parlour::adapters
