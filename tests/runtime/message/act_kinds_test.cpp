#include <gtest/gtest.h>

#include "runtime/message/act_kinds.hpp"

namespace parlour {

TEST(ActKinds, HaveNamesAndAreFoundByThem) {
  EXPECT_EQ(name_of(ActKind::inform), "inform");
  EXPECT_EQ(act_kind("person"), ActKind::person);
  EXPECT_EQ(act_kind("Inform"), std::nullopt);
  EXPECT_EQ(act_kind(""), std::nullopt);
  for (const auto& name : act_names())
    EXPECT_EQ(name_of(act_kind(name).value()), name);
}

} // namespace parlour
