// Any bytes as what the program of MoonshineASR says, in one piece and byte by
// byte: both must be understood alike. To write a text as people type it makes
// it no longer.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/asr/moonshine_frames.hpp"
#include "adapters/asr/moonshine_text.hpp"

namespace {

using namespace parlour::adapters::moonshine;

void read_all(AnswerReader& reader, std::vector<std::string>& texts) {
  for (;;) {
    const auto answer = reader.next();
    if (!answer || !*answer)
      return;
    texts.push_back((*answer)->text);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  AnswerReader at_once;
  at_once.add(bytes);
  std::vector<std::string> texts;
  read_all(at_once, texts);

  AnswerReader in_pieces;
  std::vector<std::string> same;
  for (std::size_t at = 0; at < size; ++at) {
    in_pieces.add(bytes.substr(at, 1));
    const auto answer = in_pieces.next();
    if (!answer)
      break;
    if (*answer)
      same.push_back((*answer)->text);
  }
  if (texts != same)
    std::abort();
  for (const auto& text : texts)
    if (typed_text(text).size() > text.size())
      std::abort();
  if (typed_text(bytes).size() > size)
    std::abort();
  return 0;
}
