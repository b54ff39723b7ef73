#include "script/dialogue/topics/misnamed.hpp"

#include "script/source/findings.hpp"

namespace parlour::dialogue {

namespace {

template <class Named>
std::string did_you_mean(const std::string& name,
                         const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const auto& one : all)
    names.push_back(one.name);
  return script::did_you_mean(name, names);
}

Error no(const std::string& what) {
  return {ErrorKind::range, what, {}};
}

} // namespace

std::optional<Error> misnamed(const script::Program& program, const Act& act) {
  if (act.topic.empty())
    return {};
  const auto id = program.topic(act.topic);
  if (id == script::no_id)
    return no("there is no topic '" + act.topic + "' for this frame" +
              did_you_mean(act.topic, program.topics));
  const auto& topic = program.topics[id];
  for (const auto& value : act.slots)
    if (topic.slot(value.slot) == script::no_id)
      return no("the topic '" + topic.name + "' has no slot '" + value.slot +
                "' for this frame" + did_you_mean(value.slot, topic.slots));
  return {};
}

} // namespace parlour::dialogue
