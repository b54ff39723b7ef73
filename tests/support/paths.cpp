#include "tests/support/paths.hpp"

namespace parlour::test {

std::string source_path(const std::string& name) {
  return std::string(PARLOUR_SOURCE_DIR) + "/" + name;
}

std::string program_path() {
  return PARLOUR_PROGRAM;
}

} // namespace parlour::test
