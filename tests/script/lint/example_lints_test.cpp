#include "tests/script/lint/lint_case.hpp"

namespace parlour::script::lint {

INSTANTIATE_TEST_SUITE_P(
    examples, LintCase,
    testing::Values(
        Linted{"<topic name='A'><examples><value>I want a cab!</value>"
               "<value>i want [a cab](S)</value></examples>"
               "<slot name='S'/></topic>\n"
               "<topic name='B'><examples><value>i want a   cab</value>"
               "<value>I want a cat</value></examples></topic>",
               "4:27 same-example"},
        // Courtesy tells nothing apart, another value neither.
        Linted{"<topic name='A'><examples><value>I'd like a cab to "
               "[Bedok](To)</value></examples><slot name='To'/></topic>\n"
               "<topic name='B'><examples><value>a cab to [Tampines](To), "
               "please</value><value>could I pay</value></examples>"
               "<slot name='To'/></topic>",
               "4:27 same-example"},
        // Other slots do, and all words count where there is only courtesy.
        Linted{"<topic name='A'><examples><value>a cab to [Bedok](To)</value>"
               "<value>I want to</value></examples><slot name='To'/></topic>\n"
               "<topic name='B'><examples><value>a cab to [six](Time)</value>"
               "<value>I need to</value></examples><slot name='Time'/></topic>",
               ""},
        Linted{"<topic name='A'><examples><value>a cab</value></examples>"
               "</topic><topic name='B'><examples><value>a cat</value>"
               "</examples></topic>",
               ""}));

} // namespace parlour::script::lint
