#include <condition_variable>
#include <mutex>

#include "adapters/database/mariadb/mariadb_watch.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::Pair;

class MariaDBWatchTest : public MariaDBTest {
protected:
  // What a watch of another program's database tells.
  void watch(const std::string& columns, const std::string& every) {
    const auto all =
        with(with(options_for("house"), "columns", columns), "watch", every);
    ASSERT_TRUE(start(options_for("house")));
    auto read = read_mariadb_options(all, host.application);
    ASSERT_TRUE(read);
    auto made = MariaDBWatch::start(*read, [this](const auto& news) {
      const std::lock_guard lock(mutex_);
      news_.push_back(news);
      told_.notify_all();
    });
    ASSERT_TRUE(made);
    watch_ = std::move(*made);
    watch_->look_now();
  }
  void TearDown() override {
    watch_.reset();
    MariaDBTest::TearDown();
  }
  ValueWatch::News next() {
    std::unique_lock lock(mutex_);
    if (!told_.wait_for(lock, 1min, [&] { return !news_.empty(); }))
      return {};
    auto news = news_.front();
    news_.erase(news_.begin());
    return news;
  }
  bool is_silent() {
    const std::lock_guard lock(mutex_);
    return news_.empty();
  }

private:
  std::mutex mutex_;
  std::condition_variable told_;
  std::vector<ValueWatch::News> news_;
  std::unique_ptr<MariaDBWatch> watch_;
};

TEST(MariaDBWatch, LooksMoreRarelyWhereALookTakesLong) {
  EXPECT_EQ(pause_after_look(2ms, 300ms), 300ms);
  EXPECT_EQ(pause_after_look(400ms, 300ms), 4s);
  EXPECT_EQ(pause_after_look(0ms, 5ms), 5ms);
}

TEST_F(MariaDBWatchTest, NoticesByItselfWhatOthersWrite) {
  watch("db:staff.name", "5ms");
  write("delete from staff where name <> 'Lim'");
  EXPECT_THAT(next().changed,
              ElementsAre(Pair("db:staff.name", ElementsAre("Lim"))));
  EXPECT_TRUE(is_silent());
}

TEST_F(MariaDBWatchTest, SaysThatAColumnCannotBeRead) {
  watch("db:staff.name", "5ms");
  write("drop table staff");
  EXPECT_EQ(next().errors.size(), 1u);
}

} // namespace
} // namespace parlour::adapters
