#include "adapters/database/sqlite/sqlite_values.hpp"

#include <string_view>

#include <sqlite3.h>

#include "adapters/database/row_texts.hpp"
#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters {

namespace {

// SQLITE_STATIC: SQLite keeps the pointers and copies nothing. They are used
// until the statement is reset, and the caller's values live that long.
int bind_one(sqlite3_stmt* statement, int place, const Value& value) {
  if (const auto* boolean = value.if_boolean())
    return sqlite3_bind_int(statement, place, *boolean ? 1 : 0);
  if (const auto* integer = value.if_integer())
    return sqlite3_bind_int64(statement, place, *integer);
  if (const auto* number = value.if_number())
    return sqlite3_bind_double(statement, place, *number);
  if (const auto* text = value.if_string())
    return sqlite3_bind_text64(statement, place, text->data(), text->size(),
                               SQLITE_STATIC, SQLITE_UTF8);
  if (const auto* binary = value.if_binary())
    return sqlite3_bind_blob64(statement, place, binary->bytes.data(),
                               binary->bytes.size(), SQLITE_STATIC);
  return value.is_unknown() ? sqlite3_bind_null(statement, place)
                            : SQLITE_MISMATCH;
}

// A placeholder as an error message names it: ":level" or "number 2".
std::string label(sqlite3_stmt* statement, int place) {
  const auto* name = sqlite3_bind_parameter_name(statement, place);
  return name ? name : "number " + std::to_string(place);
}

// Text is checked here, since SQLite accepts any bytes.
Expected<void> bind(sqlite3_stmt* statement, int place, const Value& value) {
  if (const auto* text = value.if_string(); text && find_invalid_utf8(*text))
    return fail(ErrorKind::type, "the value of placeholder " +
                                     label(statement, place) +
                                     " is not valid UTF-8.");
  switch (bind_one(statement, place, value)) {
  case SQLITE_OK:
    return {};
  case SQLITE_TOOBIG:
    return fail(ErrorKind::limit, "the value of placeholder " +
                                      label(statement, place) +
                                      " is too long.");
  default:
    return fail(ErrorKind::type,
                "placeholder " + label(statement, place) +
                    " takes a text, number or boolean, not a " +
                    std::string(name_of(value.type())) + ".");
  }
}

// Positions count from 1 in SQLite.
Expected<void> bind_list(sqlite3_stmt* statement, const List& values) {
  const auto count =
      static_cast<std::size_t>(sqlite3_bind_parameter_count(statement));
  if (count != values.size())
    return fail(ErrorKind::type,
                "it has " + std::to_string(count) + " placeholder" +
                    (count == 1 ? "" : "s") + ", but " +
                    std::to_string(values.size()) + " value" +
                    (values.size() == 1 ? " is" : "s are") + " given.");
  for (int place = 1; const auto& value : values)
    if (auto bound = bind(statement, place++, value); !bound)
      return bound;
  return {};
}

// The keys have no colon: {"level": 1} for `:level`. Names that occur twice in
// a statement are one placeholder in SQLite.
Expected<void> bind_map(sqlite3_stmt* statement, const Map& values) {
  const auto count = sqlite3_bind_parameter_count(statement);
  for (int place = 1; place <= count; ++place) {
    const auto* name = sqlite3_bind_parameter_name(statement, place);
    const auto* value = name ? values.find(name + 1) : nullptr;
    if (!value)
      return fail(ErrorKind::type, "no value is given for placeholder " +
                                       label(statement, place) + ".");
    if (auto bound = bind(statement, place, *value); !bound)
      return bound;
  }
  if (static_cast<std::size_t>(count) < values.size())
    return fail(ErrorKind::type, "more values are given than it has "
                                 "placeholders.");
  return {};
}

// Appends the cell and returns the number of bytes beyond the value itself.
std::size_t append_text(sqlite3_value* cell, RowTexts& texts, List& cells) {
  const auto* first = reinterpret_cast<const char*>(sqlite3_value_text(cell));
  const auto length = static_cast<std::size_t>(sqlite3_value_bytes(cell));
  cells.push_back(texts.add({first, length}));
  return length;
}

std::size_t append_blob(sqlite3_value* cell, List& cells) {
  const auto* first = static_cast<const std::byte*>(sqlite3_value_blob(cell));
  const auto length = static_cast<std::size_t>(sqlite3_value_bytes(cell));
  cells.emplace_back(Binary{"application/octet-stream",
                            first
                                ? std::vector<std::byte>(first, first + length)
                                : std::vector<std::byte>{}});
  return length;
}

// Reads through sqlite3_value, which looks the cell up once instead of once for
// each question. It is only allowed if no other thread uses the connection.
std::size_t append_cell(sqlite3_value* cell, RowTexts& texts, List& cells) {
  switch (sqlite3_value_type(cell)) {
  case SQLITE_TEXT:
    return append_text(cell, texts, cells);
  case SQLITE_BLOB:
    return append_blob(cell, cells);
  case SQLITE_INTEGER:
    cells.emplace_back(std::int64_t{sqlite3_value_int64(cell)});
    return 0;
  case SQLITE_FLOAT:
    cells.emplace_back(sqlite3_value_double(cell));
    return 0;
  default:
    cells.emplace_back();
    return 0;
  }
}

} // namespace

Expected<void> bind_values(sqlite3_stmt* statement, const Value& values) {
  if (const auto* map = values.if_map())
    return bind_map(statement, *map);
  if (const auto* list = values.if_list())
    return bind_list(statement, *list);
  if (values.is_unknown())
    return bind_list(statement, {});
  return fail(ErrorKind::type, "its values are a list or a map, not a " +
                                   std::string(name_of(values.type())) + ".");
}

std::size_t append_row(sqlite3_stmt* statement, std::size_t columns,
                       List& cells) {
  // All texts of the row share one block of memory.
  RowTexts texts(columns);
  std::size_t bytes = columns * sizeof(Value);
  for (int i = 0; i < static_cast<int>(columns); ++i)
    bytes += append_cell(sqlite3_column_value(statement, i), texts, cells);
  return bytes;
}

} // namespace parlour::adapters
