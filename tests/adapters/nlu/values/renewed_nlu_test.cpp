#include <gmock/gmock.h>

#include "adapters/nlu/values/renewed_nlu.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Names = std::vector<std::string>;

// Understands the names of one column.
class Register : public RenewedNLU<Names> {
public:
  mutable std::vector<Error> errors; // why none can be made
  mutable int made = 0;

protected:
  Expected<void> on_start(const Options&) override {
    return begin([this](const ColumnReader& read)
                     -> tl::expected<Names, std::vector<Error>> {
      ++made;
      auto names = read("db:staff.name");
      if (!errors.empty())
        return tl::make_unexpected(errors);
      return *names;
    });
  }
  std::vector<Value> acts(const Names& names, const std::string& text,
                          const Map& context) const override {
    if (std::ranges::find(names, text) == names.end())
      return {};
    return {text, *context.find("now")};
  }
};

class RenewedNluTest : public testing::Test {
protected:
  RenewedNluTest() {
    host.columns = [](const std::string&) {
      return Expected<std::vector<std::string>>({"Ann"});
    };
    host.time.set(7);
  }
  std::vector<std::string> answers_to(const std::string& text) {
    plugin.receive(parlour::test::message("DoNLU", {text}));
    return host.take_events();
  }
  void tell(List names) {
    plugin.receive(
        parlour::test::message("SetValues", {"db:staff.name", names}));
  }

  parlour::test::FakePluginHost host;
  Register plugin;
};

TEST_F(RenewedNluTest, UnderstandsByTheValuesToldLast) {
  ASSERT_TRUE(plugin.start(host, {}));
  EXPECT_THAT(answers_to("Ann"), ElementsAre("FrameInfo(Ann, 7)"));
  tell({"Ben"});
  EXPECT_THAT(answers_to("Ann"), ElementsAre("NoResult(Ann)"));
  EXPECT_THAT(answers_to("Ben"), ElementsAre("FrameInfo(Ben, 7)"));
  tell({"Ben"});
  EXPECT_EQ(plugin.made, 2);
}

// They are not known, so they are no news when they are told again.
TEST_F(RenewedNluTest, TriesAgainWithValuesThatCouldNotBeUsed) {
  ASSERT_TRUE(plugin.start(host, {}));
  plugin.errors = {{ErrorKind::settings, "not now", {}}};
  tell({"Ben"});
  EXPECT_THAT(host.logs, ElementsAre("The new values of db:staff.name are not "
                                     "used: not now"));
  EXPECT_THAT(answers_to("Ann"), ElementsAre("FrameInfo(Ann, 7)"));
  plugin.errors.clear();
  tell({"Ben"});
  EXPECT_THAT(answers_to("Ben"), ElementsAre("FrameInfo(Ben, 7)"));
}

TEST_F(RenewedNluTest, TellsAllThatIsWrong) {
  plugin.errors = {{ErrorKind::settings, "first", {}},
                   {ErrorKind::settings, "second", {"a.xml", 3, 0}},
                   {ErrorKind::settings, "third", {"a.xml", 4, 5}}};
  EXPECT_EQ(plugin.start(host, {}).error().message,
            "first\na.xml:3: second\na.xml:4:5: third");
  plugin.errors.push_back({ErrorKind::database, "gone", {}});
  EXPECT_EQ(plugin.start(host, {}).error().message, "gone");
}

} // namespace
} // namespace parlour::adapters::nlu
