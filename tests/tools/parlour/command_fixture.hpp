// CommandTest: calls commands as functions, with the applications beside this
// file.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/parlour/cli/command_line.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

class CommandTest : public testing::Test {
protected:
  CommandTest() : places_(process_places()) {
    places_.working = test::source_path("tests/tools/parlour/applications");
  }

  int call(std::vector<std::string> arguments) {
    out_.str("");
    err_.str("");
    return run_command_line(std::move(arguments), places_, {out_, err_});
  }
  std::string application(const std::string& name) const {
    return (places_.working / name).string();
  }

  Places places_;
  std::ostringstream out_;
  std::ostringstream err_;
};

} // namespace parlour::tools
