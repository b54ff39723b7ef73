#include <algorithm>

#include <gtest/gtest.h>

#include "script/support/fifo.hpp"

namespace parlour::dialogue {
namespace {

std::vector<int> all(Fifo<int>& fifo) {
  std::vector<int> items;
  while (!fifo.empty())
    items.push_back(fifo.take());
  return items;
}

TEST(Fifo, WhatComesFirstGoesFirst) {
  Fifo<int> fifo;
  EXPECT_TRUE(fifo.empty());
  for (int i = 0; i < 100; ++i)
    fifo.push_back(i);
  for (int i = 0; i < 60; ++i)
    EXPECT_EQ(fifo.take(), i);
  fifo.push_back(100);
  EXPECT_EQ(fifo.size(), 41u);
  EXPECT_EQ(fifo.front(), 60);
  EXPECT_EQ(all(fifo).back(), 100);
}

TEST(Fifo, SomeGoInFront) {
  Fifo<int> fifo;
  fifo.push_front(2);
  fifo.push_back(3);
  fifo.push_back(4);
  EXPECT_EQ(fifo.take(), 2);
  fifo.push_front(1);
  fifo.push_front(0);
  EXPECT_EQ(all(fifo), (std::vector<int>{0, 1, 3, 4}));
}

TEST(Fifo, OneFromTheMiddle) {
  Fifo<int> fifo;
  for (int i = 0; i < 4; ++i)
    fifo.push_back(i);
  fifo.take();
  EXPECT_EQ(fifo.take(std::find(fifo.begin(), fifo.end(), 2)), 2);
  EXPECT_EQ(all(fifo), (std::vector<int>{1, 3}));
  fifo.push_back(5);
  fifo.clear();
  EXPECT_TRUE(fifo.empty());
}

} // namespace
} // namespace parlour::dialogue
