// Reader: reads sentences as the application does, behind its own scripts.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/understand/own_words.hpp"

namespace parlour::tools {

struct Reading {
  // What the understanding was given; nothing: the scripts sent it nothing.
  std::optional<SentWords> sent;
  adapters::nlu::Understanding made;
};

class Reader {
public:
  // All errors, of the options, grammars, examples and columns, or of the
  // start. `component` must be a GrammarNLU.
  static tl::expected<Reader, std::vector<Error>>
  open(const Application& application, const ChosenComponent& component,
       Timestamp clock);

  // `context` adds to what the session tells, or replaces it: what was asked,
  // what is spoken of.
  Reading read(const std::string& text, const Map& context, bool explain);

private:
  Reader(std::unique_ptr<OwnWords> own, adapters::nlu::NluEngine engine);

  std::unique_ptr<OwnWords> own_;
  adapters::nlu::NluEngine engine_;
};

// One line of JSON: text, sent (what the scripts made of it, or null), acts and
// score. An act has its alternatives.
std::string reading_line(const std::string& text, const Reading& reading);

} // namespace parlour::tools
