#include "adapters/database/value_watch.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace parlour::adapters {

namespace {

constexpr std::string_view prefix = "db:";

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

std::string table_of(const std::string& column) {
  const auto local = within_database(column);
  return lower(local.substr(prefix.size(), local.find('.') - prefix.size()));
}

} // namespace

std::string within_database(const std::string& column) {
  if (std::ranges::count(column, '.') < 2)
    return column.starts_with(prefix) ? column : std::string(prefix) + column;
  return std::string(prefix) + column.substr(column.find('.') + 1);
}

ValueWatch::ValueWatch(const std::vector<std::string>& columns) {
  for (const auto& name : columns)
    columns_.push_back({name, table_of(name), {}});
}

bool ValueWatch::concerns(const std::set<std::string>& tables) const {
  return std::ranges::any_of(tables, [&](const std::string& table) {
    return std::ranges::count(columns_, lower(table), &Column::table) > 0;
  });
}

ValueWatch::News ValueWatch::look(const Read& read) {
  News news;
  for (auto& column : columns_)
    look(column, read, news);
  return news;
}

void ValueWatch::look(Column& column, const Read& read, News& news) {
  auto values = read(column.name);
  if (!values) {
    // Who reads it for the first time tells of that.
    if (!std::exchange(column.failed, true) && column.was_read)
      news.errors.push_back(values.error());
    return;
  }
  const bool failed = std::exchange(column.failed, false);
  if (std::exchange(column.was_read, true) ? column.values != *values : failed)
    news.changed.emplace_back(column.name, *values);
  column.values = std::move(*values);
}

Message values_changed(const std::string& column,
                       const ValueWatch::Values& values) {
  Message message;
  message.command = "ValuesChanged";
  message.params = {column, List(values.begin(), values.end())};
  return message;
}

} // namespace parlour::adapters
