#include "tools/parlour/application/understanding.hpp"

#include "adapters/nlu/understand/grammar_nlu.hpp"

namespace parlour::tools {

tl::expected<adapters::nlu::Understander, std::vector<Error>>
build_understander(const Application& application,
                   const ChosenComponent& component,
                   const ColumnReader& columns) {
  const auto& model = application.program->understanding;
  return adapters::nlu::build_understander(
      component.options, model ? *model : UnderstandingModel{}, columns,
      application.folder.string());
}

} // namespace parlour::tools
