// MariaDB's binary protocol: values are exchanged through buffers whose
// addresses the library is told (MYSQL_BIND). MariaDBParameters owns those of a
// statement's placeholders, MariaDBRow those of a result's columns.
#include "adapters/database/mariadb/connection/mariadb_values.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <mysql.h>

#include "adapters/database/row_texts.hpp"
#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters {

namespace {

// The number of the character set "binary", which tells blobs from texts.
constexpr unsigned binary_charset = 63;
// The initial buffer of a text cell, and the size beyond which buffers are
// freed.
constexpr std::size_t first_size = 256;
constexpr std::size_t large_size = 16 << 10;

// A placeholder as an error message names it: ":level" or "number 2".
std::string label(const std::vector<std::string>& names, std::size_t place) {
  return names[place].empty() ? "number " + std::to_string(place + 1)
                              : ":" + names[place];
}

// The error messages are those of SQLite, since a script may use either
// database.
Expected<List> by_position(const List& values, std::size_t count) {
  if (count == values.size())
    return values;
  return fail(ErrorKind::type,
              "it has " + std::to_string(count) + " placeholder" +
                  (count == 1 ? "" : "s") + ", but " +
                  std::to_string(values.size()) + " value" +
                  (values.size() == 1 ? " is" : "s are") + " given.");
}

Expected<List> by_name(const Map& values,
                       const std::vector<std::string>& names) {
  List ordered;
  for (std::size_t place = 0; place < names.size(); ++place) {
    const auto* value = values.find(names[place]);
    if (!value)
      return fail(ErrorKind::type, "no value is given for placeholder " +
                                       label(names, place) + ".");
    ordered.push_back(*value);
  }
  for (const auto& [name, value] : values.entries())
    if (std::find(names.begin(), names.end(), name) == names.end())
      return fail(ErrorKind::type, "more values are given than it has "
                                   "placeholders.");
  return ordered;
}

Expected<List> arrange(const Value& values,
                       const std::vector<std::string>& names) {
  if (const auto* map = values.if_map())
    return by_name(*map, names);
  if (const auto* list = values.if_list())
    return by_position(*list, names.size());
  if (values.is_unknown())
    return by_position({}, names.size());
  return fail(ErrorKind::type, "its values are a list or a map, not a " +
                                   std::string(name_of(values.type())) + ".");
}

// The library does not write to the buffers of parameters, so const may be
// removed.
void point_at(MYSQL_BIND& bind, enum_field_types type, const void* first,
              std::size_t length) {
  bind.buffer_type = type;
  bind.buffer = const_cast<void*>(first);
  bind.buffer_length = length;
}

// A decimal becomes a number; one that cannot be read as a number stays a text.
Value decimal(std::string_view digits) {
  const auto number = parse_number(digits);
  return number.is_unknown() ? Value(digits) : number;
}

// A column of type BIT arrives as bytes, the most significant first.
std::int64_t bits(std::string_view bytes) {
  std::uint64_t number = 0;
  for (char byte : bytes)
    number = number << 8 | static_cast<unsigned char>(byte);
  return static_cast<std::int64_t>(number);
}

Binary blob(std::string_view bytes) {
  const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
  return {"application/octet-stream", {first, first + bytes.size()}};
}

} // namespace

Expected<List> values_in_order(const Value& values,
                               const std::vector<std::string>& names) {
  auto ordered = arrange(values, names);
  for (std::size_t place = 0; ordered && place < ordered->size(); ++place) {
    const auto& value = (*ordered)[place];
    if (value.if_list() || value.if_map() || value.if_result())
      return fail(ErrorKind::type,
                  "placeholder " + label(names, place) +
                      " takes a text, number or boolean, not a " +
                      std::string(name_of(value.type())) + ".");
    if (const auto* text = value.if_string(); text && find_invalid_utf8(*text))
      return fail(ErrorKind::type, "the value of placeholder " +
                                       label(names, place) +
                                       " is not valid UTF-8.");
  }
  return ordered;
}

// The buffer of one placeholder. `type` keeps its value while the placeholder
// is NULL, so that NULL does not count as a change of type.
struct MariaDBParameters::Parameter {
  void take(const Value& value);
  bool fits(const MYSQL_BIND& bind) const {
    return bind.buffer_type == type && bind.buffer == buffer();
  }
  // Makes `bind` point to this buffer.
  void point(MYSQL_BIND& bind);

