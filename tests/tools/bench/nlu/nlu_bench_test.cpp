#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/nlu/nlu_bench.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

NluApplication application() {
  NluApplication made;
  made.model.topics = {{"Taxi", false, {}, {"I need a taxi"}}};
  made.model.grammars = {{"taxi",
                          "public <x> = a cab {topic=Taxi} {act=inform};",
                          {"taxi.jsgf", 1, 1}}};
  made.names = {"Jeffery Ho", "Tan Wei Ming"};
  made.said = {"I need a taxi"};
  return made;
}

TEST(NluBench, has_rows) {
  EXPECT_THAT(nlu_bench_rows(), IsSupersetOf({"clinc", "snips", "desk", "names",
                                              "frames", "application"}));
}

TEST(NluBench, tells_figures_and_bars) {
  std::ostringstream out;
  EXPECT_TRUE(nlu_bench({}, application(), out));
  EXPECT_THAT(out.str(), HasSubstr("clinc        not measured"));
  EXPECT_THAT(out.str(), HasSubstr("bar 97.5: met"));
  EXPECT_THAT(out.str(), HasSubstr("all slots right 100.0 % (bar 90: met)"));
  EXPECT_THAT(out.str(), HasSubstr("1 texts, 100 % understood"));
}

TEST(NluBench, says_what_could_not_be_measured) {
  std::ostringstream out;
  EXPECT_FALSE(nlu_bench({"snips", "/nowhere", false}, application(), out));
  EXPECT_THAT(out.str(), HasSubstr("there is no 2017-06"));
  EXPECT_THAT(out.str(), Not(HasSubstr("names")));
}

} // namespace
} // namespace parlour::tools
