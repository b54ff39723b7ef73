#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/speech/digit_strings.hpp"

namespace parlour::tools {
namespace {

using Files = std::vector<std::filesystem::path>;

Files recordings_of(const std::string& speaker) {
  Files files;
  for (int digit = 0; digit < 10; ++digit)
    for (int index = 0; index < 3; ++index)
      files.emplace_back(std::to_string(digit) + "_" + speaker + "_" +
                         std::to_string(index) + ".wav");
  return files;
}

TEST(DigitStrings, are_made_of_the_speakers_recordings) {
  auto files = recordings_of("anna");
  for (auto& other : recordings_of("hannah"))
    files.push_back(std::move(other));
  const auto strings = digit_strings(files, "anna", 5);
  ASSERT_EQ(strings.size(), 5u);
  for (const auto& string : strings) {
    ASSERT_EQ(string.digits.size(), 8u);
    ASSERT_EQ(string.files.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_THAT(string.files[i].string(),
                  testing::StartsWith(string.digits.substr(i, 1) + "_anna_"));
  }
  EXPECT_EQ(digit_strings(files, "anna", 5)[4].digits, strings[4].digits);
}

TEST(DigitStrings, need_all_digits) {
  auto files = recordings_of("anna");
  EXPECT_TRUE(digit_strings(files, "nobody", 5).empty());
  files.resize(3);
  EXPECT_TRUE(digit_strings(files, "anna", 5).empty());
}

TEST(DigitStrings, are_found_in_a_folder) {
  EXPECT_TRUE(digit_recordings("/no/such/folder").empty());
}

TEST(DigitStrings, tell_what_cannot_be_read) {
  EXPECT_FALSE(sound_of({"1", {"/no/such/1_anna_0.wav"}}));
}

} // namespace
} // namespace parlour::tools
