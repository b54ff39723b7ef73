#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include "runtime/message/typed_turn.hpp"
#include "tools/parlour/status/tail_hub.hpp"

namespace parlour::tools {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

// Whoever reads, and the other end for the hub.
class Follower {
public:
  Follower() {
    int both[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, both) == 0) {
      mine_ = Descriptor(both[0]);
      its = Descriptor(both[1]);
    }
  }
  std::string line() {
    std::string text;
    char byte = 0;
    while (recv(mine_.get(), &byte, 1, 0) == 1 && byte != '\n')
      text += byte;
    return text;
  }
  void leave() {
    mine_ = Descriptor();
  }
  Descriptor its;

private:
  Descriptor mine_;
};

Inspection log_of(const std::string& session, const std::string& text) {
  return {InspectionKind::log, session, "info", text};
}

TEST(TailHub, SendsLinesToWhoWantsThem) {
  TailHub hub;
  Follower all;
  Follower some;
  hub.see(log_of("s1", "before anybody follows"), 0);
  hub.add(std::move(all.its), {});
  hub.add(std::move(some.its), {.session = "s2"});
  hub.see(log_of("s1", "one"), 0);
  hub.see(log_of("s2", "two"), 0);
  EXPECT_THAT(all.line(), EndsWith("info: one"));
  EXPECT_THAT(all.line(), EndsWith("info: two"));
  EXPECT_THAT(some.line(), EndsWith("info: two"));
  hub.close();
  EXPECT_EQ(all.line(), "");
}

TEST(TailHub, TellsWhenSomebodyFollowsAndWhenNobodyDoes) {
  std::promise<void> is_over;
  std::vector<bool> told;
  TailHub hub;
  hub.connect([&](bool wanted) {
    told.push_back(wanted);
    if (!wanted)
      is_over.set_value();
  });
  Follower first;
  Follower second;
  hub.add(std::move(first.its), {});
  hub.add(std::move(second.its), {});
  first.leave();
  second.leave();
  is_over.get_future().get();
  EXPECT_THAT(told, testing::ElementsAre(true, false));
}

TEST(TailHub, AMessageHasTheTurnOfItsSession) {
  TailHub hub;
  Follower reader;
  hub.add(std::move(reader.its), {});
  const auto heard = [](Message message) {
    Inspection seen;
    seen.kind = InspectionKind::message;
    seen.session = message.session = "s1";
    seen.message = std::make_shared<const Message>(std::move(message));
    return seen;
  };
  hub.see(heard({}), 0);
  hub.see(heard(typed_turn("hello", 7)), 0);
  hub.see(heard({}), 0);
  hub.see(log_of("s2", ""), 0);
  EXPECT_THAT(reader.line(), HasSubstr("  s1  -  message"));
  EXPECT_THAT(reader.line(), HasSubstr("  s1  7  message"));
  EXPECT_THAT(reader.line(), HasSubstr("  s1  7  message"));
  EXPECT_THAT(reader.line(), HasSubstr("  s2  -  log"));
}

// See never waits, or this test would not end.
TEST(TailHub, WhoReadsSlowlyLosesLinesAndIsTold) {
  TailHub hub;
  Follower slow;
  hub.add(std::move(slow.its), {});
  const std::string text(1'000, 'x');
  constexpr std::uint64_t many = 20'000;
  for (std::uint64_t i = 0; i < many; ++i)
    hub.see(log_of("s1", text), 0);
  std::uint64_t read = 0;
  std::uint64_t lost = 0;
  while (read + lost < many) {
    const auto line = slow.line();
    ASSERT_NE(line, "");
    if (line.starts_with("-- "))
      lost += std::stoull(line.substr(3));
    else
      ++read;
  }
  EXPECT_GT(lost, 0u);
  EXPECT_EQ(read + lost, many);
}

TEST(TailHub, SoManyFollowAndNoMore) {
  TailHub hub;
  std::vector<Follower> readers(TailHub::max_readers);
  for (auto& reader : readers)
    hub.add(std::move(reader.its), {});
  Follower one_more;
  hub.add(std::move(one_more.its), {});
  EXPECT_THAT(one_more.line(), HasSubstr("too many"));
  EXPECT_EQ(one_more.line(), "");
}

} // namespace
} // namespace parlour::tools
