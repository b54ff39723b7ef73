#include "actors/support/privacy/recent_secrets.hpp"

namespace parlour::actors {

RecentSecrets::~RecentSecrets() {
  while (!texts_.empty())
    forget_first();
}

bool RecentSecrets::add(const std::string& text) {
  if (const auto known = places_.find(text); known != places_.end()) {
    texts_.splice(texts_.end(), texts_, known->second);
    return false;
  }
  const auto place = texts_.insert(texts_.end(), text);
  places_.emplace(*place, place);
  if (shared_)
    shared_->add(text);
  const bool is_new = secrets_.add(text);
  if (texts_.size() > most)
    forget_oldest();
  return is_new;
}

void RecentSecrets::forget_oldest() {
  while (texts_.size() > most - most / 4)
    forget_first();
  secrets_ = {};
  for (const auto& text : texts_)
    secrets_.add(text);
}

void RecentSecrets::forget_first() {
  if (shared_)
    shared_->remove(texts_.front());
  places_.erase(texts_.front());
  texts_.pop_front();
}

} // namespace parlour::actors