  enum_field_types type = MYSQL_TYPE_NULL;
  my_bool is_null = 1;
  std::int64_t integer = 0;
  double number = 0;
  std::string bytes;
  unsigned long length = 0;

private:
  const void* buffer() const;
  void take_bytes(enum_field_types of_type, const void* first,
                  std::size_t size);
};

void MariaDBParameters::Parameter::take_bytes(enum_field_types of_type,
                                              const void* first,
                                              std::size_t size) {
  type = of_type;
  bytes.assign(static_cast<const char*>(first), size);
  length = size;
}

// Copies a value. The caller has checked that it is of a type that fits.
void MariaDBParameters::Parameter::take(const Value& value) {
  is_null = value.is_unknown();
  if (const auto* boolean = value.if_boolean()) {
    type = MYSQL_TYPE_LONGLONG;
    integer = *boolean ? 1 : 0;
  } else if (const auto* whole = value.if_integer()) {
    type = MYSQL_TYPE_LONGLONG;
    integer = *whole;
  } else if (const auto* real = value.if_number()) {
    type = MYSQL_TYPE_DOUBLE;
    number = *real;
  } else if (const auto* text = value.if_string()) {
    take_bytes(MYSQL_TYPE_STRING, text->data(), text->size());
  } else if (const auto* binary = value.if_binary()) {
    take_bytes(MYSQL_TYPE_BLOB, binary->bytes.data(), binary->bytes.size());
  }
}

const void* MariaDBParameters::Parameter::buffer() const {
  if (type == MYSQL_TYPE_LONGLONG)
    return &integer;
  if (type == MYSQL_TYPE_DOUBLE)
    return &number;
  return bytes.data();
}

void MariaDBParameters::Parameter::point(MYSQL_BIND& bind) {
  point_at(bind, type, buffer(), bytes.size());
  bind.length = &length;
  bind.is_null = &is_null;
}

MariaDBParameters::MariaDBParameters() = default;

MariaDBParameters::MariaDBParameters(MariaDBParameters&&) noexcept = default;

MariaDBParameters&
MariaDBParameters::operator=(MariaDBParameters&&) noexcept = default;

MariaDBParameters::~MariaDBParameters() = default;

Expected<void> MariaDBParameters::take(const Value& values,
                                       const std::vector<std::string>& names) {
  const auto ordered = values_in_order(values, names);
  if (!ordered)
    return tl::make_unexpected(ordered.error());
  parameters_.resize(names.size());
  binds_.resize(names.size());
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    parameters_[i].take((*ordered)[i]);
    // Binding again is necessary only if a type or an address has changed.
    if (parameters_[i].fits(binds_[i]))
      continue;
    parameters_[i].point(binds_[i]);
    is_bound_ = false;
  }
  return {};
}

bool MariaDBParameters::bind(MYSQL_STMT* statement) {
  if (!is_bound_ && !binds_.empty())
    is_bound_ = mysql_stmt_bind_param(statement, binds_.data()) == 0;
  return is_bound_ || binds_.empty();
}

bool MariaDBParameters::are_large() const {
  return std::any_of(parameters_.begin(), parameters_.end(),
                     [](const Parameter& parameter) {
                       return parameter.bytes.capacity() > large_size;
                     });
}

// The buffer of one column.
struct MariaDBRow::Cell {
  enum class As : std::uint8_t { integer, number, decimal, bits, text, blob };

  static As kind_of(const MYSQL_FIELD& field);
  bool fits(const MYSQL_FIELD& field) const;
  void point(MYSQL_BIND& bind);
  Value value(RowTexts& texts) const;

  As as = As::text;
  bool is_unsigned = false;
  std::int64_t integer = 0;
  double number = 0;
  std::string bytes;
  unsigned long length = 0;
  my_bool is_null = 0;
  my_bool cut = 0;
};

// How a column is read. Dates and times are read as texts, which the server
// formats.
MariaDBRow::Cell::As MariaDBRow::Cell::kind_of(const MYSQL_FIELD& field) {
  switch (field.type) {
  case MYSQL_TYPE_TINY:
  case MYSQL_TYPE_SHORT:
  case MYSQL_TYPE_INT24:
  case MYSQL_TYPE_LONG:
  case MYSQL_TYPE_LONGLONG:
  case MYSQL_TYPE_YEAR:
    return As::integer;
  case MYSQL_TYPE_FLOAT:
  case MYSQL_TYPE_DOUBLE:
    return As::number;
  case MYSQL_TYPE_DECIMAL:
  case MYSQL_TYPE_NEWDECIMAL:
    return As::decimal;
  case MYSQL_TYPE_BIT:
    return As::bits;
  case MYSQL_TYPE_TINY_BLOB:
  case MYSQL_TYPE_MEDIUM_BLOB:
  case MYSQL_TYPE_LONG_BLOB:
  case MYSQL_TYPE_BLOB:
  case MYSQL_TYPE_VAR_STRING:
  case MYSQL_TYPE_STRING:
    return field.charsetnr == binary_charset ? As::blob : As::text;
  default:
    return As::text;
  }
}

