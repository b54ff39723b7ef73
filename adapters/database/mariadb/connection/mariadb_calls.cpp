#include "adapters/database/mariadb/connection/mariadb_calls.hpp"

#include <utility>

#include <mysql.h>
#include <poll.h>

namespace parlour::adapters {

void MariaDBCalls::give_time(Milliseconds time) {
  deadline_ = std::chrono::steady_clock::now() + time;
}

bool MariaDBCalls::is_late() const {
  return std::chrono::steady_clock::now() >= deadline_;
}

short MariaDBCalls::interest() const {
  return static_cast<short>(((wanted_ & MYSQL_WAIT_READ) != 0 ? POLLIN : 0) |
                            ((wanted_ & MYSQL_WAIT_WRITE) != 0 ? POLLOUT : 0) |
                            ((wanted_ & MYSQL_WAIT_EXCEPT) != 0 ? POLLPRI : 0));
}

MariaDBCalls::Moment MariaDBCalls::deadline() const {
  return waiting_ ? deadline_ : Moment::max();
}

// Translates poll's events to the library's flags. An error or hang-up of the
// socket counts as whatever was waited for, so that the library meets the error
// itself.
void MariaDBCalls::go_on(short ready) {
  int flags = 0;
  if ((ready & (POLLIN | POLLHUP | POLLERR)) != 0)
    flags |= wanted_ & (MYSQL_WAIT_READ | MYSQL_WAIT_EXCEPT);
  if ((ready & (POLLOUT | POLLHUP | POLLERR)) != 0)
    flags |= wanted_ & MYSQL_WAIT_WRITE;
  // No flag means that the deadline has passed or the socket has an error that
  // poll cannot name; MYSQL_WAIT_TIMEOUT makes the call end with an error.
  wanted_ = pending_->proceed(flags != 0 ? flags : MYSQL_WAIT_TIMEOUT);
  if (wanted_ == 0)
    std::exchange(waiting_, {}).resume();
}

} // namespace parlour::adapters
