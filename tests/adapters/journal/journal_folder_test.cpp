#include <chrono>
#include <csignal>
#include <future>
#include <thread>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "adapters/journal/journal_folder.hpp"
#include "adapters/journal/journal_format.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using namespace std::chrono_literals;

class JournalFolderTest : public testing::Test {
protected:
  const test::TemporaryFolder temporary;
  const std::filesystem::path folder = temporary.path() / "kept";
  std::mutex mutex;
  std::vector<std::string> told;
  JournalFolder::Options options{[this](const std::string& line) {
                                   std::lock_guard lock(mutex);
                                   told.push_back(line);
                                 },
                                 JournalSync::with_system};

  Expected<std::unique_ptr<JournalFolder>> open() {
    return JournalFolder::open(folder, options);
  }
  // Of each part.
  std::vector<std::vector<std::string>> parts() {
    std::vector<std::vector<std::string>> all;
    const auto found = parts_of(folder).value();
    for (const auto& [number, path] : found) {
      const auto bytes = read_file(path).value();
      auto reader = JournalReader::over(bytes).value();
      auto& records = all.emplace_back();
      while (const auto record = reader.next())
        records.emplace_back(record->value());
      EXPECT_EQ(reader.torn_bytes(), 0u);
    }
    return all;
  }
  std::vector<std::string> records() {
    std::vector<std::string> all;
    for (const auto& part : parts())
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }
};

TEST_F(JournalFolderTest, KeepsRecordsInTheirOrder) {
  const auto journal = open().value();
  journal->append("one");
  journal->append("two");
  journal->flush();
  EXPECT_THAT(records(), ElementsAre("one", "two"));
}

TEST_F(JournalFolderTest, WritesWhatIsLeftWhenItGoes) {
  open().value()->append("one");
  EXPECT_THAT(records(), ElementsAre("one"));
  EXPECT_THAT(told, IsEmpty());
}

TEST_F(JournalFolderTest, EachRunBeginsAPart) {
  open().value()->append("one");
  open().value()->append("two");
  EXPECT_THAT(parts(), ElementsAre(ElementsAre("one"), ElementsAre("two")));
}

TEST_F(JournalFolderTest, ALargePartIsFollowedByAnother) {
  options.part_bytes = 100;
  const auto journal = open().value();
  EXPECT_EQ(journal->append(std::string(80, 'x')).part, 1u);
  journal->flush();
  const auto held = journal->hold();
  EXPECT_EQ(held->number, 2u);
  EXPECT_EQ(journal->append("two").part, 2u);
  journal->flush();
  EXPECT_EQ(journal->append("three").part, 2u);
  journal->flush();
  EXPECT_THAT(parts(), ElementsAre(SizeIs(1), ElementsAre("two", "three")));
}

TEST_F(JournalFolderTest, SaysWhatIsWritten) {
  const auto journal = open().value();
  std::promise<void> second;
  const auto one = journal->append("one").record;
  const auto two = journal->append("two").record;
  EXPECT_GT(two, one);
  journal->when_written(two, [&] { second.set_value(); });
  second.get_future().wait();
  EXPECT_THAT(records(), ElementsAre("one", "two"));
  bool at_once = false;
  journal->when_written(one, [&] { at_once = true; });
  EXPECT_TRUE(at_once);
}

// They are old, and nobody needs them any more.
TEST_F(JournalFolderTest, RemovesOldParts) {
  options.part_bytes = 1;
  options.keep = 0s;
  const auto journal = open().value();
  auto held = journal->hold();
  for (int i = 0; i < 3; ++i) {
    journal->append("x");
    journal->flush();
  }
  EXPECT_EQ(parts().size(), 3u);
  EXPECT_EQ(first_needed(parts_of(folder).value()), 1u);
  held = journal->hold();
  journal->append("y");
  journal->flush();
  EXPECT_THAT(records(), ElementsAre("y"));
  EXPECT_EQ(first_needed(parts_of(folder).value()), 4u);
}

TEST_F(JournalFolderTest, KeepsWhatIsYoung) {
  options.part_bytes = 1;
  const auto journal = open().value();
  for (int i = 0; i < 3; ++i) {
    journal->append("x");
    journal->flush();
  }
  EXPECT_EQ(parts().size(), 3u);
}

// Until they have gone on, the sessions that a run has left stand in its parts.
TEST_F(JournalFolderTest, TheNextRunNeedsWhatTheLastOneDid) {
  options.part_bytes = 1;
  {
    const auto journal = open().value();
    const auto held = journal->hold();
    journal->append("x");
    journal->flush();
    journal->append("x");
    journal->flush();
  }
  options.part_bytes = 1'000;
  open();
  EXPECT_EQ(first_needed(parts_of(folder).value()), 1u);
}

TEST_F(JournalFolderTest, TakesRecordsFromManyThreads) {
  {
    const auto journal = open().value();
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < 4; ++thread)
      threads.emplace_back([&] {
        for (int i = 0; i < 1'000; ++i)
          journal->append(std::string(200, 'x'));
      });
  }
  EXPECT_EQ(records().size(), 4'000u);
}

// Also one that was damaged: nothing is written behind what is wrong.
TEST_F(JournalFolderTest, LeavesOlderPartsAsTheyAre) {
  open().value()->append("one");
  const auto first = part_path(folder, 1);
  auto bytes = read_file(first).value() + "unfinished";
  temporary.write("kept/000001.journal", bytes);
  open().value()->append("two");
  EXPECT_EQ(read_file(first).value(), bytes);
}

TEST_F(JournalFolderTest, RefusesWhatIsNoFolder) {
  temporary.write("kept", "a letter");
  EXPECT_FALSE(open());
  EXPECT_EQ(temporary.read("kept"), "a letter");
  EXPECT_FALSE(JournalFolder::open("/proc/no", {}));
}

TEST_F(JournalFolderTest, IsReadByItsOwnerOnly) {
  const auto journal = open().value();
  EXPECT_EQ(std::filesystem::status(part_path(folder, 1)).permissions(),
            std::filesystem::perms(0600));
}

TEST_F(JournalFolderTest, IsOneRunsAlone) {
  const auto first = open().value();
  EXPECT_THAT(open().error().message, HasSubstr("another run"));
}

// A limit of the file's size stands for a disk that is full.
TEST_F(JournalFolderTest, SaysThatTheDiskIsFullAndGoesOnLater) {
  const auto journal = open().value();
  journal->append("one");
  journal->flush();
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit full{read_file(part_path(folder, 1))->size() + 3,
                    limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  journal->append("two");
  journal->flush();
  {
    std::lock_guard lock(mutex);
    EXPECT_THAT(told, ElementsAre(HasSubstr("cannot be written")));
  }
  EXPECT_THAT(records(), ElementsAre("one"));
  setrlimit(RLIMIT_FSIZE, &limit);
  journal->append("three");
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  while (records().size() < 3 && std::chrono::steady_clock::now() < deadline)
    std::this_thread::yield(); // it tries again each second
  EXPECT_THAT(records(), ElementsAre("one", "two", "three"));
  EXPECT_EQ(journal->lost(), 0u);
}

} // namespace
} // namespace parlour::adapters
