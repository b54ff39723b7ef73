#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>

#include "adapters/files/data_files.hpp"
#include "tests/adapters/files/files_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST_F(FilesTest, WritesReadsAppendsDeletes) {
  EXPECT_EQ(write("a.txt", "one"), "unknown");
  EXPECT_EQ(append("a.txt", ", two"), "unknown");
  EXPECT_EQ(read("a.txt"), "one, two");
  EXPECT_EQ(write("a.txt", "anew"), "unknown");
  EXPECT_EQ(outside.read("data/a.txt"), "anew");
  EXPECT_EQ(remove("a.txt"), "unknown");
  EXPECT_FALSE(outside.has("data/a.txt"));
}

TEST_F(FilesTest, NothingIsAddedToATextAndNothingTaken) {
  write("a.txt", " \r\n\u00e9\n");
  EXPECT_EQ(outside.read("data/a.txt"), " \r\n\u00e9\n");
  write("empty.txt", "");
  EXPECT_EQ(read("empty.txt"), "");
}

TEST_F(FilesTest, MakesFoldersAndTheDataFolderItself) {
  std::filesystem::remove(data());
  EXPECT_EQ(read("a.txt"),
            "error: reading 'a.txt': 'data': No such file or directory");
  EXPECT_EQ(list("*"), "[]");
  EXPECT_EQ(append("log/2026/a.txt", "x"), "unknown");
  EXPECT_EQ(outside.read("data/log/2026/a.txt"), "x");
}

TEST_F(FilesTest, WhatIsMissingIsAnError) {
  EXPECT_THAT(read("a.txt"), HasSubstr("No such file"));
  EXPECT_THAT(read("folder/a.txt"), HasSubstr("No such file"));
  EXPECT_THAT(remove("a.txt"), HasSubstr("No such file"));
}

TEST_F(FilesTest, AFolderIsNoFile) {
  write("folder/a.txt", "x");
  EXPECT_THAT(read("folder"), HasSubstr("folder"));
  EXPECT_THAT(write("folder", "x"), HasSubstr("folder"));
  EXPECT_THAT(append("folder", "x"), HasSubstr("folder"));
  EXPECT_THAT(remove("folder"), HasSubstr("folder"));
  EXPECT_THAT(write("folder/a.txt/b", "x"), HasSubstr("no folder"));
}

TEST_F(FilesTest, WhatIsNotUtf8IsNoText) {
  outside.write("data/latin", "caf\xe9");
  EXPECT_THAT(read("latin"), HasSubstr("UTF-8"));
}

TEST_F(FilesTest, AFileHasSoManyBytesAndNoMore) {
  max_bytes = 4;
  EXPECT_EQ(write("a.txt", "1234"), "unknown");
  EXPECT_THAT(append("a.txt", "5"), HasSubstr("more than 4 bytes"));
  EXPECT_EQ(read("a.txt"), "1234");
  EXPECT_THAT(write("a.txt", "12345"), HasSubstr("more than 4 bytes"));
  outside.write("data/large", "12345");
  EXPECT_THAT(read("large"), HasSubstr("more than 4 bytes"));
}

TEST_F(FilesTest, NoSpellingLeadsOutside) {
  for (const std::string name :
       {"../secret.txt", "..", ".", "", "/", "/etc/passwd",
        "a/../../secret.txt", "./../secret.txt", "a/..", "//etc/passwd",
        "data/../../secret.txt", "..\\secret.txt", ".lock", "a/.hidden",
        "secret.txt/", "a//b"})
    for (auto action : {FileAction::read, FileAction::write, FileAction::append,
                        FileAction::remove, FileAction::list})
      EXPECT_THAT(ask(action, name, "x"), StartsWith("error: the file name"))
          << name;
  EXPECT_THAT(read(std::string("a\0/../../secret.txt", 18)),
              StartsWith("error: "));
  EXPECT_EQ(outside.read("secret.txt"), "secret");
}

TEST_F(FilesTest, NoLinkLeadsOutside) {
  link("../secret.txt", "file");
  link("..", "folder");
  link("/", "root");
  link("../new.txt", "dangling");
  for (const std::string name :
       {"file", "folder/secret.txt", "root/etc/passwd", "dangling"})
    for (auto action : {FileAction::read, FileAction::write, FileAction::append,
                        FileAction::remove})
      EXPECT_THAT(ask(action, name, "x"), HasSubstr("link")) << name;
  EXPECT_EQ(list("*"), "[]");
  EXPECT_EQ(list("*/*"), "[]");
  EXPECT_EQ(outside.read("secret.txt"), "secret");
  EXPECT_FALSE(outside.has("new.txt"));
}

