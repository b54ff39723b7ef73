#include <thread>

#include <gtest/gtest.h>

#include "runtime/base/metrics.hpp"

namespace parlour {
namespace {

TEST(Metrics, CountersMissNothingOfManyThreads) {
  Counter counter;
  Histogram time;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int turn = 0; turn < 1'000; ++turn) {
        counter.add();
        time.observe(20'000);
      }
    });
  for (auto& thread : threads)
    thread.join();
  EXPECT_EQ(counter.value(), 4'000u);
  EXPECT_EQ(time.counts().count(), 4'000u);
  EXPECT_EQ(time.counts().sum, 80'000'000);
}

TEST(Metrics, BoundsRiseFromTenMicrosecondsToSeventySeconds) {
  const auto& bounds = Histogram::bounds;
  EXPECT_EQ(bounds.front(), 10'000);
  EXPECT_EQ(bounds.back(), 70'000'000'000);
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    EXPECT_LT(bounds[i - 1], bounds[i]);
    EXPECT_LE(bounds[i] * 10, bounds[i - 1] * 17);
  }
}

TEST(Metrics, ATimeBelongsToTheBucketOfItsBound) {
  Histogram time;
  time.observe(0);
  time.observe(10'000);
  time.observe(10'001);
  time.observe(70'000'000'001);
  const auto counts = time.counts();
  EXPECT_EQ(counts.buckets.front(), 2u);
  EXPECT_EQ(counts.buckets[1], 1u);
  EXPECT_EQ(counts.buckets.back(), 1u);
}

TEST(Metrics, QuantilesLieBetweenTheBounds) {
  Histogram time;
  EXPECT_FALSE(time.counts().quantile(0.5));
  for (int i = 0; i < 99; ++i)
    time.observe(1'000'000); // the bucket from 0.7 to 1 ms
  time.observe(3'000'000'000);
  const auto counts = time.counts();
  EXPECT_GT(*counts.quantile(0.5), 0.0007);
  EXPECT_LT(*counts.quantile(0.5), 0.001);
  EXPECT_DOUBLE_EQ(*counts.quantile(0.99), 0.001);
  EXPECT_GT(*counts.quantile(0.999), 2.0);
  time.observe(80'000'000'000);
  EXPECT_DOUBLE_EQ(*time.counts().quantile(1), 70);
}

TEST(Metrics, WhatHasComeSinceIsToldByItself) {
  Histogram time;
  time.observe(20'000);
  const auto before = time.counts();
  time.observe(1'000'000);
  const auto since = time.counts().since(before);
  EXPECT_EQ(since.count(), 1u);
  EXPECT_EQ(since.sum, 1'000'000);
  EXPECT_GT(*since.quantile(0.5), 0.0007);
}

TEST(Metrics, AreFoundByTheirNames) {
  const Metrics all = {metric("a", MetricKind::gauge, "A.", 1),
                       metric("b_seconds", "B.", Histogram())};
  ASSERT_NE(find(all, "a"), nullptr);
  EXPECT_EQ(find(all, "a")->samples.at(0).value, 1);
  EXPECT_EQ(find(all, "b_seconds")->kind, MetricKind::histogram);
  EXPECT_EQ(find(all, "c"), nullptr);
}

} // namespace
} // namespace parlour
