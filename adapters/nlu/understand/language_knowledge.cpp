#include "adapters/nlu/understand/language_knowledge.hpp"

#include <system_error>
#include <utility>

#include "adapters/nlu/encoder/known_sentences.hpp"
#include "runtime/base/outside/environment.hpp"
#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters::nlu {

namespace {

template <class Knowledge>
bool same(const std::shared_ptr<const Knowledge>& left,
          const std::shared_ptr<const Knowledge>& right) {
  return left == right || (left && right && *left == *right);
}

} // namespace

bool LanguageKnowledge::operator==(const LanguageKnowledge& other) const {
  return same(vectors, other.vectors) && same(encoder, other.encoder);
}

template <class Knowledge>
std::shared_ptr<const Knowledge>
LanguageStore::read(Kept<Knowledge>& kept, const std::filesystem::path& path,
                    std::vector<Error>& errors) {
  if (!is_there(path))
    return {};
  std::error_code ignored; // reading it says what is wrong
  const auto written = std::filesystem::last_write_time(path, ignored);
  if (kept.knowledge && kept.path == path && kept.written == written)
    return kept.knowledge;
  auto made = Knowledge::read(path);
  if (!made) {
    errors.push_back(made.error());
    return {};
  }
  kept = {path, written, *made};
  return *made;
}

LanguageKnowledge LanguageStore::read(const std::filesystem::path& platform,
                                      std::vector<Error>& errors) {
  const std::lock_guard lock(mutex_);
  auto vectors = read(vectors_, platform / "words.vectors", errors);
  auto encoder = read(encoder_, platform / "sentences.encoder", errors);
  auto known = encoder ? known_sentences_file(environment_variable)
                       : std::filesystem::path();
  return {std::move(vectors), std::move(encoder), std::move(known)};
}

LanguageStore& language_store() {
  static LanguageStore store;
  return store;
}

} // namespace parlour::adapters::nlu
