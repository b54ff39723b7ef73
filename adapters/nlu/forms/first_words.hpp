// Words with which a form may begin. Most words of most sentences are none, and
// trying each reader at each of them would be half of the work of
// understanding.
#pragma once

#include <string_view>

namespace parlour::adapters::nlu {

// Whether a time, date, number, duration, telephone number or level may begin
// with the word; e-mail addresses may begin with any. A reader that accepts
// another first word must name it here.
bool may_begin_form(std::string_view word);

} // namespace parlour::adapters::nlu
