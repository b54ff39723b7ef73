#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/nlu/understand/engine_store.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu {
namespace {

class EngineStoreTest : public testing::Test {
protected:
  NluEngine get(const UnderstandingModel& model) {
    auto got = store_.get(model, options_, columns_);
    EXPECT_TRUE(got);
    return std::move(*got);
  }

  EngineStore store_;
  NluEngine::Options options_;
  ColumnReader columns_ = test::sample_column;
};

UnderstandingModel with_example(const std::string& example) {
  auto model = test::sample_model();
  model.topics[2].examples.push_back(example);
  return model;
}

TEST_F(EngineStoreTest, has_the_one_that_was_built) {
  const auto first = get(test::sample_model());
  EXPECT_EQ(first, get(test::sample_model()));
  EXPECT_FALSE(first.understand("is there a bank").acts.empty());
}

TEST_F(EngineStoreTest, tells_engines_apart_by_all_that_they_are_built_from) {
  const auto first = get(test::sample_model());
  EXPECT_NE(first, get(with_example("drive me home")));
  options_.threshold = 0.6;
  const auto careful = get(test::sample_model());
  EXPECT_NE(first, careful);
  columns_ = [](const std::string&) {
    return Expected<std::vector<std::string>>({"Zelda Quill"});
  };
  const auto other_names = get(test::sample_model());
  EXPECT_NE(careful, other_names);
  EXPECT_FALSE(other_names.understand("to meet Zelda Quill").acts.empty());
}

TEST_F(EngineStoreTest, forgets_what_was_not_wanted_for_longest) {
  const auto first = get(test::sample_model());
  const auto second = get(with_example("drive me home"));
  EXPECT_EQ(first, get(test::sample_model()));
  const auto third = get(with_example("a ride please"));
  EXPECT_EQ(first, get(test::sample_model()));
  EXPECT_NE(second, get(with_example("drive me home")));
  EXPECT_NE(third, get(with_example("a ride please")));
}

TEST_F(EngineStoreTest, tells_errors_each_time) {
  auto model = test::sample_model();
  model.grammars[0].text = "#JSGF V1.0; grammar desk; public <a> = {Nonsense};";
  for (int times = 0; times < 2; ++times)
    EXPECT_FALSE(store_.get(model, options_, columns_));
  columns_ = [](const std::string&) -> Expected<std::vector<std::string>> {
    return fail(ErrorKind::database, "the disk is gone");
  };
  EXPECT_FALSE(store_.get(test::sample_model(), options_, columns_));
}

} // namespace
} // namespace parlour::adapters::nlu
