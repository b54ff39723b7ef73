#include "adapters/nlu/encoder/word_pieces.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/encoder/dense.hpp"
#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::string_view blank = "\u2581";

// As the pieces were counted: a blank before each word.
std::string with_blanks(std::string_view text) {
  std::string made(blank);
  for (const char byte : text)
    if (byte == ' ')
      made += blank;
    else
      made += byte;
  return made;
}

// The bytes of the character at the beginning.
std::size_t character_length(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && continues_code_point(text[length]))
    ++length;
  return length;
}

} // namespace

WordPieces WordPieces::read(ByteReader& reader) {
  WordPieces made;
  const auto count = reader.count("pieces");
  for (std::size_t number = 0; number < count && reader.ok(); ++number) {
    const auto text = reader.text();
    made.longest_ = std::max(made.longest_, text.size());
    made.numbers_.try_emplace(std::string(text),
                              static_cast<std::uint32_t>(number));
  }
  made.scores_ = read_numbers(reader, count);
  return made;
}

// For each place in the text, the best way to get there.
std::vector<WordPieces::Step> WordPieces::steps(std::string_view text) const {
  std::vector<Step> best(text.size() + 1);
  best[0].reached = true;
  const auto go = [&](std::size_t begin, std::size_t length, float score,
                      std::uint32_t piece) {
    auto& step = best[begin + length];
    const auto sum = best[begin].score + score;
    if (!step.reached || sum > step.score)
      step = {sum, piece, begin, true};
  };
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    if (!best[begin].reached)
      continue;
    bool fits = false;
    const auto most = std::min(longest_, text.size() - begin);
    for (std::size_t length = 1; length <= most; ++length)
      if (const auto found = numbers_.find(text.substr(begin, length));
          found != numbers_.end()) {
        fits = true;
        go(begin, length, scores_[found->second], found->second);
      }
    if (!fits)
      go(begin, character_length(text.substr(begin)), 0, unknown);
  }
  return best;
}

std::vector<std::uint32_t> WordPieces::cut(std::string_view text,
                                           std::size_t most) const {
  const auto all = with_blanks(text);
  const auto best = steps(all);
  std::vector<std::uint32_t> made;
  for (auto end = all.size(); end > 0; end = best[end].begin)
    if (const auto piece = best[end].piece;
        piece != unknown || made.empty() || made.back() != unknown)
      made.push_back(piece);
  std::ranges::reverse(made);
  made.resize(std::min(made.size(), most));
  return made;
}

} // namespace parlour::adapters::nlu
