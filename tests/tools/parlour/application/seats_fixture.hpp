// SeatsTest: an application with <seat> elements, and components and an agent
// for them.
#pragma once

#include <string>

#include "tests/tools/parlour/application_fixture.hpp"

namespace parlour::tools {

class SeatsTest : public ApplicationTest {
protected:
  Application with(const std::string& seats) {
    return load("<Plugins><Plugin>LogTaxi</Plugin><Plugin>LogRobot</Plugin>"
                "<Plugin>LogTelephone</Plugin></Plugins>"
                "<component name=\"Second\" plugin=\"LogTaxi\"/>"
                "<agents><agent name=\"Olivia\" stand-in=\"LogRobot\"/>"
                "</agents>" +
                    seats,
                "<state name=\"Welcome\"/>");
  }
  std::string errors(const std::string& seats) {
    return findings(with(seats));
  }
};

} // namespace parlour::tools
