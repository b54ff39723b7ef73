#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {
namespace {

TEST(Trace, is_a_line_for_each_kind) {
  EXPECT_EQ(trace_line({InspectionKind::slot, "s", "A.B", "x (accepted)"}),
            "slot        A.B: x (accepted)");
  EXPECT_EQ(trace_line({InspectionKind::output, "s", "", "released:\nHi"}),
            "output      released: Hi");
}

TEST(Trace, shows_a_message_with_its_way) {
  auto message = std::make_shared<Message>();
  message->source = "ASR";
  message->command = "RecognitionResult";
  message->params = {"hi", 1};
  const auto line =
      trace_line({InspectionKind::message, "s", "", "", message, "session"});
  EXPECT_EQ(line, "message     " + to_string(*message) + "  [session]");
}

} // namespace
} // namespace parlour::tools
