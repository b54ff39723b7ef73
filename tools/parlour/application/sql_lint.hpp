// Lint "sql": whether the SQL of an application's scripts fits its database,
// which is made in memory from schema and seed.
#pragma once

#include <filesystem>

#include "script/compiler/compiler.hpp"
#include "tools/parlour/application/composition.hpp"

namespace parlour::tools {

// Adds warnings to `compiled.findings`. Silent where the application has no
// database of its own making, or one whose SQL fails (which is told elsewhere).
void lint_sql(script::Compiled& compiled, const Composition& composition,
              const std::filesystem::path& application);

} // namespace parlour::tools
