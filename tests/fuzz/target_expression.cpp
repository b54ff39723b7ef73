// Compiles any text as an expression and evaluates it. The first byte chooses
// how: as an expression, as a text with {expressions}, or as an attribute that
// may be either.
#include "script/compiler/code/body_compiler.hpp"
#include "tests/fuzz/quiet_host.hpp"

namespace parlour::fuzz {

namespace {

class Evaluation {
public:
  Evaluation() {
    names_.variables = {{"a", 0}, {"b", 1}, {"c", 2}};
    program_.variables.resize(3);
    program_.settings.limits.bytes = 1 << 20;
    program_.settings.limits.result = 1 << 16;
    program_.settings.limits.instructions = 20'000;
    findings_.add_file("a.xml");
  }

  void run(char way, const std::string& text) {
    const auto code = compile(way, text);
    if (findings_.has_errors())
      return;
    QuietHost host;
    script::Interpreter interpreter({std::shared_ptr<void>(), &program_});
    interpreter.set_variable(0, List{Value(1), Value("x"), Value(2.5)});
    interpreter.set_variable(1, Map{{"k", Value(List{Value(7)})}});
    interpreter.set_variable(2, "Grüße 12");
    const auto value =
        interpreter.evaluate(code, {Value(3), Value("text")}, {}, host);
    if (value)
      to_string(*value);
  }

private:
  script::CodeId compile(char way, const std::string& text) {
    script::BodyCompiler compiler(program_, names_, findings_);
    const script::Attribute attribute{"expr", text, {0, 1, 1}, {0, 1, 7}};
    if (way % 3 == 0)
      return compiler.text(text, {0, 1, 1}, {}, {"p", "q"});
    if (way % 3 == 1)
      return compiler.text_or_expression(attribute, {});
    return compiler.expression(attribute, {}, {"p", "q"});
  }

  script::Program program_;
  script::Names names_;
  script::Findings findings_;
};

} // namespace

} // namespace parlour::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size == 0)
    return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  parlour::fuzz::Evaluation().run(static_cast<char>(data[0]), text);
  return 0;
}
