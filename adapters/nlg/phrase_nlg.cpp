#include "adapters/nlg/phrase_nlg.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace parlour::adapters {

namespace {

// The act with the data of a second parameter, unless it has data of its own.
Value with_data(const Map& act, const std::vector<Value>& params) {
  if (params.size() < 2 || act.find("data"))
    return act;
  Map both = act;
  both.set("data", params[1]);
  return both;
}

std::vector<Answer> no_phrase(const Value& say) {
  return {{"Speak", {""}}, {"NoPhrase", {say["act"], say["topic"]}}};
}

} // namespace

// Words may come with failures, such as an expression of a phrase that failed;
// each is reported with its place.
std::vector<Answer> PhraseNLG::answers(const Message& message) const {
  if (message.command != "Generate")
    return {
        {"Failed",
         {"PhraseNLG does not know the command '" + message.command + "'."}}};
  if (message.params.empty() || message.params[0].is_unknown())
    return no_phrase({});
  const auto* act = message.params[0].if_map();
  if (!act)
    return {{"Speak", {message.params[0].text()}}};
  const auto say = with_data(*act, message.params);
  const auto phrases = host().phrases();
  auto [words, failures] = phrases ? phrases->render(say) : Rendering{};
  auto answers = words ? std::vector<Answer>{{"Speak", {std::move(*words)}}}
                       : no_phrase(say);
  for (auto& failure : failures)
    answers.push_back({"PhraseFailed",
                       {std::move(failure.message), failure.place.file,
                        std::int64_t{failure.place.line}}});
  return answers;
}

PluginFactory phrase_nlg_factory() {
  PluginDescription description;
  description.name = "PhraseNLG";
  description.roles = {"NLG"};
  description.sentence = "words from the phrases of application and platform";
  description.is_inline = true;
  description.events = {{"NoPhrase", "act, topic", Reply::none}};
  return {description, [] { return std::make_unique<PhraseNLG>(); }};
}

} // namespace parlour::adapters
