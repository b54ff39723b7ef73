#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/bench/support/lua_peer.hpp"

namespace parlour::tools {
namespace {

TEST(LuaPeer, runs_a_file_where_it_is_there) {
  const test::TemporaryFolder folder;
  folder.write("x.lua", "return function() return 1, larger(6, 7) end");
  for (const auto& peer : lua_peers())
    if (peer.is_there()) {
      const auto measured = peer.run(folder.path() / "x.lua");
      ASSERT_TRUE(measured) << peer.title;
      EXPECT_EQ(measured->result, "7");
    }
}

TEST(LuaPeer, that_is_not_there_runs_nothing) {
  const LuaPeer none{"Lua 9", "bench_lua9", "", "liblua9-dev"};
  EXPECT_FALSE(none.is_there());
}

TEST(LuaPeer, each_says_what_brings_it) {
  for (const auto& peer : lua_peers())
    EXPECT_FALSE(peer.package.empty());
}

} // namespace
} // namespace parlour::tools
