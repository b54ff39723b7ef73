// What the operators mean (language rules 3.5 to 3.11), as functions of boxes
// that know no interpreter. What can fail says so in an Outcome.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "script/values/objects.hpp"

namespace parlour::script {

// A failure with its kind and sentence, or nothing.
struct Failure {
  ErrorKind kind = ErrorKind::type;
  std::string message;
};
using Outcome = std::optional<Failure>;

inline constexpr int deepest_nesting = 1000;

std::string_view type_name(const Box& box); // as type(x) gives it
std::string a_type(const Box& box);         // "a list", "an integer", "unknown"
bool truth(const Box& box);

// An integer or a number.
struct Numeric {
  bool is_integer = true;
  std::int64_t integer = 0;
  double number = 0;

  double as_number() const {
    return is_integer ? static_cast<double>(integer) : number;
  }
};
// Of an integer or a number; with `from_text` also of a well-formed string.
std::optional<Numeric> numeric(const Box& box, bool from_text = true);
int compare(const Numeric& left, const Numeric& right);

// Equality walks containers; `budget` bounds the walk, and 0 afterwards says
// that it was too long for an answer.
bool equal(const Box& left, const Box& right, std::size_t& budget,
           int depth = 0);

enum class Order : std::uint8_t { less, equal, greater, none };
// None where a side is unknown.
Outcome order(const Box& left, const Box& right, Order& result);

enum class Arithmetic : std::uint8_t { subtract, multiply, divide, modulo };
Outcome arithmetic(Heap& heap, Arithmetic operation, const Box& left,
                   const Box& right, Box& result);
Outcome add(Heap& heap, const Box& left, const Box& right, Box& result);
Outcome negate(Heap& heap, const Box& operand, Box& result);
// Finite, or an error of kind Arithmetic.
Outcome number_result(double value, Box& result);

// Adds the printed form; false where it would be longer than `limit` bytes or
// is nested too deep.
bool print(std::string& text, const Box& box, std::size_t limit, int depth = 0);

Outcome get_index(Heap& heap, const Box& container, const Box& key,
                  Box& result);
Outcome get_field(Heap& heap, const Box& container, const Box& name,
                  Box& result);
// Putting a value into a container that it holds would make a ring, and fails.
// The search for it adds to `work` what it cost, counted in boxes.
Outcome set_index(Heap& heap, const Box& container, const Box& key, Box value,
                  std::size_t& work);
Outcome append(const Box& list, Box value, std::size_t& work);
Outcome refuse_ring(const Box& container, const Box& value, std::size_t& work);
Outcome is_in(const Box& element, const Box& container, bool& result,
              std::size_t& budget);

// The list of maps of a result set's rows.
Box rows_of(Heap& heap, const Box& result);
Box keys_of(Heap& heap, const MapObject& map);
// Where a part stands in a text, from a byte on; npos where it does not. Takes
// time by the size of the text, whatever the part is.
std::size_t find_text(std::string_view text, std::string_view part,
                      std::size_t from = 0);
// The byte where a code point starts; the size where there is none.
std::size_t byte_position(const StringObject& string, std::size_t code_point);
std::size_t character_size(char first);
// A position in something of this size: negative ones count from the end;
// nothing where it is outside.
std::optional<std::size_t> place_in(std::int64_t position, std::size_t size);

} // namespace parlour::script
