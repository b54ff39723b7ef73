#include <gtest/gtest.h>

#include "runtime/message/message.hpp"

namespace parlour {
namespace {

Message sent(std::vector<Value> params, std::vector<std::string> sinks = {}) {
  Message message;
  message.source = "ASR";
  message.command = "RecognitionResult";
  message.params = std::move(params);
  message.sinks = std::move(sinks);
  return message;
}

TEST(Message, ShowsItsWay) {
  EXPECT_EQ(to_string(sent({})), "ASR.RecognitionResult()");
  EXPECT_EQ(to_string(sent({"10:30am", 0.9}, {"NLU"})),
            "ASR.RecognitionResult(10:30am, 0.9) -> NLU");
  EXPECT_EQ(to_string(sent({Value()}, {"NLU", "Log"})),
            "ASR.RecognitionResult(unknown) -> NLU, Log");
}

TEST(Message, ShowsEveryParameterWhateverItsText) {
  EXPECT_EQ(to_string(sent({"", "x"})), "ASR.RecognitionResult(, x)");
  EXPECT_EQ(to_string(sent({"a(", "b"})), "ASR.RecognitionResult(a(, b)");
}

TEST(Message, IsEqualByContent) {
  auto first = sent({Value(List{1})});
  auto second = sent({Value(List{1})});
  EXPECT_EQ(first, second);
  second.correlation = 3;
  EXPECT_NE(first, second);
  EXPECT_NE(first, sent({Value(List{2})}));
}

} // namespace
} // namespace parlour
