// ConnectionState is what the errors of a connection say of it: whether it can
// still be used, and whether the last statement was executed. Pure.
#pragma once

#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

class ConnectionState {
public:
  // Whether the connection is unusable.
  bool lost() const {
    return lost_;
  }
  // Whether the connection was lost after the last statement was sent and
  // before the server answered: nobody knows whether the statement was
  // executed.
  bool in_doubt() const {
    return in_doubt_;
  }
  // Whether the last error made the server roll the transaction back.
  bool ended_transaction() const {
    return ended_transaction_;
  }
  // The number of the last error (mariadb_errors.hpp), or 0 if there was none.
  unsigned code() const {
    return code_;
  }

  // From `sent`, when a statement may have been sent, until `answered` it is in
  // doubt.
  void sent() {
    in_doubt_ = true;
  }
  void answered() {
    in_doubt_ = false;
  }
  void lose() {
    lost_ = true;
  }

  // Records an error and puts it into words. `sql` is empty for what no script
  // has said; `is_late` says whether the deadline has passed.
  tl::unexpected<Error> failed(std::string_view sql, unsigned code,
                               const char* reason, bool is_late);

private:
  bool lost_ = false;
  bool in_doubt_ = false;
  bool ended_transaction_ = false;
  unsigned code_ = 0;
};

} // namespace parlour::adapters
