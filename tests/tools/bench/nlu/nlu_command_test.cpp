#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/bench/nlu/nlu_command.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

struct NluCommand : testing::Test {
  NluCommand() : places(process_places()) {}

  bool call() {
    return nlu_command(places, {"application", {}, false}, {out, err});
  }

  Places places;
  std::ostringstream out;
  std::ostringstream err;
};

TEST_F(NluCommand, measures_the_receptionist) {
  places.working = test::source_path("");
  EXPECT_TRUE(call()) << err.str();
  EXPECT_THAT(out.str(), HasSubstr("% understood"));
  EXPECT_THAT(out.str(), Not(HasSubstr("clinc")));
}

TEST_F(NluCommand, says_where_it_looked_for_the_receptionist) {
  places.working = "/";
  places.shares.clear();
  EXPECT_FALSE(call());
  EXPECT_THAT(err.str(), HasSubstr("there is no application 'receptionist'"));
}

} // namespace
} // namespace parlour::tools
