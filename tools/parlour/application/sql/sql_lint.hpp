// The lint "sql": prepares each SQL statement of the scripts on a database in
// memory that is made from the schema and seed. Nothing is executed.
#pragma once

#include <filesystem>

#include "script/compiler/compiler.hpp"
#include "tools/parlour/application/plugins/composition.hpp"

namespace parlour::tools {

// Adds warnings to `compiled.findings`. Does nothing if the first database has
// no schema, or its SQL fails (resource_check.hpp reports that).
void lint_sql(script::Compiled& compiled, const Composition& composition,
              const std::filesystem::path& application);

} // namespace parlour::tools
