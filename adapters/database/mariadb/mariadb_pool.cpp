#include "adapters/database/mariadb/mariadb_pool.hpp"

#include <algorithm>
#include <csignal>
#include <iterator>
#include <utility>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "adapters/database/mariadb/mariadb_setup.hpp"

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;
using Kind = DatabaseCommand;

constexpr std::size_t most_pending = 1'000;
// The server ends a statement itself; beyond that it is not there any more.
constexpr Milliseconds grace{1'000};

MariaDBConnection::Outcome carry_out(MariaDBConnection& connection,
                                     const DatabaseOrder& order) {
  const auto& params = order.message.params;
  switch (order.kind) {
  case Kind::connect:
    return connection.control("do 1");
  case Kind::begin:
    return connection.begin();
  case Kind::commit:
    return connection.end(MariaDBConnection::End::commit);
  case Kind::rollback:
    return connection.end(MariaDBConnection::End::rollback);
  default:
    return connection.run(params[0], params.size() > 1 ? params[1] : Value(),
                          order.write ? Access::write : Access::read);
  }
}

} // namespace

MariaDBPool::MariaDBPool(MariaDBOptions options, Tell tell, Log log)
    : options_(std::make_shared<const MariaDBOptions>(std::move(options))),
      tell_(std::move(tell)), log_(std::move(log)) {
  wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  for (std::size_t i = 0; i < options_->connections; ++i)
    workers_.push_back(std::make_unique<Worker>());
  thread_ = std::thread([this] { work(); });
}

MariaDBPool::~MariaDBPool() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake();
  thread_.join();
  ::close(wake_);
}

Expected<void> MariaDBPool::first_connection() {
  return first_.get_future().get();
}

void MariaDBPool::submit(DatabaseOrder order) {
  const auto deadline = Steady::now() + options_->busy_timeout;
  {
    const std::lock_guard lock(mutex_);
    if (pending_ < most_pending) {
      ++pending_;
      inbox_.push_back({std::move(order), deadline});
      return std::exchange(wants_waking_, false) ? wake() : void();
    }
  }
  tell_(order.message, fail(ErrorKind::limit, "Too many wait for the "
                                              "database."));
}

void MariaDBPool::wake() {
  const std::uint64_t once = 1;
  (void)!write(wake_, &once, sizeof once);
}

// -- the thread ---------------------------------------------------------------

void MariaDBPool::work() {
  // Signals are for others, that of a closed socket for nobody.
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  open_one();
  while (take_in()) {
    expire(Steady::now());
    assign();
    hand_over();
    wait_for_events();
  }
  end();
}

// False where it is to end.
bool MariaDBPool::take_in() {
  bool goes_on = false;
  {
    const std::lock_guard lock(mutex_);
    goes_on = !over_;
    wants_waking_ = false;
    taken_.swap(inbox_);
  }
  std::move(taken_.begin(), taken_.end(), std::back_inserter(waiting_));
  taken_.clear();
  return goes_on;
}

// The connections have work again before others are told what was done.
void MariaDBPool::hand_over() {
  if (told_.empty())
    return;
  {
    const std::lock_guard lock(mutex_);
    pending_ -= told_.size();
  }
  for (auto& [message, outcome] : told_)
    tell_(message, std::move(outcome));
  told_.clear();
}

// Nothing can be begun before one of them is done.
bool MariaDBPool::is_busy() const {
  return std::all_of(workers_.begin(), workers_.end(), [](const auto& worker) {
    return static_cast<bool>(worker->task);
  });
}

// False where something has come in that could be begun.
bool MariaDBPool::may_sleep() {
  const bool busy = is_busy();
  const std::lock_guard lock(mutex_);
  wants_waking_ = !busy;
  return !over_ && (busy || inbox_.empty());
}

void MariaDBPool::assign() {
  // Whose connection dies over it right away waits in front of the others.
  round_.swap(waiting_);
  for (; !round_.empty() && !is_busy(); round_.pop_front())
    if (auto& first = round_.front(); !assign(first))
      waiting_.push_back(std::move(first));
  if (waiting_.empty())
    waiting_.swap(round_);
  std::move(round_.begin(), round_.end(), std::back_inserter(waiting_));
  round_.clear();
  open_at_ = Moment::max();
  if (is_busy() || !somebody_needs_one() || is_opening())
    return;
  if (Steady::now() < next_attempt_ || open_one())
    open_at_ = next_attempt_;
}

bool MariaDBPool::is_opening() const {
  return std::any_of(workers_.begin(), workers_.end(), [](const auto& worker) {
    return worker->task && !worker->waiting;
  });
}

bool MariaDBPool::somebody_needs_one() const {
  return std::any_of(waiting_.begin(), waiting_.end(), [this](const auto& one) {
    return !holder(one.order.message.session);
  });
}

// False where it has to wait.
bool MariaDBPool::assign(Waiting& waiting) {
  if (auto error = objection(waiting)) {
    tell(std::move(waiting), tl::make_unexpected(std::move(*error)));
    return true;
  }
  auto* worker = holder(waiting.order.message.session);
  if (!worker)
    worker = free_worker(waiting.order.write ? Access::write : Access::read);
  if (!worker || !worker->is_idle())
    return false;
  start(*worker, std::move(waiting));
  return true;
}

