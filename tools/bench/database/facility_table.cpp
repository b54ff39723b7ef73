#include "tools/bench/database/facility_table.hpp"

#include <fmt/format.h>

namespace parlour::tools {

std::string facility_schema() {
  return "create table facility (id integer primary key, name varchar(64) "
         "not null unique, category varchar(32), floor varchar(16), "
         "description varchar(128), contact varchar(32)) "
         "/*! character set utf8mb4 collate utf8mb4_nopad_bin */;\n";
}

std::string facility_seed() {
  std::string all;
  for (int i = 0; i < facilities; ++i)
    all += fmt::format("insert into facility values ({}, 'facility {}', "
                       "'cat {}', '{}', 'a description of the facility number "
                       "{} on the floor', '6555-{:04}');\n",
                       i, i, i % 10, i % 24, i, i);
  return all;
}

std::string facility_name(std::size_t i) {
  // 7 and 600 have no common divisor, so all rows are asked for in turn.
  return "facility " + std::to_string(i * 7 % facilities);
}

} // namespace parlour::tools
