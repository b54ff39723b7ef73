// Whether something is as an `expect` line says. Pure.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "runtime/message/message.hpp"
#include "tools/parlour/application/plugins/module_names.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

// Equal values, or values that are written in the same way.
bool is_as_expected(const Value& expected, const Value& found);
// Whether the message is the one of `expect post`.
bool is_as_expected(const Step& step, const Message& post,
                    const ModuleNames& names);
// Whether the robot said what `R:` or `R~` expects.
bool is_as_expected(const Step& step, const std::string& said);
// Which of the outputs in a row the first of these lines is about: the first
// one; if it is a pattern, as many as it matches, a line each. Lines of the
// robot right behind it have one output each left. `outputs` is not empty.
std::vector<std::string> outputs_for(std::span<const Step> lines,
                                     const std::deque<std::string>& outputs);
std::string as_lines(const std::vector<std::string>& outputs);
// Asks the database for `expect sql`.
Message sql_question(const std::string& query);
// One cell as a value, several as a list; unknown if there is none.
Value cells_of(const ResultSet& rows);

} // namespace parlour::tools
