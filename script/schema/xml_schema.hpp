// The language as an XML Schema (XSD 1.0), for editors without RELAX NG. It
// says less: see docs/editors.md.
#pragma once

#include <string>

namespace parlour::script {

std::string xml_schema();

} // namespace parlour::script
