// Reads the columns of databases that slots and grammars take their values
// from: "db:robot.name" is a column of the first database,
// "db:Archive.robot.name" one of the database component "Archive".
#pragma once

#include <filesystem>
#include <string>

#include "runtime/message/understanding.hpp"
#include "tools/parlour/application/composition.hpp"

namespace parlour::tools {

// The reader returns the distinct values of a column, or an error, of kind
// Settings if there is no such database. It blocks while it reads. SQLite's
// values come from the run's database in `data_folder`, or from schema and seed
// if that is empty; MariaDB's come from its server, or from schema and seed for
// a copy (rehearsed).
ColumnReader column_reader(const Composition& composition,
                           const std::filesystem::path& application,
                           const std::string& data_folder);

} // namespace parlour::tools
