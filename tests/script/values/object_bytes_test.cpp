#include <gtest/gtest.h>

#include "script/values/convert.hpp"
#include "script/values/object_bytes.hpp"

namespace parlour::script {

namespace {

class ObjectBytesTest : public testing::Test {
protected:
  static std::string written(const Box& box) {
    ObjectWriter objects;
    ByteWriter root;
    objects.write(root, box);
    ByteWriter whole;
    objects.write_objects(whole);
    whole.add(root);
    return whole.take();
  }
  Box read(const std::string& bytes) {
    ByteReader reader(bytes);
    ObjectReader objects(reader, there, constants);
    objects.read_objects();
    auto box = objects.read();
    error = reader.ok() ? "" : reader.error().message;
    return box;
  }
  void expect_same(const Box& box) {
    const auto before = here.used();
    const auto bytes = written(box);
    const auto again = read(bytes);
    EXPECT_EQ(error, "");
    EXPECT_EQ(to_string(to_value(again)), to_string(to_value(box)));
    EXPECT_EQ(written(again), bytes);
    EXPECT_EQ(there.used(), before);
  }

  ConstantPool constants;
  Heap here{nullptr, 1 << 20};
  Heap there{nullptr, 1 << 20};
  std::string error;
};

TEST_F(ObjectBytesTest, EveryKindComesBackWithWhatItHolds) {
  ResultSet result;
  result.columns = {"a"};
  result.cells = {Value(1)};
  expect_same(Box::number(-0.5));
  expect_same(Box::small(-7));
  expect_same(make_integer(here, std::int64_t{1} << 60));
  expect_same(make_string(here, "日本"));
  expect_same(to_box(here, List{Value(1), Value(List{Value("x")}), Value()}));
  expect_same(make_foreign(here, Value(result)));
}

TEST_F(ObjectBytesTest, AMapKeepsItsOrderAndItsIndex) {
  const auto map = make_map(here);
  for (int i = 40; i > 0; --i)
    map.map()->set(make_string(here, "k" + std::to_string(i)), Box::small(i));
  Box removed;
  map.map()->remove("k7", removed);
  expect_same(map);
  auto again = read(written(map));
  EXPECT_EQ(again.map()->find("k9")->as_small(), 9);
  EXPECT_EQ(again.map()->find("k7"), nullptr);
}

TEST_F(ObjectBytesTest, TheRoomOfAListComesAlong) {
  const auto list = make_list(here, 100);
  list.list()->elements.push_back(Box::small(1));
  expect_same(list);
}

TEST_F(ObjectBytesTest, ConstantsStayConstants) {
  const auto word = constants.string("word");
  const auto large = constants.integer(std::int64_t{1} << 50);
  EXPECT_TRUE(read(written(word)).same_bits(word));
  EXPECT_TRUE(read(written(large)).same_bits(large));
  const auto bytes = written(word);
  const ConstantPool others;
  ByteReader reader(bytes);
  ObjectReader(reader, there, others).read_objects();
  EXPECT_FALSE(reader.ok());
}

TEST_F(ObjectBytesTest, WhatIsNestedDeepNeedsNoStack) {
  auto deep = make_list(here);
  for (int i = 0; i < 10'000; ++i) {
    auto outer = make_list(here, 1);
    outer.list()->elements.push_back(std::move(deep));
    deep = std::move(outer);
  }
  const auto bytes = written(deep);
  EXPECT_EQ(written(read(bytes)), bytes);
}

TEST_F(ObjectBytesTest, WhatIsSharedIsWrittenOnce) {
  auto list = make_list(here);
  const auto text = make_string(here, std::string(1000, 'x'));
  for (int i = 0; i < 10; ++i)
    list.list()->elements.push_back(text);
  EXPECT_LT(written(list).size(), 1100u);
  const auto again = read(written(list));
  EXPECT_TRUE(again.list()->elements[0].same_bits(again.list()->elements[9]));
}

TEST_F(ObjectBytesTest, NoBytesMakeARing) {
  // One list that holds object 0, which is the list itself.
  read(std::string("\x01\x04\x01\x05\x00\x00\x05\x00", 8));
  EXPECT_EQ(error, "byte 5: object 0 is not there, of 0 in all");
}

TEST_F(ObjectBytesTest, AMapHasNoKeyTwice) {
  const std::string key("\x00\x01k", 3);
  const std::string entry("\x00\x00", 2);
  read("\x02" + key + "\x05\x02" + entry + entry + std::string(5, '\0'));
  EXPECT_NE(error.find("a map has a key twice"), std::string::npos) << error;
}

TEST_F(ObjectBytesTest, RoomBeyondTheLimitIsNotTaken) {
  read(std::string("\x01\x04\x00\xff\xff\xff\xff\x7f\x05\x00", 10));
  EXPECT_EQ(error, "");
  EXPECT_LT(there.used(), 1000u);
}

} // namespace

} // namespace parlour::script
