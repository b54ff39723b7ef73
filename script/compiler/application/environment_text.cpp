#include "script/compiler/application/environment_text.hpp"

#include <utility>

namespace parlour::script {

namespace {

// An empty variable of the environment counts as missing.
std::string variable(const std::string& name, Position position,
                     Environment environment, Findings& findings) {
  auto value = environment ? environment(name) : std::string();
  if (value.empty())
    findings.add(
        {Severity::warning,
         {position},
         "the environment has no '" + name + "'; ${" + name + "} is empty",
         "missing-environment"});
  return value;
}

} // namespace

std::string with_environment(const Attribute& attribute,
                             Environment environment, Findings& findings) {
  const auto& value = attribute.value;
  std::string result;
  std::size_t done = 0;
  // `done` is the end of what has been copied to the result.
  for (auto at = value.find("${"); at != std::string::npos;
       at = value.find("${", done)) {
    const auto end = value.find('}', at);
    if (end == std::string::npos) {
      findings.error(attribute.value_position, "${ without its }");
      return {};
    }
    result += value.substr(done, at - done);
    result += variable(value.substr(at + 2, end - at - 2),
                       attribute.value_position, environment, findings);
    done = end + 1;
  }
  return result + value.substr(done);
}

void read_options(const Element& element, const std::string& whose,
                  Environment environment, Findings& findings,
                  std::map<std::string, std::string>& options) {
  for (const auto& option : element.children) {
    const auto name = option.value("name");
    auto value =
        with_environment(*option.attribute("value"), environment, findings);
    if (!options.emplace(name, std::move(value)).second)
      findings.error(option.position, "the option '" + name + "' of '" + whose +
                                          "' is given twice");
  }
}

} // namespace parlour::script
