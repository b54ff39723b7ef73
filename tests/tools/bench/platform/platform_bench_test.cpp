#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/bench/platform/platform_bench.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct PlatformBench : testing::Test {
  PlatformBench() : places(process_places()) {
    places.working = test::source_path("");
  }

  bool call(const std::string& only = "") {
    return platform_bench(places, {20, only}, {out, err});
  }

  Places places;
  std::ostringstream out;
  std::ostringstream err;
};

TEST_F(PlatformBench, TellsItsFigures) {
  EXPECT_TRUE(call()) << out.str() << err.str();
  EXPECT_THAT(out.str(), AllOf(HasSubstr("for each of the first 2,"),
                               HasSubstr("KiB for each of 20 that wait"),
                               HasSubstr("KiB for each of 20 at rest"),
                               HasSubstr("turns a second with 20 open"),
                               HasSubstr("0 were told something else")));
}

TEST_F(PlatformBench, MeasuresOneRow) {
  EXPECT_TRUE(call("turns"));
  EXPECT_THAT(out.str(), Not(HasSubstr("KiB")));
}

TEST_F(PlatformBench, SaysWhereItLookedForTheReceptionist) {
  places.working = "/";
  places.shares.clear();
  EXPECT_FALSE(call());
  EXPECT_THAT(err.str(), HasSubstr("there is no application 'receptionist'"));
}

} // namespace
} // namespace parlour::tools
