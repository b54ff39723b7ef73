#include "script/slip_rules.hpp"

namespace parlour::script::slip_rules {

namespace {

// A sign around or at the place, and what is written here.
struct Sign {
  std::string_view written;
  std::string_view meant; // empty: no single correction
  std::string_view sentence;
};

constexpr Sign signs[] = {
    {"!==", "!=", "'!==' is written '!='"},
    {"===", "==", "'===' is written '=='"},
    {"<>", "!=", "'<>' is written '!='"},
    {"=>", ">=", "'=>' is written '>='"},
    {"=<", "<=", "'=<' is written '<='"},
    {"=!", "!=", "'=!' is written '!='"},
    {":=", "", "an expression changes nothing; a <set> assigns"},
    {"??", "", "'?\?' is written: isknown(a) ? a : b"},
    {"?.", ".",
     "'?.' is written with the point alone; a field of unknown is unknown"},
    {"->", ".", "'->' is written as a point: map.field"},
    {"::", ".", "'::' is written as a point"},
    {"**", "", "a power is written pow(base, exponent)"},
    {"^", "", "a power is written pow(base, exponent)"},
    {"//", "", "whole numbers are divided by integer(a / b)"},
    {"&", "and",
     "a single '&' has no meaning here; write 'and', or + to join texts"},
    {"|", "or", "a single '|' has no meaning here; write 'or'"},
    {"~", "", "'~' has no meaning here; texts are compared by == or matches()"},
    {"`", "", "a text stands in straight quotes: 'text'"},
    {"@", "", "'@' has no meaning here; a text stands in quotes: 'text'"},
    {"#", "", "'#' has no meaning here; a text stands in quotes: 'text'"},
    {"\\", "", "a backslash stands inside of quoted texts only"},
};

} // namespace

Found assignment(const Scene& scene) {
  const auto sign = scene.previous();
  const auto whole = trimmed(scene.text);
  const bool doubled = whole.ends_with("++") || whole.ends_with("--");
  const bool combined = scene.rest().starts_with('=') && sign != '\0' &&
                        std::string_view("+-*/%").find(sign) != npos;
  if (!doubled && !combined)
    return {};
  const auto at = combined ? scene.at - 1 : scene.text.find_last_of("+-") - 1;
  const auto operation = scene.text.substr(at, 1);
  const auto name = string_of(trimmed(scene.text.substr(0, at)));
  const auto right = doubled ? "1" : string_of(trimmed(scene.rest().substr(1)));
  return ExpressionSlip{at, 2,
                        "an expression changes nothing; write <set name=\"" +
                            name + "\" expr=\"" + name + " " +
                            string_of(operation) + " " + right + "\"/>"};
}

Found foreign_sign(const Scene& scene) {
  if (scene.error.starts_with("an escape") || scene.error.starts_with("\\u"))
    return ExpressionSlip{scene.at, 2, string_of(scene.error)};
  for (const auto& sign : signs)
    for (std::size_t back = 0; back < sign.written.size(); ++back) {
      if (back > scene.at)
        break;
      const auto at = scene.at - back;
      if (!scene.text.substr(at).starts_with(sign.written))
        continue;
      ExpressionSlip slip{at, sign.written.size(), string_of(sign.sentence)};
      if (!sign.meant.empty())
        slip.replacement = string_of(sign.meant);
      return slip;
    }
  return {};
}

Found equals(const Scene& scene) {
  if (!scene.rest().starts_with('='))
    return {};
  if (scene.before().empty())
    return ExpressionSlip{scene.at, 1,
                          "an expression begins without '='; leave it out", ""};
  return ExpressionSlip{scene.at, 1, "'=' does not compare; write '=='", "=="};
}

Found semicolon(const Scene& scene) {
  if (!scene.rest().starts_with(';'))
    return {};
  ExpressionSlip slip{scene.at, 1, "nothing ends with ';' here; leave it out"};
  if (trimmed(scene.rest().substr(1)).empty())
    slip.replacement = "";
  return slip;
}

Found decimal_comma(const Scene& scene) {
  const auto rest = scene.rest();
  if (rest.size() < 2 || rest[0] != ',' || !is_digit(rest[1]) ||
      !is_digit(scene.previous()))
    return {};
  const auto begin = word_begin(scene.text, scene.at);
  const auto end = word_end(scene.text, scene.at + 1);
  auto number = string_of(scene.text.substr(begin, end - begin));
  number[scene.at - begin] = '.';
  return ExpressionSlip{begin, end - begin,
                        "a fraction is written with a point: " + number,
                        number};
}

Found leading_point(const Scene& scene) {
  const auto rest = scene.rest();
  if (rest.size() < 2 || rest[0] != '.' || !is_digit(rest[1]))
    return {};
  const auto end = word_end(scene.text, scene.at + 1);
  const auto number =
      "0" + string_of(scene.text.substr(scene.at, end - scene.at));
  return ExpressionSlip{scene.at, end - scene.at,
                        "a fraction has a digit before its point: " + number,
                        number};
}

} // namespace parlour::script::slip_rules
