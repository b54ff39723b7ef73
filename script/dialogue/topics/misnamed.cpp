#include "script/dialogue/topics/misnamed.hpp"

#include "script/source/findings.hpp"

namespace parlour::dialogue {

namespace {

Error no(const std::string& what) {
  return {ErrorKind::range, what, {}};
}

} // namespace

std::optional<Error> misnamed(const script::Program& program, const Act& act) {
  if (act.topic.empty())
    return {};
  const auto id = program.topic(act.topic);
  if (id == script::no_id)
    return no(
        "there is no topic '" + act.topic + "' for this frame" +
        script::did_you_mean(act.topic, script::names_in(program.topics)));
  const auto& topic = program.topics[id];
  for (const auto& value : act.slots)
    if (topic.slot(value.slot) == script::no_id)
      return no(
          "the topic '" + topic.name + "' has no slot '" + value.slot +
          "' for this frame" +
          script::did_you_mean(value.slot, script::names_in(topic.slots)));
  return {};
}

} // namespace parlour::dialogue
