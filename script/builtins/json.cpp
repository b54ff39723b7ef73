// JSON (language rule 8.9). It is written compactly and in insertion order.
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/base/result_rows.hpp"
#include "runtime/base/text/utf8.hpp"
#include "script/values/convert.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

// Deeper text is rejected, as the reader is recursive.
constexpr int deepest = 200;

// Escapes what JSON requires; other characters are written in UTF-8.
void quote(std::string& json, std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  json += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (json += '\\') += c;
    else if (c == '\n')
      json += "\\n";
    else if (c == '\t')
      json += "\\t";
    else if (c == '\r')
      json += "\\r";
    else if (byte < 0x20)
      ((json += "\\u00") += digits[byte >> 4]) += digits[byte & 15];
    else
      json += c;
  }
  json += '"';
}

// Writes a value as JSON up to the limit of a result. Unknown becomes null, and
// a binary its printed form.
class Writer {
public:
  explicit Writer(std::size_t limit) : limit_(limit) {}

  // Returns false if the limit or the depth is exceeded.
  bool write(const Value& value, int depth = 0) {
    if (depth > deepest_nesting || json.size() > limit_)
      return false;
    if (const auto* list = value.if_list())
      return write_list(*list, depth);
    if (const auto* map = value.if_map())
      return write_map(*map, depth);
    if (const auto* result = value.if_result())
      return write_result(*result, depth);
    if (value.is_unknown())
      json += "null";
    else if (const auto* string = value.if_string())
      quote(json, *string);
    else if (value.if_binary())
      quote(json, to_string(value));
    else
      json += to_string(value);
    return true;
  }

  std::string json;

private:
  bool write_list(const List& list, int depth) {
    json += '[';
    for (const auto& element : list) {
      if (&element != list.data())
        json += ',';
      if (!write(element, depth + 1))
        return false;
    }
    json += ']';
    return true;
  }

  bool write_map(const Map& map, int depth) {
    json += '{';
    for (const auto& entry : map.entries()) {
      if (&entry != map.entries().data())
        json += ',';
      quote(json, entry.first);
      json += ':';
      if (!write(entry.second, depth + 1))
        return false;
    }
    json += '}';
    return true;
  }

  // A result set becomes a list of objects.
  bool write_result(const ResultSet& result, int depth) {
    return write_list(rows_as_maps(result), depth);
  }

  std::size_t limit_;
};

// A recursive descent parser that builds boxes. The first error ends it: all
// functions then return without reading further.
class Reader {
public:
  Reader(Heap& heap, std::string_view text) : heap_(heap), text_(text) {}

  // The value, and nothing but blanks behind it.
  bool whole(Box& result) {
    result = value(0);
    skip();
    return ok_ && at_ == text_.size();
  }
  // The position of the first error, in code points.
  std::size_t position() const {
    return count_code_points(text_.substr(0, ok_ ? at_ : wrong_));
  }

private:
  char peek() const {
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void skip() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
  }
  // Remembers the first error and makes the callers return.
  Box fail() {
    if (ok_)
      wrong_ = at_;
    ok_ = false;
    return {};
  }
  bool accept(std::string_view word) {
    if (!text_.substr(at_).starts_with(word))
      return false;
    at_ += word.size();
    return true;
  }

  // Any value; blanks before it are skipped.
  Box value(int depth) {
    skip();
    if (depth > deepest || !ok_)
      return fail();
    if (accept("["))
      return list(depth);
    if (accept("{"))
      return map(depth);
    if (peek() == '"') {
      std::string text;
      return string(text) ? make_string(heap_, text) : fail();
    }
    if (accept("null"))
      return {};
    if (accept("true"))
      return Box::boolean(true);
    if (accept("false"))
      return Box::boolean(false);
    return number();
  }

