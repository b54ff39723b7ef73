#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/reference/function_entry.hpp"
#include "tools/parlour/reference/reference.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string told(const std::string& name) {
  const auto text = reference_text(name, {});
  return text ? *text : "error: " + text.error().message;
}

TEST(FunctionEntry, TellsOfAFunction) {
  EXPECT_THAT(told("substring"),
              AllOf(StartsWith("substring(text, start, count?): from a"),
                    HasSubstr("substring('Marina Bay', 7)  ->  Bay")));
}

} // namespace
} // namespace parlour::tools
