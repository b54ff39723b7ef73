// The list of passes, and running them over a compiled application.

#include "script/lint/lint.hpp"

#include "script/lint/passes.hpp"
#include "script/xml/allowances.hpp"

// The order does not matter: findings are sorted afterwards.
namespace parlour::script::lint {

namespace {

constexpr Pass passes[] = {
    lint_states,      lint_functions, lint_variables,  lint_messages,
    lint_events,      lint_routes,    lint_slots,      lint_loops,
    lint_conditions,  lint_fields,    lint_arguments,  lint_lists,
    lint_time,        lint_texts,     lint_examples,   lint_computing,
    lint_joined_sql,  lint_habits,    lint_partners,   lint_frames,
    lint_repetitions, lint_columns,   lint_allowances,
};

} // namespace

void lint(Compiled& compiled, const Options& options) {
  if (!compiled.program)
    return;
  const LintContext context{*compiled.program, compiled.documents,
                            compiled.settings ? &*compiled.settings : nullptr,
                            options};
  for (const auto pass : passes)
    pass(context, compiled.findings);
  compiled.findings.sort();
  take_allowed(compiled.findings);
}

} // namespace parlour::script::lint
