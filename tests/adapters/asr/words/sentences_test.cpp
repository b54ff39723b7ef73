#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/sentences.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::IsEmpty;

TEST(SentencesTest, AreThoseOfTheGraph) {
  Symbols symbols;
  const auto call = symbols.word("call");
  const auto name = symbols.value_set("name");
  GraphBuilder builder;
  builder.add_sentence({call, name});
  builder.add_sentence({call});
  GraphBuilder names;
  std::set<Sentence> all{{call}};
  for (int i = 0; i < 30; ++i) {
    const auto word = symbols.word(std::to_string(i));
    names.add_sentence({word});
    all.insert({call, word});
  }
  const auto drawn = draw_sentences(builder.finish(), 500, 1);
  EXPECT_EQ(drawn.size(), 500u);
  const auto filled = fill_sets(drawn, symbols, {{name, names.finish()}}, 1);
  EXPECT_EQ(std::set<Sentence>(filled.begin(), filled.end()), all);
  EXPECT_EQ(draw_sentences(builder.finish(), 500, 1), drawn);
  // What has no values is left out.
  for (const auto& sentence : fill_sets(drawn, symbols, {}, 1))
    EXPECT_EQ(sentence, Sentence{call});
}

TEST(SentencesTest, ForgetNoArc) {
  Symbols symbols;
  GraphBuilder builder;
  std::set<Symbol> words;
  for (int i = 0; i < 1'000; ++i) {
    const auto word = symbols.word(std::to_string(i));
    words.insert(word);
    builder.add_sentence({word, word});
  }
  std::set<Symbol> drawn;
  for (const auto& sentence : cover_arcs(builder.finish(), 1))
    drawn.insert(sentence.begin(), sentence.end());
  EXPECT_EQ(drawn, words);
}

TEST(SentencesTest, EndEvenInLoops) {
  GraphBuilder builder;
  const auto loop = builder.add();
  builder.take(GraphBuilder::start, loop, 0);
  builder.take(loop, loop, 0);
  builder.accept(loop);
  for (const auto& sentence : draw_sentences(builder.finish(), 100, 1))
    EXPECT_LE(sentence.size(), 40u);
  EXPECT_THAT(draw_sentences(GraphBuilder().finish(), 10, 1), IsEmpty());
}

} // namespace
} // namespace parlour::adapters::asr