TEST_F(FilesTest, ADataFolderThatIsALinkIsRefused) {
  std::filesystem::remove(data());
  std::filesystem::create_symlink("/", data());
  EXPECT_THAT(read("etc/passwd"), HasSubstr("link"));
  EXPECT_THAT(list("*"), HasSubstr("link"));
}

TEST_F(FilesTest, AFileOfTwoNamesIsOnlyReplaced) {
  std::filesystem::create_hard_link(outside.path() / "secret.txt",
                                    data() / "hard");
  EXPECT_THAT(read("hard"), HasSubstr("other names"));
  EXPECT_THAT(append("hard", "x"), HasSubstr("other names"));
  EXPECT_EQ(write("hard", "mine"), "unknown");
  EXPECT_EQ(outside.read("secret.txt"), "secret");
}

TEST_F(FilesTest, APipeHoldsNobodyUp) {
  ASSERT_EQ(mkfifo((data() / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(read("pipe"), HasSubstr("regular"));
  EXPECT_THAT(append("pipe", "x"), HasSubstr("regular"));
  EXPECT_THAT(write("pipe", "x"), HasSubstr("regular"));
  EXPECT_EQ(list("*"), "[]");
}

TEST_F(FilesTest, NothingIsLeftBehind) {
  write("a.txt", "x");
  std::filesystem::create_directory(data() / "folder");
  write("folder", "x");
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry :
       std::filesystem::directory_iterator(data()))
    ++entries;
  EXPECT_EQ(entries, 2u);
}

TEST_F(FilesTest, ListsWhatFitsSorted) {
  for (auto name : {"b.txt", "a.txt", "c.csv", "log/z.txt", "log/1.txt",
                    "log/deep/x.txt", "\u00e9.txt"})
    write(name, "x");
  outside.write("data/.hidden.txt", "x");
  outside.write("data/\xff.txt", "x");
  EXPECT_EQ(list("*.txt"), "[a.txt, b.txt, \u00e9.txt]");
  EXPECT_EQ(list("?.txt"), "[a.txt, b.txt, \u00e9.txt]");
  EXPECT_EQ(list("log/*"), "[log/1.txt, log/z.txt]");
  EXPECT_EQ(list("*/*.txt"), "[log/1.txt, log/z.txt]");
  EXPECT_EQ(list("nothing/*"), "[]");
  EXPECT_EQ(list("c.csv"), "[c.csv]");
  max_bytes = 8;
  EXPECT_THAT(list("*"), HasSubstr("too many"));
}

TEST_F(FilesTest, OfSeveralWritersOneWins) {
  std::vector<std::thread> writers;
  std::atomic<int> mixed = 0;
  write("a.txt", std::string(50'000, 'a'));
  for (char letter = 'a'; letter < 'e'; ++letter)
    writers.emplace_back([&, letter] {
      for (int i = 0; i < 10; ++i) {
        files({FileAction::write, "a.txt", std::string(50'000, letter),
               max_bytes});
        const auto text = files({FileAction::read, "a.txt", "", max_bytes});
        mixed += text->text() != std::string(50'000, text->text()[0]);
        files({FileAction::append, "log", "12345\n", max_bytes});
      }
    });
  for (auto& writer : writers)
    writer.join();
  EXPECT_EQ(mixed, 0);
  std::string lines;
  for (int i = 0; i < 40; ++i)
    lines += "12345\n";
  EXPECT_EQ(read("log"), lines);
}

// Whoever exchanges a folder for a link meanwhile gains nothing.
TEST_F(FilesTest, ARaceLeadsNowhere) {
  std::filesystem::create_directory(outside.path() / "other");
  outside.write("other/a.txt", "outside");
  write("folder/a.txt", "inside");
  std::atomic<bool> over = false;
  std::thread swapper([&] {
    const auto folder = data() / "folder";
    const auto aside = data() / "aside";
    while (!over) {
      std::error_code ignored;
      std::filesystem::rename(folder, aside, ignored);
      std::filesystem::create_symlink("../other", folder, ignored);
      std::filesystem::remove(folder, ignored);
      std::filesystem::rename(aside, folder, ignored);
    }
  });
  for (int i = 0; i < 500; ++i) {
    EXPECT_NE(read("folder/a.txt"), "outside");
    append("folder/a.txt", "x");
  }
  over = true;
  swapper.join();
  EXPECT_EQ(outside.read("other/a.txt"), "outside");
}

} // namespace
} // namespace parlour::adapters
