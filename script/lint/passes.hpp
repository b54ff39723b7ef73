// The passes. Each function finds a few lints and knows nothing of the others.
// A new pass is declared here and listed in lint.cpp.
//
// What all passes have in common: they warn only if they are sure, say what to
// write instead, and stay silent about what may be in files that they cannot
// see.
#pragma once

#include "script/lint/lint_context.hpp"

namespace parlour::script::lint {

// Reads the application and adds warnings.
using Pass = void (*)(const LintContext&, Findings&);

void lint_states(const LintContext& context, Findings& findings);
void lint_functions(const LintContext& context, Findings& findings);
void lint_variables(const LintContext& context, Findings& findings);
void lint_messages(const LintContext& context, Findings& findings);
void lint_events(const LintContext& context, Findings& findings);
void lint_routes(const LintContext& context, Findings& findings);
void lint_slots(const LintContext& context, Findings& findings);
void lint_loops(const LintContext& context, Findings& findings);
void lint_conditions(const LintContext& context, Findings& findings);
void lint_fields(const LintContext& context, Findings& findings);
void lint_arguments(const LintContext& context, Findings& findings);
void lint_lists(const LintContext& context, Findings& findings);
void lint_time(const LintContext& context, Findings& findings);
void lint_texts(const LintContext& context, Findings& findings);
void lint_examples(const LintContext& context, Findings& findings);
void lint_computing(const LintContext& context, Findings& findings);
void lint_joined_sql(const LintContext& context, Findings& findings);
void lint_habits(const LintContext& context, Findings& findings);
void lint_partners(const LintContext& context, Findings& findings);
void lint_columns(const LintContext& context, Findings& findings);
void lint_frames(const LintContext& context, Findings& findings);
void lint_repetitions(const LintContext& context, Findings& findings);
void lint_allowances(const LintContext& context, Findings& findings);

} // namespace parlour::script::lint
