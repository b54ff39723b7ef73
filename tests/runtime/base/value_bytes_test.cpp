#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "runtime/base/value_bytes.hpp"

namespace parlour {

namespace {

ResultSet rows() {
  ResultSet result;
  result.columns = {"name", "level"};
  result.cells = {Value("Kiosk"), Value(2), Value(), Value(0.5)};
  return result;
}

List every_kind() {
  Binary sound;
  sound.format = "pcm";
  sound.bytes = {std::byte{0}, std::byte{255}};
  return {Value(),       Value(true),
          Value(false),  Value(0),
          Value(-1),     Value(std::numeric_limits<std::int64_t>::min()),
          Value(0.1),    Value(-0.0),
          Value(""),     Value("日本"),
          Value(List{}), Value(List{Value(List{Value(1)})}),
          Value(Map{}),  Value(Map{{"b", Value(1)}, {"a", Value(List{})}}),
          Value(rows()), Value(ResultSet{}),
          Value(sound)};
}

std::string error_of(std::string_view bytes) {
  const auto value = value_from_bytes(bytes);
  return value ? "read " + to_string(*value) : value.error().message;
}

Value nested(int depth) {
  Value value;
  for (int i = 0; i < depth; ++i)
    value = List{std::move(value)};
  return value;
}

TEST(ValueBytes, EveryKindComesBackAsItWas) {
  for (const auto& value : every_kind()) {
    const auto bytes = to_bytes(value);
    const auto read = value_from_bytes(bytes);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->type(), value.type());
    EXPECT_EQ(*read, value) << to_string(value);
    EXPECT_EQ(to_bytes(*read), bytes);
  }
  const auto negative = value_from_bytes(to_bytes(-0.0));
  EXPECT_TRUE(std::signbit(*negative->if_number()));
}

TEST(ValueBytes, AreFew) {
  EXPECT_EQ(to_bytes(Value()).size(), 1u);
  EXPECT_EQ(to_bytes(Value(63)).size(), 2u);
  EXPECT_EQ(to_bytes(Value("word")).size(), 6u);
  EXPECT_EQ(to_bytes(Value(List{Value(1), Value(true)})).size(), 5u);
}

TEST(ValueBytes, EveryPartOfSomeIsRefused) {
  const auto bytes = to_bytes(Value(every_kind()));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(value_from_bytes(std::string_view(bytes).substr(0, size)));
}

TEST(ValueBytes, WhatIsWrongIsTold) {
  EXPECT_EQ(error_of(""), "byte 0: the bytes end too early");
  EXPECT_EQ(error_of("\x0a"), "byte 1: there is no type of value 10");
  EXPECT_EQ(error_of("\x01\x01"), "byte 1: more bytes follow the value");
  EXPECT_EQ(error_of("\x06\x7f"), "byte 2: 127 elements of a list are told, "
                                  "but only 0 bytes are left");
  EXPECT_EQ(error_of("\x05\x01\xff"), "byte 3: a text is not UTF-8");
  EXPECT_EQ(error_of(std::string("\x07\x02\x01k\x00\x01k\x00", 8)),
            "byte 8: a map has the key 'k' twice");
}

TEST(ValueBytes, ANumberIsFinite) {
  EXPECT_EQ(to_bytes(Value(std::nan(""))), to_bytes(Value()));
  const auto bytes = "\x04" + std::string(7, '\xff') + "\x7f";
  EXPECT_EQ(error_of(bytes), "byte 9: a number is not finite");
}

TEST(ValueBytes, DepthIsBounded) {
  EXPECT_TRUE(value_from_bytes(to_bytes(nested(deepest_value))));
  EXPECT_TRUE(value_from_bytes(to_bytes(nested(deepest_value + 5))));
  std::string bytes;
  for (int i = 0; i < 100'000; ++i)
    bytes += "\x06\x01";
  EXPECT_NE(error_of(bytes).find("nested more than 1024 deep"),
            std::string::npos);
}

} // namespace

} // namespace parlour
