#include <gtest/gtest.h>

#include "adapters/database/mariadb/connection/statement_cache.hpp"

namespace parlour::adapters {
namespace {

// Statements that no server knows.
class StatementCacheTest : public testing::Test {
protected:
  PreparedStatement& add(const std::string& sql) {
    return cache.add({sql, {}, StatementKind::reads, nullptr});
  }

  StatementCache cache;
};

TEST_F(StatementCacheTest, FindsStatementsByTheirSql) {
  EXPECT_EQ(cache.find("select 1"), nullptr);
  auto& one = add("select 1");
  auto& two = add("select 2");
  EXPECT_EQ(cache.find("select 1"), &one);
  EXPECT_EQ(cache.find("select 2"), &two);
  EXPECT_EQ(cache.size(), 2u);
}

TEST_F(StatementCacheTest, KnowsWhatWasUsedLongestAgo) {
  auto& one = add("select 1");
  auto& two = add("select 2");
  EXPECT_EQ(&cache.oldest(), &one);
  EXPECT_EQ(&cache.newest(), &two);
  cache.find("select 1");
  EXPECT_EQ(&cache.oldest(), &two);
  EXPECT_EQ(&cache.newest(), &one);
}

TEST_F(StatementCacheTest, ForgetsAny) {
  add("select 1");
  add("select 2");
  add("select 3");
  cache.forget(*cache.find("select 2"));
  EXPECT_EQ(cache.find("select 2"), nullptr);
  EXPECT_NE(cache.find("select 1"), nullptr);
  EXPECT_NE(cache.find("select 3"), nullptr);
  EXPECT_EQ(cache.size(), 2u);
}

} // namespace
} // namespace parlour::adapters
