#include "tests/fuzz/program_maker.hpp"

#include <utility>

namespace parlour::fuzz {

namespace {

constexpr std::size_t max_functions = 3;
constexpr int deepest = 3;

} // namespace

std::size_t ProgramMaker::choose(std::size_t count) {
  if (bytes_.empty())
    return 0;
  const auto byte = static_cast<unsigned char>(bytes_.front());
  bytes_.remove_prefix(1);
  return byte % count;
}

std::string ProgramMaker::variable() {
  return scope_[choose(scope_.size())];
}

std::string ProgramMaker::new_variable() {
  scope_.push_back("v" + std::to_string(named_++));
  return scope_.back();
}

std::string ProgramMaker::attribute(const char* name,
                                    const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

// -- expressions --------------------------------------------------------------

std::string ProgramMaker::literal() {
  return one_of({"0", "1", "2", "-1", "3.5", "''", "'a'", "'12'", "'Grüße'",
                 "true", "false", "unknown", "[]", "{}", "0.1",
                 "140737488355327", "9223372036854775807", "'x, y'"});
}

std::string ProgramMaker::operation(int depth) {
  const auto left = expression(depth - 1);
  const auto* symbol = one_of({"+", "-", "*", "/", "%", "==", "!=", "lt", "le",
                               "gt", "ge", "in", "and", "or"});
  return "(" + left + ") " + symbol + " (" + expression(depth - 1) + ")";
}

std::string ProgramMaker::builtin_call(int depth) {
  if (choose(2)) {
    const auto* name =
        one_of({"length",  "upper", "lower",   "trim",   "split",    "reverse",
                "sort",    "first", "last",    "keys",   "values",   "abs",
                "floor",   "ceil",  "round",   "sqrt",   "number",   "integer",
                "string",  "type",  "isknown", "tojson", "fromjson", "spoken",
                "ordinal", "list",  "min",     "max",    "an"});
    return std::string(name) + "(" + expression(depth - 1) + ")";
  }
  const auto* name =
      one_of({"append",   "remove",  "indexof", "contains", "startswith",
              "endswith", "find",    "join",    "slice",    "substring",
              "range",    "has",     "pow",     "min",      "max",
              "matches",  "capture", "format",  "count",    "split"});
  const auto left = expression(depth - 1);
  return std::string(name) + "(" + left + ", " + expression(depth - 1) + ")";
}

std::string ProgramMaker::function_call(int depth) {
  auto text =
      "f" + std::to_string(choose(functions_)) + "(" + expression(depth - 1);
  if (choose(2))
    text += ", " + expression(depth - 1);
  return text + ")";
}

std::string ProgramMaker::expression(int depth) {
  switch (depth > 0 ? choose(12) : choose(2)) {
  case 0:
    return variable();
  case 2:
  case 3:
    return operation(depth);
  case 4:
    return builtin_call(depth);
  case 5:
    return function_call(depth);
  case 6:
    return variable() + "[" + expression(depth - 1) + "]";
  case 7:
    return variable() + "." + one_of({"a", "b", "message", "kind"});
  case 8:
    return "[" + expression(depth - 1) + ", " + variable() + "]";
  case 9:
    return "{'a': " + expression(depth - 1) + ", 'b': " + literal() + "}";
  case 10:
    return "(" + expression(depth - 1) + ") ? (" + variable() + ") : (" +
           literal() + ")";
  case 11:
    return std::string(one_of({"not ", "-"})) + "(" + expression(depth - 1) +
           ")";
  default:
    return literal();
  }
}

// -- statements ---------------------------------------------------------------

void ProgramMaker::block(int depth) {
  const auto visible = scope_.size();
  for (auto left = 1 + choose(4); left > 0; --left)
    statement(depth);
  scope_.resize(visible);
}

void ProgramMaker::element(const std::string& start, const char* name) {
  script_ += "<" + std::string(name) + start + ">";
}

void ProgramMaker::assignment() {
  switch (choose(5)) {
  case 0: {
    const auto value = expression();
    script_ += "<var" + attribute("name", new_variable()) +
               attribute("expr", value) + "/>\n";
    return;
  }
  case 1:
    script_ += "<set" +
               attribute("name", variable() + "[" + expression(1) + "]") +
               attribute("expr", expression()) + "/>\n";
    return;
  case 2:
    script_ += "<set" + attribute("name", variable() + ".a") +
               attribute("expr", expression()) + "/>\n";
    return;
  case 3:
    script_ += "<append" + attribute("name", variable()) +
               attribute("expr", expression()) + "/>\n";
    return;
  default:
    script_ += "<set" + attribute("name", variable()) +
               attribute("expr", expression()) + "/>\n";
  }
}

void ProgramMaker::loop(int depth) {
  const auto visible = scope_.size();
  const char* name = "for";
  switch (choose(3)) {
  case 0: {
    const auto from = attribute("from", expression(1));
    const auto to = attribute("to", expression(1));
    const auto step = choose(2) ? attribute("step", literal()) : "";
    element(attribute("name", new_variable()) + from + to + step, name);
    break;
  }
  case 1: {
    const auto in = attribute("in", expression());
    element(attribute("each", new_variable()) + in +
                attribute("index", new_variable()),
            name);
    break;
  }
  default:
    name = "while";
    element(attribute("cond", expression()), name);
  }
  ++loops_;
  block(depth - 1);
  --loops_;
  script_ += std::string("</") + name + ">\n";
  scope_.resize(visible);
}

// Up to six arms: enough for the compiler to make a jump table.
void ProgramMaker::arms(int depth, const char* name, const char* condition,
                        const std::string& start) {
  for (auto left = 1 + choose(6); left > 0; --left) {
    element(attribute(condition, start + literal()), name);
    left > 3 ? simple_statement() : block(depth - 1);
    script_ += std::string("</") + name + ">";
  }
}

void ProgramMaker::branch(int depth) {
  switch (choose(4)) {
  case 0:
    element(attribute("cond", expression()), "if");
    block(depth - 1);
    script_ += "<else>";
    block(depth - 1);
    script_ += "</else></if>\n";
    return;
  case 1:
    element(attribute("expr", expression()), "switch");
    arms(depth, "case", "value", "");
    script_ += "</switch>\n";
    return;
  case 2: {
    const auto start = variable() + " == ";
    element(attribute("cond", start + literal()), "if");
    simple_statement();
    arms(depth, "elseif", "cond", start);
    script_ += "</if>\n";
    return;
  }
  default:
    script_ += "<try>";
    block(depth - 1);
    scope_.push_back("v" + std::to_string(named_++));
    element(attribute("name", scope_.back()), "catch");
    block(depth - 1);
    scope_.pop_back();
    script_ += "</catch></try>\n";
  }
}

void ProgramMaker::call() {
  element(attribute("function", "f" + std::to_string(choose(functions_))) +
              attribute("return", variable()),
          "call");
  for (auto left = 1 + choose(2); left > 0; --left)
    script_ += "<var" +
               attribute("expr", choose(3) ? variable() : expression(2)) + "/>";
  script_ += "</call>\n";
}

void ProgramMaker::effect(int depth) {
  switch (choose(4)) {
  case 0:
    script_ +=
        "<print param=\"{" + expression() + "}, {" + variable() + "}\"/>\n";
    return;
  case 1:
    script_ += "<wait for=\"20ms\"/>\n";
    return;
  case 2:
    script_ += "<throw" + attribute("expr", expression()) + "/>\n";
    return;
  default: {
    const int loops = loops_;
    loops_ = 0;
    element(attribute("name", std::string(one_of({"s", "t"}))) +
                attribute("after", "10ms"),
            "timer");
    block(depth - 1);
    script_ += "</timer>\n";
    loops_ = loops;
  }
  }
}

void ProgramMaker::simple_statement() {
  if (loops_ > 0 && choose(4) == 0)
    script_ += one_of({"<continue/>\n", "<break/>\n"});
  else
    script_ += "<print param=\"{" + variable() + "}\"/>\n";
}

void ProgramMaker::statement(int depth) {
  if (depth <= 0)
    return simple_statement();
  switch (choose(7)) {
  case 0:
    return simple_statement();
  case 1:
    return loop(depth);
  case 2:
    return branch(depth);
  case 3:
    return call();
  case 4:
    return effect(depth);
  default:
    return assignment();
  }
}

void ProgramMaker::function(std::size_t number) {
  const auto visible = scope_.size();
  const auto name = "f" + std::to_string(number);
  script_ += "<function" + attribute("name", name) + "><param name=\"p\"/>" +
             "<param name=\"q\"" + attribute("expr", literal()) + "/>\n";
  scope_.insert(scope_.end(), {"p", "q"});
  block(deepest);
  script_ += "<return" + attribute("expr", expression()) + "/></function>\n";
  scope_.resize(visible);
}

std::string ProgramMaker::make() {
  script_ = "<dialogue>\n";
  functions_ = 1 + choose(max_functions);
  for (const std::string name : {"a", "b", "c"}) {
    script_ += "<var" + attribute("name", name) + attribute("expr", literal()) +
               "/>\n";
    scope_.push_back(name);
  }
  script_ += "<function name=\"main\">\n";
  block(deepest);
  script_ += "</function>\n";
  for (std::size_t i = 0; i < functions_; ++i)
    function(i);
  return std::move(script_) + "</dialogue>\n";
}

} // namespace parlour::fuzz
