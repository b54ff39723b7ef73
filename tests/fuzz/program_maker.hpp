// ProgramMaker: makes a script that compiles from any bytes. Each decision (a
// statement, an operand, a name) uses up one byte; when there are none left, it
// takes the simplest alternative, so that every script is finite.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::fuzz {

class ProgramMaker {
public:
  explicit ProgramMaker(std::string_view bytes) : bytes_(bytes) {}

  std::string make();

private:
  std::size_t choose(std::size_t count);
  template <std::size_t count>
  const char* one_of(const char* const (&all)[count]) {
    return all[choose(count)];
  }
  std::string variable();
  std::string new_variable();
  std::string attribute(const char* name, const std::string& value);
  void element(const std::string& start, const char* name);

  std::string expression(int depth = 3);
  std::string literal();
  std::string operation(int depth);
  std::string builtin_call(int depth);
  std::string function_call(int depth);

  void function(std::size_t number);
  void block(int depth);
  void statement(int depth);
  void simple_statement();
  void assignment();
  void loop(int depth);
  void branch(int depth);
  void arms(int depth, const char* name, const char* condition,
            const std::string& start);
  void call();
  void effect(int depth);

  std::string_view bytes_;
  std::string script_;
  std::vector<std::string> scope_;
  std::size_t functions_ = 1; // without main
  std::size_t named_ = 0;
  int loops_ = 0;
};

} // namespace parlour::fuzz
