// A small receptionist for tests of the understanding: topics, a grammar and
// some names.
#pragma once

#include <stdexcept>
#include <string>

#include "adapters/nlu/understand/grammar_nlu.hpp"
#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters::nlu::test {

inline const char* const sample_grammar = R"(
#JSGF V1.0;
grammar desk;
public <meet> = (to meet | to see | appointment with)
  @db:staff.name {Host} {topic=Appointment};
public <visitor> = (I am | my name is) @words {Visitor} {topic=Appointment};
public <firm> = from @words {Organisation} {topic=Appointment};
public <at> = at @time {Time};
public <ask> = (is there | where is)
  (@Facility.Category | @Facility.Name) [<floor>] {act=request};
public <on> = <floor> {topic=Facility};
<floor> = on @level {Location};
public <cab> = (need | book) a taxi [to @words {Destination}]
  {topic=Taxi} {act=inform};
)";

inline UnderstandingModel sample_model() {
  UnderstandingModel model;
  model.topics = {{"Appointment",
                   false,
                   {{"Visitor", "", {}, "", true, false},
                    {"Organisation", "", {}, "", false, false},
                    {"Host", "query", {}, "db:staff.name", true, false},
                    {"Time", "time", {}, "", true, false},
                    {"Date", "date", {}, "", false, false}},
                   {}},
                  {"Facility",
                   true,
                   {{"Name", "query", {}, "db:facility.name", false, true},
                    {"Category",
                     "set",
                     {"coffee shop", "food court", "bank", "toilet"},
                     "",
                     false,
                     true},
                    {"Location", "level", {}, "", false, true}},
                   {}},
                  {"Taxi",
                   false,
                   {{"Destination", "", {}, "", true, false},
                    {"Time", "time", {}, "", true, false},
                    {"Phone", "phone", {}, "", true, false}},
                   {"Please book a ride to [Changi Airport](Destination) at "
                    "[9:00](Time)"}}};
  model.grammars = {{"desk", sample_grammar, {"desk.jsgf", 1, 1}}};
  return model;
}

inline Expected<std::vector<std::string>>
sample_column(const std::string& name) {
  if (name == "db:staff.name")
    return std::vector<std::string>{
        "Jeffery Ho",  "Ho Hui Min", "Tan Wei Ming",         "Tan Hui Min",
        "Anand Menon", "Priya Nair", "Sumathi d/o Arumugam", "Margaret Sim"};
  if (name == "db:facility.name")
    return std::vector<std::string>{"Sky garden", "Ya Kun Toastwich",
                                    "Starbucks Coffee", "Swimming pool"};
  return fail(ErrorKind::database, "no such column");
}

// Every column has these: as many as are known as people.
inline Expected<std::vector<std::string>> sample_people(const std::string&) {
  return std::vector<std::string>{
      "Koh Sok Hwee", "Katherine Neo", "Rajesh s/o Chandran", "Jeffery Ho",
      "Grace Chen",   "Kelvin Palmer", "Priya Nair",          "Anand Menon",
      "Rachel Lim",   "Adeline Foo"};
}

inline GrammarModel generic_grammar() {
  return *read_grammar(
      parlour::test::source_path("config/platform/generic-acts.jsgf"));
}

inline NluEngine sample() {
  auto built = NluEngine::build(sample_model(), sample_column,
                                {0.4, {generic_grammar()}});
  if (!built)
    throw std::runtime_error(to_string(built.error().front()));
  return std::move(*built);
}

// Saturday, nine in the morning.
inline Timestamp sample_now() {
  return *parse_timestamp("2026-11-21 09:00");
}

// The context in which "Topic.Slot" has been asked for, "Topic" is the current
// topic, or nothing is known ("").
inline Value sample_context(const std::string& asked) {
  Map context{{"now", sample_now()}};
  const auto point = asked.find('.');
  const auto topic = asked.substr(0, point);
  if (!asked.empty())
    context.set("current", topic);
  if (point != std::string::npos)
    context.set("asked",
                Map{{"topic", topic}, {"slot", asked.substr(point + 1)}});
  return context;
}

// The acts as one line: "act Topic Slot=value …", joined by " + ". A value that
// is not in its set has a "?", candidates are "a|b", and an elliptical act
// begins with "~".
inline std::string summary(const List& acts) {
  std::string text;
  for (const auto& act : acts) {
    text += (text.empty() ? "" : " + ") +
            std::string(act["elliptical"] ? "~" : "") + act["act"].text();
    if (!act["topic"].is_unknown())
      text += " " + act["topic"].text();
    for (const auto& [name, slot] : act["slots"].if_map()->entries()) {
      text += " " + name + "=";
      if (const auto* candidates = slot["candidates"].if_list())
        for (std::size_t at = 0; at < candidates->size(); ++at)
          text += (at > 0 ? "|" : "") + candidates->at(at).text();
      else
        text += slot["value"].text() + (slot["unmatched"] ? "?" : "");
    }
  }
  return text;
}

} // namespace parlour::adapters::nlu::test
