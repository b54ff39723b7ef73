// `parlour bench nlu`: the receptionist's understanding, and public data sets.
#include <map>
#include <memory>

#include "adapters/nlu/understand/grammar_nlu.hpp"
#include "tools/bench/nlu/nlu_bench.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/cli/bench_rows.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

const char* const staff_names = "db:rr_staff.staff_name";

// Each column is read once, so that the database's time is not measured.
ColumnReader remembered(ColumnReader reader) {
  using Columns = std::map<std::string, std::vector<std::string>>;
  return [reader = std::move(reader), columns = std::make_shared<Columns>()](
             const std::string& name) -> Expected<std::vector<std::string>> {
    if (const auto found = columns->find(name); found != columns->end())
      return found->second;
    auto read = reader(name);
    if (read)
      columns->emplace(name, *read);
    return read;
  };
}

// What the users of its conversations say.
std::vector<std::string> said_to(const fs::path& dialogues) {
  std::vector<std::string> said;
  for (const auto& file : fs::directory_iterator(dialogues))
    for (const auto& step : read_conversation(file.path()).conversation.steps)
      if (step.kind == StepKind::user)
        said.push_back(step.text);
  return said;
}

} // namespace

int bench_nlu_command(const Places& places, const BenchOptions& options,
                      const Console& console) {
  if (!has_row(nlu_bench_rows(), options, console))
    return exit_code::usage;
  auto opened = open_application(places, "receptionist", console);
  if (const auto* status = std::get_if<int>(&opened))
    return *status;
  const auto& application = std::get<Application>(opened);
  NluApplication measured;
  if (const auto& model = application.program->understanding)
    measured.model = *model;
  measured.columns = remembered(column_reader(
      in_memory(application.composition), application.folder, ""));
  if (const auto names = measured.columns(staff_names))
    measured.names = *names;
  if (const auto* component = first_of_role(application.composition, "NLU"))
    if (auto generic = adapters::nlu::read_generic(component->options,
                                                   application.folder.string()))
      measured.generic = {std::move(*generic)};
  measured.said = said_to(application.folder / "dialogues");
  return nlu_bench({options.only, options.data, options.validation}, measured,
                   console.out)
             ? exit_code::well
             : exit_code::wrong;
}

} // namespace parlour::tools
