#include <gmock/gmock.h>

#include "adapters/asr/moonshine_place.hpp"
#include "tests/adapters/asr/fake_moonshine.hpp"

namespace parlour::adapters::moonshine {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const PlaceOrder& order) {
  const auto place = find_place(order);
  return place ? "none" : to_string(place.error());
}

auto names(const std::string& what) {
  return AllOf(HasSubstr(what), HasSubstr("`tools/dependencies ears`"),
               HasSubstr("SphinxASR"));
}

TEST(MoonshinePlace, FindsTheProgramWhereItUsuallyIs) {
  const test::FakeMoonshine fake("behaves");
  const auto place = find_place(
      {{}, {"/no/such/moonshine.mjs", fake.program()}, "sh", "/no:/bin"});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->program, fake.program());
  EXPECT_EQ(place->node, "/bin/sh");
}

TEST(MoonshinePlace, TakesTheNamedOnes) {
  const test::FakeMoonshine fake("behaves");
  EXPECT_TRUE(find_place({fake.program(), {}, "/bin/sh", ""}));
}

TEST(MoonshinePlace, SaysWhatIsMissing) {
  const test::FakeMoonshine fake("behaves");
  EXPECT_THAT(complaint({{}, {"/no/such.mjs"}, "sh", "/bin"}),
              names("moonshine.mjs is missing"));
  EXPECT_THAT(complaint({"/no/such.mjs", {}, "sh", "/bin"}),
              names("/no/such.mjs"));
  EXPECT_THAT(complaint({fake.program(), {}, "node", "/no:"}),
              names("'node' (Node.js 18"));
  EXPECT_THAT(complaint({fake.program(), {}, "/no/node", "/bin"}),
              names("'/no/node'"));
  std::filesystem::remove(fake.program().parent_path() /
                          "node_modules/llama-tokenizer-js");
  EXPECT_THAT(complaint({fake.program(), {}, "sh", "/bin"}),
              names("llama-tokenizer-js is missing"));
}

} // namespace
} // namespace parlour::adapters::moonshine
