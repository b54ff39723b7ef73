#include <future>

#include <gtest/gtest.h>

#include "adapters/asr/sphinx/recogniser_pool.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"

namespace parlour::adapters::asr {
namespace {

class RecogniserPoolTest : public testing::Test {
protected:
  void SetUp() override {
    if (!SphinxDecoder::is_built_in())
      GTEST_SKIP() << "built without PocketSphinx";
  }
  static std::unique_ptr<RecogniserPool> make(UnderstandingModel model,
                                              std::size_t most = 2) {
    LanguageSources sources;
    sources.model = std::move(model);
    sources.columns = small_columns;
    auto pool = RecogniserPool::make(std::move(sources), english_model, most);
    EXPECT_TRUE(pool);
    return std::move(*pool);
  }
  static bool knows(const Hearing& hearing, const std::string& word) {
    return hearing.vocabulary()->made->language.words().contains(word);
  }
};

TEST_F(RecogniserPoolTest, MakesAsManyAsItMay) {
  auto pool = make(small_application());
  auto first = pool->take();
  auto second = pool->take();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->vocabulary(), second->vocabulary());
  EXPECT_FALSE(pool->take());
  pool->give_back(std::move(*first));
  EXPECT_TRUE(pool->take());
}

TEST_F(RecogniserPoolTest, IsDeafWithoutWords) {
  auto pool = make({});
  EXPECT_TRUE(pool->is_deaf());
  EXPECT_FALSE(pool->take());
}

TEST_F(RecogniserPoolTest, TakesNewValuesBetweenUtterances) {
  auto pool = make(small_application(), 1);
  EXPECT_FALSE(pool->set_values("db:others.name", {"Deborah"}));
  ASSERT_TRUE(pool->set_values("db:guests.name", {"Deborah"}));
  auto old = pool->take();
  EXPECT_TRUE(knows(*old, "siti"));
  const auto outcome = pool->renew();
  ASSERT_TRUE(*outcome);
  pool->use(std::move(**outcome));
  auto next = pool->take();
  ASSERT_TRUE(next);
  EXPECT_TRUE(knows(*next, "deborah"));
  EXPECT_FALSE(knows(*next, "siti"));
  pool->give_back(std::move(*old));
  EXPECT_FALSE(pool->take());
}

TEST_F(RecogniserPoolTest, WorksOnALoop) {
  auto loop = Loop::start([](const std::string&) {}).value();
  auto pool = make(small_application());
  pool->set_values("db:guests.name", {"Deborah"});
  std::promise<RecogniserPool::Outcome> made;
  pool->renew(*loop, [&](RecogniserPool::Outcome outcome) {
    made.set_value(std::move(outcome));
  });
  const auto outcome = made.get_future().get();
  ASSERT_TRUE(*outcome);
  EXPECT_TRUE(
      (*outcome)->vocabulary->made->language.words().contains("deborah"));
}

} // namespace
} // namespace parlour::adapters::asr
