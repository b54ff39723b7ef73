// BodyCompiler: the interface between the compilers of declarations (topics,
// states, handlers …) and the compiler of code (statements, expressions). The
// former call it for every body and attribute that runs. All names must have
// been collected (declared_names.hpp) before.
//
// An example, the question of a slot:
//
//   BodyContext context;
//   context.topic = &topic;
//   slot.question = bodies.text_or_expression(*attribute, context);
#pragma once

#include <string>
#include <vector>

#include "script/compiler/code/expressions/declared_names.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

// Appends the compiled code to Program::code and returns its index. Mistakes
// become findings; the code is then incomplete but well-formed, so compiling
// goes on.
class BodyCompiler {
public:
  BodyCompiler(Program& program, const Names& names, Findings& findings);

  // Compiles the statements in `parent`, except children named in `except`. The
  // parameters are the first registers, in order.
  CodeId body(const Element& parent, const BodyContext& context,
              const std::vector<std::string>& parameters = {},
              ElementNames except = {});
  // Compiles the <filled> of a topic, which need not be there, behind the
  // question whether all that was said is right (engine rule 5.13), and its
  // <refused>.
  CodeId after_summary(const Element& topic, bool only_if_unsure,
                       const BodyContext& context);
  // Compiles a <function>, its <param>s and statements, into the code that was
  // reserved for it.
  void function(const Element& element, CodeId reserved,
                const BodyContext& context);

  // Compile an attribute's value by language rule 4: always an expression; a
  // text or an expression; a text with {expr}.
  CodeId expression(const Attribute& attribute, const BodyContext& context,
                    const std::vector<std::string>& parameters = {});
  CodeId text_or_expression(const Attribute& attribute,
                            const BodyContext& context);
  CodeId text(const std::string& text, Position position,
              const BodyContext& context,
              const std::vector<std::string>& parameters = {});

private:
  Program& program_;
  const Names& names_;
  Findings& findings_;
};

} // namespace parlour::script
