// Tables of expressions and what becomes of them.
#pragma once

#include <string>
#include <vector>

namespace parlour::test {

struct Row {
  std::string expression;
  std::string result; // printed; "Kind: message" of an error
};

// Runs them in one script, one after the other.
void expect_rows(const std::vector<Row>& rows);

} // namespace parlour::test