bool MariaDBRow::Cell::fits(const MYSQL_FIELD& field) const {
  return as == kind_of(field) &&
         is_unsigned == ((field.flags & UNSIGNED_FLAG) != 0);
}

// Tells the library to write into this buffer. Integers and floating-point
// numbers are converted to the widest type by the library.
void MariaDBRow::Cell::point(MYSQL_BIND& bind) {
  bind.is_null = &is_null;
  bind.length = &length;
  bind.error = &cut;
  bind.is_unsigned = is_unsigned;
  if (as == As::integer)
    return point_at(bind, MYSQL_TYPE_LONGLONG, &integer, sizeof integer);
  if (as == As::number)
    return point_at(bind, MYSQL_TYPE_DOUBLE, &number, sizeof number);
  // A longer text arrives truncated, and append_to fetches it again.
  const bool is_bytes = as == As::blob || as == As::bits;
  bytes.resize(std::max(bytes.size(), first_size));
  point_at(bind, is_bytes ? MYSQL_TYPE_BLOB : MYSQL_TYPE_STRING, bytes.data(),
           bytes.size());
}

// An unsigned integer beyond the signed range becomes a floating-point number.
Value MariaDBRow::Cell::value(RowTexts& texts) const {
  const auto said = std::string_view(bytes).substr(0, length);
  switch (as) {
  case As::integer:
    return is_unsigned && integer < 0
               ? Value(static_cast<double>(static_cast<std::uint64_t>(integer)))
               : Value(integer);
  case As::number:
    return number;
  case As::decimal:
    return decimal(said);
  case As::bits:
    return bits(said);
  case As::blob:
    return blob(said);
  default:
    return texts.add(said);
  }
}

MariaDBRow::MariaDBRow(MYSQL_RES* description)
    : cells_(mysql_num_fields(description)), binds_(cells_.size()) {
  const auto* fields = mysql_fetch_fields(description);
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    columns.emplace_back(fields[i].name);
    cells_[i].as = Cell::kind_of(fields[i]);
    cells_[i].is_unsigned = (fields[i].flags & UNSIGNED_FLAG) != 0;
    cells_[i].point(binds_[i]);
  }
  columns_ = std::move(columns);
}

MariaDBRow::~MariaDBRow() = default;

// Columns may change between two executions, if the tables are altered.
bool MariaDBRow::fits(MYSQL_RES* description) const {
  const auto* fields = mysql_fetch_fields(description);
  bool fits = mysql_num_fields(description) == cells_.size();
  for (std::size_t i = 0; fits && i < cells_.size(); ++i)
    fits =
        cells_[i].fits(fields[i]) &&
        columns_[i] == std::string_view(fields[i].name, fields[i].name_length);
  return fits;
}

bool MariaDBRow::is_large() const {
  return std::any_of(cells_.begin(), cells_.end(), [](const Cell& cell) {
    return cell.bytes.size() > large_size;
  });
}

bool MariaDBRow::bind(MYSQL_STMT* statement) {
  return mysql_stmt_bind_result(statement, binds_.data()) == 0;
}

std::size_t MariaDBRow::size() const {
  std::size_t bytes = cells_.size() * sizeof(Value);
  for (const auto& cell : cells_)
    bytes += cell.is_null ? 0 : cell.length;
  return bytes;
}

bool MariaDBRow::append_to(List& cells, MYSQL_STMT* statement) {
  RowTexts texts(cells_.size());
  bool has_grown = false;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto& cell = cells_[i];
    // `length` is the length at the server. Integers and numbers have no byte
    // buffer.
    if (!cell.is_null && cell.length > cell.bytes.size() &&
        !cell.bytes.empty()) {
      // The rest of the cell is fetched separately, at its full length.
      cell.bytes.resize(cell.length);
      cell.point(binds_[i]);
      if (mysql_stmt_fetch_column(statement, &binds_[i],
                                  static_cast<unsigned>(i), 0) != 0)
        return false;
      has_grown = true;
    }
    cells.push_back(cell.is_null ? Value() : cell.value(texts));
  }
  // The statement still has the addresses of the old buffers.
  return !has_grown || bind(statement);
}

} // namespace parlour::adapters
