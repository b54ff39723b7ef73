#include <gmock/gmock.h>

#include "adapters/nlu/values/known_columns.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;

TEST(KnownColumns, are_read_once) {
  int reads = 0;
  const ColumnReader reader = [&](const std::string& name) {
    ++reads;
    return Expected<std::vector<std::string>>({name});
  };
  KnownColumns known;
  EXPECT_THAT(known.read("db:a.b", reader).value(), ElementsAre("db:a.b"));
  EXPECT_THAT(known.read("db:a.b", reader).value(), ElementsAre("db:a.b"));
  EXPECT_EQ(reads, 1);
}

TEST(KnownColumns, are_asked_for_again_after_a_failure) {
  KnownColumns known;
  const ColumnReader fails = [](const std::string&) {
    return fail(ErrorKind::database, "gone");
  };
  EXPECT_FALSE(known.read("db:a.b", fails));
  EXPECT_FALSE(known.read("db:a.b", fails));
  // It can be read now, and somebody tells its values.
  EXPECT_TRUE(known.set("db:a.b", {"x"}));
  EXPECT_THAT(known.read("db:a.b", fails).value(), ElementsAre("x"));
}

TEST(KnownColumns, tell_whether_values_are_new) {
  KnownColumns known;
  const ColumnReader reader = [](const std::string&) {
    return Expected<std::vector<std::string>>({"x"});
  };
  EXPECT_FALSE(known.set("db:a.b", {"y"}));
  (void)known.read("db:a.b", reader);
  EXPECT_FALSE(known.set("db:a.b", {"x"}));
  EXPECT_TRUE(known.set("db:a.b", {"x", 7}));
  EXPECT_THAT(known.read("db:a.b", reader).value(), ElementsAre("x", "7"));
}

} // namespace
} // namespace parlour::adapters::nlu
