#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/bench/database/mariadb_server.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class MariaDBServerTest : public testing::Test {
protected:
  void SetUp() override {
    if (MariaDBServer::program().empty())
      GTEST_SKIP() << "there is no mariadbd; install mariadb-server-core";
  }

  test::TemporaryFolder folder_;
};

TEST_F(MariaDBServerTest, SaysWhyItDoesNotStart) {
  MariaDBServer server(folder_.path(), {{"--no-such-option"}, false, false});
  const auto started = server.start();
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::offline);
  EXPECT_THAT(started.error().message, HasSubstr("no-such-option"));
}

TEST_F(MariaDBServerTest, StartsAndStopsAsOftenAsItIsTold) {
  MariaDBServer server(folder_.path());
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(server.start());
    ASSERT_TRUE(server.start());
    EXPECT_TRUE(std::filesystem::is_socket(server.socket()));
    server.stop();
  }
  EXPECT_EQ(server.port(), 0u);
}

} // namespace
} // namespace parlour::tools
