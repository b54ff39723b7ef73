// `parlour bench nlu` measures the understanding of the application
// receptionist: its model, the columns of its database, and what users say in
// its conversations.
#pragma once

#include "tools/bench/nlu/nlu_bench.hpp"
#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// Prints the table. False if something could not be measured, or if `places`
// has no receptionist; the console then tells why.
bool nlu_command(const Places& places, const NluBenchOptions& options,
                 const Console& console);

} // namespace parlour::tools
