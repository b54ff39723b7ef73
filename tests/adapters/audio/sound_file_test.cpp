#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "adapters/audio/sound_file.hpp"
#include "tests/adapters/audio/tones.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

class SoundFileTest : public testing::Test {
protected:
  static std::vector<Sample> read_all(const std::filesystem::path& path) {
    auto reader = SoundFileReader::open(path);
    EXPECT_TRUE(reader) << path;
    std::vector<Sample> all;
    std::vector<Sample> piece(1'000);
    while (const auto count = reader->read(piece)) {
      const auto read = std::span(piece).first(count);
      all.insert(all.end(), read.begin(), read.end());
    }
    return all;
  }
  std::string refusal(const std::filesystem::path& path) {
    const auto reader = SoundFileReader::open(path);
    return reader ? "" : to_string(reader.error());
  }

  test::TemporaryFolder folder;
};

TEST_F(SoundFileTest, WhatIsWrittenIsRead) {
  const auto tone = test::tone(440, 1, 9'999);
  for (const auto* name : {"a.wav", "a.flac", "noending"}) {
    const auto path = folder.path() / name;
    {
      auto writer = SoundFileWriter::create(path, {16'000, 1});
      ASSERT_TRUE(writer) << name;
      ASSERT_TRUE(writer->write(tone));
    }
    EXPECT_EQ(SoundFileReader::open(path)->format(), PcmFormat{}) << name;
    EXPECT_EQ(read_all(path), tone) << name;
  }
  EXPECT_THAT(folder.read("a.flac"), testing::StartsWith("fLaC"));
  EXPECT_THAT(folder.read("a.wav"), testing::StartsWith("RIFF"));
}

TEST_F(SoundFileTest, WavCanBeReadWhileItIsWritten) {
  const auto path = folder.path() / "a.wav";
  auto writer = SoundFileWriter::create(path, {8'000, 2});
  ASSERT_TRUE(writer);
  const std::vector<Sample> samples = {1, 2, 3, 4};
  ASSERT_TRUE(writer->write(samples));
  EXPECT_EQ(read_all(path), samples);
  EXPECT_EQ(SoundFileReader::open(path)->format(), (PcmFormat{8'000, 2}));
}

TEST_F(SoundFileTest, ComesFromItsBeginningAgain) {
  const auto path = folder.path() / "a.wav";
  ASSERT_TRUE(
      SoundFileWriter::create(path, {})->write(std::vector<Sample>{1, 2, 3}));
  auto reader = SoundFileReader::open(path);
  std::vector<Sample> piece(2);
  EXPECT_EQ(reader->read(piece), 2u);
  reader->rewind();
  EXPECT_EQ(reader->read(piece), 2u);
  EXPECT_EQ(piece, (std::vector<Sample>{1, 2}));
}

TEST_F(SoundFileTest, TwoWritersHaveTwoFiles) {
  const auto path = folder.path() / "a.wav";
  const auto first = SoundFileWriter::create(path, {});
  const auto second = SoundFileWriter::create(path, {});
  ASSERT_TRUE(second);
  EXPECT_EQ(first->path(), path);
  EXPECT_EQ(second->path(), folder.path() / "a-2.wav");
}

TEST_F(SoundFileTest, AFileIsMadeAnew) {
  const auto path = folder.path() / "a.wav";
  ASSERT_TRUE(SoundFileWriter::create(path, {})->write(test::tone(9, 1, 999)));
  ASSERT_TRUE(SoundFileWriter::create(path, {})->write(std::vector<Sample>{5}));
  EXPECT_EQ(read_all(path), std::vector<Sample>{5});
}

TEST_F(SoundFileTest, RefusesWhatIsNoSound) {
  folder.write("text.wav", "hello");
  folder.write("empty.wav", "");
  folder.write("cut.wav", std::string("RIFF\x10\0\0\0WAVEfmt ", 16));
  EXPECT_THAT(refusal(folder.path() / "text.wav"),
              HasSubstr("text.wav: this is no sound that can be read"));
  EXPECT_THAT(refusal(folder.path() / "empty.wav"), HasSubstr("no sound"));
  EXPECT_THAT(refusal(folder.path() / "cut.wav"), HasSubstr("no sound"));
  EXPECT_THAT(refusal(folder.path() / "none.wav"), HasSubstr("none.wav"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("folder"));
  const auto pipe = folder.path() / "pipe.wav";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal(pipe), HasSubstr("pipe"));
}

TEST_F(SoundFileTest, RefusesWhatCannotBeWritten) {
  std::filesystem::create_directory(folder.path() / "taken.wav");
  EXPECT_EQ(
      SoundFileWriter::create(folder.path() / "taken.wav", {}).error().kind,
      ErrorKind::file);
  EXPECT_EQ(
      SoundFileWriter::create(folder.path() / "no/a.wav", {}).error().kind,
      ErrorKind::file);
}

} // namespace
} // namespace parlour::adapters
