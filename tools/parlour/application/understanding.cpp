// Calls the builder of adapters/nlu with the application's model.
#include "tools/parlour/application/understanding.hpp"

#include "adapters/nlu/understand/grammar_nlu.hpp"

namespace parlour::tools {

tl::expected<adapters::nlu::NluEngine, std::vector<Error>>
build_engine(const Application& application, const ChosenComponent& component,
             const ColumnReader& columns) {
  const auto& model = application.program->understanding;
  return adapters::nlu::build_engine(component.options,
                                     model ? *model : UnderstandingModel{},
                                     columns, application.folder.string());
}

} // namespace parlour::tools
