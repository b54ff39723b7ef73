#include "adapters/loop/watch.hpp"

#include <functional>
#include <utility>

#include <asio/error_code.hpp>
#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/post.hpp>
#include <poll.h>

namespace parlour::adapters {

// asio's handlers share it, because they run later than a cancellation.
struct Watch::State : std::enable_shared_from_this<Watch::State> {
  // It knows the kind of its loop, which spares virtual calls.
  using Descriptor =
      asio::posix::basic_stream_descriptor<asio::io_context::executor_type>;

  State(asio::io_context& context, Ready action)
      : descriptor(context), ready(std::move(action)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  // Without release() asio would close what is not its own.
  ~State() {
    stop();
  }

  void await(int wanted, short wanted_events) {
    if (is_waiting && number == wanted && events == wanted_events)
      return;
    pause();
    if (wanted < 0 || wanted_events == 0)
      return;
    if (number != wanted)
      stop();
    number = wanted;
    events = wanted_events;
    begin();
  }

  // Waits for nothing, but asio still knows the descriptor: to wait again costs
  // one call of the system instead of four.
  void pause() {
    ++round;
    asio::error_code ignored; // it could not be waited for at all
    if (std::exchange(is_waiting, false))
      descriptor.cancel(ignored);
  }

  void stop() {
    ++round;
    is_waiting = false;
    number = -1;
    if (descriptor.is_open())
      descriptor.release();
  }

  // Reports what is ready, unless nobody waits any more for what the handler
  // was made for.
  auto handler(short event) {
    return [self = shared_from_this(), made_in = round,
            event](const asio::error_code&) {
      if (self->round == made_in)
        self->report(event);
    };
  }

  void begin() {
    is_waiting = true;
    if (!descriptor.is_open()) {
      is_new = true;
      asio::error_code error;
      descriptor.assign(number, error);
      if (error) {
        asio::post(descriptor.get_executor(),
                   [done = handler(events)] { done({}); });
        return;
      }
    }
    const std::pair<short, Descriptor::wait_type> kinds[] = {
        {POLLIN, Descriptor::wait_read},
        {POLLOUT, Descriptor::wait_write},
        {POLLPRI, Descriptor::wait_error}};
    for (const auto& [event, kind] : kinds)
      if (events & event)
        descriptor.async_wait(kind, handler(event));
  }

  // A descriptor that is new to asio may get an event of an earlier one, whose
  // memory it has. So the first event is checked.
  void report(short event) {
    pause();
    if (is_new && is_unready())
      return begin();
    is_new = false;
    ready(event);
  }
  bool is_unready() const {
    pollfd now{number, events, 0};
    return poll(&now, 1, 0) == 0;
  }

  Descriptor descriptor;
  const Ready ready;
  // What is waited for, or was last; -1: nothing since stop().
  int number = -1;
  short events = 0;
  bool is_waiting = false;
  bool is_new = false;
  // Handlers of an earlier round do nothing.
  unsigned round = 0;
};

Watch::Watch(Loop& loop, Ready ready)
    : state_(std::make_shared<State>(loop.context(), std::move(ready))) {}

Watch::~Watch() {
  state_->stop();
}

void Watch::await(int descriptor, short events) {
  state_->await(descriptor, events);
}

void Watch::stop() {
  state_->stop();
}

} // namespace parlour::adapters
