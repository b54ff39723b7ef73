// Value and its containers. Numbers compare exactly across types; maps keep the
// order of their entries and find keys by a hash index once they are large.

#include "runtime/base/value.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>

#include "runtime/base/text/decimal.hpp"

namespace parlour {

namespace {

const Value unknown_value;

constexpr std::size_t searched = 16; // entries; larger maps have a hash index
constexpr std::size_t usual = 4;     // entries of most maps that are filled

// Column names ignore the case of ASCII letters, as most databases do.
bool same_text(std::string_view left, std::string_view right) {
  auto lower = [](char c) {
    return std::tolower(static_cast<unsigned char>(c));
  };
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [&](char a, char b) { return lower(a) == lower(b); });
}

std::string_view trimmed(std::string_view text) {
  constexpr auto blanks = " \t\r\n";
  auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// A sign, digits, then optionally a point with digits and an exponent. This is
// checked first because from_chars also accepts "inf", "nan", "5." and ".5".
bool has_number_form(std::string_view text) {
  std::size_t position = text.starts_with('-') || text.starts_with('+');
  auto digits = [&] {
    auto start = position;
    while (position < text.size() &&
           std::isdigit(static_cast<unsigned char>(text[position])))
      ++position;
    return position > start;
  };
  if (!digits())
    return false;
  if (position < text.size() && text[position] == '.') {
    ++position;
    if (!digits())
      return false;
  }
  if (position < text.size() && (text[position] | 0x20) == 'e') {
    ++position;
    if (position < text.size() &&
        (text[position] == '-' || text[position] == '+'))
      ++position;
    if (!digits())
      return false;
  }
  return position == text.size();
}

bool equal_numbers(const Value& left, const Value& right) {
  if (left.if_integer() && right.if_integer())
    return *left.if_integer() == *right.if_integer();
  if (left.if_number() && right.if_number())
    return *left.if_number() == *right.if_number();
  // Converting the integer to a double could round it. The double is converted
  // instead, if it is integral and in range, which is exact.
  auto integer = *(left.if_integer() ? left : right).if_integer();
  auto number = *(left.if_number() ? left : right).if_number();
  return std::trunc(number) == number && std::abs(number) < 9.3e18 &&
         number >= -9223372036854775808.0 && number < 9223372036854775808.0 &&
         static_cast<std::int64_t>(number) == integer;
}

bool is_numeric(const Value& value) {
  return value.if_integer() || value.if_number();
}

} // namespace

Map::Map(std::initializer_list<Entry> entries) {
  entries_.reserve(entries.size());
  for (const auto& entry : entries)
    set(entry.first, entry.second);
}

std::size_t Map::size() const {
  return entries_.size();
}

bool Map::empty() const {
  return entries_.empty();
}

// The position of a key; size() if it is missing. Linear below `searched`
// entries, which is faster than hashing for so few.
std::size_t Map::position(std::string_view key) const {
  if (index_.empty()) {
    const auto found =
        std::find_if(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return entry.first == key; });
    return static_cast<std::size_t>(found - entries_.begin());
  }
  const auto mask = index_.size() - 1;
  for (auto at = std::hash<std::string_view>()(key) & mask; index_[at] != 0;
       at = (at + 1) & mask)
    if (entries_[index_[at] - 1].first == key)
      return index_[at] - 1;
  return entries_.size();
}

// Enters one position into the index, which must have a free place.
void Map::index(std::size_t position) {
  const auto mask = index_.size() - 1;
  auto at = std::hash<std::string_view>()(entries_[position].first) & mask;
  while (index_[at] != 0)
    at = (at + 1) & mask;
  index_[at] = static_cast<std::uint32_t>(position + 1);
}

// Four times as many places as entries, rounded up to a power of two so that a
// hash is reduced by a mask. The index is rebuilt when half of it is used.
void Map::rebuild_index() {
  index_.clear();
  if (entries_.size() <= searched)
    return;
  index_.resize(std::bit_ceil(entries_.size() * 4));
  for (std::size_t i = 0; i < entries_.size(); ++i)
    index(i);
}

const Value* Map::find(std::string_view key) const {
  const auto at = position(key);
  return at < entries_.size() ? &entries_[at].second : nullptr;
}

// A new key is appended; the index is extended, or rebuilt when it is half
// full.
void Map::set(std::string_view key, Value value) {
  if (const auto at = position(key); at < entries_.size()) {
    entries_[at].second = std::move(value);
    return;
  }
  if (entries_.empty())
    entries_.reserve(usual);
  entries_.emplace_back(std::string(key), std::move(value));
  if (entries_.size() > searched && entries_.size() * 2 > index_.size())
    rebuild_index();
  else if (!index_.empty())
    index(entries_.size() - 1);
}

void Map::erase(std::string_view key) {
  const auto at = position(key);
  if (at == entries_.size())
    return;
  // Erasing moves all later entries, so their positions in the index change.
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(at));
  rebuild_index();
}

// The order of the entries does not count.
bool Map::operator==(const Map& other) const {
  if (size() != other.size())
    return false;
  return std::all_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    const auto* value = other.find(entry.first);
    return value && *value == entry.second;
  });
}

Columns::Columns(std::vector<std::string> names) {
  if (!names.empty())
    names_ = std::make_shared<const std::vector<std::string>>(std::move(names));
}

Columns::Columns(std::initializer_list<std::string> names)
    : Columns(std::vector<std::string>(names)) {}

// Results of one statement usually share their columns, so the pointers are
// compared first.
bool Columns::operator==(const Columns& other) const {
  return names_ == other.names_ || names() == other.names();
}

const std::vector<std::string>& Columns::none() {
  static const std::vector<std::string> nothing;
  return nothing;
}

