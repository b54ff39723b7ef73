#include <map>

#include <gmock/gmock.h>

#include "adapters/database/value_watch.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(ValueWatch, ReadsAColumnWithinItsDatabase) {
  EXPECT_EQ(within_database("db:robot.name"), "db:robot.name");
  EXPECT_EQ(within_database("db:Archive.robot.name"), "db:robot.name");
  EXPECT_EQ(within_database("robot.name"), "db:robot.name");
}

TEST(ValueWatch, TellsOnlyWhatHasChanged) {
  std::map<std::string, ValueWatch::Values> columns{{"db:a.b", {"x"}},
                                                    {"db:c.d", {"y"}}};
  const auto read = [&](const std::string& name) {
    return Expected<ValueWatch::Values>(columns.at(name));
  };
  ValueWatch watch({"db:a.b", "db:c.d"});
  EXPECT_THAT(watch.look(read).changed, IsEmpty());
  EXPECT_THAT(watch.look(read).changed, IsEmpty());
  columns["db:c.d"] = {"y", "z"};
  EXPECT_THAT(watch.look(read).changed,
              ElementsAre(Pair("db:c.d", ElementsAre("y", "z"))));
  EXPECT_THAT(watch.look(read).changed, IsEmpty());
  columns["db:a.b"] = {};
  EXPECT_THAT(watch.look(read).changed, ElementsAre(Pair("db:a.b", IsEmpty())));
}

TEST(ValueWatch, KeepsOldValuesWhereReadingFailsAndSaysSoOnce) {
  Expected<ValueWatch::Values> found = ValueWatch::Values{"x"};
  const auto read = [&](const std::string&) { return found; };
  ValueWatch watch({"db:a.b"});
  watch.look(read);
  found = fail(ErrorKind::database, "gone");
  EXPECT_EQ(watch.look(read).errors.size(), 1u);
  const auto again = watch.look(read);
  EXPECT_THAT(again.errors, IsEmpty());
  EXPECT_THAT(again.changed, IsEmpty());
  found = ValueWatch::Values{"x"};
  EXPECT_THAT(watch.look(read).changed, IsEmpty());
  found = fail(ErrorKind::database, "gone");
  EXPECT_EQ(watch.look(read).errors.size(), 1u);
}

// Who needs the column at the start says that it cannot be read.
TEST(ValueWatch, TellsOfAColumnThatCanBeReadAtLast) {
  Expected<ValueWatch::Values> found = fail(ErrorKind::database, "gone");
  const auto read = [&](const std::string&) { return found; };
  ValueWatch watch({"db:a.b"});
  EXPECT_THAT(watch.look(read).errors, IsEmpty());
  found = ValueWatch::Values{"x"};
  EXPECT_EQ(watch.look(read).changed.size(), 1u);
  EXPECT_THAT(watch.look(read).changed, IsEmpty());
}

TEST(ValueWatch, KnowsItsTables) {
  const ValueWatch watch({"db:Archive.Robot.name"});
  EXPECT_TRUE(watch.concerns({"visit", "ROBOT"}));
  EXPECT_FALSE(watch.concerns({"visit", "name"}));
  EXPECT_TRUE(ValueWatch().is_idle());
}

TEST(ValueWatch, TellsOfValuesInNoSession) {
  const auto message = values_changed("db:a.b", {"x", "y"});
  EXPECT_EQ(to_string(message), ".ValuesChanged(db:a.b, [x, y])");
  EXPECT_TRUE(message.session.empty());
}

} // namespace
} // namespace parlour::adapters
