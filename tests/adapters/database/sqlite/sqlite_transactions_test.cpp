#include <gtest/gtest.h>

#include "adapters/database/sqlite/sqlite_transactions.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

TEST(SQLiteTransactions, HaveOneHolder) {
  SQLiteTransactions transactions;
  EXPECT_FALSE(transactions.held());
  const auto ticket = transactions.hold("");
  EXPECT_TRUE(transactions.held_by(""));
  EXPECT_FALSE(transactions.held_by("a"));
  transactions.release();
  EXPECT_FALSE(transactions.holds(ticket));
  EXPECT_NE(transactions.hold("a"), ticket);
  EXPECT_FALSE(transactions.holds(ticket));
}

TEST(SQLiteTransactions, RememberWhoLostOne) {
  SQLiteTransactions transactions;
  transactions.hold("a");
  transactions.take_away();
  EXPECT_FALSE(transactions.held());
  EXPECT_TRUE(transactions.lost_by("a"));
  transactions.forget_loss("a");
  EXPECT_FALSE(transactions.lost_by("a"));
}

TEST(SQLiteTransactions, ForgetThoseWhoNeverAsk) {
  SQLiteTransactions transactions;
  for (int session = 0; session <= 1'000; ++session) {
    transactions.hold(std::to_string(session));
    transactions.take_away();
  }
  EXPECT_FALSE(transactions.lost_by("0"));
  EXPECT_TRUE(transactions.lost_by("1"));
}

TEST(SQLiteTransactions, LetOthersWaitInOrder) {
  SQLiteTransactions transactions;
  EXPECT_FALSE(transactions.next());
  (void)transactions.wait(test::message("First"));
  const auto second = transactions.wait(test::message("Second"));
  (void)transactions.wait(test::message("Third"));
  EXPECT_EQ(transactions.leave(*second)->command, "Second");
  EXPECT_FALSE(transactions.leave(*second));
  EXPECT_EQ(transactions.next()->message.command, "First");
  EXPECT_EQ(transactions.next()->message.command, "Third");
  EXPECT_FALSE(transactions.next());
}

TEST(SQLiteTransactions, DoNotLetEverybodyWait) {
  SQLiteTransactions transactions;
  int waiting = 0;
  while (waiting < 100'000 && transactions.wait(test::message("Query")))
    ++waiting;
  EXPECT_EQ(waiting, 1'000);
}

} // namespace
} // namespace parlour::adapters
