// Columns for value sets: "db:robot.name" of the first database, and
// "db:Archive.robot.name" of the one that is called so.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/understanding.hpp"
#include "tools/parlour/application/composition.hpp"

namespace parlour::tools {

// An error where there is no such database. With an empty data folder, of what
// schema and seed make.
ColumnReader column_reader(const Composition& composition,
                           const std::filesystem::path& application,
                           const std::string& data_folder);

} // namespace parlour::tools
