// A café's counter, for tests of recognisers.
#pragma once

#include <memory>
#include <string>

#include "adapters/asr/words/language.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "tests/support/audio/voices.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters::asr {

inline constexpr const char* english_model =
    "/usr/share/pocketsphinx/model/en-us";

inline UnderstandingModel small_application() {
  UnderstandingModel model;
  model.topics.push_back(
      {"Order",
       false,
       {{"Drink",
         "set",
         {"coffee", "lemon tea", "hot chocolate"},
         "",
         false,
         false},
        {"Guest", "query", {}, "db:guests.name", false, false}},
       {"I would like a [coffee](Drink)"}});
  model.grammars.push_back(
      {"order",
       "public <order> = (i want | i would like | bring me) @Order.Drink "
       "[please];\npublic <guest> = call @db:guests.name;\n"
       "public <table> = a table (for | at) @number;",
       {}});
  return model;
}

inline Expected<std::vector<std::string>> small_columns(const std::string&) {
  return std::vector<std::string>{"Jeffery Ho", "Siti Aminah",
                                  "Arumugam Pillai"};
}

inline GrammarModel platform_grammar(const std::string& name) {
  const auto text = read_file(test::source_path("config/platform/" + name));
  return {name, text ? *text : "", {}};
}

// Within silence, as an endpointer passes it on.
inline test::Sound said(const std::string& text,
                        const std::string& voice = "rms") {
  auto sound = test::silence(300);
  const auto speech = test::spoken(text, voice);
  sound.insert(sound.end(), speech.begin(), speech.end());
  sound.resize(sound.size() + test::samples_in(300));
  return sound;
}

} // namespace parlour::adapters::asr
