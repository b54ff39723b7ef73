// The operators of the language (language rules 3.5 to 3.11) as functions of
// boxes. They know no interpreter; a function that can fail returns an Outcome,
// which is empty on success.
//
// Operands must be values, not bound parameters (Box::resolved). An example:
//
//   Box sum;
//   if (auto failure = add(heap, left, right, sum))
//     raise(*failure);
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "script/values/objects.hpp"
#include "script/values/walk_budget.hpp"

namespace parlour::script {

// Why an operation failed, with the kind that <catch> sees.
struct Failure {
  ErrorKind kind = ErrorKind::type;
  std::string message;
};
using Outcome = std::optional<Failure>;

inline constexpr int deepest_nesting = 1000;

std::string_view type_name(const Box& box); // as type(x) returns it
std::string a_type(const Box& box);         // "a list", "an integer", "unknown"
// Truth in conditions (language rule 2.3).
bool truth(const Box& box);

// An integer or a number, for arithmetic on mixed operands.
struct Numeric {
  bool is_integer = true;
  std::int64_t integer = 0;
  double number = 0;

  double as_number() const {
    return is_integer ? static_cast<double>(integer) : number;
  }
};
// Reads a box as a number; with `from_text` also a string that is written like
// one (language rule 3.8).
std::optional<Numeric> numeric(const Box& box, bool from_text = true);
// The bytes that numeric() has to read.
std::size_t digits_of(const Box& box);
// Negative, zero or positive.
int compare(const Numeric& left, const Numeric& right);

// Equality of language rule 3.5. If the budget is exhausted afterwards, the
// comparison was given up and the result has no meaning.
bool equal(const Box& left, const Box& right, WalkBudget& budget,
           int depth = 0);

enum class Order : std::uint8_t { less, equal, greater, none };
// The order of language rule 3.6; `none` if a side is unknown.
Outcome order(const Box& left, const Box& right, Order& result,
              WalkBudget& budget);

enum class Arithmetic : std::uint8_t { subtract, multiply, divide, modulo };
// The result is a new value in `result`; operands are never changed. Integers
// that overflow become numbers (language rule 2.4).
Outcome arithmetic(Heap& heap, Arithmetic operation, const Box& left,
                   const Box& right, Box& result);
Outcome add(Heap& heap, const Box& left, const Box& right, Box& result);
Outcome negate(Heap& heap, const Box& operand, Box& result);
// A finite value; otherwise an error of kind Arithmetic (language rule 2.5).
Outcome number_result(double value, Box& result);

// Appends the printed form (language rule 2.2). Returns false if the text would
// become longer than `limit` bytes or the value is nested too deep.
bool print(std::string& text, const Box& box, std::size_t limit, int depth = 0);

// Reading what is missing gives unknown (language rule 2.8).
Outcome get_index(Heap& heap, const Box& container, const Box& key,
                  Box& result);
Outcome get_field(Heap& heap, const Box& container, const Box& name,
                  Box& result);
// A container cannot be put inside of itself (language rule 2.7); these
// functions search for that and fail, as they do if the budget does not suffice
// for the search.
Outcome set_index(Heap& heap, const Box& container, const Box& key, Box value,
                  WalkBudget& budget);
Outcome append(const Box& list, Box value, WalkBudget& budget);
Outcome refuse_ring(const Box& container, const Box& value, WalkBudget& budget);
Outcome is_in(const Box& element, const Box& container, bool& result,
              WalkBudget& budget);
// As it is printed, a key of a map (language rule 2.10). Missing: too long.
Box key_text(Heap& heap, const Box& key);

// The rows of a result set as a list of maps.
Box rows_of(Heap& heap, const Box& result);
Box keys_of(Heap& heap, const MapObject& map);
// The offset of a part in a text, from byte `from` on; npos if it does not
// occur. Takes time linear in the text, whatever the part is.
std::size_t find_text(std::string_view text, std::string_view part,
                      std::size_t from = 0);
// The offset of a code point in bytes; the size of the string if it does not
// exist.
std::size_t byte_position(const StringObject& string, std::size_t code_point);
// The length of a code point by its first byte.
std::size_t character_size(char first);
// The index for a position in something of this size. Negative positions count
// from the end (language rule 2.8); nothing if it is outside.
std::optional<std::size_t> place_in(std::int64_t position, std::size_t size);

} // namespace parlour::script
