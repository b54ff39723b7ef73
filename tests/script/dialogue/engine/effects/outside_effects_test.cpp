// Queries of scripts, and their errors.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/outside_effects.hpp"
#include "tests/script/dialogue/bell.hpp"

namespace parlour::dialogue {
namespace {

TEST(OutsideEffects, QueriesGiveRows) {
  Bell world("<querydb param=\"select name from staff where id = ?\" args='3' "
             "return='r'/><speak param='{r[0]}'/>");
  world.database = [](const QueryRequest& request) -> Expected<ResultSet> {
    EXPECT_EQ(request.values, List{3});
    EXPECT_FALSE(request.write);
    return rows({"name"}, {"Ann"});
  };
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Ann"});
}

Expected<ResultSet> broken(const QueryRequest&) {
  return fail(ErrorKind::database, "no such table");
}

TEST(OutsideEffects, AQuerysErrorCaught) {
  Bell world("<try><querydb param='select 1' return='r'/><catch name='e'>"
             "<speak param='{e.kind}'/></catch></try>");
  world.database = broken;
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Database"});
}

TEST(OutsideEffects, AnErrorThatNobodyCatches) {
  Bell world("<querydb param='select 1' return='r'/>");
  world.database = broken;
  world.ring();
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: no such table}]"});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
  world.ring(); // the session lives
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 2u);
}

} // namespace
} // namespace parlour::dialogue
