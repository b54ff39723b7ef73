#include <gtest/gtest.h>

#include "adapters/mqtt/discovery/entity.hpp"

namespace parlour::adapters::mqtt {
namespace {

TEST(Entity, KnowsItsWords) {
  Entity lamp;
  lamp.words = {{"ON", "on"}, {"OFF", "off"}};
  EXPECT_EQ(meaning_of(lamp, "ON"), Value("on"));
  EXPECT_EQ(meaning_of(lamp, "on"), std::nullopt);
  EXPECT_EQ(meaning_of(lamp, "None"), Value());
}

TEST(Entity, HasANumberOrAText) {
  Entity sensor;
  sensor.meaning = Meaning::number;
  EXPECT_EQ(meaning_of(sensor, "21.5"), Value(21.5));
  EXPECT_EQ(meaning_of(sensor, "-3"), Value(-3));
  EXPECT_EQ(meaning_of(sensor, "cloudy"), Value("cloudy"));
}

TEST(Entity, IsOpenUnlessItIsClosed) {
  Entity blind;
  blind.meaning = Meaning::position;
  EXPECT_EQ(meaning_of(blind, "0"), Value("closed"));
  EXPECT_EQ(meaning_of(blind, "40"), Value("open"));
  EXPECT_EQ(meaning_of(blind, "half"), std::nullopt);
  blind.closed = 255;
  blind.open = 0;
  EXPECT_EQ(meaning_of(blind, "255"), Value("closed"));
  EXPECT_EQ(meaning_of(blind, "0"), Value("open"));
}

} // namespace
} // namespace parlour::adapters::mqtt
