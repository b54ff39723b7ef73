// The language as an XML Schema (XSD 1.0).
#pragma once

#include <string>

namespace parlour::script {

std::string xml_schema();

} // namespace parlour::script