std::size_t ResultSet::row_count() const {
  return columns.empty() ? 0 : cells.size() / columns.size();
}

// The first column of that name counts.
const Value* ResultSet::cell(std::size_t row, std::string_view column) const {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (same_text(columns[i], column) && row < row_count())
      return &cells[row * columns.size() + i];
  return nullptr;
}

bool ResultSet::operator==(const ResultSet& other) const {
  return columns == other.columns && cells == other.cells;
}

std::string_view name_of(ValueType type) {
  constexpr std::array<std::string_view, 9> names{
      "unknown", "boolean", "integer", "number", "string",
      "list",    "map",     "result",  "binary"};
  return names[static_cast<std::size_t>(type)];
}

Value::Value(std::string value)
    : data_(std::make_shared<const std::string>(std::move(value))) {}

Value::Value(std::string_view value)
    : data_(std::make_shared<const std::string>(value)) {}

Value::Value(List value)
    : data_(std::make_shared<const List>(std::move(value))) {}

Value::Value(Map value)
    : data_(std::make_shared<const Map>(std::move(value))) {}

Value::Value(ResultSet value)
    : data_(std::make_shared<const ResultSet>(std::move(value))) {}

Value::Value(Binary value)
    : data_(std::make_shared<const Binary>(std::move(value))) {}

const Value& Value::operator[](std::string_view key) const {
  const auto* map = if_map();
  const auto* value = map ? map->find(key) : nullptr;
  return value ? *value : unknown_value;
}

const Value& Value::at(std::size_t position) const {
  const auto* list = if_list();
  return list && position < list->size() ? (*list)[position] : unknown_value;
}

std::string Value::text() const {
  const auto* string = if_string();
  return string ? *string : to_string(*this);
}

double Value::number_or(double otherwise) const {
  if (const auto* integer = if_integer())
    return static_cast<double>(*integer);
  const auto* number = if_number();
  return number ? *number : otherwise;
}

// Numbers beyond 64 bits have no integer and give `otherwise`.
std::int64_t Value::integer_or(std::int64_t otherwise) const {
  if (const auto* integer = if_integer())
    return *integer;
  const auto* number = if_number();
  return number && std::abs(*number) < 9e18 ? static_cast<std::int64_t>(*number)
                                            : otherwise;
}

Value::operator bool() const {
  switch (type()) {
  case ValueType::unknown:
    return false;
  case ValueType::boolean:
    return *if_boolean();
  case ValueType::integer:
    return *if_integer() != 0;
  case ValueType::number:
    return *if_number() != 0;
  case ValueType::string:
    return !if_string()->empty();
  case ValueType::list:
    return !if_list()->empty();
  case ValueType::map:
    return !if_map()->empty();
  case ValueType::result:
    return if_result()->row_count() > 0;
  case ValueType::binary:
    return true;
  }
  return false;
}

// Numbers first, also against strings that are written like numbers; then
// values of the same type; everything else is unequal (language rule 3.5).
bool Value::operator==(const Value& other) const {
  if (is_numeric(*this) && is_numeric(other))
    return equal_numbers(*this, other);
  if (is_numeric(*this) && other.if_string())
    return *this == parse_number(*other.if_string());
  if (if_string() && is_numeric(other))
    return parse_number(*if_string()) == other;
  if (type() != other.type())
    return false;
  switch (type()) {
  case ValueType::unknown:
    return true;
  case ValueType::boolean:
    return *if_boolean() == *other.if_boolean();
  case ValueType::string:
    return *if_string() == *other.if_string();
  case ValueType::list:
    return *if_list() == *other.if_list();
  case ValueType::map:
    return *if_map() == *other.if_map();
  case ValueType::result:
    return *if_result() == *other.if_result();
  case ValueType::binary:
    return *if_binary() == *other.if_binary();
  default:
    return false; // numbers were compared above
  }
}

// Containers print their elements without quotes (language rule 2.2).
namespace {

std::string joined(const List& list) {
  std::string text = "[";
  for (const auto& element : list)
    text += (&element == list.data() ? "" : ", ") + to_string(element);
  return text + "]";
}

std::string joined(const Map& map) {
  std::string text = "{";
  for (const auto& [key, value] : map.entries())
    text += (text.size() > 1 ? ", " : "") + key + ": " + to_string(value);
  return text + "}";
}

} // namespace

std::string to_string(const Value& value) {
  switch (value.type()) {
  case ValueType::unknown:
    return "unknown";
  case ValueType::boolean:
    return *value.if_boolean() ? "true" : "false";
  case ValueType::integer:
    return std::to_string(*value.if_integer());
  case ValueType::number:
    return number_text(*value.if_number());
  case ValueType::string:
    return *value.if_string();
  case ValueType::list:
    return joined(*value.if_list());
  case ValueType::map:
    return joined(*value.if_map());
  case ValueType::result:
    return joined(value.if_result()->cells);
  case ValueType::binary:
    return "binary(" + std::to_string(value.if_binary()->bytes.size()) + ")";
  }
  return {};
}

std::string number_text(double number) {
  return decimal_text(decimal_of(number));
}

// An integer if it fits into 64 bits, else a number, which rounds.
Value parse_number(std::string_view text) {
  text = trimmed(text);
  if (!has_number_form(text))
    return {};
  if (text.starts_with('+'))
    text.remove_prefix(1);
  std::int64_t integer = 0;
  const auto* end = text.data() + text.size();
  if (auto [stop, error] = std::from_chars(text.data(), end, integer);
      error == std::errc{} && stop == end)
    return integer;
  double number = 0;
  auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stop == end ? Value(number) : Value();
}

} // namespace parlour
