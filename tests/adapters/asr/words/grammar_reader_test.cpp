#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/grammar_reader.hpp"
#include "adapters/asr/words/sentences.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::IsSubsetOf;
using testing::UnorderedElementsAre;

// All sentences that are drawn from the public rules.
std::set<std::string> sentences_of(const std::string& text) {
  UnderstandingModel model;
  Symbols symbols;
  Spellings spellings;
  ValueSets sets(model, nullptr, symbols, spellings);
  GrammarReader reader(symbols, sets, spellings);
  std::vector<Error> errors;
  GraphBuilder builder;
  reader.add(nlu::jsgf::parse({"test", text, {}}, errors), builder);
  std::set<std::string> made;
  for (const auto& sentence : draw_sentences(builder.finish(), 2'000, 1)) {
    std::string words;
    for (const auto symbol : sentence)
      words += (words.empty() ? "" : " ") + symbols.text(symbol);
    made.insert(words);
  }
  return made;
}

TEST(GrammarReaderTest, ReadsRules) {
  EXPECT_THAT(
      sentences_of("public <ask> = [please] (bring | /2/ get) <what>;"
                   "<what> = tea | (lemon tea) {Size=large}; <odd> = odd;"
                   "public <bye> = good bye {act=bye};"),
      IsSubsetOf({"bring tea",
                  "get tea",
                  "please bring tea",
                  "please get tea",
                  "bring lemon tea",
                  "get lemon tea",
                  "please bring lemon tea",
                  "please get lemon tea",
                  "bring a lemon tea",
                  "get a lemon tea",
                  "please bring a lemon tea",
                  "please get a lemon tea",
                  "bring an lemon tea",
                  "get an lemon tea",
                  "please bring an lemon tea",
                  "please get an lemon tea",
                  "bring the lemon tea",
                  "get the lemon tea",
                  "please bring the lemon tea",
                  "please get the lemon tea",
                  "bring any lemon tea",
                  "get any lemon tea",
                  "please bring any lemon tea",
                  "please get any lemon tea",
                  "bring some lemon tea",
                  "get some lemon tea",
                  "please bring some lemon tea",
                  "please get some lemon tea",
                  "good bye"}));
  EXPECT_THAT(sentences_of("public <all> = a* b+ <NULL>;"),
              Contains("a a b b"));
  EXPECT_THAT(sentences_of("public <time> = ten \"o'clock\";"),
              UnorderedElementsAre("ten o'clock"));
}

TEST(GrammarReaderTest, KeepsValuesAsSets) {
  EXPECT_THAT(sentences_of("public <call> = call @words {Taxi.Person};"
                           "public <at> = at @time;"),
              UnorderedElementsAre("call words:Person", "at time"));
}

TEST(GrammarReaderTest, LeavesOutWhatCannotBe) {
  EXPECT_THAT(sentences_of("public <a> = a <a>; public <b> = b <none>;"
                           "public <c> = <VOID> c;"),
              IsEmpty());
}

} // namespace
} // namespace parlour::adapters::asr
