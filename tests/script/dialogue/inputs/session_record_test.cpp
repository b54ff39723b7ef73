#include <gtest/gtest.h>

#include "script/dialogue/inputs/session_record.hpp"

namespace parlour::dialogue {
namespace {

TEST(SessionRecord, IsReadAsItWasWritten) {
  const auto opened =
      read_record(to_bytes({"K3f9", SessionOpened{7, 8}})).value();
  EXPECT_EQ(opened.session, "K3f9");
  EXPECT_EQ(std::get<SessionOpened>(opened.what).program, 7u);
  EXPECT_EQ(std::get<SessionOpened>(opened.what).seed, 8u);
  const std::string any("\0\xff", 2);
  const auto taken =
      read_record(to_bytes({"K3f9", InputTaken{any, "b"}})).value();
  EXPECT_EQ(std::get<InputTaken>(taken.what).input, any);
  EXPECT_EQ(std::get<InputTaken>(taken.what).answers, "b");
}

TEST(SessionRecord, DamagedBytesAreAnError) {
  const auto bytes = to_bytes({"K3f9", InputTaken{"input", "b"}});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read_record(bytes.substr(0, size)));
  EXPECT_FALSE(read_record(bytes + "x"));
  EXPECT_EQ(read_record(std::string("\1\7\0", 3)).error().kind,
            ErrorKind::file);
  EXPECT_FALSE(read_record(std::string("\2\0\0", 3)));
}

} // namespace
} // namespace parlour::dialogue
