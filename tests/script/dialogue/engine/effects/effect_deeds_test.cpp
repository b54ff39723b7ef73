#include <array>

#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/effect_deeds.hpp"
#include "script/values/objects.hpp"

namespace parlour::dialogue {
namespace {

using enum script::EffectKind;

TEST(EffectDeeds, AreWhatSomebodyElseNotices) {
  for (const auto kind : {post, request, speak, say, write_file, fire_frames,
                          transit, activate, send_socket, begin})
    EXPECT_TRUE(is_deed(script::Effect(kind)));
  for (const auto kind : {confirm, wait, log, print, read_file, clear, ask})
    EXPECT_FALSE(is_deed(script::Effect(kind)));
}

bool queries(const char* sql) {
  script::Heap heap({}, 1000);
  const std::array operands{script::make_string(heap, sql)};
  return is_deed(script::Effect(querydb, operands));
}

TEST(EffectDeeds, AQueryIsNoneWhereItOnlyLooks) {
  EXPECT_FALSE(queries("select 1"));
  EXPECT_FALSE(queries("\n  SELECT name from staff"));
  EXPECT_TRUE(queries("insert into staff values (1)"));
  EXPECT_TRUE(queries(""));
  EXPECT_TRUE(queries("select name from staff into outfile '/tmp/staff'"));
  EXPECT_TRUE(queries("select name from staff for update"));
  EXPECT_TRUE(queries("with x as (delete from staff returning name) select 1"));
}

} // namespace
} // namespace parlour::dialogue
