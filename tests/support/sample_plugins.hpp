// Where the plug-ins of tests/adapters/plugins/samples are built.
#pragma once

#include <filesystem>

namespace parlour::test {

inline std::filesystem::path sample_plugins() {
  return std::filesystem::path(PARLOUR_PROGRAM).parent_path().parent_path() /
         "plugins";
}

} // namespace parlour::test
