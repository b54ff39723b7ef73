#include "adapters/nlu/understand/language_knowledge.hpp"

#include <system_error>
#include <utility>

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
  std::error_code none;
  const auto written = std::filesystem::last_write_time(path, none);
  if (none)
    return {};
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
  return {std::move(vectors),
          read(encoder_, platform / "sentences.encoder", errors)};
}

LanguageStore& language_store() {
  static LanguageStore store;
  return store;
}

} // namespace parlour::adapters::nlu
