#include <gtest/gtest.h>

#include "adapters/database/mariadb/connection/connection_state.hpp"
#include "adapters/database/mariadb/connection/mariadb_errors.hpp"

namespace parlour::adapters {
namespace {

constexpr unsigned deadlock = 1213;       // the server's
constexpr unsigned server_is_gone = 2006; // the library's

TEST(ConnectionStateTest, IsInDoubtUntilTheServerAnswers) {
  ConnectionState state;
  state.sent();
  EXPECT_TRUE(state.in_doubt());
  state.answered();
  EXPECT_FALSE(state.in_doubt());
  state.sent();
  (void)state.failed("select 1", mariadb_no_such_table, "no such table", false);
  EXPECT_FALSE(state.in_doubt());
  EXPECT_FALSE(state.lost());
  state.sent();
  (void)state.failed("select 1", server_is_gone, "gone", false);
  EXPECT_TRUE(state.in_doubt());
  EXPECT_TRUE(state.lost());
}

TEST(ConnectionStateTest, KnowsTheLastError) {
  ConnectionState state;
  EXPECT_EQ(state.code(), 0u);
  const auto said =
      state.failed("select  1", mariadb_no_such_table, "no table", false);
  EXPECT_EQ(said.value().message, "'select 1' failed: no table.");
  EXPECT_EQ(state.code(), mariadb_no_such_table);
  EXPECT_FALSE(state.ended_transaction());
  (void)state.failed("", deadlock, "deadlock", false);
  EXPECT_TRUE(state.ended_transaction());
}

// What was ended at its deadline is a timeout; a server that says no is none.
TEST(ConnectionStateTest, TellsWhatCameTooLate) {
  ConnectionState state;
  EXPECT_NE(state.failed("", mariadb_no_such_table, "no", true).value().kind,
            ErrorKind::timeout);
  const auto late = state.failed("", server_is_gone, "gone", true).value();
  EXPECT_EQ(late.kind, ErrorKind::timeout);
  EXPECT_EQ(late.message, "gone (no answer in time).");
}

} // namespace
} // namespace parlour::adapters
