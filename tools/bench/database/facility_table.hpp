// The table that the database benches query: 600 rows, found by name.
#pragma once

#include <cstddef>
#include <string>

namespace parlour::tools {

constexpr int facilities = 600;

// SQL that SQLite and MariaDB both accept.
std::string facility_schema();
std::string facility_seed();

// Finds one row; the placeholder is its name.
inline constexpr auto facility_query =
    "select id, name, category, floor, description, contact from facility "
    "where name = ?";
constexpr std::size_t facility_columns = 6;
constexpr std::size_t description_column = 4;

// The name for which query number `i` asks. Successive queries ask for rows
// that lie apart.
std::string facility_name(std::size_t i);

} // namespace parlour::tools
