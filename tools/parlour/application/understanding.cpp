// Calls the builder of adapters/nlu with the application's model.
#include "tools/parlour/application/understanding.hpp"

#include "adapters/nlu/understand/grammar_nlu.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {

tl::expected<adapters::nlu::NluEngine, std::vector<Error>>
build_engine(const Application& application, const ChosenComponent& component,
             const ColumnReader& columns) {
  const auto& model = application.program->understanding;
  return adapters::nlu::build_engine(component.options,
                                     model ? *model : UnderstandingModel{},
                                     columns, application.folder.string());
}

std::vector<adapters::nlu::LeftOutExample>
try_examples(const Application& application) {
  const auto& model = application.program->understanding;
  for (const auto& component : application.composition.components)
    if (const auto attempt =
            shipped_plugin(component.factory.description.name).try_examples;
        attempt && model)
      return attempt(component.options, *model,
                     column_reader(rehearsed(application.composition),
                                   application.folder, ""),
                     application.folder.string());
  return {};
}

Map first_context(const script::Program& program, Timestamp now) {
  Map context{{"now", now}};
  const auto state = program.state(program.settings.start);
  if (state != script::no_id && !program.states[state].grammar.empty())
    context.set("grammar", program.states[state].grammar);
  return context;
}

Map with_alternatives(Map context, const List& alternatives) {
  List heard;
  for (const auto& each : alternatives)
    heard.push_back(each.if_map() ? each["text"] : each);
  context.set("heard", std::move(heard));
  return context;
}

} // namespace parlour::tools
