#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/text_run.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;

class OneRead : public ByteSource {
public:
  explicit OneRead(Read first) : first_(std::move(first)) {}
  Read read(std::optional<Milliseconds>) override {
    return std::exchange(first_, Read{});
  }

private:
  Read first_;
};

class NotingPartner : public Partner {
public:
  explicit NotingPartner(bool is_virtual) : virtual_(is_virtual) {}
  void enter(const std::vector<std::string>& turns) override {
    calls.push_back("enter " + std::to_string(turns.size()));
  }
  void run_until_quiet() override {
    calls.emplace_back("quiet");
  }
  void step_to_next_due() override {
    calls.emplace_back("step");
  }
  bool is_virtual() const override {
    return virtual_;
  }
  std::vector<std::string> calls;

private:
  bool virtual_;
};

std::vector<std::string> calls_for(Read read, bool is_virtual, bool ended) {
  OneRead source(std::move(read));
  RowReader rows(source, [](const std::string&) {});
  NotingPartner partner(is_virtual);
  EXPECT_EQ(talk_by_rows(partner, rows), ended);
  return partner.calls;
}

TEST(TalkByRows, lets_virtual_time_stand_still_but_for_empty_lines) {
  EXPECT_THAT(calls_for({Read::Kind::bytes, "a\nb\n\n\nc"}, true, true),
              ElementsAre("enter 2", "quiet", "quiet", "step", "enter 1",
                          "quiet", "quiet"));
}

TEST(TalkByRows, goes_on_reading_in_real_time) {
  EXPECT_THAT(calls_for({Read::Kind::bytes, "a\n"}, false, true),
              ElementsAre("enter 1", "quiet"));
}

TEST(TalkByRows, reads_on_after_a_part_when_all_is_quiet) {
  std::string many;
  for (std::size_t i = 0; i < longest_row; ++i)
    many += "y\n";
  EXPECT_THAT(calls_for({Read::Kind::bytes, many + "z\n"}, false, true),
              ElementsAre("enter 1000", "quiet", "enter 1", "quiet"));
}

TEST(TalkByRows, ends_when_interrupted) {
  EXPECT_THAT(calls_for({Read::Kind::interrupted, {}}, false, false),
              ElementsAre());
}

} // namespace
} // namespace parlour::tools
