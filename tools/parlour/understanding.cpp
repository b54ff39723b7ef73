#include "tools/parlour/understanding.hpp"

#include "adapters/nlu/grammar_nlu.hpp"

namespace parlour::tools {

namespace nlu = adapters::nlu;

namespace {

std::string option(const ChosenComponent& component, const char* name) {
  const auto found = component.options.find(name);
  return found == component.options.end() ? "" : found->second;
}

} // namespace

tl::expected<nlu::Understander, std::vector<Error>>
build_understander(const Application& application,
                   const ChosenComponent& component,
                   const ColumnReader& columns) {
  nlu::Understander::Options options;
  const auto threshold = parse_number(option(component, "threshold"));
  options.threshold = threshold.number_or(options.threshold);
  auto generic =
      nlu::read_generic(component.options, application.folder.string());
  if (!generic)
    return tl::make_unexpected(std::vector<Error>{generic.error()});
  options.generic = {std::move(*generic)};
  const auto& model = application.program->understanding;
  return nlu::Understander::build(model ? *model : UnderstandingModel{},
                                  columns, std::move(options));
}

} // namespace parlour::tools
