// The rows of a query's result as maps, for whoever knows no tables: agents,
// services, JSON.
#pragma once

#include "runtime/base/value.hpp"

namespace parlour {

// A map for each row, with the columns in their order. Maps have each name
// once: of columns with the same name, such as those of `select a.name,
// b.name`, the second is called name_2, or the next number that no column has.
// Names that differ in case are different. Takes time linear in the cells.
List rows_as_maps(const ResultSet& result);

} // namespace parlour
