#include <limits>

#include <gtest/gtest.h>

#include "runtime/base/bytes.hpp"

namespace parlour {

namespace {

std::string number_bytes(std::uint64_t value) {
  ByteWriter bytes;
  bytes.number(value);
  return bytes.take();
}

TEST(Bytes, AreReadAsTheyWereWritten) {
  ByteWriter writer;
  writer.byte(200);
  writer.number(300);
  writer.signed_number(-1);
  writer.signed_number(std::numeric_limits<std::int64_t>::min());
  writer.fixed(0x0102030405060708);
  writer.text("日本");
  const auto bytes = writer.take();
  ByteReader reader(bytes);
  EXPECT_EQ(reader.byte(), 200);
  EXPECT_EQ(reader.number(), 300u);
  EXPECT_EQ(reader.signed_number(), -1);
  EXPECT_EQ(reader.signed_number(), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(reader.fixed(), 0x0102030405060708u);
  EXPECT_EQ(reader.text(), "日本");
  EXPECT_TRUE(reader.ok() && reader.at_end());
}

TEST(Bytes, NumbersTakeAsFewAsTheyNeed) {
  EXPECT_EQ(number_bytes(127).size(), 1u);
  EXPECT_EQ(number_bytes(128).size(), 2u);
  EXPECT_EQ(number_bytes(std::numeric_limits<std::uint64_t>::max()).size(),
            10u);
}

TEST(Bytes, ANumberHasOneFormOnly) {
  for (const std::string& bytes :
       {std::string("\x80\x00", 2), std::string(9, '\xff') + '\x02',
        std::string(10, '\xff'), std::string("\x80")}) {
    ByteReader reader(bytes);
    EXPECT_EQ(reader.number(), 0u);
    EXPECT_FALSE(reader.ok());
  }
}

TEST(Bytes, TheFirstFailureIsTold) {
  ByteReader reader("ab");
  reader.byte();
  reader.fixed();
  reader.fail("something else");
  EXPECT_EQ(reader.byte(), 0);
  EXPECT_EQ(reader.error().message, "byte 2: the bytes end too early");
}

TEST(Bytes, CountsAndIndexesAreChecked) {
  ByteReader few("\x05"
                 "abc");
  EXPECT_EQ(few.count("things"), 0u);
  EXPECT_EQ(few.error().message,
            "byte 1: 5 things are told, but only 3 bytes are left");
  ByteReader outside("\x05");
  EXPECT_EQ(outside.below(5, "code"), 0u);
  EXPECT_EQ(outside.error().message,
            "byte 1: code 5 is not there, of 5 in all");
}

TEST(Bytes, TextsAreUtf8AndBlocksAreAnything) {
  const std::string bytes = "\x02\xc3\x28";
  ByteReader text(bytes);
  EXPECT_EQ(text.text(), "");
  EXPECT_FALSE(text.ok());
  ByteReader block(bytes);
  EXPECT_EQ(block.block(), "\xc3\x28");
}

} // namespace

} // namespace parlour
