#include "runtime/base/component_policy.hpp"

#include <charconv>
#include <map>

namespace parlour {

namespace {

constexpr std::size_t max_instances = 64;

// The n of "pool(n)"; 0 if the text has another form or n is out of range.
std::size_t size_of_pool(std::string_view text) {
  constexpr std::string_view head = "pool(";
  if (!text.starts_with(head) || !text.ends_with(')'))
    return 0;
  const auto* first = text.data() + head.size();
  const auto* last = text.data() + text.size() - 1;
  std::size_t size = 0;
  const auto [end, error] = std::from_chars(first, last, size);
  return error == std::errc() && end == last && size <= max_instances ? size
                                                                      : 0;
}

} // namespace

Expected<Scope> parse_scope(std::string_view text) {
  using enum Scope::Kind;
  // "loaded", alone or before a scope, means that no instance exists until a
  // script loads the component.
  if (text == "loaded")
    return Scope{usual, 0};
  constexpr std::string_view loaded = "loaded ";
  if (text.starts_with(loaded)) {
    auto scope = parse_scope(text.substr(loaded.size()));
    if (scope && scope->kind != pool && scope->instances != 0) {
      scope->instances = 0;
      return scope;
    }
    return fail(ErrorKind::settings, "expected node, seat, session, or inline "
                                     "behind 'loaded'");
  }
  static const std::map<std::string_view, Scope::Kind> words = {
      {"node", node},
      {"seat", seat},
      {"session", session},
      {"inline", in_turn}};
  if (const auto found = words.find(text); found != words.end())
    return Scope{found->second};
  if (const auto size = size_of_pool(text); size != 0)
    return Scope{pool, size};
  return fail(ErrorKind::settings,
              "expected node, seat, session, inline, pool(n) with n from 1 to "
              "64, or loaded, alone or before one of the first four");
}

} // namespace parlour
