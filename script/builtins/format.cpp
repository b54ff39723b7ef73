// The built-in function format (language rule 8.13).
#include "script/builtins/builtin_numbers.hpp"
#include "script/spoken/format_pattern.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

bool add_value(BuiltinCall& call, const Box& value, const Format& format,
               std::string& text) {
  const auto limit = call.machine.program->settings.limits.result;
  const auto number = numeric(value);
  const bool is_number = numeric(value, false) || format.needs_number();
  if (format.needs_number() && !number)
    return call.fail(ErrorKind::type,
                     "the pattern wants a number, not " + a_type(value));
  std::string printed;
  if (is_number)
    printed = formatted(decimal_of(*number), format);
  else if (!print(printed, value, limit))
    return call.room(limit + 1);
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
