// What whoever polls asks of a connection.
#include <algorithm>
#include <utility>

#include <mysql.h>
#include <poll.h>

#include "adapters/database/mariadb/mariadb_connection.hpp"

namespace parlour::adapters {

void MariaDBConnection::give_time(Milliseconds time) {
  deadline_ = std::chrono::steady_clock::now() + time;
}

int MariaDBConnection::descriptor() const {
  return static_cast<int>(mysql_get_socket(handle_));
}

short MariaDBConnection::interest() const {
  if (!waiting_)
    return POLLIN; // the server says good-bye
  return static_cast<short>(((wanted_ & MYSQL_WAIT_READ) != 0 ? POLLIN : 0) |
                            ((wanted_ & MYSQL_WAIT_WRITE) != 0 ? POLLOUT : 0) |
                            ((wanted_ & MYSQL_WAIT_EXCEPT) != 0 ? POLLPRI : 0));
}

MariaDBConnection::Moment MariaDBConnection::deadline() const {
  return waiting_ ? deadline_ : Moment::max();
}

void MariaDBConnection::go_on(short ready) {
  int flags = 0;
  if ((ready & (POLLIN | POLLHUP | POLLERR)) != 0)
    flags |= wanted_ & (MYSQL_WAIT_READ | MYSQL_WAIT_EXCEPT);
  if ((ready & (POLLOUT | POLLHUP | POLLERR)) != 0)
    flags |= wanted_ & MYSQL_WAIT_WRITE;
  // Its time is up, or the socket itself is wrong.
  wanted_ = pending_->proceed(flags != 0 ? flags : MYSQL_WAIT_TIMEOUT);
  if (wanted_ == 0)
    std::exchange(waiting_, {}).resume();
}

StatementOutcome carry_out(MariaDBConnection& connection,
                           MariaDBConnection::Outcome task) {
  for (task.start(); !task.done();) {
    const auto left = std::chrono::ceil<Milliseconds>(
        connection.deadline() - std::chrono::steady_clock::now());
    pollfd polled{connection.descriptor(), connection.interest(), 0};
    poll(&polled, 1,
         static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 60'000)));
    if (polled.revents != 0 || left <= Milliseconds::zero())
      connection.go_on(polled.revents);
  }
  return task.result();
}

} // namespace parlour::adapters
