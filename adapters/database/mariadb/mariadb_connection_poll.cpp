// The part of MariaDBConnection that a polling thread uses.
#include <utility>

#include <mysql.h>
#include <poll.h>

#include "adapters/database/mariadb/mariadb_connection.hpp"
#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::adapters {

void MariaDBConnection::give_time(Milliseconds time) {
  deadline_ = std::chrono::steady_clock::now() + time;
}

int MariaDBConnection::descriptor() const {
  return static_cast<int>(mysql_get_socket(handle_));
}

short MariaDBConnection::interest() const {
  if (!waiting_)
    // Only the end of the connection can be received without a task.
    return POLLIN;
  return static_cast<short>(((wanted_ & MYSQL_WAIT_READ) != 0 ? POLLIN : 0) |
                            ((wanted_ & MYSQL_WAIT_WRITE) != 0 ? POLLOUT : 0) |
                            ((wanted_ & MYSQL_WAIT_EXCEPT) != 0 ? POLLPRI : 0));
}

MariaDBConnection::Moment MariaDBConnection::deadline() const {
  return waiting_ ? deadline_ : Moment::max();
}

// Translates poll's events to the library's flags. An error or hang-up of the
// socket counts as whatever was waited for, so that the library meets the error
// itself.
void MariaDBConnection::go_on(short ready) {
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

StatementOutcome carry_out(MariaDBConnection& connection,
                           MariaDBConnection::Outcome task) {
  for (task.start(); !task.done();) {
    pollfd awaited[] = {{connection.descriptor(), connection.interest(), 0}};
    wait_until_ready(awaited, connection.deadline());
    connection.go_on(awaited[0].revents);
  }
  return task.result();
}

} // namespace parlour::adapters
