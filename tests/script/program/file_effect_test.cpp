#include <array>

#include <gtest/gtest.h>

#include "script/program/file_effect.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

TEST(FileEffect, BecomesARequest) {
  Heap heap({}, 1000);
  const std::array operands{make_string(heap, "a.txt"), Box::small(12)};
  const auto request =
      file_request(Effect(EffectKind::write_file, operands), 100);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->action, FileAction::write);
  EXPECT_EQ(request->name, "a.txt");
  EXPECT_EQ(request->text, "12");
  EXPECT_EQ(request->max_bytes, 100u);
}

TEST(FileEffect, IsNoOther) {
  EXPECT_FALSE(file_request(Effect(EffectKind::print), 100));
}

} // namespace

} // namespace parlour::script
