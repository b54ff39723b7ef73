#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/sqlite/sqlite_open.hpp"
#include "adapters/database/sqlite/sqlite_values.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

class SQLiteValuesTest : public testing::Test {
protected:
  SQLiteConnection db{open_memory().value(), {}, Milliseconds(0)};

  Value back(Value value) {
    auto answer = db.run("select ?", List{std::move(value)}, Access::read);
    return answer ? answer->rows.cells.at(0) : Value(answer.error().message);
  }
  Error error(const std::string& sql, Value values) {
    auto answer = db.run(sql, values, Access::read);
    return answer ? Error{} : answer.error();
  }
};

TEST_F(SQLiteValuesTest, ComeBackAsTheyWent) {
  for (const auto& value :
       {Value(), Value(std::int64_t{1} << 60), Value(2.5), Value("O'Brien; --"),
        Value(""), Value("Müller 陈"), Value(std::string("a\0b", 3))})
    EXPECT_EQ(back(value), value) << to_string(value);
  EXPECT_EQ(back(true), Value(1));
  EXPECT_EQ(back(false), Value(0));
  const Binary bytes{"application/octet-stream", {std::byte{1}, std::byte{0}}};
  EXPECT_EQ(back(bytes), Value(bytes));
}

TEST_F(SQLiteValuesTest, KeepTheirTypes) {
  EXPECT_TRUE(back("12").if_string());
  EXPECT_TRUE(back(2.0).if_number());
  EXPECT_TRUE(back(12).if_integer());
}

TEST_F(SQLiteValuesTest, AreNoLists) {
  for (const auto& value : {Value(List{1}), Value(Map{}), Value(ResultSet{})}) {
    const auto wrong = error("select ?", List{value});
    EXPECT_EQ(wrong.kind, ErrorKind::type);
    EXPECT_THAT(wrong.message, HasSubstr("placeholder number 1 takes"));
  }
  EXPECT_EQ(error("select 1", "text").kind, ErrorKind::type);
}

TEST_F(SQLiteValuesTest, FitTheirPlaceholders) {
  EXPECT_THAT(error("select ?, ?", List{1}).message,
              HasSubstr("2 placeholders, but 1 value is given"));
  EXPECT_THAT(error("select 1", List{1, 2}).message,
              HasSubstr("0 placeholders, but 2 values are given"));
  EXPECT_EQ(error("select ?", {}).kind, ErrorKind::type);
}

TEST_F(SQLiteValuesTest, GoByName) {
  auto answer =
      db.run("select :a, :b, :a", Map{{"b", 2}, {"a", 1}}, Access::read);
  ASSERT_TRUE(answer);
  EXPECT_EQ(to_string(Value(answer->rows)), "[1, 2, 1]");
  EXPECT_THAT(error("select :a", Map{{"b", 2}}).message,
              HasSubstr("no value is given for placeholder :a"));
  EXPECT_THAT(error("select :a", Map{{"a", 1}, {"b", 2}}).message,
              HasSubstr("more values"));
  EXPECT_EQ(error("select ?", Map{{"a", 1}}).kind, ErrorKind::type);
}

TEST_F(SQLiteValuesTest, AreUTF8) {
  const auto wrong = error("select ?", List{"\xff\xfe"});
  EXPECT_EQ(wrong.kind, ErrorKind::type);
  EXPECT_THAT(wrong.message, HasSubstr("not valid UTF-8"));
  auto answer = db.run("select cast(x'61ff62' as text)", {}, Access::read);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->rows.cells.at(0), Value("a\xef\xbf\xbd"
                                            "b"));
}

TEST_F(SQLiteValuesTest, AreNotTooLong) {
  EXPECT_EQ(error("select ?", List{std::string(17 << 20, 'x')}).kind,
            ErrorKind::limit);
}

} // namespace
} // namespace parlour::adapters
