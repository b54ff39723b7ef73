// The language as a RELAX NG schema (XML syntax).
#pragma once

#include <string>

namespace parlour::script {

std::string relax_ng_schema();

} // namespace parlour::script
