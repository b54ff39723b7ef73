#include "adapters/asr/words/pronunciations.hpp"

#include <fstream>
#include <sstream>
#include <string_view>

#include "adapters/asr/words/phones.hpp"
#include "adapters/asr/words/program_output.hpp"
#include "adapters/asr/words/spoken_words.hpp"

namespace parlour::adapters::asr {

namespace {

// The word of a dictionary's line, and its phones.
struct Line {
  std::string_view word;
  std::string_view phones;
};

// "hello(2)" is another way to say "hello".
Line split(std::string_view line) {
  const auto end = line.find_first_of(" \t");
  if (end == std::string_view::npos)
    return {};
  auto word = line.substr(0, end);
  if (const auto number = word.find('('); number != std::string_view::npos)
    word = word.substr(0, number);
  auto phones = line.substr(line.find_first_not_of(" \t", end));
  while (!phones.empty() && (phones.back() == '\r' || phones.back() == ' '))
    phones.remove_suffix(1);
  return {word, phones};
}

} // namespace

// The dictionary has more than a hundred thousand words; only the wanted ones
// are kept.
Expected<Pronunciations> dictionary_sounds(const std::filesystem::path& path,
                                           const std::set<std::string>& words) {
  std::ifstream file(path);
  if (!file)
    return fail(ErrorKind::file, "cannot be read", {path.string(), 0, 0});
  Pronunciations found;
  for (std::string text; std::getline(file, text);) {
    const auto line = split(text);
    const std::string word(line.word);
    if (words.contains(word) && are_phones(line.phones))
      found[word].emplace_back(line.phones);
  }
  return found;
}

// A sentence for each word keeps the lines apart.
Pronunciations espeak_sounds(const std::set<std::string>& words) {
  Pronunciations found;
  if (words.empty())
    return found;
  std::string input;
  for (const auto& word : words)
    input += word + ".\n";
  const auto output =
      program_output({"espeak-ng", "-q", "-x", "--sep=_", "-v", "en-us"}, input,
                     std::chrono::seconds(10));
  if (!output)
    return found;
  std::istringstream lines(*output);
  auto word = words.begin();
  for (std::string line; word != words.end() && std::getline(lines, line);) {
    if (line.empty())
      continue;
    if (const auto phones = phones_of(line))
      found[*word].push_back(*phones);
    ++word;
  }
  // A line more or less, and the words would have the sounds of others.
  std::string rest;
  while (std::getline(lines, rest))
    if (!rest.empty())
      return {};
  return word == words.end() ? found : Pronunciations();
}

// A name of several words has no sound as a whole: each word has its own.
Pronunciations given_sounds(const std::vector<PronunciationModel>& given) {
  Pronunciations sounds;
  for (const auto& each : given)
    if (const auto words = spoken_words(each.word); words.size() == 1)
      sounds[words[0]].push_back(each.phones);
  return sounds;
}

// What the application says of a word takes the place of the dictionary's.
Expected<Pronunciations> model_sounds(const std::filesystem::path& model,
                                      const std::set<std::string>& words,
                                      const Pronunciations& given) {
  auto sounds = dictionary_sounds(model / "cmudict-en-us.dict", words);
  if (!sounds)
    return fail(ErrorKind::settings,
                "no dictionary of PocketSphinx is in " + model.string() +
                    "; install pocketsphinx-en-us, or set the option 'model'");
  for (const auto& [word, ways] : given)
    if (words.contains(word))
      (*sounds)[word] = ways;
  std::set<std::string> lacking;
  for (const auto& word : words)
    if (!sounds->contains(word))
      lacking.insert(word);
  sounds->merge(espeak_sounds(lacking));
  return sounds;
}

std::string dictionary_text(const Pronunciations& sounds) {
  std::string text;
  for (const auto& [word, ways] : sounds)
    for (std::size_t i = 0; i < ways.size(); ++i)
      text += word + (i ? "(" + std::to_string(i + 1) + ")" : "") + " " +
              ways[i] + "\n";
  return text;
}

} // namespace parlour::adapters::asr
