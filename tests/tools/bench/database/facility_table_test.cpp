#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/database/facility_table.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST(FacilityTable, is_asked_for_all_of_its_names) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < facilities; ++i)
    names.insert(facility_name(i));
  EXPECT_EQ(names.size(), std::size_t{facilities});
  const auto seed = facility_seed();
  for (const auto& name : names)
    EXPECT_THAT(seed, HasSubstr("'" + name + "'"));
}

} // namespace
} // namespace parlour::tools
