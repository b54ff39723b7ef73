#include <gtest/gtest.h>

#include "adapters/database/statement.hpp"

namespace parlour::adapters {
namespace {

TEST(FirstWords, AreShort) {
  EXPECT_EQ(first_words("  select\n\t1 "), "'select 1'");
  EXPECT_EQ(first_words("select staff_name, designation, telephone from "
                        "rr_staff where staff_name = ?"),
            "'select staff_name, designation, telephone from …'");
  EXPECT_EQ(first_words(std::string(100, 'x')),
            "'" + std::string(48, 'x') + " …'");
}

TEST(StatementErrors, AreOfTheirKind) {
  EXPECT_EQ(only_reads("drop table t").value().kind, ErrorKind::refused);
  EXPECT_EQ(not_alone("select 1; select 2").value().message,
            "'select 1; select 2': one statement at a time; something follows "
            "its ';'.");
  EXPECT_EQ(no_statement().value().kind, ErrorKind::database);
  EXPECT_EQ(too_much("select 1", 5, 6).value().message,
            "'select 1' returns more than 5 rows or 6 bytes; narrow it with "
            "'where' or 'limit'.");
}

} // namespace
} // namespace parlour::adapters
