// SharedSecrets: the private texts of all sessions, masked in a text whatever
// session it is from.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "runtime/base/text/text_map.hpp"
#include "runtime/message/masking.hpp"

namespace parlour::actors {

// A text of several sessions is known until each of them has removed it.
// Masking takes time in proportion to the text's length, however many sessions
// there are. Not thread-safe.
// Used under the lock of Discretion.
class SharedSecrets {
public:
  void add(std::string_view text);
  // One that was added.
  // Nothing happens where it is not known.
  void remove(std::string_view text);
  // As Secrets does.
  std::string masked(std::string_view text) const;

private:
  // Secrets by their beginnings: those that begin alike, and how often each was
  // added. A secret can only occur where a text has its beginning.
  // Most secrets are shorter, so that few begin alike.
  static constexpr std::size_t max_beginning = 32;
  using Alike = std::map<std::string, std::size_t, std::less<>>;

  void collect(std::string_view beginning, Secrets& to) const;

  TextMap<Alike> by_beginning_;
  // How many beginnings there are of each length.
  std::array<std::size_t, max_beginning + 1> lengths_{};
};

} // namespace parlour::actors
