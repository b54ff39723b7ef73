#include <gtest/gtest.h>

#include "adapters/database/mariadb/connection/mariadb_errors.hpp"

namespace parlour::adapters {
namespace {

TEST(MariaDBErrors, AreOfKinds) {
  EXPECT_EQ(mariadb_error_kind(1062), ErrorKind::database); // twice the same
  EXPECT_EQ(mariadb_error_kind(1064), ErrorKind::database); // syntax
  EXPECT_EQ(mariadb_error_kind(1205), ErrorKind::timeout);
  EXPECT_EQ(mariadb_error_kind(1213), ErrorKind::database);
  EXPECT_EQ(mariadb_error_kind(1045), ErrorKind::refused);
  EXPECT_EQ(mariadb_error_kind(2020), ErrorKind::limit);
  EXPECT_EQ(mariadb_error_kind(2002), ErrorKind::offline);
  EXPECT_EQ(mariadb_error_kind(2013), ErrorKind::offline);
}

TEST(MariaDBErrors, KnowWhatIsLost) {
  for (unsigned code : {2002u, 2006u, 2013u, 1053u, 1927u, 1040u})
    EXPECT_TRUE(ends_connection(code)) << code;
  for (unsigned code : {1062u, 1205u, 1213u, 2057u, 2032u, 0u})
    EXPECT_FALSE(ends_connection(code)) << code;
  EXPECT_TRUE(says_nothing_of_statement(2013));
  EXPECT_FALSE(says_nothing_of_statement(1053));
  EXPECT_TRUE(ends_transaction(1213));
  EXPECT_FALSE(ends_transaction(1062));
}

} // namespace
} // namespace parlour::adapters
