// unknown-lint: a comment allows a warning that does not exist.
//
//   <!-- check: allow unred-variable -->    did you mean 'unread-variable'?
//
// An allowance that is not needed is no mistake: it may be needed again.
#include "script/lint/lints.hpp"
#include "script/lint/passes.hpp"
#include "script/xml/allowances.hpp"

namespace parlour::script::lint {

namespace {

Position place_of(const std::string& name, const Allowance& allowance,
                  const SourceText& source, std::uint16_t file) {
  auto position = source.at(source.text().find(name, allowance.begin));
  position.file = file;
  return position;
}

} // namespace

void lint_allowances(const LintContext&, Findings& findings) {
  std::vector<std::string> known;
  for (const auto& one : lints())
    known.push_back(one.name);
  for (std::size_t i = 0; i < findings.files().size(); ++i) {
    const auto file = static_cast<std::uint16_t>(i);
    for (const auto& allowance : read_allowances(findings.text(file).text()))
      for (const auto& name : allowance.names)
        if (!is_lint(name))
          warn(findings, "unknown-lint",
               place_of(name, allowance, findings.text(file), file),
               "there is no lint '" + name + "'" +
                   (did_you_mean(name, known).empty()
                        ? "; parlour check --help lists them"
                        : did_you_mean(name, known)));
  }
}

} // namespace parlour::script::lint
