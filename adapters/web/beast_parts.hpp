// What the files that use Boost.Asio and Beast share. All of it belongs to one
// thread, which runs the io_context; so no executor is needed that could be
// anything.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/basic_waitable_timer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/basic_stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/wait_traits.hpp>
#include <boost/system/system_error.hpp>

#include "adapters/web/text_server.hpp"
#include "adapters/web/visit.hpp"

namespace parlour::adapters::web {

namespace net = boost::asio;
using net::ip::tcp;

// What LoopOver and AcceptorOver use of Boost.Asio, which Boost.Beast needs
// (adapters/loop/standalone_asio.hpp).
struct BoostAsio {
  using Clock = std::chrono::steady_clock;
  using Context = net::io_context;
  using Executor = Context::executor_type;
  using WorkGuard = net::executor_work_guard<Executor>;
  using Descriptor = net::posix::basic_stream_descriptor<Executor>;
  using Timer =
      net::basic_waitable_timer<Clock, net::wait_traits<Clock>, Executor>;
  using Socket = net::basic_stream_socket<tcp, Executor>;
  using Acceptor = net::basic_socket_acceptor<tcp, Executor>;
  using Error = boost::system::error_code;
  using Failure = boost::system::system_error;
  static constexpr auto aborted = net::error::operation_aborted;

  static void post(Context& context, std::function<void()> action) {
    net::post(context, std::move(action));
  }
};

using ErrorCode = BoostAsio::Error;
using Socket = BoostAsio::Socket;
using SteadyClock = BoostAsio::Clock;
using Timer = BoostAsio::Timer;

// Lines and frames have one class each (beast_lines.cpp, beast_frames.cpp).
// Each handler of asio holds the visit, so that it lives until the last one has
// come.
// A visit with its socket. The server holds it until it asks to be removed.
class SocketVisit : public Visit,
                    public std::enable_shared_from_this<SocketVisit> {
public:
  using Visit::Visit;
  // Closes at once; nothing is sent any more.
  virtual void drop() = 0;
};

// What visits have of their server.
// Owned by the server, which outlives all visits.
struct VisitParts {
  net::io_context& context;
  VisitorBook& book;
  const ServerOptions& options;
  // The visit is over: the server lets it go.
  std::function<void(SocketVisit*)> remove;
  std::function<void(std::shared_ptr<SocketVisit>)> add;
};

// Lines of a person or a program. Becomes the other kind where a request for a
// WebSocket comes.
// Every connection begins so; `parts` outlives it.
void start_line_visit(VisitParts& parts, Socket socket);
// `begun`: what has been read of the request.
void start_frame_visit(VisitParts& parts, Socket socket, std::string begun);

// The system notices connections that are half open.
void keep_alive(Socket& socket);

} // namespace parlour::adapters::web
