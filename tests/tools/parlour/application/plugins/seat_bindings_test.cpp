#include "tests/tools/parlour/application/seats_fixture.hpp"
#include "tools/parlour/application/plugins/seat_bindings.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using SeatBindingsTest = SeatsTest;

TEST_F(SeatBindingsTest, what_belongs_to_a_seat_comes_first) {
  const auto application =
      with("<seat name=\"desk\" Taxi=\"Second\" Robot=\"Olivia\"/>");
  EXPECT_EQ(findings(application), "");
  std::vector<std::string> names;
  for (const auto& one : application.composition.components)
    names.push_back(one.name + " " + one.policy.seat);
  EXPECT_THAT(names, ElementsAre("Olivia desk", "Second desk", "LogTaxi ",
                                 "LogRobot ", "LogTelephone "));
  EXPECT_EQ(application.composition.components[0].policy.scope.kind,
            Scope::Kind::seat);
}

TEST_F(SeatBindingsTest, tells_of_a_component_that_does_not_fill_the_role) {
  EXPECT_THAT(errors("<seat name=\"desk\" Taxi=\"LogRobot\"/>"),
              HasSubstr("error: 'LogRobot' does not fill the role Taxi at the "
                        "seat 'desk', but Robot; it is filled by LogTaxi, "
                        "Second"));
  EXPECT_THAT(errors("<seat name=\"desk\" TTS=\"LogRobot\"/>"),
              HasSubstr("no component of the settings fills that role"));
}

} // namespace
} // namespace parlour::tools
