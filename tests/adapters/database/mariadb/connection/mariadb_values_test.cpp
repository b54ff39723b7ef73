#include "adapters/database/mariadb/connection/mariadb_values.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using MariaDBValuesTest = MariaDBTest;

TEST(ValuesInOrder, ComeByPositionOrName) {
  EXPECT_EQ(values_in_order(List{1, "a"}, {"", ""}), (List{1, "a"}));
  EXPECT_EQ(values_in_order(Map{{"b", 2}, {"a", 1}}, {"a", "b", "a"}),
            (List{1, 2, 1}));
  EXPECT_EQ(values_in_order({}, {}), List{});
}

TEST(ValuesInOrder, SayWhatDoesNotFit) {
  const auto message = [](const Value& values,
                          const std::vector<std::string>& names) {
    const auto ordered = values_in_order(values, names);
    return ordered ? "none" : ordered.error().message;
  };
  EXPECT_EQ(message(List{1}, {}),
            "it has 0 placeholders, but 1 value is given.");
  EXPECT_EQ(message(Map{{"a", 1}}, {"b"}),
            "no value is given for placeholder :b.");
  EXPECT_EQ(message(Map{{"a", 1}, {"b", 1}}, {"b"}),
            "more values are given than it has placeholders.");
  EXPECT_EQ(message(List{Map{}}, {""}), "placeholder number 1 takes a text, "
                                        "number or boolean, not a map.");
  EXPECT_EQ(message(5, {}), "its values are a list or a map, not a integer.");
}

TEST_F(MariaDBValuesTest, AreWhatAScriptFindsInSQLite) {
  ASSERT_TRUE(start(options()));
  EXPECT_EQ(query("select cast('2026-11-21' as date), "
                  "cast('2026-11-21 10:30:00' as datetime), "
                  "cast('10:30:00' as time), 12.50, cast(7 as decimal(9,0)), "
                  "cast(18446744073709551615 as unsigned), "
                  "-9223372036854775807, 1e300, cast('[1]' as char)"),
            "Result([2026-11-21, 2026-11-21 10:30:00, 10:30:00, 12.5, 7, " +
                to_string(Value(18446744073709551615.0)) +
                ", -9223372036854775807, " + to_string(Value(1e300)) +
                ", [1]])");
}

TEST_F(MariaDBValuesTest, ComeBackAsTheyWere) {
  ASSERT_TRUE(start(options()));
  write("create table t (a bigint, b double, c varchar(20), d blob, "
        "e boolean, f text)");
  const Binary bytes{"application/octet-stream",
                     {std::byte{0}, std::byte{255}}};
  EXPECT_EQ(write("insert into t values (?, ?, ?, ?, ?, ?)",
                  List{-5, 0.1, "it's", bytes, true, Value()}),
            "Result([], 1)");
  send("s1", "Query", {"select * from t"});
  ASSERT_EQ(host.events.size(), 1u);
  const auto* rows = host.events[0].params[0].if_result();
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->cells, (List{-5, 0.1, "it's", bytes, 1, Value()}));
}

} // namespace
} // namespace parlour::adapters
