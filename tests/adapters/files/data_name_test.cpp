#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/files/data_name.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string fault_of(std::string_view name) {
  const auto parts = split_name(name);
  return parts ? "" : parts.error().message;
}

TEST(DataName, HasItsParts) {
  EXPECT_THAT(*split_name("a.txt"), ElementsAre("a.txt"));
  EXPECT_THAT(*split_name("a/b c/d…e.f"), ElementsAre("a", "b c", "d…e.f"));
  EXPECT_THAT(*split_name("a..b"), ElementsAre("a..b"));
}

TEST(DataName, SaysWhatIsWrong) {
  EXPECT_THAT(fault_of("/a"), HasSubstr("absolute"));
  EXPECT_THAT(fault_of("a/../b"), HasSubstr("leads out"));
  EXPECT_THAT(fault_of("a//b"), HasSubstr("empty part"));
  EXPECT_THAT(fault_of("a/"), HasSubstr("empty part"));
  EXPECT_THAT(fault_of(""), HasSubstr("empty part"));
  EXPECT_THAT(fault_of(".lock"), HasSubstr("begins with a dot"));
  EXPECT_THAT(fault_of("a\nb"), HasSubstr("control character"));
  EXPECT_THAT(fault_of("a\\b"), HasSubstr("backslash"));
  EXPECT_THAT(fault_of(std::string(256, 'a')), HasSubstr("too long"));
  EXPECT_THAT(fault_of(std::string(1 << 20, '/')), HasSubstr("too long"));
}

TEST(DataName, IsShownInOneShortLine) {
  EXPECT_EQ(shown_name("a\nb"), "'a?b'");
  EXPECT_EQ(shown_name(std::string(79, 'a') + "é"),
            "'" + std::string(79, 'a') + "…'");
}

} // namespace
} // namespace parlour::adapters
