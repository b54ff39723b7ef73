// The folder in which the plug-ins of tests/adapters/plugins/samples are built.
#pragma once

#include <filesystem>

#include "tests/support/paths.hpp"

namespace parlour::test {

inline std::filesystem::path sample_plugins() {
  return std::filesystem::path(test::program_path())
             .parent_path()
             .parent_path() /
         "plugins";
}

} // namespace parlour::test
