#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/push_to_talk/key_source.hpp"
#include "tests/adapters/push_to_talk/fake_keys.hpp"
#include "tests/tools/parlour/terminal_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class KeySourceTest : public testing::Test {
protected:
  void open(const std::string& name = "space") {
    auto opened = KeySource::open_device(keys.path(), *find_key(name));
    ASSERT_TRUE(opened) << opened.error().message;
    source = std::move(*opened);
  }
  std::vector<KeyMove> moves() {
    std::vector<KeyMove> all;
    is_there = source->read(all);
    return all;
  }

  test::FakeKeys keys;
  std::unique_ptr<KeySource> source;
  bool is_there = true;
};

TEST_F(KeySourceTest, ReadsOneKeyOfADevice) {
  open();
  keys.press();
  keys.repeat();
  keys.press(KEY_A);
  keys.release();
  EXPECT_THAT(moves(), ElementsAre(KeyMove::pressed, KeyMove::released));
  EXPECT_TRUE(is_there);
  EXPECT_THAT(moves(), IsEmpty());
  EXPECT_TRUE(is_there);
}

TEST_F(KeySourceTest, ReadsAnyKey) {
  open("any");
  keys.press(KEY_A);
  keys.release(KEY_A);
  EXPECT_THAT(moves(), ElementsAre(KeyMove::pressed, KeyMove::released));
}

TEST_F(KeySourceTest, PutsEventsTogether) {
  open();
  const auto bytes = test::FakeKeys::key(KEY_SPACE, 1);
  keys.write(bytes.substr(0, 30));
  EXPECT_THAT(moves(), IsEmpty());
  keys.write(bytes.substr(30));
  EXPECT_THAT(moves(), ElementsAre(KeyMove::pressed));
}

TEST_F(KeySourceTest, ReadsMoreThanFitsAtOnce) {
  open();
  std::string bytes;
  for (int i = 0; i < 500; ++i)
    bytes += test::FakeKeys::key(KEY_SPACE, i % 2);
  keys.write(bytes);
  EXPECT_EQ(moves().size(), 500u);
}

TEST_F(KeySourceTest, TakesTheKeyForReleasedWhenEventsWereDropped) {
  open();
  keys.write(test::FakeKeys::event(EV_SYN, SYN_DROPPED, 0));
  EXPECT_THAT(moves(), ElementsAre(KeyMove::released));
}

TEST_F(KeySourceTest, TellsThatTheDeviceIsGone) {
  open();
  keys.press();
  keys.unplug();
  EXPECT_THAT(moves(), ElementsAre(KeyMove::pressed));
  EXPECT_FALSE(is_there);
}

TEST_F(KeySourceTest, SaysWhyItCannot) {
  keys.unplug();
  const auto none = KeySource::open_device(keys.path(), {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, ErrorKind::settings);
  EXPECT_THAT(none.error().message,
              HasSubstr("event3\" cannot be used: there is no such device "
                        "(/proc/bus/input/devices"));
  EXPECT_THAT(
      KeySource::open_terminal("/dev/null", *find_key("space")).error().message,
      HasSubstr("there is no terminal that could tell of a key"));
  EXPECT_THAT(
      KeySource::open_terminal("/dev/tty", *find_key("f5")).error().message,
      HasSubstr("a terminal does not tell of this key"));
}

TEST_F(KeySourceTest, ReadsAKeyOfATerminal) {
  test::PseudoTerminal terminal;
  auto opened = KeySource::open_terminal(terminal.name(), *find_key("enter"));
  ASSERT_TRUE(opened) << opened.error().message;
  source = std::move(*opened);
  terminal.type("a\rb");
  std::vector<KeyMove> all;
  while (all.empty() && is_there)
    is_there = source->read(all);
  EXPECT_THAT(all, ElementsAre(KeyMove::typed));
  EXPECT_TRUE(is_there);
}

TEST_F(KeySourceTest, LeavesTheTerminalAsItWas) {
  test::PseudoTerminal terminal;
  const int same = ::open(terminal.name().c_str(), O_RDONLY | O_NOCTTY);
  termios before{}, meanwhile{}, after{};
  tcgetattr(same, &before);
  {
    auto opened = KeySource::open_terminal(terminal.name(), *find_key("space"));
    ASSERT_TRUE(opened);
    tcgetattr(same, &meanwhile);
  }
  tcgetattr(same, &after);
  close(same);
  EXPECT_EQ(meanwhile.c_lflag & (ICANON | ECHO), 0u);
  EXPECT_NE(meanwhile.c_lflag & ISIG, 0u);
  EXPECT_EQ(before.c_lflag, after.c_lflag);
  EXPECT_EQ(before.c_iflag, after.c_iflag);
}

} // namespace
} // namespace parlour::adapters
