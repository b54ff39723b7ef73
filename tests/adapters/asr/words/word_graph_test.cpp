#include <algorithm>

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
    std::uint32_t at = 0;
    for (const auto symbol : sentence(words)) {
      const auto& arcs = graph.states[at].arcs;
      const auto arc = std::ranges::find(arcs, symbol, &WordGraph::Arc::symbol);
      if (arc == arcs.end())
        return false;
      at = arc->target;
    }
    return graph.states[at].is_final;
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
