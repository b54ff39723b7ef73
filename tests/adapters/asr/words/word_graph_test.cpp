#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "adapters/asr/words/word_graph.hpp"

namespace parlour::adapters::asr {
namespace {

class WordGraphTest : public testing::Test {
protected:
  std::vector<Symbol> sentence(std::initializer_list<const char*> words) {
    std::vector<Symbol> made;
    for (const auto* word : words)
      made.push_back(symbols.word(word));
    return made;
  }
  bool takes(const WordGraph& graph, std::initializer_list<const char*> words) {
    std::set<std::uint32_t> at{0};
    for (const auto symbol : sentence(words)) {
      std::set<std::uint32_t> next;
      for (const auto state : at)
        for (const auto& arc : graph.states[state].arcs)
          if (arc.symbol == symbol)
            next.insert(arc.target);
      at = std::move(next);
    }
    return std::ranges::any_of(
        at, [&](const auto state) { return graph.states[state].is_final; });
  }

  Symbols symbols;
  GraphBuilder builder;
};

TEST_F(WordGraphTest, SharesBeginningsAndEnds) {
  builder.add_sentence(sentence({"i", "want", "tea"}));
  builder.add_sentence(sentence({"i", "need", "tea"}));
  builder.add_sentence(sentence({"i", "need", "tea"}));
  const auto graph = builder.finish();
  EXPECT_EQ(graph.states.size(), 4u);
  EXPECT_EQ(graph.arc_count(), 4u);
  EXPECT_TRUE(takes(graph, {"i", "need", "tea"}));
  EXPECT_FALSE(takes(graph, {"i", "need"}));
}

TEST_F(WordGraphTest, FollowsEmptyMovesAndLoops) {
  const auto again = builder.add();
  builder.link(GraphBuilder::start, again);
  const auto end = builder.add();
  builder.take(again, end, symbols.word("very"));
  builder.link(end, again);
  builder.accept(end);
  const auto graph = builder.finish();
  EXPECT_TRUE(takes(graph, {"very", "very", "very"}));
  EXPECT_FALSE(takes(graph, {}));
}

TEST_F(WordGraphTest, ContractsWordsThatFollow) {
  builder.add_sentence(sentence({"i", "am", "here"}));
  builder.contract(symbols.word("i"), symbols.word("am"), symbols.word("i'm"));
  const auto graph = builder.finish();
  EXPECT_TRUE(takes(graph, {"i'm", "here"}));
  EXPECT_TRUE(takes(graph, {"i", "am", "here"}));
}

// Without choices, "a b c" and "c" would need a state for each of the words
// that may have been left out.
TEST_F(WordGraphTest, StaysSmallWhereManyWordsMayBeLeftOut) {
  std::vector<Symbol> words;
  for (int i = 0; i < 20; ++i)
    words.push_back(symbols.word(std::to_string(i)));
  auto at = GraphBuilder::start;
  for (const auto last : {"x", "y"}) {
    const auto next = builder.add();
    for (const auto word : words)
      builder.take(at, next, word);
    builder.link(at, next);
    const auto end = builder.add();
    builder.take(next, end, symbols.word(last));
    at = end;
  }
  builder.accept(at);
  const auto graph = builder.finish();
  EXPECT_EQ(graph.states.size(), 5u);
  EXPECT_EQ(graph.arc_count(), 44u);
  EXPECT_TRUE(takes(graph, {"x", "19", "y"}));
  EXPECT_FALSE(takes(graph, {"x", "19"}));
}

TEST_F(WordGraphTest, LeavesOutWhatNoSentenceGoesThrough) {
  builder.add_sentence(sentence({"a", "b"}));
  const auto nowhere = builder.add();
  builder.take(GraphBuilder::start, nowhere, symbols.word("c"));
  const auto unreached = builder.add();
  builder.take(unreached, nowhere, symbols.word("d"));
  const auto graph = builder.finish();
  EXPECT_EQ(graph.states.size(), 3u);
  EXPECT_EQ(graph.arc_count(), 2u);
}

TEST_F(WordGraphTest, IsEmptyWithoutSentences) {
  const auto graph = builder.finish();
  ASSERT_EQ(graph.states.size(), 1u);
  EXPECT_FALSE(graph.states[0].is_final);
}

TEST_F(WordGraphTest, IsBounded) {
  GraphBuilder small(10);
  for (int i = 0; i < 20; ++i)
    small.add_sentence(sentence({"a", "b", "c"}));
  EXPECT_TRUE(small.is_full());
  EXPECT_LE(small.finish().states.size(), 10u);
}

} // namespace
} // namespace parlour::adapters::asr
