#include <gtest/gtest.h>

#include "script/file_effect.hpp"

namespace parlour::script {

namespace {

TEST(FileEffect, BecomesARequest) {
  Effect effect;
  effect.kind = EffectKind::write_file;
  effect.operands = {"a.txt", 12};
  const auto request = file_request(effect, 100);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->action, FileAction::write);
  EXPECT_EQ(request->name, "a.txt");
  EXPECT_EQ(request->text, "12");
  EXPECT_EQ(request->most_bytes, 100u);
}

TEST(FileEffect, IsNoOther) {
  Effect effect;
  effect.kind = EffectKind::print;
  EXPECT_FALSE(file_request(effect, 100));
}

} // namespace

} // namespace parlour::script
