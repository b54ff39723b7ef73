#include <gtest/gtest.h>

#include "script/dialogue/knowledge/sql_text.hpp"

namespace parlour::dialogue {

namespace {

struct Case {
  const char* statement;
  const char* condition;
  const char* order;
  const char* expected;
};

class SqlText : public testing::TestWithParam<Case> {};

TEST_P(SqlText, IsJoined) {
  const auto& [statement, condition, order, expected] = GetParam();
  EXPECT_EQ(with_condition(statement, condition, order), expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, SqlText,
    testing::Values(
        Case{"select * from t", "a = ?", "", "select * from t where a = ?"},
        Case{"select * from t ; ", "", "", "select * from t"},
        Case{"select * from t where b = 1", "a = ?", "",
             "select * from t where b = 1 and (a = ?)"},
        Case{"select * from t where b = 1 or c = 2", "a = ?", "",
             "select * from t where (b = 1 or c = 2) and (a = ?)"},
        Case{"select * from t WHERE (b = 1 or c = 2) LIMIT 3", "a = ?", "",
             "select * from t WHERE (b = 1 or c = 2) and (a = ?) LIMIT 3"},
        Case{"select a, count(*) from t group by a", "a = ?", "",
             "select a, count(*) from t where a = ? group by a"},
        Case{"select * from t order by b limit 5", "a = ?", "c desc",
             "select * from t where a = ? order by b, c desc limit 5"},
        Case{"select * from t limit 5", "", "c",
             "select * from t order by c limit 5"},
        Case{"select * from t", "a = ?", "c",
             "select * from t where a = ? order by c"},
        Case{"select * from (select * from u where x = 1) t", "a = ?", "",
             "select * from (select * from u where x = 1) t where a = ?"},
        Case{"select 'where' w, \"order\" from t", "a = ?", "",
             "select 'where' w, \"order\" from t where a = ?"},
        Case{"select 'it''s where' from t", "a = ?", "",
             "select 'it''s where' from t where a = ?"},
        Case{"select `group` from t /* where */", "a = ?", "",
             "select `group` from t /* where */ where a = ?"},
        Case{"select somewhere from t", "a = ?", "",
             "select somewhere from t where a = ?"},
        Case{"select a from t union select a from u", "a = ?", "",
             "select * from (select a from t union select a from u) as "
             "answer where a = ?"}));

TEST(SqlText, EscapesWhatLikeWouldRead) {
  EXPECT_EQ(escape_like("100%_sure!"), "100!%!_sure!!");
}

} // namespace

} // namespace parlour::dialogue
