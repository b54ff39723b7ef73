#include "adapters/loop/loop.hpp"

#include <utility>

#include "adapters/loop/loop_over.hpp"
#include "adapters/loop/standalone_asio.hpp"

namespace parlour::adapters {

Expected<std::unique_ptr<Loop>> Loop::start(Thrown thrown) {
  auto thread = Thread::start(std::move(thrown));
  if (!thread)
    return tl::make_unexpected(std::move(thread.error()));
  return std::unique_ptr<Loop>(new Loop(std::move(*thread)));
}

Loop::Loop(std::unique_ptr<Thread> thread) : thread_(std::move(thread)) {}

Loop::~Loop() = default;

void Loop::post(Action action) {
  thread_->post(std::move(action));
}

void Loop::stop(Milliseconds linger) {
  thread_->stop(linger);
}

asio::io_context& Loop::context() {
  return thread_->context();
}

} // namespace parlour::adapters
