#include <atomic>
#include <csignal>
#include <future>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <utility>

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>

#include "adapters/web/beast_parts.hpp"
#include "adapters/web/bounds.hpp"
#include "adapters/web/text_server.hpp"

namespace parlour::adapters::web {

std::string text_of(const tcp::endpoint& end) {
  const auto host = end.address().to_string();
  return (end.address().is_v6() ? '[' + host + ']' : host) + ':' +
         std::to_string(end.port());
}

// asio passes on what a handler throws, and can be run again then.
void run_until_done(net::io_context& context,
                    const std::function<void(const std::string&)>& thrown) {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  for (;;)
    try {
      context.run();
      return;
    } catch (const std::exception& error) {
      thrown(error.what());
    } catch (...) {
      thrown("an exception of an unknown type");
    }
}

namespace {

using Acceptor = net::basic_socket_acceptor<tcp, Executor>;

// While the process has too many files open, accepting fails at once, again and
// again.
constexpr Milliseconds pause_between{200};
// The system's own queue: thousands may come at once after a restart.
constexpr int max_waiting_to_be_accepted = 4'096;
// For last words, when the server ends.
constexpr Milliseconds time_to_end{2'000};

// Other threads reach it by tell() only; everything else runs on its thread.
//
// How it ends: nobody else is let in, who is there is told, and has two seconds
// to read it; then all sockets are closed, and the thread returns.
class BeastServer : public TextServer {
public:
  BeastServer(ServerOptions options, Host& host, Thrown thrown)
      : options_(std::move(options)), thrown_(std::move(thrown)),
        book_(options_.book, host), acceptor_(context_), pause_(context_),
        expiry_(context_), parts_{context_, book_, options_,
                                  [this](auto* visit) { remove(visit); },
                                  [this](auto visit) { add(visit); }} {}

  // Visitors of a run that was killed are in the book before anybody can
  // connect.
  Expected<void> listen() {
    ErrorCode error;
    const auto address = net::ip::make_address(options_.address, error);
    const tcp::endpoint end(address, options_.port);
    if (!error)
      acceptor_.open(end.protocol(), error);
    if (!error)
      acceptor_.set_option(Acceptor::reuse_address(true), error);
    if (!error)
      acceptor_.bind(end, error);
    if (!error)
      acceptor_.listen(max_waiting_to_be_accepted, error);
    if (error)
      return fail(ErrorKind::network,
                  "nobody can be served at " + options_.address + " port " +
                      std::to_string(options_.port) + ": " + error.message());
    address_ = text_of(acceptor_.local_endpoint());
    for (auto& left : options_.left)
      book_.bring_back(std::move(left), SteadyClock::now());
    options_.left = {};
    await_expiry();
    accept();
    thread_ = std::thread([this] { run_until_done(context_, thrown_); });
    return {};
  }

  ~BeastServer() override {
    if (!thread_.joinable())
      return;
    net::post(context_, [this] { end(); });
    thread_.join();
  }

  std::string address() const override {
    return address_;
  }

  // -- conversations ----------------------------------------------------------

  void began(VisitorId visitor, std::string session) override {
    tell([=](BeastServer& self) { self.book_.began(visitor, session); });
  }
  void said(VisitorId visitor, std::string session, Said what) override {
    tell([visitor, session = std::move(session), what = std::move(what)](
             BeastServer& self) { self.book_.said(visitor, session, what); });
  }
  void done(VisitorId visitor, std::string session,
            std::uint64_t turn) override {
    tell([=](BeastServer& self) { self.book_.done(visitor, session, turn); });
  }
  void ended(VisitorId visitor, std::string session) override {
    tell([=](BeastServer& self) {
      self.book_.ended(visitor, session, SteadyClock::now());
      self.await_expiry();
    });
  }

  void stop_accepting() override {
    tell([](BeastServer& self) { self.close_acceptor(); });
  }

  // The caller waits, so the server's thread must not call this.
  Counts counts() override {
    std::promise<Counts> counts;
    tell([&](BeastServer& self) {
      counts.set_value(
          {self.visits_.size(), self.book_.size(), self.book_.counters()});
    });
    return counts.get_future().get();
  }

private:
  using News = std::function<void(BeastServer&)>;

  // All that has come meanwhile is taken at once: the thread need not be woken
  // for each.
  // Only the first of a batch wakes the thread: those that come before it has
  // taken the batch go with it.
  void tell(News news) {
    {
      const std::lock_guard lock(mutex_);
      news_.push_back(std::move(news));
      if (news_.size() > 1)
        return;
    }
    net::post(context_, [this] {
      std::vector<News> all;
      {
        const std::lock_guard lock(mutex_);
        all.swap(news_);
      }
      for (auto& one : all)
        one(*this);
    });
  }

  // -- connections ------------------------------------------------------------

  // One connection at a time is accepted, on the thread that serves all.
  void accept() {
    acceptor_.async_accept(context_, [this](ErrorCode error, Socket socket) {
      if (error == net::error::operation_aborted || !acceptor_.is_open())
        return;
      if (error)
        return accept_later();
      if (visits_.size() < options_.book.sessions + max_without_session)
        start_line_visit(parts_, std::move(socket));
      accept(); // beyond the bound the socket is closed at once
    });
  }

  void accept_later() {
    pause_.expires_after(pause_between);
    pause_.async_wait([this](ErrorCode error) {
      if (!error)
        accept();
    });
  }

  void close_acceptor() {
    ErrorCode ignored;
    acceptor_.close(ignored);
    pause_.cancel();
  }

  void add(std::shared_ptr<SocketVisit> visit) {
    auto* const key = visit.get();
    visits_.emplace(key, std::move(visit));
  }

  void remove(SocketVisit* visit) {
    visits_.erase(visit);
    await_expiry();
    if (is_ending_ && visits_.empty())
      let_end();
  }

  // -- time -------------------------------------------------------------------

  // Asked again whenever somebody may have lost a connection; nothing changes
  // where the same moment is awaited already.
  void await_expiry() {
    const auto next = book_.next_expiry();
    if (!next || is_ending_ || awaited_ == next)
      return;
    awaited_ = next;
    expiry_.expires_at(*next);
    expiry_.async_wait([this](ErrorCode error) {
      if (error)
        return;
      awaited_.reset();
      book_.expire(SteadyClock::now());
      await_expiry();
    });
  }

  // Who is still there is told, and has a moment to read it.
  void end() {
    is_ending_ = true;
    close_acceptor();
    expiry_.cancel();
    pause_.expires_after(time_to_end);
    pause_.async_wait([this](ErrorCode) { let_end(); });
    for (const auto& [key, visit] : std::unordered_map(visits_))
      visit->turn_away("closing", "the server ends");
    if (visits_.empty())
      let_end();
  }

  // The context returns from run() when the last handlers are done.
  void let_end() {
    pause_.cancel();
    stays_.reset();
    for (const auto& [key, visit] : std::unordered_map(visits_))
      visit->drop();
  }

  ServerOptions options_;
  const Thrown thrown_;
  net::io_context context_{1};
  net::executor_work_guard<Executor> stays_{context_.get_executor()};
  // Used on the server's thread only.
  VisitorBook book_;
  Acceptor acceptor_;
  Timer pause_;
  Timer expiry_;
  std::optional<VisitorBook::Moment> awaited_;
  std::unordered_map<SocketVisit*, std::shared_ptr<SocketVisit>> visits_;
  VisitParts parts_;
  bool is_ending_ = false;
  std::string address_;
  std::mutex mutex_; // of what others tell
  std::vector<News> news_;
  std::thread thread_;
};

} // namespace

Expected<std::unique_ptr<TextServer>>
TextServer::start(ServerOptions options, Host& host, Thrown thrown) {
  auto server = std::make_unique<BeastServer>(std::move(options), host,
                                              std::move(thrown));
  if (auto listening = server->listen(); !listening)
    return tl::make_unexpected(listening.error());
  return server;
}

} // namespace parlour::adapters::web
