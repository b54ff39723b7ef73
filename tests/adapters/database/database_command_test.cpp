#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/database_command.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

TEST(DatabaseCommand, IsReadFromTheMessage) {
  EXPECT_EQ(command_of(test::message("Connect")), DatabaseCommand::connect);
  EXPECT_EQ(command_of(test::message("Query", {"select 1"})),
            DatabaseCommand::query);
  EXPECT_EQ(command_of(test::message("Rollback")), DatabaseCommand::rollback);
}

TEST(DatabaseCommand, IsRefusedOtherwise) {
  const auto unknown = command_of(test::message("Truncate"));
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, ErrorKind::refused);
  EXPECT_THAT(unknown.error().message, HasSubstr("'Truncate'"));
  EXPECT_EQ(command_of(test::message("Query", {5})).error().kind,
            ErrorKind::type);
}

TEST(ResultParams, CountTheChangesOfAWrite) {
  EXPECT_EQ(result_params(test::message("Query", {"x", {}, true}), {{}, 3}),
            (std::vector<Value>{ResultSet{}, 3}));
  EXPECT_EQ(result_params(test::message("Query", {"x"}), {{}, 3}),
            std::vector<Value>{ResultSet{}});
  EXPECT_EQ(result_params(test::message("Commit"), {}),
            std::vector<Value>{ResultSet{}});
}

} // namespace
} // namespace parlour::adapters
