#include "tools/bench/nlu/nlu_command.hpp"

#include <map>
#include <memory>

#include "adapters/nlu/understand/grammar_nlu.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

// The column with the names for the row "names".
const char* const staff_names = "db:rr_staff.staff_name";

// Reads each column only once, so that the bench does not measure the database.
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

// The user turns of all conversations in the folder.
std::vector<std::string> said_to(const fs::path& dialogues) {
  std::vector<std::string> said;
  for (const auto& file : fs::directory_iterator(dialogues))
    for (const auto& step : read_conversation(file.path()).conversation.steps)
      if (step.kind == StepKind::user)
        said.push_back(step.text);
  return said;
}

// What the bench measures of the application, as plain data. It is read before
// the measuring starts.
NluApplication measured_part(const Application& application) {
  NluApplication measured;
  if (const auto& model = application.program->understanding)
    measured.model = *model;
  measured.columns = remembered(column_reader(
      rehearsed(application.composition), application.folder, ""));
  if (const auto names = measured.columns(staff_names))
    measured.names = *names;
  if (const auto* component = first_of_role(application.composition, "NLU"))
    if (auto platform = adapters::nlu::read_platform(
            component->options, application.folder.string()))
      measured.platform = std::move(*platform);
  measured.said = said_to(application.folder / "dialogues");
  return measured;
}

} // namespace

bool nlu_command(const Places& places, const NluBenchOptions& options,
                 const Console& console) {
  auto opened = open_application(places, "receptionist", console);
  if (std::holds_alternative<int>(opened))
    return false;
  return nlu_bench(options, measured_part(std::get<Application>(opened)),
                   console.out);
}

} // namespace parlour::tools
