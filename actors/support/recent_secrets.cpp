#include "actors/support/recent_secrets.hpp"

namespace parlour::actors {

bool RecentSecrets::add(const std::string& text) {
  if (const auto known = places_.find(text); known != places_.end()) {
    texts_.splice(texts_.end(), texts_, known->second);
    return false;
  }
  const auto place = texts_.insert(texts_.end(), text);
  places_.emplace(*place, place);
  const bool is_new = secrets_.add(text);
  if (texts_.size() > most)
    forget_oldest();
  return is_new;
}

void RecentSecrets::forget_oldest() {
  while (texts_.size() > most - most / 4) {
    places_.erase(texts_.front());
    texts_.pop_front();
  }
  secrets_ = {};
  for (const auto& text : texts_)
    secrets_.add(text);
}

} // namespace parlour::actors
