// Built-in functions for phrases (language rules 8.10 and 8.12): how numbers,
// lists, times and levels are spoken in English. script/spoken makes the words.
#include "script/builtins/builtin_numbers.hpp"
#include "script/spoken/spoken.hpp"
#include "script/spoken/spoken_number.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

// One of several values of a slot (engine rule 5.14).
struct Item {
  const Box* value = nullptr; // null: it is none
  const Box* amount = nullptr;
};

Item item_of(const Box& box) {
  if (!box.is_map() || box.map()->entries.size() != 2)
    return {};
  const auto* amount = box.map()->find("amount");
  return amount && numeric(*amount, false)
             ? Item{box.map()->find("value"), amount}
             : Item{};
}

// Speaks one value, which costs as much as a built-in. A number without a kind
// is spoken as a number.
bool say(BuiltinCall& call, const Box& value, const std::string& kind,
         std::string& words) {
  if (const auto item = item_of(value); item.value) { // "two coffees"
    if (!say(call, *item.value, kind, words))
      return false;
    words = counted(decimal_of(*numeric(*item.amount, false)), words, {});
    return true;
  }
  ToSay what;
  if (!call.print(what.text, value) ||
      !call.machine.charge(Machine::builtin_cost))
    return false;
  if (const auto number = numeric(value))
    what.number = decimal_of(*number);
  what.now = call.machine.host->now();
  const bool is_number = numeric(value, false).has_value();
  words = script::spoken(what, kind.empty() && is_number ? "number" : kind);
  return true;
}

// Speaks each element and joins them: "A, B and C".
bool say_all(BuiltinCall& call, const ListObject& list, const std::string& kind,
             const std::string& link) {
  std::vector<std::string> parts;
  for (const auto& element : list.elements)
    if (!say(call, element, kind, parts.emplace_back()))
      return false;
  return call.give_text(series(parts, link));
}

// Reads an optional text; unknown counts as not given. False after an error.
bool optional_text(BuiltinCall& call, std::size_t index, std::string& value) {
  return !call.has(index) || call[index].is_unknown() ||
         call.text(index, value);
}

bool is_vowel(char c) {
  return std::string_view("aeiouAEIOU").find(c) != std::string_view::npos;
}

} // namespace

// count(2, 'box') is "two boxes"; the plural may be given.
bool count(BuiltinCall& call) {
  Numeric number;
  std::string noun;
  std::string several;
  return call.number(0, number) && call.text(1, noun) &&
         optional_text(call, 2, several) &&
         call.give_text(counted(decimal_of(number), noun, several));
}

// ordinal(2) is "second".
bool ordinal(BuiltinCall& call) {
  std::int64_t number = 0;
  return call.integer(0, number) && call.give_text(ordinal_words(number));
}

// list(['A', 'B']) is "A and B": elements as they are, or by a kind.
bool list(BuiltinCall& call) {
  ListObject* elements = nullptr;
  std::string link = "and";
  std::string kind = "set";
  if (call[0].is_unknown())
    return call.give_text("");
  return call.list(0, elements) && optional_text(call, 1, link) &&
         optional_text(call, 2, kind) && say_all(call, *elements, kind, link);
}

// The article goes by the first letter; "an hour" has to be written.
bool an(BuiltinCall& call) {
  std::string noun;
  if (!call.text(0, noun))
    return false;
  const bool vowel = !noun.empty() && is_vowel(noun[0]);
  return call.give_text((vowel ? "an " : "a ") + noun);
}

// spoken(x, kind): the words for a value, or for each element of a list;
// nothing is said for unknown.
bool spoken(BuiltinCall& call) {
  std::string kind;
  std::string words;
  ListObject* elements = nullptr;
  if (!optional_text(call, 1, kind))
    return false;
  if (call[0].is_unknown())
    return call.give_text("");
  if (call[0].is_list())
    return call.list(0, elements) && say_all(call, *elements, kind, "and");
  if (!call.text(0, words))
    return false;
  return say(call, call[0], kind, words) && call.give_text(words);
}

} // namespace parlour::script::builtins
