#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/bench/platform/visitors.hpp"
#include "tools/parlour/application/opening.hpp"

namespace parlour::tools {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(Visitors, EachHaveAConversationOfTheirOwn) {
  auto places = process_places();
  places.working = test::source_path("");
  std::ostringstream out;
  auto opened = open_application(places, "receptionist", {out, out});
  ASSERT_TRUE(std::holds_alternative<Application>(opened)) << out.str();
  auto visitors = Visitors::arrive(std::get<Application>(opened));
  ASSERT_TRUE(visitors) << visitors.error().message;
  visitors->open(2);
  EXPECT_EQ(visitors->told(1), "Good morning, how can I help you?\n");
  visitors->say({"Is there a food court?"});
  EXPECT_EQ(visitors->count(), 2u);
  EXPECT_THAT(visitors->told(0), HasSubstr("Food Chain"));
  EXPECT_EQ(visitors->told(0), visitors->told(1));
  EXPECT_EQ(visitors->misled(), 0u);
  visitors->open(1);
  EXPECT_EQ(visitors->misled(), 1u);
}

} // namespace
} // namespace parlour::tools
