// The language as a RELAX NG schema in XML syntax, for editors. Made from the
// element table.
#pragma once

#include <string>

namespace parlour::script {

std::string relax_ng_schema();

} // namespace parlour::script
