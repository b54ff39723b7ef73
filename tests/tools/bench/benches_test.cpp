#include <set>

#include <gtest/gtest.h>

#include "tools/bench/benches.hpp"

namespace parlour::tools {
namespace {

TEST(Benches, have_names_and_rows_of_their_own) {
  std::set<std::string> names;
  for (const auto& bench : benches()) {
    EXPECT_TRUE(names.insert(bench.name).second) << bench.name;
    EXPECT_FALSE(bench.rows.empty()) << bench.name;
    EXPECT_NE(bench.run, nullptr) << bench.name;
  }
}

} // namespace
} // namespace parlour::tools
