#include <string>

#include <gtest/gtest.h>

#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

TEST(Box, HoldsEveryKindInEightBytes) {
  EXPECT_TRUE(Box().is_unknown());
  EXPECT_TRUE(Box::boolean(true).is_true());
  EXPECT_EQ(Box::small(-5).as_small(), -5);
  EXPECT_EQ(Box::number(-0.5).as_number(), -0.5);
  EXPECT_FALSE(Box::number(-1e300).is_small());
  EXPECT_FALSE(Box::fits(std::int64_t{1} << 47));
}

TEST(Heap, AccountsForWhatIsHeldAndGivesItBack) {
  Heap heap(nullptr, 1 << 20);
  {
    auto list = make_list(heap);
    for (int i = 0; i < 100; ++i)
      list.list()->elements.push_back(make_string(heap, "a string"));
    const Box shared = list;
    EXPECT_GT(heap.used(), 100u * 8);
  }
  EXPECT_EQ(heap.used(), 0u);
}

TEST(Heap, TakesDownALongChainWithoutADeepStack) {
  Heap heap(nullptr, std::size_t{1} << 30);
  Box chain;
  for (int i = 0; i < 200'000; ++i) {
    auto list = make_list(heap);
    list.list()->elements.push_back(std::move(chain));
    chain = std::move(list);
  }
  chain = Box();
  EXPECT_EQ(heap.used(), 0u);
}

TEST(Map, KeepsItsOrderWhenItGrowsAndShrinks) {
  Heap heap(nullptr, 1 << 20);
  auto box = make_map(heap);
  auto& map = *box.map();
  for (int i = 0; i < 50; ++i)
    map.set(make_string(heap, std::to_string(i)), Box::small(i));
  map.set(make_string(heap, "3"), Box::small(33));
  Box removed;
  EXPECT_TRUE(map.remove("0", removed));
  EXPECT_FALSE(map.remove("0", removed));
  EXPECT_EQ(map.find("3")->as_small(), 33);
  EXPECT_EQ(map.entries[2].key.text(), "3");
  EXPECT_EQ(map.find("49")->as_small(), 49);
  EXPECT_EQ(map.find("50"), nullptr);
}

TEST(Map, FindsWhatItFoundLastWhileItIsThere) {
  Heap heap(nullptr, 1 << 20);
  auto box = make_map(heap);
  auto& map = *box.map();
  const auto first = make_string(heap, "a");
  const auto second = make_string(heap, "b");
  map.set(first, Box::small(1));
  map.set(second, Box::small(2));
  EXPECT_EQ(map.find(*second.string())->as_small(), 2);
  EXPECT_EQ(map.find(*second.string())->as_small(), 2);
  EXPECT_EQ(map.find(*first.string())->as_small(), 1);
  Box removed;
  ASSERT_TRUE(map.remove("a", removed));
  EXPECT_EQ(map.find(*first.string()), nullptr);
  EXPECT_EQ(map.find(*second.string())->as_small(), 2);
  ASSERT_TRUE(map.remove("b", removed));
  EXPECT_EQ(map.find(*second.string()), nullptr);
}

TEST(Strings, KnowTheirCodePoints) {
  std::string text;
  for (std::uint32_t i = 0; i < 40; ++i) {
    EXPECT_EQ(count_code_points(text), i) << text;
    constexpr const char* letters[] = {"a", "é", "日", "😀"};
    text += letters[i * i % 7 % 4];
  }
}

TEST(ConstantPool, InternsStrings) {
  ConstantPool pool;
  EXPECT_TRUE(pool.string("a").same_bits(pool.string("a")));
  EXPECT_FALSE(pool.string("a").same_bits(pool.string("b")));
  EXPECT_EQ(pool.integer(INT64_MAX).as_integer(), INT64_MAX);
}

} // namespace

} // namespace parlour::script
