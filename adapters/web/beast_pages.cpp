// Pages by Boost.Beast.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <thread>
#include <unordered_set>
#include <utility>

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>

#include "adapters/web/beast_parts.hpp"
#include "adapters/web/bounds.hpp"
#include "adapters/web/page_server.hpp"

namespace parlour::adapters::web {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;

using PageAcceptor = net::basic_socket_acceptor<tcp, Executor>;

constexpr Milliseconds page_pause{200}; // after accepting failed
// How many the system may keep until they are accepted.
constexpr int waiting_for_pages = 64;

class PageVisit;
using PageVisits = std::unordered_set<std::shared_ptr<PageVisit>>;

// Whoever goes away in the middle, or never comes, is not answered.
bool is_malformed(const ErrorCode& error) {
  return error.category() ==
             make_error_code(http::error::bad_method).category() &&
         error != http::error::end_of_stream &&
         error != http::error::partial_message;
}

// One connection. The server holds it until it is over.
// Read one request, answer it, close: whoever watches asks every few seconds.
class PageVisit : public std::enable_shared_from_this<PageVisit> {
public:
  PageVisit(net::io_context& context, const PageServerOptions& options,
            PageVisits& visits, Socket socket)
      : options_(options), visits_(visits), socket_(std::move(socket)),
        timer_(context.get_executor()) {}

  // Head and body are bounded before anything is read.
  void start() {
    parser_.header_limit(max_head);
    parser_.body_limit(0);
    be_patient();
    http::async_read(socket_, buffer_, parser_,
                     [self = shared_from_this()](ErrorCode error, std::size_t) {
                       self->judge(error);
                     });
  }

  void drop() {
    ErrorCode ignored;
    timer_.cancel();
    socket_.close(ignored);
    visits_.erase(shared_from_this());
  }

private:
  void be_patient() {
    timer_.expires_after(options_.patience);
    timer_.async_wait([self = shared_from_this()](ErrorCode error) {
      if (!error)
        self->drop();
    });
  }

  // Who speaks no HTTP gets an answer in HTTP all the same.
  void judge(ErrorCode error) {
    if (error == http::error::header_limit)
      return refuse(http::status::request_header_fields_too_large);
    if (error == http::error::body_limit)
      return refuse(http::status::payload_too_large);
    if (is_malformed(error))
      return refuse(http::status::bad_request);
    if (error)
      return drop();
    answer_request();
  }

  // What stands behind a '?' changes nothing.
  void answer_request() {
    const auto& request = parser_.get();
    const bool is_head = request.method() == http::verb::head;
    if (!is_head && request.method() != http::verb::get) {
      response_.set(http::field::allow, "GET, HEAD");
      return refuse(http::status::method_not_allowed);
    }
    std::string path(request.target().data(), request.target().size());
    path.erase(std::min(path.find('?'), path.size()));
    const auto page = options_.pages.find(path);
    if (page == options_.pages.end())
      return refuse(http::status::not_found);
    try {
      const auto made = page->second();
      send(made.is_well ? http::status::ok : http::status::service_unavailable,
           made, is_head);
    } catch (const std::exception& thrown) {
      send(http::status::internal_server_error,
           {false, std::string(thrown.what()) + "\n"}, is_head);
    }
  }

  // The text says which pages there are, as a person may have mistyped one.
  void refuse(http::status status) {
    std::string known;
    for (const auto& [path, page] : options_.pages)
      known += (known.empty() ? "" : ", ") + path;
    const auto reason = http::obsolete_reason(status);
    send(status, {false, std::string(reason.data(), reason.size()) +
                             "; there is: GET " + known + "\n"});
  }

  // The patience begins anew: the other side has to read the answer now.
  void send(http::status status, const Page& page, bool is_head = false) {
    response_.version(11);
    response_.result(status);
    response_.set(http::field::content_type, page.content_type);
    response_.set(http::field::connection, "close");
    response_.set(http::field::cache_control, "no-store");
    response_.content_length(page.text.size());
    if (!is_head)
      response_.body() = page.text;
    be_patient();
    http::async_write(
        socket_, response_,
        [self = shared_from_this()](ErrorCode error, std::size_t) {
          self->finish(error);
        });
  }

  // Unread bytes would make the system throw the answer away: so they are read
  // until the other side closes, or patience ends.
  void finish(ErrorCode error) {
    ErrorCode ignored;
    socket_.shutdown(Socket::shutdown_send, ignored);
    if (error)
      return drop();
    skip();
  }

  void skip() {
    socket_.async_read_some(
        net::buffer(skipped_),
        [self = shared_from_this()](ErrorCode error, std::size_t) {
          if (error)
            self->drop();
          else
            self->skip();
        });
  }

  const PageServerOptions& options_;
  PageVisits& visits_;
  Socket socket_;
  Timer timer_;
  beast::flat_buffer buffer_{max_head};
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
  std::array<char, 1'024> skipped_{};
};

// The thread runs nothing but the context; all members that it uses are set
// before it starts.
class BeastPages : public PageServer {
public:
  BeastPages(PageServerOptions options, Thrown thrown)
      : options_(std::move(options)), thrown_(std::move(thrown)),
        acceptor_(context_), pause_(context_) {}

  Expected<void> listen() {
    ErrorCode error;
    const auto address = net::ip::make_address(options_.address, error);
    const tcp::endpoint end(address, options_.port);
    if (!error)
      acceptor_.open(end.protocol(), error);
    if (!error)
      acceptor_.set_option(PageAcceptor::reuse_address(true), error);
    if (!error)
      acceptor_.bind(end, error);
    if (!error)
      acceptor_.listen(waiting_for_pages, error);
    if (error)
      return fail(ErrorKind::network,
                  "no pages can be served at " + options_.address + " port " +
                      std::to_string(options_.port) + ": " + error.message());
    address_ = text_of(acceptor_.local_endpoint());
    accept();
    thread_ = std::thread([this] { run_until_done(context_, thrown_); });
    return {};
  }

  ~BeastPages() override {
    if (!thread_.joinable())
      return;
    net::post(context_, [this] {
      ErrorCode ignored;
      acceptor_.close(ignored);
      pause_.cancel();
      for (const auto& visit : PageVisits(visits_))
        visit->drop();
    });
    thread_.join();
  }

  std::string address() const override {
    return address_;
  }

private:
  void accept() {
    acceptor_.async_accept(context_, [this](ErrorCode error, Socket socket) {
      if (error == net::error::operation_aborted || !acceptor_.is_open())
        return;
      if (error)
        return accept_later();
      if (visits_.size() < options_.connections) {
        auto visit = std::make_shared<PageVisit>(context_, options_, visits_,
                                                 std::move(socket));
        visits_.insert(visit);
        visit->start();
      }
      accept(); // beyond the bound the socket is closed at once
    });
  }

  // While the process has too many files open.
  void accept_later() {
    pause_.expires_after(page_pause);
    pause_.async_wait([this](ErrorCode error) {
      if (!error)
        accept();
    });
  }

  const PageServerOptions options_;
  const Thrown thrown_;
  net::io_context context_{1};
  PageAcceptor acceptor_;
  Timer pause_;
  PageVisits visits_; // used on the server's thread only
  std::string address_;
  std::thread thread_;
};

} // namespace

Expected<std::unique_ptr<PageServer>>
PageServer::start(PageServerOptions options, Thrown thrown) {
  auto server =
      std::make_unique<BeastPages>(std::move(options), std::move(thrown));
  if (auto listening = server->listen(); !listening)
    return tl::make_unexpected(listening.error());
  return server;
}

} // namespace parlour::adapters::web
