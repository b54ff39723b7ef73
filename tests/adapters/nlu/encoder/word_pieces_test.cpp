#include <gmock/gmock.h>

#include "adapters/nlu/encoder/word_pieces.hpp"
#include "tests/adapters/nlu/encoder/small_encoder.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Piece {
  std::string_view text;
  float score;
};

WordPieces pieces_of(const std::vector<Piece>& pieces) {
  ByteWriter writer;
  writer.number(pieces.size());
  small::Numbers scores;
  for (const auto& [text, score] : pieces) {
    writer.text(text);
    scores.push_back(score);
  }
  small::write_numbers(writer, scores);
  const auto bytes = writer.take();
  ByteReader reader(bytes);
  auto made = WordPieces::read(reader);
  EXPECT_TRUE(reader.ok() && reader.at_end());
  return made;
}

TEST(WordPieces, TakeTheLikeliestCut) {
  const auto pieces = pieces_of({{"?", 0},
                                 {"\u2581un", -2},
                                 {"do", -2},
                                 {"\u2581u", -1},
                                 {"n", -4},
                                 {"\u2581undo", -5}});
  EXPECT_EQ(pieces.size(), 6U);
  EXPECT_THAT(pieces.cut("undo", 9), ElementsAre(1, 2));
  EXPECT_THAT(pieces.cut("un undo", 9), ElementsAre(1, 1, 2));
}

TEST(WordPieces, CountWhatNobodyKnowsOnce) {
  const auto pieces = pieces_of({{"?", 0}, {"\u2581a", -1}, {"b", -1}});
  EXPECT_THAT(pieces.cut("a\u00e4\u00f6b", 9), ElementsAre(1, 0, 2));
  EXPECT_THAT(pieces.cut("xyz", 9), ElementsAre(0));
}

TEST(WordPieces, LeaveOutWhatIsTooLong) {
  const auto pieces = pieces_of({{"?", 0}, {"\u2581a", -1}});
  EXPECT_THAT(pieces.cut("a a a a", 2), ElementsAre(1, 1));
  EXPECT_THAT(WordPieces().cut("a", 0), IsEmpty());
}

TEST(WordPieces, NeedAScoreForEach) {
  ByteWriter writer;
  writer.number(2);
  writer.text("a");
  writer.text("b");
  small::write_numbers(writer, {1});
  const auto bytes = writer.take();
  ByteReader reader(bytes);
  WordPieces::read(reader);
  EXPECT_FALSE(reader.ok());
}

} // namespace
} // namespace parlour::adapters::nlu
