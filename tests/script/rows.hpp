// Tables of expressions and their results.
#pragma once

#include <string>
#include <vector>

namespace parlour::test {

struct Row {
  std::string expression;
  std::string result; // as it is printed, or "Kind: message" for an error
};

// Evaluates all rows in one script, one after the other.
void expect_rows(const std::vector<Row>& rows);

} // namespace parlour::test
