// BodyCompiler: the border between the compiler of declarations (topics,
// states, handlers …) and the compiler of code (statements, expressions). The
// former calls it for every body and attribute that runs; what is declared
// must be registered in Names before.
#pragma once

#include <string>
#include <vector>

#include "script/compiler/code/declared_names.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

class BodyCompiler {
public:
  BodyCompiler(Program& program, const Names& names, Findings& findings);

  // The statements inside `parent` (all children but those named in
  // `except`), as code without parameters or with the given ones.
  CodeId body(const Element& parent, const BodyContext& context,
              const std::vector<std::string>& parameters = {},
              ElementNames except = {});
  // A <function>: its <param>s and statements, into the reserved code.
  void function(const Element& element, CodeId reserved,
                const BodyContext& context);

  // Language rule 4. An expression; text or expression; text with {expr}.
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
