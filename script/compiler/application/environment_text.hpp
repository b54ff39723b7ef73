// Values in settings.xml: ${NAME} of the environment in an attribute, and the
// options of a plug-in, which may have it.
#pragma once

#include <map>
#include <string>

#include "script/source/findings.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

// The value of a variable of the environment; empty if there is none.
using Environment = std::string (*)(const std::string&);

// The attribute's value with each ${NAME} replaced by its value in the
// environment. A variable that is missing or empty becomes a warning; if
// `environment` is null, all are empty. No finding quotes a value, as it may be
// a password.
std::string with_environment(const Attribute& attribute,
                             Environment environment, Findings& findings);

// The <option> children of the element, which belong to `whose`. One that is
// there already is an error, and keeps its value.
void read_options(const Element& element, const std::string& whose,
                  Environment environment, Findings& findings,
                  std::map<std::string, std::string>& options);

} // namespace parlour::script
