// RecentSecrets: private texts, as many as there is room for.
#pragma once

#include <list>
#include <map>
#include <string>
#include <string_view>

#include "actors/support/privacy/shared_secrets.hpp"
#include "runtime/message/masking.hpp"

namespace parlour::actors {

// Once there are more than `most`, those that were added longest ago are
// forgotten, a quarter at once: masks are made anew then, which takes time. So
// the newest three quarters are always known. Not thread-safe.
class RecentSecrets {
public:
  // The bound of architecture rule 5.
  static constexpr std::size_t most = 1'000;

  RecentSecrets() = default;
  // What is known here is known in `shared`, too, which must outlive it.
  explicit RecentSecrets(SharedSecrets& shared) : shared_(&shared) {}
  RecentSecrets(const RecentSecrets&) = delete;
  RecentSecrets& operator=(const RecentSecrets&) = delete;
  ~RecentSecrets();

  // A text that is known counts as new again. False if it was known, or
  // consists of blanks.
  bool add(const std::string& text);
  // Exactly that text.
  bool contains(std::string_view text) const {
    return places_.contains(text);
  }
  const Secrets& secrets() const {
    return secrets_;
  }

private:
  void forget_oldest();
  void forget_first();

  std::list<std::string> texts_; // the newest is the last
  // Views into the texts of the list, whose elements never move.
  std::map<std::string_view, std::list<std::string>::iterator> places_;
  Secrets secrets_; // the same, as they are masked
  SharedSecrets* const shared_ = nullptr;
};

} // namespace parlour::actors
