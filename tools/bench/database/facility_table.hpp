// What the database benchmarks ask for: one row of 600, by its name.
#pragma once

#include <cstddef>
#include <string>

namespace parlour::tools {

constexpr int facilities = 600;

// SQL for any database.
std::string facility_schema();
std::string facility_seed();

// Of one row, with a placeholder for its name.
inline constexpr auto facility_query =
    "select id, name, category, floor, description, contact from facility "
    "where name = ?";
constexpr std::size_t facility_columns = 6;
constexpr std::size_t description_column = 4;

// The name that query number `i` asks for.
std::string facility_name(std::size_t i);

} // namespace parlour::tools
