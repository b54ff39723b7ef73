// What LoopOver and AcceptorOver use of the standalone asio library. Boost.Asio
// has the same under other names (adapters/web): Boost.Beast needs that one. An
// internal header of transports that are written with asio.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include <asio/basic_socket_acceptor.hpp>
#include <asio/basic_stream_socket.hpp>
#include <asio/basic_waitable_timer.hpp>
#include <asio/error.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/posix/basic_stream_descriptor.hpp>
#include <asio/post.hpp>
#include <asio/system_error.hpp>

namespace parlour::adapters {

// All of them know the kind of their loop, which spares them virtual calls.
struct StandaloneAsio {
  using Clock = std::chrono::steady_clock;
  using Context = asio::io_context;
  using Executor = Context::executor_type;
  using WorkGuard = asio::executor_work_guard<Executor>;
  using Descriptor = asio::posix::basic_stream_descriptor<Executor>;
  using Timer =
      asio::basic_waitable_timer<Clock, asio::wait_traits<Clock>, Executor>;
  using Socket = asio::basic_stream_socket<asio::ip::tcp, Executor>;
  using Acceptor = asio::basic_socket_acceptor<asio::ip::tcp, Executor>;
  using Error = asio::error_code;
  using Failure = asio::system_error;
  static constexpr auto aborted = asio::error::operation_aborted;

  static void post(Context& context, std::function<void()> action) {
    asio::post(context, std::move(action));
  }
};

} // namespace parlour::adapters
