// What an application's components will read when they start, read now: the
// database's SQL, columns that slots and grammars name, grammars. Creates
// nothing on the disk.
#pragma once

#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// Adds to the findings. Without a program only databases are looked at.
void check_resources(Application& application);

} // namespace parlour::tools
