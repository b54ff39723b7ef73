#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/vad/probability_detector.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<SpeechEdge> edges(const std::vector<double>& likely) {
  ProbabilityDetector detector(200);
  std::vector<SpeechEdge> found;
  std::int64_t position = 1'000;
  for (const auto one : likely) {
    if (const auto edge = detector.take(one, position))
      found.push_back(*edge);
    position += ProbabilityDetector::piece;
  }
  if (const auto edge = detector.finish())
    found.push_back(*edge);
  return found;
}

TEST(ProbabilityDetectorTest, SpeechBeginsAndEnds) {
  EXPECT_THAT(edges({0, 0, 0.9, 0.9, 0.6, 0.4, 0, 0, 0, 0, 0, 0, 0, 0}),
              ElementsAre(SpeechEdge{true, 1'064}, SpeechEdge{false, 1'192}));
}

TEST(ProbabilityDetectorTest, GoesOnOverAShortPause) {
  EXPECT_THAT(edges({1, 1, 1, 0, 0, 0, 0, 0, 1, 0, 0}),
              ElementsAre(SpeechEdge{true, 1'000}, SpeechEdge{false, 1'288}));
}

TEST(ProbabilityDetectorTest, AKnockIsNone) {
  EXPECT_THAT(edges({0, 1, 1, 0, 0.4, 0.4, 0.4, 0, 1, 1, 0}), IsEmpty());
}

} // namespace
} // namespace parlour::adapters
