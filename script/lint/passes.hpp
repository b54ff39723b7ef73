// The passes of the lint: each looks for a few of the lints and knows nothing
// of the others.
#pragma once

#include "script/lint/subject.hpp"

namespace parlour::script::lint {

using Pass = void (*)(const Subject&, Findings&);

void lint_states(const Subject& subject, Findings& findings);
void lint_functions(const Subject& subject, Findings& findings);
void lint_variables(const Subject& subject, Findings& findings);
void lint_messages(const Subject& subject, Findings& findings);
void lint_events(const Subject& subject, Findings& findings);
void lint_routes(const Subject& subject, Findings& findings);
void lint_slots(const Subject& subject, Findings& findings);
void lint_loops(const Subject& subject, Findings& findings);
void lint_conditions(const Subject& subject, Findings& findings);
void lint_fields(const Subject& subject, Findings& findings);
void lint_arguments(const Subject& subject, Findings& findings);
void lint_lists(const Subject& subject, Findings& findings);
void lint_time(const Subject& subject, Findings& findings);
void lint_texts(const Subject& subject, Findings& findings);
void lint_examples(const Subject& subject, Findings& findings);
void lint_computing(const Subject& subject, Findings& findings);
void lint_joined_sql(const Subject& subject, Findings& findings);
void lint_habits(const Subject& subject, Findings& findings);
void lint_partners(const Subject& subject, Findings& findings);
void lint_frames(const Subject& subject, Findings& findings);
void lint_repetitions(const Subject& subject, Findings& findings);
void lint_allowances(const Subject& subject, Findings& findings);

} // namespace parlour::script::lint