  // Accepts the characters of numbers and lets parse_number decide, which
  // accepts slightly more than JSON does: only a leading plus is refused here.
  Box number() {
    const auto end =
        std::min(text_.find_first_not_of("+-.eE0123456789", at_), text_.size());
    const auto value = parse_number(text_.substr(at_, end - at_));
    if (end == at_ || value.is_unknown() || text_[at_] == '+' ||
        !std::isfinite(value.number_or(0)))
      return fail();
    at_ = end;
    return to_box(heap_, value);
  }

  // The opening bracket has been read.
  Box list(int depth) {
    auto box = make_list(heap_);
    skip();
    if (accept("]"))
      return box;
    do
      box.list()->elements.push_back(value(depth + 1));
    while (ok_ && (skip(), accept(",")));
    return accept("]") ? box : fail();
  }

  // The opening brace has been read. A repeated key sets its value again.
  Box map(int depth) {
    auto box = make_map(heap_);
    skip();
    if (accept("}"))
      return box;
    do {
      std::string key;
      skip();
      if (!string(key) || (skip(), !accept(":")))
        return fail();
      box.map()->set(make_string(heap_, key), value(depth + 1));
    } while (ok_ && (skip(), accept(",")));
    return accept("}") ? box : fail();
  }

  // A string up to its closing quote. Control characters must be escaped.
  bool string(std::string& text) {
    if (!accept("\""))
      return false;
    while (at_ < text_.size() && peek() != '"') {
      if (static_cast<unsigned char>(peek()) < 0x20)
        return false;
      if (peek() == '\\' ? !escape(text) : (text += text_[at_++], false))
        return false;
    }
    return accept("\"");
  }

  // An escape; code points beyond 16 bits are written as two surrogates.
  bool escape(std::string& text) {
    constexpr std::string_view from = "\"\\/bfnrt";
    constexpr std::string_view to = "\"\\/\b\f\n\r\t";
    ++at_;
    if (const auto found = from.find(peek());
        at_ < text_.size() && found != std::string_view::npos) {
      text += to[found];
      ++at_;
      return true;
    }
    std::uint32_t code = 0;
    if (!unit(code))
      return false;
    std::uint32_t low = 0;
    // The first half of a pair; the second half must follow.
    if (code >= 0xd800 && code < 0xdc00) {
      if (!accept("\\") || !unit(low) || low < 0xdc00 || low > 0xdfff)
        return false;
      code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
    } else if (code >= 0xdc00 && code < 0xe000) {
      return false;
    }
    append_code_point(text, code);
    return true;
  }

  // "u" and four hexadecimal digits.
  bool unit(std::uint32_t& code) {
    if (peek() != 'u' || text_.size() - at_ < 5)
      return false;
    for (auto c : text_.substr(at_ + 1, 4)) {
      constexpr std::string_view digits = "0123456789abcdef";
      const auto digit =
          digits.find(static_cast<char>(c >= 'A' && c <= 'F' ? c + 32 : c));
      if (digit == std::string_view::npos)
        return false;
      code = code << 4 | static_cast<std::uint32_t>(digit);
    }
    at_ += 5;
    return true;
  }

  Heap& heap_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t wrong_ = 0; // offset of the first error
  bool ok_ = true;
};

} // namespace

// The value is converted first, so that the writer sees no interpreter and no
// bound parameters.
bool to_json(BuiltinCall& call) {
  const auto limit = call.machine.program->settings.limits.result;
  // Each value takes at least one character of the result.
  auto budget = call.machine.walk_budget(limit * WalkBudget::bytes_per_value);
  const auto value = to_value(call[0], budget);
  if (!call.machine.charge(budget.price()))
    return false;
  Writer writer(limit);
  if (budget.exhausted() || !writer.write(value))
    return call.room(limit + 1);
  return call.give_text(writer.json);
}

// Each byte can be a value.
bool from_json(BuiltinCall& call) {
  std::string text;
  if (!call.text(0, text) || !call.values(text.size()))
    return false;
  Reader reader(call.heap(), text);
  Box value;
  if (!reader.whole(value))
    return call.fail(ErrorKind::type, "the text is not JSON, from position " +
                                          std::to_string(reader.position()));
  return call.give(std::move(value));
}

} // namespace parlour::script::builtins
