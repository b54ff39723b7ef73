// Reads now what the components of an application will read when they start:
// the SQL of databases, the columns that slots and grammars name, grammars and
// other files. Mistakes in them become findings. Writes nothing to the disk.
#pragma once

#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// A column that a slot takes its values from, and the place of its name.
struct NamedColumn {
  std::string name; // "db:robot.name"
  SourceLocation place;
};
// All such columns of an application, from the <cardinality> elements.
std::vector<NamedColumn> columns_of_slots(const script::Compiled& compiled);

// Adds findings to the application. If its scripts have errors (`program` is
// null), only databases and files are checked.
void check_resources(Application& application,
                     const std::vector<NamedColumn>& columns);

} // namespace parlour::tools