// What keeps the order from being carried out now or later.
std::optional<Error> MariaDBPool::objection(const Waiting& waiting) {
  const auto& [kind, message, write] = waiting.order;
  const auto& session = message.session;
  const bool ends = kind == Kind::commit || kind == Kind::rollback;
  if (kind == Kind::begin) {
    lost_.forget(session);
    if (holder(session))
      return already_begun();
  } else if (lost_.has(session) && (ends || kind == Kind::query)) {
    if (ends)
      lost_.forget(session);
    return rolled_back(message);
  } else if (ends && !holder(session)) {
    return not_begun(message);
  }
  return {};
}

MariaDBPool::Worker* MariaDBPool::holder(const SessionId& session) const {
  for (const auto& worker : workers_)
    if (worker->session == session)
      return worker.get();
  return nullptr;
}

// One that need not be told what it may do, if there is.
MariaDBPool::Worker* MariaDBPool::free_worker(Access access) {
  Worker* found = nullptr;
  for (const auto& worker : workers_)
    if (worker->is_idle() && !worker->session &&
        (!found || worker->connection->access() == access))
      found = worker.get();
  return found;
}

bool MariaDBPool::any_connected() const {
  return std::any_of(workers_.begin(), workers_.end(), [](const auto& worker) {
    return worker->connection && (worker->waiting || worker->is_idle());
  });
}

// True where that came to its end at once, well or badly.
bool MariaDBPool::open_one() {
  for (const auto& worker : workers_) {
    if (worker->connection)
      continue;
    worker->connection = std::make_unique<MariaDBConnection>(options_);
    auto& connection = *worker->connection;
    worker->task = set_up_ ? connection.open(MariaDBConnection::To::database)
                           : open_and_set_up(connection, *options_);
    worker->task.start();
    const bool is_done = worker->task.done();
    if (is_done)
      conclude(*worker);
    return is_done;
  }
  return false;
}

void MariaDBPool::start(Worker& worker, Waiting waiting) {
  worker.waiting = std::move(waiting);
  worker.connection->give_time(options_->query_timeout + grace);
  worker.task = carry_out(*worker.connection, worker.waiting->order);
  // A session that begins has its connection from now on.
  if (worker.waiting->order.kind == Kind::begin)
    worker.session = worker.waiting->order.message.session;
  worker.task.start();
  if (worker.task.done())
    conclude(worker);
}

MariaDBPool::Moment MariaDBPool::next_moment() const {
  auto moment = open_at_;
  for (const auto& worker : workers_) {
    if (worker->connection)
      moment = std::min(moment, worker->connection->deadline());
    if (!worker->task)
      moment = std::min(moment, worker->transaction_ends);
  }
  for (const auto& one : waiting_)
    if (one.deadline < moment && !holder(one.order.message.session))
      moment = one.deadline;
  return moment;
}

// Who waits unseen, as all are busy, is seen before its time is up.
Milliseconds MariaDBPool::time_to_sleep() {
  if (!may_sleep())
    return Milliseconds(0);
  auto moment = next_moment();
  if (is_busy())
    moment = std::min(moment, Steady::now() + options_->busy_timeout);
  if (moment == Moment::max())
    return Milliseconds(-1);
  const auto left = std::chrono::ceil<Milliseconds>(moment - Steady::now());
  return std::clamp(left, Milliseconds(0), Milliseconds(60'000));
}

void MariaDBPool::wait_for_events() {
  polled_.assign(1, {wake_, POLLIN, 0});
  for (const auto& worker : workers_)
    polled_.push_back(worker->connection
                          ? pollfd{worker->connection->descriptor(),
                                   worker->connection->interest(), 0}
                          : pollfd{-1, 0, 0});
  poll(polled_.data(), polled_.size(),
       static_cast<int>(time_to_sleep().count()));
  std::uint64_t times = 0;
  if (polled_.front().revents != 0)
    (void)!read(wake_, &times, sizeof times);
  const auto now = Steady::now();
  for (std::size_t i = 0; i < workers_.size(); ++i)
    if (workers_[i]->connection)
      look_after(*workers_[i], polled_[i + 1].revents, now);
}

void MariaDBPool::look_after(Worker& worker, short ready, Moment now) {
  if (worker.task) {
    if (ready == 0 && worker.connection->deadline() > now)
      return;
    worker.connection->go_on(ready);
    if (worker.task.done())
      conclude(worker);
  } else if (ready != 0) {
    take_away(worker); // nobody asked the server anything: it has gone
  } else if (worker.session && worker.transaction_ends <= now) {
    take_away(worker);
    log_("A transaction was open for too long and was rolled back.");
  }
}

void MariaDBPool::expire(Moment now) {
  std::erase_if(waiting_, [&](Waiting& one) {
    if (one.deadline > now || holder(one.order.message.session))
      return false;
    tell(std::move(one), tl::make_unexpected(why_it_waited()));
    return true;
  });
}

Error MariaDBPool::why_it_waited() const {
  if (trouble_ && !any_connected())
    return {trouble_->kind,
            "The database server cannot be reached: " + trouble_->message +
                " It is tried again and again; look whether the server runs "
                "and what the settings say of host, port and socket.",
            trouble_->place};
  if (!any_connected())
    return {ErrorKind::timeout,
            "The database server has not answered yet; it is tried again.",
            {}};
  return {ErrorKind::timeout,
          "All connections to the database are busy; the option 'connections' "
          "says how many there may be.",
          {}};
}

} // namespace parlour::adapters
