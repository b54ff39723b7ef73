// Reads the columns of databases that slots and grammars take their values
// from: "db:robot.name" is a column of the first database,
// "db:Archive.robot.name" one of the database component "Archive".
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/message/understanding.hpp"
#include "tools/parlour/application/plugins/composition.hpp"

namespace parlour::tools {

// The reader returns the distinct values of a column, or an error, of kind
// Settings if there is no such database. It blocks while it reads. SQLite's
// values come from the run's database in `data_folder`, or from schema and seed
// if that is empty; MariaDB's come from its server, or from schema and seed for
// a copy (rehearsed).
ColumnReader column_reader(const Composition& composition,
                           const std::filesystem::path& application,
                           const std::string& data_folder);

// The names of the columns that slots and grammars take values from, each once.
std::vector<std::string> column_names(const UnderstandingModel& model);

// Tells of each component of the composition which of these columns are its
// own, as an option's text: "db:robot.name, db:robot.skill". Keeps no reference
// to its arguments.
std::function<std::string(const std::string& component)>
column_owners(const Composition& composition, std::vector<std::string> columns);

} // namespace parlour::tools
