#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "adapters/journal/journal_file.hpp"
#include "adapters/journal/journal_format.hpp"
#include "runtime/base/file_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace std::chrono_literals;

class JournalFileTest : public testing::Test {
protected:
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "x.journal";
  std::mutex mutex;
  std::vector<std::string> told;

  Expected<std::unique_ptr<JournalFile>> open() {
    return JournalFile::open(path, [this](const std::string& line) {
      std::lock_guard lock(mutex);
      told.push_back(line);
    });
  }
  std::vector<std::string> records() {
    const auto bytes = read_file(path).value();
    auto reader = JournalReader::over(bytes).value();
    std::vector<std::string> all;
    while (const auto record = reader.next())
      all.emplace_back(record->value());
    EXPECT_EQ(reader.torn_bytes(), 0u);
    return all;
  }
};

TEST_F(JournalFileTest, KeepsRecordsInTheirOrder) {
  const auto journal = open().value();
  journal->append("one");
  journal->append("two");
  journal->flush();
  EXPECT_THAT(records(), ElementsAre("one", "two"));
}

TEST_F(JournalFileTest, WritesWhatIsLeftWhenItGoes) {
  open().value()->append("one");
  EXPECT_THAT(records(), ElementsAre("one"));
  EXPECT_THAT(told, IsEmpty());
}

TEST_F(JournalFileTest, GoesOnWhereItEnded) {
  open().value()->append("one");
  open().value()->append("two");
  EXPECT_THAT(records(), ElementsAre("one", "two"));
}

TEST_F(JournalFileTest, TakesRecordsFromManyThreads) {
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

TEST_F(JournalFileTest, CutsOffWhatACrashLeftUnfinished) {
  open().value()->append("one");
  {
    std::ofstream(path, std::ios::app | std::ios::binary)
        << framed("unfinished").substr(0, 12);
  }
  open().value()->append("two");
  EXPECT_THAT(told, ElementsAre(HasSubstr("not finished")));
  EXPECT_THAT(records(), ElementsAre("one", "two"));
}

TEST_F(JournalFileTest, RefusesADamagedOne) {
  open().value()->append("one");
  auto bytes = read_file(path).value();
  bytes.back() ^= 1;
  folder.write("x.journal", bytes);
  const auto journal = open();
  ASSERT_FALSE(journal);
  EXPECT_THAT(journal.error().message, HasSubstr("damaged"));
  EXPECT_EQ(read_file(path).value(), bytes);
}

TEST_F(JournalFileTest, RefusesWhatIsNoJournal) {
  folder.write("x.journal", "a letter");
  EXPECT_THAT(open().error().message, HasSubstr("no journal"));
  EXPECT_EQ(folder.read("x.journal"), "a letter");
  EXPECT_FALSE(JournalFile::open(folder.path(), {}));
  EXPECT_FALSE(JournalFile::open(folder.path() / "no" / "x", {}));
}

TEST_F(JournalFileTest, IsReadByItsOwnerOnly) {
  folder.write("x.journal", "");
  std::filesystem::permissions(path, std::filesystem::perms(0644));
  const auto journal = open().value();
  EXPECT_EQ(std::filesystem::status(path).permissions(),
            std::filesystem::perms(0600));
}

TEST_F(JournalFileTest, IsOneRunsAlone) {
  const auto first = open().value();
  EXPECT_THAT(open().error().message, HasSubstr("another run"));
}

// A limit of the file's size stands for a disk that is full.
TEST_F(JournalFileTest, SaysThatTheDiskIsFullAndGoesOnLater) {
  const auto journal = open().value();
  journal->append("one");
  journal->flush();
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit full{read_file(path)->size() + 3, limit.rlim_max};
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
