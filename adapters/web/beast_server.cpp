#include <future>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "adapters/loop/acceptor_over.hpp"
#include "adapters/loop/loop_over.hpp"
#include "adapters/web/beast_parts.hpp"
#include "adapters/web/bounds.hpp"
#include "adapters/web/text_server.hpp"

namespace parlour::adapters::web {

namespace {

using BoostLoop = LoopOver<BoostAsio>;

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
  BeastServer(ServerOptions options, Host& host,
              std::unique_ptr<BoostLoop> loop)
      : options_(std::move(options)), loop_(std::move(loop)),
        book_(options_.book, host), acceptor_(loop_->context()),
        expiry_(loop_->context()), last_words_(loop_->context()) {}

  // Visitors of a run that was killed are in the book before anybody can
  // connect.
  Expected<void> listen() {
    for (auto& left : options_.left)
      book_.bring_back(std::move(left), SteadyClock::now());
    options_.left = {};
    ErrorCode error;
    const auto address = net::ip::make_address(options_.address, error);
    auto opened = error ? fail(ErrorKind::network, error.message())
                        : acceptor_.open({address, options_.port},
                                         max_waiting_to_be_accepted);
    if (!opened)
      return fail(ErrorKind::network, "nobody can be served at " +
                                          options_.address + " port " +
                                          std::to_string(options_.port) + ": " +
                                          opened.error().message);
    loop_->post([this] {
      await_expiry();
      accept();
    });
    return {};
  }

  // Its own timer ends what does not end by itself, long before the loop does.
  ~BeastServer() override {
    loop_->post([this] { end(); });
    loop_->stop(10 * time_to_end);
  }

  std::string address() const override {
    return acceptor_.address();
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
    tell([](BeastServer& self) { self.acceptor_.close(); });
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
    loop_->post([this] {
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

  // Beyond the bound the socket is closed at once.
  void accept() {
    acceptor_.accept({[this](Socket socket) {
      if (visits_.size() < options_.book.sessions + max_without_session)
        start_line_visit(parts_, std::move(socket));
    }});
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
    acceptor_.close();
    expiry_.cancel();
    last_words_.expires_after(time_to_end);
    last_words_.async_wait([this](ErrorCode) { let_end(); });
    for (const auto& [key, visit] : std::unordered_map(visits_))
      visit->turn_away("closing", "the server ends");
    if (visits_.empty())
      let_end();
  }

  // The loop ends when the last handlers are done.
  void let_end() {
    last_words_.cancel();
    for (const auto& [key, visit] : std::unordered_map(visits_))
      visit->drop();
  }

  ServerOptions options_;
  const std::unique_ptr<BoostLoop> loop_;
  // Used on the loop's thread only, once that has something to do.
  VisitorBook book_;
  AcceptorOver<BoostAsio> acceptor_;
  Timer expiry_;
  Timer last_words_;
  std::optional<VisitorBook::Moment> awaited_;
  std::unordered_map<SocketVisit*, std::shared_ptr<SocketVisit>> visits_;
  VisitParts parts_{loop_->context(), book_, options_,
                    [this](auto* visit) { remove(visit); },
                    [this](auto visit) { add(visit); }};
  bool is_ending_ = false;
  std::mutex mutex_; // of what others tell
  std::vector<News> news_;
};

} // namespace

Expected<std::unique_ptr<TextServer>>
TextServer::start(ServerOptions options, Host& host, Thrown thrown) {
  auto loop = BoostLoop::start(std::move(thrown));
  if (!loop)
    return tl::make_unexpected(std::move(loop.error()));
  auto server =
      std::make_unique<BeastServer>(std::move(options), host, std::move(*loop));
  if (auto listening = server->listen(); !listening)
    return tl::make_unexpected(listening.error());
  return server;
}

} // namespace parlour::adapters::web
