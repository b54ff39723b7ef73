// The built-in function format (language rule 8.13). The pattern is parsed for
// each call; script/spoken does the work.
#include "script/builtins/builtin_numbers.hpp"
#include "script/spoken/format_pattern.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

// Appends a value by its format. Texts that are written like numbers count as
// numbers only if the format needs one.
bool add_value(BuiltinCall& call, const Box& value, const Format& format,
               std::string& text) {
  const auto number = numeric(value);
  const bool is_number = numeric(value, false) || format.needs_number();
  if (format.needs_number() && !number)
    return call.fail(ErrorKind::type,
                     "the pattern wants a number, not " + a_type(value));
  std::string printed;
  if (is_number)
    printed = formatted(decimal_of(*number), format);
  else if (!call.print(printed, value))
    return false;
  text += laid_out(std::move(printed), format, is_number);
  return call.room(text.size());
}

} // namespace

bool format(BuiltinCall& call) {
  std::string pattern;
  if (!call.text(0, pattern))
    return false;
  const auto parsed = parse_format(pattern);
  if (!parsed.error.empty())
    return call.fail(ErrorKind::range, parsed.error);
  if (!call.has(parsed.places))
    return call.fail(ErrorKind::range, "the pattern has more {} than there "
                                       "are arguments");
  std::string text;
  std::size_t next = 1;
  for (const auto& piece : parsed.pieces) {
    text += piece.text;
    if (piece.format && !add_value(call, call[next++], *piece.format, text))
      return false;
  }
  return call.give_text(text);
}

} // namespace parlour::script::builtins
