// Uses poll and the library's non-blocking calls directly, without coroutines,
// threads or conversions of values: the least that any program has to do.
#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include <mysql.h>
#include <poll.h>

#include "tools/bench/database/facility_table.hpp"
#include "tools/bench/database/raw_queries.hpp"

namespace parlour::tools {

namespace {

// One connection with one prepared statement and fixed buffers, driven by poll.
class RawConnection {
public:
  RawConnection() : handle_(mysql_init(nullptr)) {
    mysql_options(handle_, MYSQL_OPT_NONBLOCK, nullptr);
  }
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;
  ~RawConnection() {
    if (statement_)
      mysql_stmt_close(statement_);
    mysql_close(handle_);
  }

  Expected<void> open(const std::string& socket);
  int descriptor() const {
    return static_cast<int>(mysql_get_socket(handle_));
  }
  short interest() const {
    return static_cast<short>((waits_ & MYSQL_WAIT_READ ? POLLIN : 0) |
                              (waits_ & MYSQL_WAIT_WRITE ? POLLOUT : 0));
  }

  // Sends query number `i`. True if the answer has arrived already.
  bool ask(std::size_t i) {
    name_ = facility_name(i);
    length_ = name_.size();
    std::memcpy(key_.data(), name_.data(), length_);
    phase_ = Phase::executes;
    waits_ = mysql_stmt_execute_start(&failed_, statement_);
    return go_on(0);
  }
  // Continues with the events of poll. True if the answer has arrived.
  bool go_on(int ready);

  bool failed() const {
    return failed_ != 0;
  }
  std::size_t letters() const {
    return lengths_[description_column];
  }

private:
  // A query has two calls that may wait: executing it, and storing its result.
  enum class Phase { executes, stores };

  // Parameters and results are bound once, to fixed buffers.
  void bind();

  MYSQL* handle_;
  MYSQL_STMT* statement_ = nullptr;
  std::string name_;
  std::array<char, 64> key_{};
  unsigned long length_ = 0;
  std::array<std::array<char, 128>, facility_columns> cells_{};
  std::array<unsigned long, facility_columns> lengths_{};
  Phase phase_ = Phase::executes;
  int waits_ = 0;
  int failed_ = 0;
};

Expected<void> RawConnection::open(const std::string& socket) {
  if (!mysql_real_connect(handle_, nullptr, "root", "", "bench", 0,
                          socket.c_str(), 0))
    return fail(ErrorKind::offline, mysql_error(handle_));
  statement_ = mysql_stmt_init(handle_);
  if (mysql_stmt_prepare(statement_, facility_query,
                         std::strlen(facility_query)) != 0)
    return fail(ErrorKind::database, mysql_stmt_error(statement_));
  bind();
  return {};
}

void RawConnection::bind() {
  MYSQL_BIND key{};
  key.buffer_type = MYSQL_TYPE_STRING;
  key.buffer = key_.data();
  key.buffer_length = key_.size();
  key.length = &length_;
  mysql_stmt_bind_param(statement_, &key);
  std::array<MYSQL_BIND, facility_columns> cells{};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].buffer_type = MYSQL_TYPE_STRING;
    cells[i].buffer = cells_[i].data();
    cells[i].buffer_length = cells_[i].size();
    cells[i].length = &lengths_[i];
  }
  mysql_stmt_bind_result(statement_, cells.data());
}

// Continues the current call and, when it is done, starts the next one.
bool RawConnection::go_on(int ready) {
  for (;;) {
    // The call waits for an event that has not come.
    if (waits_ != 0 && ready == 0)
      return false;
    if (waits_ != 0)
      waits_ = phase_ == Phase::executes
                   ? mysql_stmt_execute_cont(&failed_, statement_, ready)
                   : mysql_stmt_store_result_cont(&failed_, statement_, ready);
    ready = 0;
    if (waits_ != 0)
      return false;
    if (failed_ != 0 || phase_ == Phase::stores)
      break;
    phase_ = Phase::stores;
    waits_ = mysql_stmt_store_result_start(&failed_, statement_);
  }
  if (failed_ == 0)
    failed_ = mysql_stmt_fetch(statement_);
  mysql_stmt_free_result(statement_);
  return true;
}

using Connections = std::vector<std::unique_ptr<RawConnection>>;

// Events of poll as flags of the library.
int flags_of(short events) {
  return (events & POLLIN ? MYSQL_WAIT_READ : 0) |
         (events & POLLOUT ? MYSQL_WAIT_WRITE : 0);
}

// Keeps one query under way on each connection until all have been asked.
class RawRun {
public:
  RawRun(Connections& all, std::size_t count) : all_(all), count_(count) {}

  // Returns the number of letters received, or an error if a query failed.
  Expected<std::size_t> run() {
    for (auto& connection : all_)
      ask(*connection);
    std::vector<pollfd> polled(all_.size());
    // One round: wait for any connection, take its answer, ask the next query
    // on it.
    while (on_their_way_ > 0 && !failed_) {
      for (std::size_t i = 0; i < all_.size(); ++i)
        polled[i] = {all_[i]->descriptor(), all_[i]->interest(), 0};
      poll(polled.data(), polled.size(), -1);
      for (std::size_t i = 0; i < all_.size(); ++i)
        if (polled[i].revents != 0 &&
            all_[i]->go_on(flags_of(polled[i].revents))) {
          --on_their_way_;
          take(*all_[i]);
          ask(*all_[i]);
        }
    }
    if (failed_)
      return fail(ErrorKind::database, "a query failed");
    return letters_;
  }

private:
  void take(const RawConnection& connection) {
    failed_ = failed_ || connection.failed();
    letters_ += connection.letters();
  }
  void ask(RawConnection& connection) {
    while (asked_ < count_ && !failed_) {
      if (!connection.ask(asked_++)) {
        ++on_their_way_;
        return;
      }
      take(connection);
    }
  }

  Connections& all_;
  std::size_t count_;
  std::size_t asked_ = 0;
  std::size_t on_their_way_ = 0;
  std::size_t letters_ = 0;
  bool failed_ = false;
};

} // namespace

Expected<Measured> raw_mariadb(const MariaDBServer& server,
                               std::size_t connections, std::size_t count) {
  Connections all;
  // Connecting is not measured.
  for (std::size_t i = 0; i < connections; ++i) {
    all.push_back(std::make_unique<RawConnection>());
    if (auto opened = all.back()->open(server.socket()); !opened)
      return tl::make_unexpected(opened.error());
  }
  const StopWatch watch(server.process());
  const auto letters = RawRun(all, count).run();
  if (!letters)
    return tl::make_unexpected(letters.error());
  return watch.stop(count, std::to_string(*letters));
}

} // namespace parlour::tools
