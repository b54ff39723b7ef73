#include "script/dialogue/acts/acts.hpp"
#include "script/dialogue/saved/reader.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

struct Keys {
  std::map<std::uint64_t, bool> map;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(map);
  }
};

struct Two {
  ActPointer act;
  std::shared_ptr<Keys> keys;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(act, keys);
  }
};

// What stands before the parts.
std::string head() {
  return bytes_of(small_program(), Two())
      .substr(0, bytes_of(small_program(), Two()).size() - 2);
}

template <class Part>
std::string error_of(const std::string& parts) {
  Part part;
  const auto done = read(small_program(), part, head() + parts);
  return done ? "" : done.error().message;
}

TEST(Reader, AnotherVersionIsRefused) {
  auto bytes = bytes_of(small_program(), Keys());
  bytes[0] = 77;
  Keys keys;
  const auto done = read(small_program(), keys, bytes);
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("of version 77"), std::string::npos);
}

TEST(Reader, AnotherProgramIsRefused) {
  auto other = std::make_shared<script::Program>(*small_program());
  other->topics[0].name = "Other";
  other->pool = std::make_shared<script::ConstantPool>();
  Keys keys;
  const auto done = read(other, keys, bytes_of(small_program(), Keys()));
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("another program"), std::string::npos);
}

TEST(Reader, MoreThanThePartsIsRefused) {
  EXPECT_NE(error_of<Keys>(std::string("\0x", 2)).find("more bytes follow"),
            std::string::npos);
}

TEST(Reader, LessThanThePartsIsRefused) {
  EXPECT_NE(error_of<Keys>("").find("too early"), std::string::npos);
}

TEST(Reader, KeysThatDoNotRiseAreRefused) {
  EXPECT_EQ(error_of<Keys>(std::string("\2\5\0\6\1", 5)), "");
  EXPECT_NE(error_of<Keys>(std::string("\2\5\0\5\1", 5)).find("do not rise"),
            std::string::npos);
  EXPECT_NE(error_of<Keys>(std::string("\2\5\0\4\1", 5)).find("do not rise"),
            std::string::npos);
}

TEST(Reader, MoreElementsThanBytesAreRefused) {
  EXPECT_NE(error_of<Keys>("\x7f").find("elements are told"),
            std::string::npos);
}

TEST(Reader, WhatIsSharedMustBeOfThatKind) {
  Two two;
  two.keys = std::make_shared<Keys>();
  auto bytes = bytes_of(small_program(), two);
  EXPECT_EQ(bytes.substr(head().size()), std::string("\0\1\0", 3));
  two.act = std::make_shared<const Act>();
  bytes = bytes_of(small_program(), two);
  bytes = bytes.substr(0, bytes.size() - 2) + '\2'; // the act once more
  EXPECT_NE(error_of<Two>(bytes.substr(head().size())).find("something else"),
            std::string::npos);
}

TEST(Reader, WhatIsSharedMustHaveBeenMet) {
  EXPECT_NE(error_of<Two>("\2").find("shared object 2"), std::string::npos);
}

} // namespace
} // namespace parlour::dialogue
