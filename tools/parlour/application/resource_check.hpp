// What an application's components will read when they start, read now: the
// database's SQL, columns that slots and grammars name, grammars. Creates
// nothing on the disk.
#pragma once

#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// A column that a slot takes its values from, and where it says so.
struct NamedColumn {
  std::string name; // "db:robot.name"
  Place place;
};
std::vector<NamedColumn> columns_of_slots(const script::Compiled& compiled);

// Adds to the findings. Without a program only databases are looked at.
void check_resources(Application& application,
                     const std::vector<NamedColumn>& columns);

} // namespace parlour::tools
