// Compiles such elements, into one Repair for each act:
//
//   <repair act="no_match, no_input" topic="Taxi" slot="Time" count="2">
//     <say act="help"/>
//   </repair>

#include "script/compiler/repair_compiler.hpp"

#include <algorithm>

#include "runtime/message/roles.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script {

namespace {

// The acts of the user, which are the events of the source Dialogue.
std::vector<std::string> known_acts() {
  std::vector<std::string> acts;
  if (const auto* dialogue = find_role("Dialogue"))
    for (const auto& event : dialogue->events)
      acts.emplace_back(event.name);
  return acts;
}

// Acts that can happen several times in a row.
bool is_counted(const std::string& act) {
  return act == "no_match" || act == "no_input" || act == "protest" ||
         act == "refuse";
}

class RepairCompiler {
public:
  RepairCompiler(const Element& element, Compilation& compilation)
      : element_(element), compilation_(compilation) {}

  void compile(bool of_platform, const FunctionNames* functions) {
    repair_.of_platform = of_platform;
    repair_.position = element_.position;
    find_topic();
    find_slot();
    compile_bodies(functions);
    auto acts = checked_acts();
    check_count(acts);
    for (auto& act : acts) {
      repair_.count = 0;
      if (is_counted(act))
        repair_.count = static_cast<std::uint32_t>(
            parse_count(element_.value("count")).value_or(1));
      repair_.act = std::move(act);
      compilation_.program.repairs.push_back(repair_);
    }
  }

private:
  void wrong_name(const char* attribute, const char* what,
                  const std::vector<std::string>& known) {
    const auto& given = *element_.attribute(attribute);
    compilation_.findings.error(given.value_position,
                                std::string("there is no ") + what + " '" +
                                    given.value + "'" +
                                    did_you_mean(given.value, known));
  }

  std::vector<std::string> checked_acts() {
    auto acts = split_names(element_.value("act"));
    const auto known = known_acts();
    for (const auto& act : acts)
      if (std::find(known.begin(), known.end(), act) == known.end())
        compilation_.findings.error(element_.attribute("act")->value_position,
                                    "there is no act '" + act + "'" +
                                        did_you_mean(act, known));
    return acts;
  }

  // Only acts that can be repeated have a count.
  void check_count(const std::vector<std::string>& acts) {
    const auto* count = element_.attribute("count");
    const auto other = std::find_if_not(acts.begin(), acts.end(), is_counted);
    if (count && other != acts.end())
      compilation_.findings.error(count->position,
                                  "'count' is of answers that fail; '" +
                                      *other + "' is not counted");
  }

  void find_topic() {
    if (!element_.attribute("topic"))
      return;
    repair_.topic = compilation_.program.topic(element_.value("topic"));
    if (repair_.topic == no_id)
      wrong_name("topic", "topic", keys_of(compilation_.names.topics));
  }

  void find_slot() {
    if (!element_.attribute("slot"))
      return;
    if (repair_.topic == no_id)
      return compilation_.findings.error(
          element_.position, "a <repair> of a 'slot' needs its 'topic'");
    const auto& topic = compilation_.program.topics[repair_.topic];
    repair_.slot = topic.slot(element_.value("slot"));
    if (repair_.slot == no_id)
      wrong_name("slot", "slot", names_of(topic.slots));
  }

  // With a topic, `this` means its slots.
  void compile_bodies(const FunctionNames* functions) {
    BodyContext context;
    context.functions = functions;
    context.name = "repair " + element_.value("act");
    if (repair_.topic != no_id)
      context.topic = &compilation_.program.topics[repair_.topic];
    if (const auto* condition = element_.attribute("if"))
      repair_.condition =
          compilation_.bodies.expression(*condition, context, {"data"});
    repair_.body = compilation_.bodies.body(element_, context, {"data"});
  }

  const Element& element_;
  Compilation& compilation_;
  Repair repair_;
};

} // namespace

void compile_repair(const Element& element, bool of_platform,
                    const FunctionNames* functions, Compilation& compilation) {
  RepairCompiler(element, compilation).compile(of_platform, functions);
}

} // namespace parlour::script
