// Regular expressions (language rule 8.3) by RE2, whose time is linear in the
// text.
#include <list>
#include <memory>

#include <re2/re2.h>

#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

constexpr std::size_t kept = 32; // compiled expressions kept for each thread
constexpr int64_t largest_program = 1 << 20;

// A small cache with the most recently used expression first, since scripts
// match the same few expressions again and again.
const RE2& compiled(const std::string& pattern) {
  static thread_local std::list<std::unique_ptr<RE2>> cache;
  for (auto each = cache.begin(); each != cache.end(); ++each)
    if ((*each)->pattern() == pattern) {
      cache.splice(cache.begin(), cache, each);
      return *cache.front();
    }
  RE2::Options options;
  options.set_log_errors(false);
  options.set_max_mem(largest_program);
  cache.push_front(std::make_unique<RE2>(pattern, options));
  if (cache.size() > kept)
    cache.pop_back();
  return *cache.front();
}

// What the program of an expression has to do with its size. One that is
// refused as too large was compiled until it had about this many steps; what is
// no expression at all was only read.
constexpr std::size_t most_steps = 10'000;

std::size_t steps_of(const RE2& expression) {
  if (expression.ok())
    return static_cast<std::size_t>(expression.ProgramSize());
  return expression.error_code() == RE2::ErrorPatternTooLarge
             ? most_steps
             : expression.pattern().size();
}

// Charges the compiling of an expression, which takes about as long as this
// many instructions for each step. It is charged whether or not this thread has
// it in its cache, as a script's fuel may not depend on that (architecture rule
// 1), but not where the expression is written in the script: of these there are
// few, and loops use them again and again.
bool pay_for_compiling(BuiltinCall& call, const RE2& expression) {
  constexpr std::size_t instructions_of_a_step = 16;
  const bool is_written =
      expression.ok() && call[1].is_string() && !call[1].object()->heap;
  return is_written ||
         call.machine.charge(steps_of(expression) * instructions_of_a_step);
}

const RE2* expression(BuiltinCall& call, std::string& text) {
  std::string pattern;
  if (!call.text(0, text) || !call.text(1, pattern))
    return nullptr;
  const auto& found = compiled(pattern);
  if (!pay_for_compiling(call, found))
    return nullptr;
  if (!found.ok()) {
    call.fail(ErrorKind::type,
              "'" + pattern +
                  "' is not a regular expression: " + found.error());
    return nullptr;
  }
  // In the worst case each character is matched against each step of the
  // program, so the fuel charged is their product.
  const auto steps = steps_of(found) / 2;
  return call.bytes(steps + text.size() * (4 + steps)) ? &found : nullptr;
}

} // namespace

// The expression may match anywhere in the text.
bool matches(BuiltinCall& call) {
  std::string text;
  if (call[0].is_unknown())
    return call.give_flag(false);
  const auto* regex = expression(call, text);
  return regex && call.give_flag(RE2::PartialMatch(text, *regex));
}

// The whole match and its groups as a list; unknown if nothing matches. A group
// that took no part in the match is unknown, too.
bool capture(BuiltinCall& call) {
  std::string text;
  if (call[0].is_unknown())
    return call.give(Box());
  const auto* regex = expression(call, text);
  if (!regex)
    return false;
  std::vector<re2::StringPiece> groups(
      static_cast<std::size_t>(regex->NumberOfCapturingGroups()) + 1);
  if (!regex->Match(text, 0, text.size(), RE2::UNANCHORED, groups.data(),
                    static_cast<int>(groups.size())))
    return call.give(Box());
  auto list = make_list(call.heap(), groups.size());
  for (const auto& group : groups)
    list.list()->elements.push_back(
        group.data() ? make_string(call.heap(), {group.data(), group.size()})
                     : Box());
  return call.give(std::move(list));
}

} // namespace parlour::script::builtins
